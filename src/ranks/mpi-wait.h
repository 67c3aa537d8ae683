/* mpi-wait.h -- how a rank waits for others without keeping a core from them.
 *
 * What MPI offers asks without pause, so that a rank that waits takes as much CPU as one that works.
 * Here it asks for some 0.3 ms of CPU and then sleeps, until a rank of the same machine has sent something
 * or for a part of what it has waited so far: a message of another machine does not wake it. */
#ifndef RANKS_MPI_WAIT_H
#define RANKS_MPI_WAIT_H

#include <mpi.h>

/* Once MPI has begun, on all ranks.  With OMP_WAIT_POLICY=active in the environment they never sleep. */
void ranks_wait_begin(void);
void ranks_wait_end(void);

/* Ranks of the machine on which this one is. */
MPI_Comm ranks_neighbours(void);

/* Wakes those of them that sleep: something has been sent that is not waited for at once. */
void ranks_wake(void);

/* Returns when n requests are done, as MPI_Waitall() does, and wakes others before and after. */
void ranks_wait(int n, MPI_Request *request);

#endif
