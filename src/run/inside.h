/* inside.h -- a run as the files of this room see it. */
#ifndef RUN_INSIDE_H
#define RUN_INSIDE_H

#include "base/status.h"
#include "eval/observe.h"
#include "plan/survey.h"
#include "run/outputs.h"
#include "run/past.h"
#include "run/run.h"
#include "run/team.h"
#include "time/method.h"

#include <stdio.h>

enum { RUN_PATH = 3900 };

struct run {
    char directory[RUN_PATH], path[RUN_PATH]; /* path: of the scene that it began with */
    struct scene *scene;
    const struct plan *plan;
    struct moment *moment;
    const struct method *method;
    struct method_def def;
    void *self;              /* of the method                                 */
    double *y;               /* [size] interpolated state                     */
    struct outputs *outputs;
    struct run_past past;
    struct method_pace pace; /* after the last step                           */
    double until, event;     /* end of the run, of the segment [s]            */
    double clock_start;      /* [s]                                           */
    double cpu_start;        /* [s], spent by then: libraries take some       */
    double clock_stop;       /* when a signal was noticed, 0: none [s]        */
    double clock_kept;       /* of the last checkpoint, or the start [s]      */
    struct {
        int status;
        bool asks;           /* in words of its own, not with right-hand sides */
        char message[STATUS_LINE];
    } met;                   /* by this rank alone, ranks.c                   */
    double fastest;          /* fluid, after the last step                    [m/s] */
    long rejected;           /* by methods of runs that this one goes on from */
    char table[96];
    bool force;              /* as run_order has it                           */
    struct team team;        /* threads                                       */
    long passes;             /* over pairs, after the last step               */
};

/* The state that the method has reached, of all ranks, which ask together; lent until the next
 * call. */
static inline const double *run_state(const struct run *r)
{
    return moment_whole(r->moment, r->method->state(r->self));
}

/* The same for the first rank, which writes; on others own rows alone are right. */
static inline const double *run_state_written(const struct run *r)
{
    return moment_first(r->moment, r->method->state(r->self));
}

/* Reads the scene, makes the plan and finds the method; writes nothing. */
int run_prepare(struct run *r, const struct run_order *order);
/* The same by all ranks at once, as plan_create_together() does it. */
int run_prepare_together(struct run *r, const struct run_order *order);
/* The same, but a plan that would take long to make is not made: then survey->large, and r->plan
 * is NULL. */
int run_prepare_small(struct run *r, const struct run_order *order, struct plan_survey *survey);
/* Makes no plan, counts only. */
int run_prepare_count(struct run *r, const struct run_order *order, struct plan_survey *survey);
void run_release(struct run *r);

/* What the scene releases is let go: r->y as it stands then.  Of many ranks, which do so in arrays of all particles, of
 * which each needs a part later: these are given back. */
int run_let_go(struct run *r);

/* run.json; status as in base/status.h, or RUN_GOES. */
enum { RUN_GOES = -1 };
int run_report(const struct run *r, int status, const char *message, const double *y);

/* The message [RUN_MESSAGE] of a run that ended early; for one that failed, with the cause. */
enum { RUN_MESSAGE = 3072 };
void run_explain(const struct run *r, int status, char *message);

/* Where the results of a run are and what came out, on standard output. */
void run_sum_up(const struct run *r, const struct run_order *order, int status);

/* threads.c: once, before the first step; after each, which took so many seconds by the clock. */
void run_threads_start(struct run *r, const struct run_order *order);
void run_threads_step(struct run *r, double seconds);

/* segments.c: after a step, ends a segment where one ends there, and begins the next. */
int run_next_segment(struct run *r);

/* After the step to (t, y), of own rows: least and largest of the fluid of all ranks, into r->past; then
 * what should end the run, or be heard of once, of all rows where fluid may have run away. */
void run_keep_extremes(struct run *r, double t, const double *y);
int run_watch(struct run *r, double t, const double *y);

/* Begins a run that is prepared, from its scene or from a checkpoint.  All ranks have the status
 * of the first that fails. */
int run_start(struct run *r);
int run_start_again(struct run *r, struct archive *from);

/* From the scene, or from a checkpoint, NULL: none; returns the exit status. */
int run_carry_out(const struct run_order *order, struct archive *from);

int run_write_used(const struct run *r); /* scene.used                         */
int run_constants(const struct run *r); /* for plots, see output/figures.h    */

/* Warnings: of a scene that can be run, of a run that came to its end.  STATUS_FAILED: its
 * energy came from nowhere. */
int run_doubt_scene(const struct run *r);
int run_doubt_end(const struct run *r, const double *y);
int run_doubt_hopes(const struct run *r); /* of the first kind, too */
void run_doubt_lacks(const struct run *r); /* and of effects that are missing */

/* Files of a run, but for steps.csv and figures.  STATUS_BAD_SCENE: more than the disk has. */
int run_disk_agree(const struct run *r);
/* What they would take with n particles in a lattice of spacing dx [m]. */
int run_disk_print(const struct run *r, double n, double dx);

/* CPU time of one right-hand side at r->y, the list made before: the least of some [s]. */
int run_time_rhs(struct run *r, double *seconds);

/* What each effect takes of it. */
void run_shares_print(struct run *r, const struct run_order *order, double whole);

/* What a run would cost, from a plan of the same scene with a larger spacing and so fewer
 * particles; nothing where none can be had. */
void run_sample_print(const struct run_order *order, const struct plan_survey *s);

/* Right-hand sides of a run to `until` where the fastest wave has this rate [1/s], each of which
 * takes so many seconds. */
void run_cost_print(double until, double rate, double seconds);

/* Sites that fluids left to solids; writes a line for each such fluid, NULL: nowhere. */
int run_carved(const struct run *r, FILE *to);

double run_clock(void);     /* [s] wall                                       */
double run_cpu(void);       /* [s] user and system, this process              */

#endif
