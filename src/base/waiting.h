/* waiting.h -- how threads wait for each other at the end of a loop.
 *
 * A thread that sleeps takes some microseconds to wake, and a right-hand side has a dozen
 * loops.  One that spins is there at once, but takes a core from those that have work.  So
 * threads spin where each has a core of its own, and not for long: should others come later,
 * they lose little. */
#ifndef BASE_WAITING_H
#define BASE_WAITING_H

#include <stdbool.h>

/* Turns that a waiting thread spins before it sleeps; 0: it sleeps at once.  threads: of the
 * program; processors: that it may use; busy: other threads that run on the `all` processors
 * of the machine, -1: not known. */
int waiting_spins(int threads, int processors, int all, int busy);

/* Sets the environment of the next program of this process, which reads it when it is loaded:
 * OMP_WAIT_POLICY=passive, and GOMP_SPINCOUNT where `threads` (0: as OMP_NUM_THREADS says, or
 * one for each processor) have cores of their own now.  What the user set stays. */
void waiting_choose(int threads);

/* The same where programs will run side by side: they sleep. */
void waiting_sleep(void);

/* Particles, with a nanosecond or two for each, above which a loop repays waking the threads:
 * many fewer where they spin.  turns: as GOMP_SPINCOUNT says, NULL where it is not set. */
long waiting_worth(const char *turns);

/* Does a loop over n such particles?  From the environment at the first call; not within a region. */
bool waiting_repays(long n);

#endif
