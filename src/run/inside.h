/* inside.h -- a run as the files of this room see it. */
#ifndef RUN_INSIDE_H
#define RUN_INSIDE_H

#include "eval/observe.h"
#include "run/outputs.h"
#include "run/past.h"
#include "run/run.h"
#include "time/method.h"

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
    double until, event;     /* end of the run, of the segment [s]            */
    double clock_start;      /* [s]                                           */
    double cpu_start;        /* [s], spent by then: libraries take some       */
    double clock_stop;       /* when a signal was noticed, 0: none [s]        */
    double clock_kept;       /* of the last checkpoint, or the start [s]      */
    long rejected;           /* by methods of runs that this one goes on from */
    char table[96];
    bool force;              /* as run_order has it                           */
};

/* Reads the scene, makes the plan and finds the method; writes nothing. */
int run_prepare(struct run *r, const struct run_order *order);
void run_release(struct run *r);

/* run.json; status as in base/status.h, or RUN_GOES. */
enum { RUN_GOES = -1 };
int run_report(const struct run *r, int status, const char *message, const double *y);

/* The message [RUN_MESSAGE] of a run that ended early; for one that failed, with the cause. */
enum { RUN_MESSAGE = 3072 };
void run_explain(const struct run *r, int status, char *message);

/* From the scene, or from a checkpoint, NULL: none; returns the exit status. */
int run_carry_out(const struct run_order *order, struct archive *from);

int run_constants(const struct run *r); /* for plots, see output/figures.h    */

/* Warnings: of a scene that can be run, of a run that came to its end.  STATUS_FAILED: its
 * energy came from nowhere. */
int run_doubt_scene(const struct run *r);
int run_doubt_end(const struct run *r);

double run_clock(void);     /* [s] wall                                       */
double run_cpu(void);       /* [s] user and system, this process              */

#endif
