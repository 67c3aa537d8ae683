/* run.c -- one run: a sequence of accepted steps with outputs in between.
 *
 * Outputs are read off the method's dense output, so their times shift no step. */
#include "run/inside.h"

#include "base/status.h"
#include "implicit/release.h"
#include "output/aside.h"
#include "output/progress.h"
#include "run/stop.h"
#include "scene/scene.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Times k * every (k = 0, 1, ...) of one kind of output; past.due has the next k. */
struct ticks {
    double every; /* [s] */
    int (*write)(struct outputs *o, struct moment *moment, double t, const double *y);
};

enum { MESSAGE = 3072 };

static const double patience = 2; /* [s] that a signal waits for the outputs of one step */

static const char *const limiters[] = { "error", "stability", "output" };

static void make_ticks(struct run *r, struct ticks tick[RUN_DUES])
{
    const struct settings_output *o = plan_output(r->plan);

    tick[RUN_ROWS] = (struct ticks){ isnan(o->interval) ? r->until / 500 : o->interval,
                                     outputs_rows };
    tick[RUN_FIELDS] = (struct ticks){ isnan(o->fields) ? r->until / 50 : o->fields,
                                       outputs_field };
    tick[RUN_SNAPSHOTS] = (struct ticks){
        o->snapshots > 1 ? r->until / (o->snapshots - 1) : 2 * r->until, outputs_snapshot };
    tick[RUN_PROFILES] = (struct ticks){
        !plan_profiles(r->plan) ? 2 * r->until : isnan(o->profiles) ? r->until / 50 : o->profiles,
        outputs_profile };
    if (o->snapshots == 0)
        r->past.due[RUN_SNAPSHOTS] = 1;
    if (!plan_profiles(r->plan))
        r->past.due[RUN_PROFILES] = 1;
}

static int stopped(const struct run *r, const char *files)
{
    return status_fail(STATUS_STOPPED, "stopped by signal %d at t = %g s of %g s; %s", stop_asked(),
                       r->past.tally.t, r->until, files);
}

/* A step may owe a million rows: too many to wait for. */
static bool is_impatient(struct run *r)
{
    if (!stop_asked())
        return false;
    if (r->clock_stop == 0)
        r->clock_stop = run_clock();
    return run_clock() - r->clock_stop > patience;
}

/* Every output that is due in (.., t]; at t itself the state is exact. */
static int write_due(struct run *r, struct ticks tick[RUN_DUES], double t)
{
    const double *end = r->method->state(r->self);
    const double slack = 1e-9 * r->until;

    for (int i = 0; i < RUN_DUES; i++)
        for (long *k = &r->past.due[i]; *k * tick[i].every <= t + slack
                                        && *k * tick[i].every <= r->until + slack; ++*k) {
            const double due = fmin(*k * tick[i].every, t);
            if (is_impatient(r))
                return stopped(r, "outputs that were due in the last step are missing");
            if (due < t)
                TRY(r->method->at(r->self, due, r->y));
            TRY(tick[i].write(r->outputs, r->moment, due, due < t ? r->y : end));
        }
    return STATUS_DONE;
}

static void keep_density(struct run *r, double t, const double *y)
{
    struct view v;
    int n;

    observe_fluid(r->moment, t, y, &v);
    n = v.rho[KIND_FLUID] ? particles_count(v.p, KIND_FLUID) : 0;
    for (int i = 0; i < n; i++) {
        const double rho = v.rho[KIND_FLUID][i];
        if (rho < r->past.tally.density[0])
            r->past.tally.density[0] = rho;
        if (rho > r->past.tally.density[1])
            r->past.tally.density[1] = rho;
    }
}

/* What should end a run, or be heard of once, after a step. */
static int watch(struct run *r, double t, const double *y)
{
    char doubt[300];

    for (int i = 0; i < plan_bodies(r->plan); i++) {
        TRY(observe_judge(r->moment, i, t, y, doubt, sizeof doubt));
        if (doubt[0] && !(r->past.tally.doubted & 1u << i))
            status_warn("%s", doubt);
        r->past.tally.doubted |= (unsigned)(doubt[0] != '\0') << i;
    }
    TRY(observe_meeting(r->moment, t, y));
    return observe_runaway(r->moment, t, y);
}

static int one_step(struct run *r, struct progress *progress)
{
    struct method_step step;

    TRY(r->method->step(r->self, fmin(r->event, r->until), &step));
    r->past.tally.t = step.t;
    r->past.tally.steps++;
    r->past.tally.limited[step.limiter]++;
    r->past.tally.rejected = step.rejected;
    keep_density(r, step.t, r->method->state(r->self));
    progress_step(progress, step.t, step.h, limiters[step.limiter]);
    TRY(outputs_step(r->outputs, r->moment, &step, r->method->state(r->self)));
    return watch(r, step.t, r->method->state(r->self));
}

/* Where f jumps a segment ends, and the method starts anew. */
static int next_segment(struct run *r)
{
    if (r->past.tally.t < r->event)
        return STATUS_DONE;
    r->event = plan_event(r->plan, r->past.tally.t);
    return r->method->restart(r->self, r->past.tally.t, r->method->state(r->self));
}

static int go(struct run *r, struct progress *progress)
{
    struct ticks tick[RUN_DUES];

    make_ticks(r, tick);
    r->event = plan_event(r->plan, 0);
    TRY(write_due(r, tick, 0));
    while (r->past.tally.t < r->until) {
        TRY(one_step(r, progress));
        TRY(write_due(r, tick, r->past.tally.t));
        TRY(next_segment(r));
        if (stop_asked() && r->past.tally.t < r->until)
            return stopped(r, "all files are complete up to there");
    }
    return STATUS_DONE;
}

static int write_used(const struct run *r)
{
    char path[ASIDE_PATH];
    struct aside file;
    int status;

    TRY(aside_join(path, r->directory, "scene.used"));
    TRY(aside_open(&file, path));
    status = scene_write_used(r->scene, file.to);
    TRY(aside_close(&file));
    return status;
}

static int start(struct run *r)
{
    char constant[40] = "";

    TRY(release_start(r->moment, r->y));
    TRY(r->method->create(r->method, &r->def, r->moment, 0, r->y, &r->self));
    if (r->def.seconds > 0)
        snprintf(constant, sizeof constant, ", steps of %g s", r->def.seconds);
    snprintf(r->table, sizeof r->table, "%s%s",
             r->method->table ? r->method->table(r->self) : "", constant);
    TRY(outputs_open(&r->outputs, r->plan, r->directory, &r->past));
    keep_density(r, 0, r->y);
    TRY(outputs_start(r->outputs, r->moment, 0, r->y));
    return write_used(r);
}

/* The last row of a run that ended early: where it ended. */
static void write_end(struct run *r)
{
    const double *y = r->method->state(r->self);

    if (r->past.tally.t > outputs_sheet(r->outputs)->t)
        outputs_rows(r->outputs, r->moment, r->past.tally.t, y);
}

/* A constant step is the choice of the user alone. */
static void doubt_step(const struct run *r)
{
    struct limit limit[2];
    char cause[160];
    double rate;

    if (!(r->def.seconds > 0) || status_has_cause())
        return;
    moment_limit(r->moment, r->past.tally.t, r->method->state(r->self), plan_stiff(r->plan), limit);
    rate = fmax(limit[0].rate, limit[1].rate);
    snprintf(cause, sizeof cause, "The constant step of %g s is %.3g times 1/(fastest rate) there; "
             "bounds of stability lie between 1 and 5", r->def.seconds, r->def.seconds * rate);
    status_advise((struct status_advice){ cause, "try a shorter step" });
}

/* What to try, unless the failure says it. */
static void advise(const struct run *r)
{
    if (status_has_remedy())
        return;
    status_advise((struct status_advice){
        .remedy = r->past.tally.steps == 0
            ? "That is the start itself: try a higher eos.c0 or wider eos.lowest and eos.highest, "
              "or look at what the scene starts with"
            : "Things to try: shorter steps (a smaller tol or CFL number), a higher eos.c0, more "
              "viscosity or density diffusion, a smaller spacing" });
}

/* The message of a run that ended early; for one that failed, with the cause. */
static void explain(const struct run *r, int status, char message[MESSAGE])
{
    char why[MESSAGE / 3] = "";

    if (status == STATUS_FAILED) {
        doubt_step(r);
        advise(r);
    }
    snprintf(message, MESSAGE, "%.*s", MESSAGE / 2, status_message());
    if (status == STATUS_FAILED)
        observe_blame(r->moment, r->past.tally.t, r->method->state(r->self), why, sizeof why);
    if (why[0])
        snprintf(message + strlen(message), MESSAGE - strlen(message), ". Cause: %s", why);
}

int run_scene(const struct run_order *order)
{
    struct progress progress;
    char message[MESSAGE] = "";
    struct run r;
    int status, last;

    status = run_prepare(&r, order);
    if (status == STATUS_DONE)
        status = run_doubt_scene(&r);
    if (status == STATUS_DONE)
        status = start(&r);
    if (status != STATUS_DONE || !r.outputs) {
        run_release(&r);
        return status;
    }
    stop_listen();
    run_carved(&r, order->quiet ? NULL : stderr);
    progress_start(&progress, stderr, 0, r.until, order->quiet);
    status = go(&r, &progress);
    progress_end(&progress, r.past.tally.t);
    if (status != STATUS_DONE) {
        explain(&r, status, message);
        write_end(&r);
    }
    if (status == STATUS_DONE && (status = run_doubt_end(&r)) != STATUS_DONE)
        snprintf(message, sizeof message, "%s", status_message());
    last = run_constants(&r);
    if (status == STATUS_DONE)
        status = last;
    last = run_report(&r, status, message, r.method->state(r.self));
    if (status == STATUS_DONE)
        status = last;
    last = outputs_close(&r.outputs);
    if (status == STATUS_DONE)
        status = last;
    run_release(&r);
    if (message[0]) {
        status_clear();
        status_fail(status, "%s", message);
    }
    return status;
}
