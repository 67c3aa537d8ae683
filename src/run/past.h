/* past.h -- what a run knows of its past that no y says.
 *
 * A checkpoint is the end of a segment: the method's restart() and moment_restart(), in the
 * run that writes it and in the one that resumes.  Nothing else of method or moment has to be kept
 * then (tests/physics/restart.c).  It carries (run/checkpoint.c)
 *
 *   - the method's pace, which restart() takes;
 *   - t and y, quadratures of the book among them: works, impulses of forces.csv and
 *     panels.csv, energies;
 *   - the hash of the scene as it was used, the method by name, what the layout says of y;
 *   - struct run_past, with the readings that running means of probes keep
 *     (measure/running.h): those of the longest window;
 *   - what a moment has counted (moment_keep());
 *   - how long the files of tables were (series_keep()), and how many particle files there are
 *     (fields_keep(), snapshot_keep()).
 *
 * What a run comes to know beside these is to get a function X_keep() of its own, which both
 * saves and loads (base/archive.h), called by the function of the struct that it belongs to.
 *
 * Columns with memory of rows before: `defect` of book.csv (the first sheet) and `rejected` of
 * steps.csv, which the method counts from its creation; NAME.mean of probes.csv.  All others
 * follow from (t, y), but for the last bits: where it fits, looks sum over the run's list of
 * pairs. */
#ifndef RUN_PAST_H
#define RUN_PAST_H

#include "eval/observe.h"
#include "measure/running.h"
#include "plan/input.h"

/* What is counted while it goes. */
struct run_tally {
    long steps, limited[3];  /* by enum method_limiter                        */
    long rejected;
    double density[2];       /* least and largest of the fluid [kg/m^3]       */
    double speed;            /* largest of the fluid [m/s]                    */
    double t;                /* reached [s]                                   */
    long doubted[INPUT_BODIES]; /* whether a warning was of this body: 0, 1   */
};

/* What rows of tables have shown so far. */
struct run_balance {
    struct book_sheet first, last;
    bool begun;              /* there is a first one                          */
    double defect_max;       /* largest defect of energy, without its sign [J] */
    double made, most;       /* largest one above 0; see outputs_energy_most() [J] */
    struct observe_sunk sunk; /* at its worst                                 */
};

enum run_due { RUN_ROWS, RUN_FIELDS, RUN_SNAPSHOTS, RUN_PROFILES, RUN_DUES };

/* Checkpoints so far. */
struct run_checkpoints {
    long due;                /* number of the next one in simulated time      */
    long written;            /* segments that ended so, at t = 0 too          */
    long by_clock;           /* of them: because of minutes of the clock      */
};

struct run_past {
    struct run_tally tally;
    struct run_balance balance;
    struct run_checkpoints checkpoints;
    double every[RUN_DUES];  /* between outputs of each kind [s]              */
    double slack;            /* in times of outputs [s]                       */
    double spent[2];         /* at the last checkpoint: processor, clock [s]  */
    long due[RUN_DUES];      /* outputs of each kind that were due so far: the next one is
                                at so many times `every`                      */
    struct running *means;   /* readings of probes with running means; NULL: none has */
};

/* All but the means, to a checkpoint and back. */
int run_past_keep(struct run_past *p, const struct plan *plan, struct archive *a);

#endif
