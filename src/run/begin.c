/* begin.c -- a run begins, from its scene or from a checkpoint: what can be refused, then memory,
 * then files. */
#include "run/inside.h"

#include "base/status.h"
#include "eval/balance.h"
#include "implicit/release.h"
#include "plan/memory.h"
#include "ranks/ranks.h"
#include "run/checkpoint.h"
#include "run/ranks.h"
#include "run/stop.h"
#include "run/tables.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

static const double never = DBL_MAX; /* [s]: whatever until= a run is resumed with */

static void choose_times(struct run *r)
{
    const struct settings_output *o = plan_output(r->plan);
    double *every = r->past.every;

    every[RUN_ROWS] = isnan(o->interval) ? r->until / 500 : o->interval;
    every[RUN_FIELDS] = isnan(o->fields) ? r->until / 50 : o->fields;
    every[RUN_SNAPSHOTS] = o->snapshots > 1 ? r->until / (o->snapshots - 1) : never;
    every[RUN_PROFILES] = !plan_profiles(r->plan) ? never
                        : isnan(o->profiles) ? r->until / 50 : o->profiles;
    r->past.slack = 1e-9 * r->until;
    if (o->snapshots == 0)
        r->past.due[RUN_SNAPSHOTS] = 1;
    if (!plan_profiles(r->plan))
        r->past.due[RUN_PROFILES] = 1;
}

static int create_method(struct run *r)
{
    char constant[40] = "";

    TRY(r->method->create(r->method, &r->def, r->moment, r->past.tally.t, r->y, &r->self));
    if (r->def.seconds > 0)
        snprintf(constant, sizeof constant, ", steps of %g s", r->def.seconds);
    snprintf(r->table, sizeof r->table, "%s%s",
             r->method->table ? r->method->table(r->self) : "", constant);
    return STATUS_DONE;
}

/* A start that has no answer is refused before there are files.  One that has is shared anew between ranks,
 * by its pairs. */
static int try_start(struct run *r)
{
    struct moment_trial was;
    int status;

    if (moment_try(r->moment, 0, r->y, &was) == STATUS_DONE) {
        status = run_ranks_balance(r);
        moment_tried(r->moment, &was);
        balance_count(r->moment);
        return status;
    }
    return status_fail_with(STATUS_FAILED, (struct status_advice){
        .remedy = "for a density that lies outside, try a higher eos.c0 or wider eos.lowest and "
                  "eos.highest; else look at what the scene starts with" }, "the start has no right-hand side: %s; nothing was "
                  "written", moment_refusal(r->moment));
}

static int open_outputs(struct run *r, bool again)
{
    const struct home home = { .dir = r->directory, .scene = r->path, .force = r->force,
                               .again = again };

    stop_listen();
    return outputs_open(&r->outputs, r->moment, &home, &r->past);
}

static void keep_once(void *self, const void *array, size_t bytes)
{
    (void)self;
    ranks_alike(array, bytes);
}

int run_let_go(struct run *r)
{
    TRY(release_start(r->moment, r->y));
    return ranks_agree(ranks_count() > 1 ? moment_renew(&r->moment) : STATUS_DONE);
}

/* What can be refused before ranks share anything. */
static int agree(struct run *r)
{
    TRY(checkpoint_agree(r));
    TRY(run_disk_agree(r));
    return tables_agree(r->plan);
}

/* One of many ranks needs its own rows of r->y alone from now on: the rest gives its memory back. */
static int forget_others(struct run *r)
{
    if (!moment_is_packed(r->moment))
        return STATUS_DONE;
    free(r->y);
    r->y = status_alloc(plan_size(r->plan), sizeof *r->y);
    return r->y ? STATUS_DONE : STATUS_FAILED;
}

static int write_start(struct run *r)
{
    if (!run_ranks_writes())
        return STATUS_DONE;
    TRY(outputs_start(r->outputs, r->moment, 0, r->y));
    return run_write_used(r);
}

int run_start(struct run *r)
{
    TRY(ranks_agree(agree(r)));
    plan_show(r->plan, keep_once, NULL); /* a plan is the same on all ranks */
    TRY(run_let_go(r));
    TRY(moment_share(r->moment, r->y, run_ranks_rows(r)));
    run_ranks_begin(r);
    TRY(try_start(r));
    TRY(ranks_agree(create_method(r)));
    choose_times(r);
    TRY(ranks_agree(open_outputs(r, false)));
    run_keep_extremes(r, 0, r->y);
    TRY(ranks_agree(write_start(r)));
    return ranks_agree(forget_others(r));
}

static int agree_again(struct run *r, struct archive *from)
{
    TRY(checkpoint_agree(r));
    return checkpoint_load_state(r, from);
}

int run_start_again(struct run *r, struct archive *from)
{
    TRY(ranks_agree(agree_again(r, from)));
    plan_show(r->plan, keep_once, NULL); /* a plan is the same on all ranks */
    TRY(moment_share(r->moment, r->y, run_ranks_rows(r)));
    TRY(ranks_agree(create_method(r)));
    TRY(r->method->restart(r->self, r->past.tally.t, r->y, &r->pace));
    run_ranks_begin(r);
    TRY(ranks_agree(open_outputs(r, true)));
    TRY(ranks_agree(checkpoint_load_past(r, from)));
    return ranks_agree(forget_others(r));
}
