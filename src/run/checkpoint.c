/* checkpoint.c -- when a run is kept, what of it, and whether that is ours. */
#include "run/checkpoint.h"

#include "base/status.h"
#include "eval/slice.h"
#include "output/hash.h"
#include "ranks/ranks.h"
#include "run/ranks.h"
#include "run/saved.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

enum { MOST = 100000 }; /* checkpoints of a run */

/* --- when --------------------------------------------------------------------------- */

int checkpoint_agree(const struct run *r)
{
    const double every = plan_output(r->plan)->checkpoint;

    if (every > 0 && r->until / every > MOST)
        return status_fail(STATUS_BAD_SCENE, "output.checkpoint = %g s would be %.0f checkpoints "
                           "until %g s, more than %d: a segment ends at each; choose %g s or "
                           "more", every, r->until / every, r->until, MOST, r->until / MOST);
    return STATUS_DONE;
}

double checkpoint_next(const struct run *r)
{
    const double every = plan_output(r->plan)->checkpoint;

    return every > 0 ? (double)r->past.checkpoints.due * every : HUGE_VAL;
}

static bool clock_says_so(const struct run *r)
{
    const double minutes = plan_output(r->plan)->checkpoint_minutes;

    double late = minutes > 0 && run_clock() - r->clock_kept >= 60 * minutes;

    if (minutes > 0) /* clocks of ranks differ */
        ranks_most(1, &late);
    return late > 0;
}

/* One at the end, too, so that a run can be made longer. */
bool checkpoint_due(const struct run *r)
{
    const struct settings_output *o = plan_output(r->plan);

    if (!(o->checkpoint > 0 || o->checkpoint_minutes > 0))
        return false;
    return r->past.tally.t >= checkpoint_next(r) || r->past.tally.t >= r->until
           || clock_says_so(r);
}

/* --- what --------------------------------------------------------------------------- */

/* Blocks of y, a line each. */
static char *describe_layout(const struct run *r)
{
    const struct layout *l = moment_layout(r->moment);
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    for (int i = 0; i < l->rows; i++)
        fprintf(to, "%s: %d of %d\n", l->row[i].name, l->row[i].n, l->row[i].components);
    if (fclose(to) == 0)
        return text;
    free(text);
    return NULL;
}

/* y goes by id. */
static int keep_state(struct run *r, struct archive *a)
{
    TRY(archive_numbers_elsewhere(a, "y", r->y, moment_size(r->moment)));
    TRY(archive_numbers(a, "t", &r->past.tally.t, 1));
    TRY(archive_numbers(a, "pace", &r->pace.h, 1));
    TRY(archive_numbers(a, "pace.error", r->pace.error, 2));
    return moment_keep(r->moment, a);
}

/* Of the tables, only the rank that writes them knows. */
static int keep_past(struct run *r, struct archive *a)
{
    TRY(archive_text(a, "path", r->path, sizeof r->path));
    TRY(run_past_keep(&r->past, r->plan, a));
    if (!run_ranks_writes())
        return STATUS_DONE;
    TRY(running_keep(r->past.means, a));
    return outputs_keep(r->outputs, a);
}

/* Whose it is. */
static int sign(struct run *r, struct archive *a)
{
    char version[] = PACKAGE_VERSION, scene[HASH_TEXT], *layout = describe_layout(r);
    int status = layout ? archive_text(a, "layout", layout, 0)
                        : status_starved("a checkpoint cannot be made");

    free(layout);
    TRY(status);
    TRY(saved_scene(r->directory, scene));
    TRY(archive_text(a, "scene", scene, 0));
    TRY(archive_text(a, "version", version, 0));
    TRY(archive_add(a, "method", ARCHIVE_TEXT, (long)strlen(r->method->name), r->method->name));
    return archive_numbers(a, "until", &r->until, 1);
}

static int fill(struct run *r, struct archive *a)
{
    TRY(sign(r, a));
    TRY(keep_state(r, a));
    return keep_past(r, a);
}

/* --- writing ------------------------------------------------------------------------ */

/* What each rank has of y. */
static int save_pieces(struct run *r, const struct archive *a, const struct slice_state *y)
{
    struct piece piece[SLICE_PIECES];
    const struct pieces all = { moment_is_packed(r->moment), y->pieces, piece };

    for (int i = 0; i < y->pieces; i++)
        piece[i] = (struct piece){ .from = y->piece[i].at, .n = y->piece[i].n,
                                   .bytes = sizeof(double), .fill = pieces_numbers,
                                   .self = y->piece[i].value };
    return a || all.shared ? saved_write(r->directory, a, &all) : STATUS_DONE;
}

/* A checkpoint that cannot be written does not end a run. */
static void save(struct run *r, const struct archive *a, const struct slice_state *y)
{
    if (save_pieces(r, a, y) == STATUS_DONE)
        return;
    status_warn("no checkpoint at t = %g s: %s; the run goes on, the checkpoint before stays",
                r->past.tally.t, status_message());
    status_forgive();
}

static void count(struct run *r)
{
    struct run_checkpoints *c = &r->past.checkpoints;
    const double t = r->past.tally.t;

    c->written++;
    c->by_clock += t < checkpoint_next(r) && t < r->until;
    while (checkpoint_next(r) <= t)
        c->due++;
}

/* On the first rank all but y; tables that cannot be written end a run as ever. */
static int make(struct run *r, const char *because, struct archive **a)
{
    int status;

    *a = NULL;
    if (!run_ranks_writes())
        return STATUS_DONE;
    status = outputs_checkpoint(r->outputs, r->past.tally.t, because);
    if (status == STATUS_DONE)
        status = archive_create(a);
    return status == STATUS_DONE ? fill(r, *a) : status;
}

static int write_all(struct run *r, bool by_clock)
{
    const double *own = r->method->state(r->self);
    const double *state = moment_is_packed(r->moment) ? own : run_state_written(r);
    struct slice_state y = { .pieces = 0 };
    struct archive *a;
    int status = run_ranks_agree(r, make(r, by_clock ? "clock" : "time", &a));

    if (status == STATUS_DONE)
        status = slice_take_state(r->moment, state, r->y, &y);
    if (status == STATUS_DONE)
        save(r, a, &y);
    slice_free_state(&y);
    archive_free(&a);
    return status;
}

int checkpoint_write(struct run *r)
{
    const double t = r->past.tally.t;
    const bool by_clock = t < checkpoint_next(r) && t < r->until;

    r->past.spent[0] = run_cpu() - r->cpu_start;
    r->past.spent[1] = run_clock() - r->clock_start;
    count(r);
    TRY(run_ranks_agree(r, write_all(r, by_clock)));
    r->clock_kept = run_clock();
    r->event = plan_event(r->plan, t);
    moment_restart(r->moment);
    return r->method->restart(r->self, t, r->method->state(r->self), &r->pace);
}

/* --- loading ------------------------------------------------------------------------ */

/* The text `name` of the checkpoint is `expected`; else STATUS_IO with `why`. */
static int agree(struct archive *a, const char *dir, const char *name, const char *expected,
                 const char *why)
{
    char *found = status_alloc(65536, 1);
    int status;

    if (!found)
        return STATUS_FAILED;
    status = archive_text(a, name, found, 65536);
    if (status == STATUS_DONE && strcmp(found, expected) != 0)
        status = status_fail(STATUS_IO, "%s: the checkpoint's %s is not that of this run, %s", dir,
                             name, why);
    free(found);
    return status;
}

int checkpoint_check(const char *dir, struct archive *a, double *until)
{
    char version[64], scene[HASH_TEXT];

    TRY(archive_text(a, "version", version, sizeof version));
    if (strcmp(version, PACKAGE_VERSION) != 0)
        return status_fail(STATUS_IO, "%s: version %s wrote the checkpoint, this is %s, which may "
                           "compute other numbers: go on with that version, or run the scene anew",
                           dir, version, PACKAGE_VERSION);
    TRY(saved_scene(dir, scene));
    TRY(agree(a, dir, "scene", scene, "scene.used was changed since: put it back as it was, or "
              "run the scene anew"));
    return archive_numbers(a, "until", until, 1);
}

int checkpoint_load_state(struct run *r, struct archive *a)
{
    char *layout = describe_layout(r);
    int status = layout ? agree(a, r->directory, "layout", layout, "y has other blocks: another "
                                "build of this version wrote it; go on with that one")
                        : status_starved("a checkpoint cannot be made");

    free(layout);
    TRY(status);
    TRY(agree(a, r->directory, "method", r->method->name, "which another build of this version "
              "chose; go on with that one"));
    TRY(keep_state(r, a));
    if (r->past.tally.t > r->until)
        return status_fail(STATUS_BAD_SCENE, "%s: that run has come to t = %g s already, later "
                           "than until = %g s", r->directory, r->past.tally.t, r->until);
    return STATUS_DONE;
}

int checkpoint_load_past(struct run *r, struct archive *a)
{
    archive_try(a, true);
    TRY(keep_past(r, a));
    if (run_ranks_writes())
        TRY(archive_spent(a));
    archive_try(a, false);
    TRY(keep_past(r, a));
    r->rejected = r->past.tally.rejected;
    r->clock_start -= r->past.spent[1];
    r->cpu_start -= r->past.spent[0];
    return STATUS_DONE;
}
