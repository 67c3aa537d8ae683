/* progress.h -- tells on standard error how far a run is: on a terminal one
 * line that is rewritten up to five times a second, elsewhere a plain line at
 * the start, every five seconds, and at the end. */
#ifndef OUTPUT_PROGRESS_H
#define OUTPUT_PROGRESS_H

#include <stdbool.h>
#include <stdio.h>

struct progress {
    FILE *to;
    bool quiet, terminal, shown;
    double until;      /* [s] simulated                                       */
    double began;      /* [s] clock                                           */
    double told;       /* [s] clock, of the last line                         */
    double told_t;     /* [s] simulated, at the last line                     */
    double rate;       /* simulated seconds in a second of the clock, smooth  */
};

/* to is stderr; quiet: nothing is ever written. */
void progress_start(struct progress *p, FILE *to, double from, double until, bool quiet);

/* After every accepted step of length h [s]; limiter says what holds it back
 * ("error", "stability", "output").  Costs a look at the clock. */
void progress_step(struct progress *p, double t, double h, const char *limiter);

/* Last line; a terminal's line is ended. */
void progress_end(struct progress *p, double t);

#endif
