/* tell.h -- the progress line of a comparison, on standard error. */
#ifndef STUDY_TELL_H
#define STUDY_TELL_H

#include <stdbool.h>

struct tell {
    bool quiet, terminal;
    const char *what;      /* "references", "runs"     */
    const char *now;       /* the run begun last; NULL */
    int all, ended, bad, reused;
    double began, told;    /* [s] clock                */
};

void tell_start(struct tell *t, const char *what, int all, bool quiet);
void tell_look(struct tell *t, int running); /* now and then */
void tell_end(struct tell *t);

#endif
