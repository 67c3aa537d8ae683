/* children.h -- runs programs side by side, each with a limit of time. */
#ifndef STUDY_CHILDREN_H
#define STUDY_CHILDREN_H

#include <stdbool.h>
#include <sys/types.h>

struct child {
    char *const *words; /* program and arguments, NULL-ended              */
    const char *said;   /* file that its stdout and stderr go to          */
    double budget;      /* [s] of the clock, then it gets SIGTERM; 0: any */
    int code;           /* exit status; -N: ended by signal N             */
    bool late;          /* its time was over                              */

    pid_t pid;          /* 0: not running; children.c alone reads what follows */
    double began, told;
    bool ended;
};

/* What the caller does while children run. */
struct children_watch {
    bool (*begin)(void *self, int i); /* just before child i: false leaves it out; may be NULL */
    int (*end)(void *self, int i);    /* child i has ended                                     */
    void (*look)(void *self, int running); /* now and then                                     */
    int (*asked)(void);               /* not 0: end them all, start no more                    */
    void *self;
};

/* Runs child[0..n) in this order, up to `jobs` at a time.  STATUS_STOPPED when asked() said
 * so; children that ended by then had their end(), the others are not reported. */
int children_run(struct child *child, int n, int jobs, const struct children_watch *watch);

#endif
