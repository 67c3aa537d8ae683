/* run.c -- one run: a sequence of accepted steps with outputs in between.
 *
 * Outputs are read off the method's dense output, so their times shift no step. */
#include "run/inside.h"

#include "base/status.h"
#include "output/progress.h"
#include "ranks/ranks.h"
#include "run/checkpoint.h"
#include "run/ranks.h"
#include "run/stop.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Outputs at times k * every (k = 0, 1, ...), but for rows; past.due has the next k. */
static const struct writer {
    int (*all)(struct outputs *o, struct moment *moment, double t, const double *y);   /* see there */
    int (*first)(struct outputs *o, struct moment *moment, double t, const double *y); /* y is whole */
} writers[RUN_DUES] = { [RUN_FIELDS] = { outputs_field, outputs_pairing },
                        [RUN_SNAPSHOTS] = { outputs_snapshot, NULL },
                        [RUN_PROFILES] = { NULL, outputs_profile } };

static const double patience = 2; /* [s] that a signal waits for the outputs of one step */

static const char *const limiters[] = { "error", "stability", "output" };

static int stopped(const struct run *r, int number, const char *files)
{
    status_fail(STATUS_STOPPED, "stopped by signal %d at t = %g s of %g s; %s", number,
                r->past.tally.t, r->until, files);
    if (r->past.checkpoints.written > 0)
        status_advise((struct status_advice){
            .remedy = "`stiffwater resume` with its directory goes on from the last checkpoint" });
    return STATUS_STOPPED;
}

/* A step may owe a million rows: too many to wait for. */
static bool is_impatient(struct run *r)
{
    if (!stop_asked() || ranks_count() > 1) /* ranks wait for each other anyhow */
        return false;
    if (r->clock_stop == 0)
        r->clock_stop = run_clock();
    return run_clock() - r->clock_stop > patience;
}

/* Found by all ranks where each has its own rows, else by the first. */
static int write_rows(struct run *r, double t, const double *own)
{
    const bool together = moment_is_packed(r->moment);
    const double *y = together ? own : moment_first(r->moment, own);

    if (!together && !run_ranks_writes())
        return STATUS_DONE;
    return outputs_rows(r->outputs, r->moment, t, y, observe_forces(r->moment, t, y));
}

static int write_other(struct run *r, const struct writer *w, double t, const double *own)
{
    const bool together = moment_is_packed(r->moment);
    const double *y = w->first || !together ? moment_first(r->moment, own) : own;
    int status = STATUS_DONE;

    if (w->first && run_ranks_writes())
        status = w->first(r->outputs, r->moment, t, y);
    if (!w->all)
        return status;
    TRY(run_ranks_agree(r, status));
    return w->all(r->outputs, r->moment, t, together ? own : y);
}

/* Every output that is due in (.., t]; at t itself the state is exact. */
static int write_due(struct run *r, double t)
{
    const double *every = r->past.every;
    const double slack = r->past.slack;

    for (int i = 0; i < RUN_DUES; i++)
        for (long *k = &r->past.due[i]; *k * every[i] <= t + slack
                                        && *k * every[i] <= r->until + slack; ++*k) {
            const double due = fmin(*k * every[i], t);
            if (is_impatient(r))
                return stopped(r, stop_asked(), "outputs that were due in the last step are missing");
            if (due < t)
                TRY(r->method->at(r->self, due, r->y));
            const double *y = due < t ? r->y : r->method->state(r->self);
            TRY(run_ranks_agree(r, i == RUN_ROWS ? write_rows(r, due, y) : write_other(r, &writers[i], due, y)));
        }
    return STATUS_DONE;
}

/* A step in space may take minutes: a signal ends it between two evaluations. */
static int step_on(struct run *r, struct method_step *step)
{
    const double end = fmin(fmin(r->event, checkpoint_next(r)), r->until);
    const int status = r->method->step(r->self, end, step);

    if (status != STATUS_FAILED || !stop_urgent() || status_is_starved())
        return status;
    status_clear();
    return stopped(r, stop_asked(), "all files are complete up to there");
}

/* After a step: what each rank does for itself, of which the others hear; what a run looks at all
 * ranks see alike, but for want of memory.  A step without memory found another way. */
static int look(struct run *r, const struct method_step *step)
{
    const bool all = outputs_reads(r->plan) || observe_may_run_away(r->moment, r->fastest);
    const double *y = all ? run_state(r) : r->method->state(r->self);
    int status;

    TRY(run_ranks_met(r, run_ranks_writes() ? outputs_step(r->outputs, r->moment, step, y) : STATUS_DONE));
    status = run_watch(r, step->t, y);
    if (!status_is_starved())
        return status;
    return run_ranks_met(r, status == STATUS_DONE ? STATUS_FAILED : status);
}

static int one_step(struct run *r, struct progress *progress)
{
    const double before = run_clock();
    struct method_step step;

    run_ranks_wish(r);
    TRY(step_on(r, &step));
    run_threads_step(r, run_clock() - before);
    step.rejected += r->rejected;
    r->pace = step.pace;
    r->past.tally.t = step.t;
    r->past.tally.steps++;
    r->past.tally.limited[step.limiter]++;
    r->past.tally.rejected = step.rejected;
    run_keep_extremes(r, step.t, r->method->state(r->self));
    progress_step(progress, step.t, step.h, limiters[step.limiter]);
    return run_ranks_heard(r, look(r, &step));
}

static int keep_when_due(struct run *r)
{
    return checkpoint_due(r) ? checkpoint_write(r) : STATUS_DONE;
}

static int first_of(int status, int next)
{
    return status != STATUS_DONE ? status : next;
}

static int report(struct run *r, int status, const char *message)
{
    const double *y = run_state_written(r);
    int constants;

    if (!run_ranks_writes())
        return STATUS_DONE;
    constants = run_constants(r);
    return first_of(constants, run_report(r, first_of(status, constants), message, y));
}

/* A run that goes on stands at a checkpoint. */
static int begin(struct run *r)
{
    TRY(write_due(r, r->past.tally.t));
    TRY(report(r, RUN_GOES, ""));
    return r->past.checkpoints.written == 0 ? keep_when_due(r) : STATUS_DONE;
}

static int go(struct run *r, struct progress *progress)
{
    r->event = plan_event(r->plan, r->past.tally.t);
    if (ranks_count() == 1) /* else one would leave the others waiting */
        moment_quit(r->moment, stop_urgent);
    TRY(begin(r));
    while (r->past.tally.t < r->until) {
        int number;

        TRY(one_step(r, progress));
        TRY(write_due(r, r->past.tally.t));
        TRY(run_next_segment(r));
        TRY(keep_when_due(r));
        TRY(run_ranks_balance(r));
        number = run_ranks_stopped(r);
        if (number && r->past.tally.t < r->until)
            return stopped(r, number, "all files are complete up to there");
    }
    return run_ranks_agree(r, STATUS_DONE);
}

/* The last row of a run that ended early: where it ended. */
static void write_end(struct run *r)
{
    double due = run_ranks_writes() && r->past.tally.t > outputs_sheet(r->outputs)->t;

    if (ranks_count() > 1)
        ranks_most(1, &due);
    if (due > 0)
        write_rows(r, r->past.tally.t, r->method->state(r->self));
}

/* The last files; the first error is told, unless the run has one. */
static int end(struct run *r, int status, const char *message)
{
    status = first_of(status, report(r, status, message));
    return first_of(status, outputs_close(&r->outputs));
}

static int doubt(struct run *r)
{
    const double *y = run_state_written(r);

    return run_ranks_writes() ? run_doubt_end(r, y) : STATUS_DONE;
}

int run_carry_out(const struct run_order *order, struct archive *from)
{
    const bool quiet = order->quiet || !run_ranks_writes();
    struct progress progress;
    char message[RUN_MESSAGE] = "";
    struct run r;
    int status;

    stop_leave();
    status = run_prepare_together(&r, order);
    if (status == STATUS_DONE)
        status = run_doubt_scene(&r);
    status = ranks_agree_after(status);
    if (status == STATUS_DONE)
        status = from ? run_start_again(&r, from) : run_start(&r);
    if (status != STATUS_DONE || !r.outputs) {
        run_release(&r);
        return status;
    }
    run_carved(&r, quiet ? NULL : stderr);
    run_threads_start(&r, order);
    progress_start(&progress, stderr, r.past.tally.t, r.until, quiet);
    status = go(&r, &progress);
    progress_end(&progress, r.past.tally.t);
    if (status != STATUS_DONE) {
        run_explain(&r, status, message);
        write_end(&r);
    }
    if (status == STATUS_DONE && (status = doubt(&r)) != STATUS_DONE)
        snprintf(message, sizeof message, "%s", status_message());
    status = end(&r, status, message);
    if (run_ranks_writes())
        run_sum_up(&r, order, status);
    run_release(&r);
    if (message[0]) {
        status_forgive();
        status_fail(status, "%s", message);
    }
    return status;
}

int run_scene(const struct run_order *order)
{
    return run_carry_out(order, NULL);
}
