/* outputs.c -- what a run leaves while it goes: tables, particle files, and the balance
 * of its book. */
#include "run/outputs.h"

#include "base/status.h"
#include "output/aside.h"
#include "ranks/ranks.h"
#include "run/columns.h"
#include "run/frames.h"
#include "run/saved.h"
#include "run/tables.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

struct outputs {
    int lock; /* the directory, held against other runs; -1: not held */
    struct tables *tables;
    struct frames *frames;
    struct run_balance *balance; /* the run's */
};

/* Two runs in one directory would mix their rows.  A file system that knows no
 * locks has none. */
static int lock_directory(struct outputs *o, const char *dir)
{
    TRY(aside_directory(dir));
    o->lock = open(dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (o->lock >= 0 && flock(o->lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return status_fail(STATUS_IO, "%s: another run is writing there; wait until it has ended, "
                           "or choose another directory (-o)", dir);
    return STATUS_DONE;
}

static int open_all(struct outputs *o, const struct moment *moment, const struct home *home,
                    struct running **means)
{
    TRY(lock_directory(o, home->dir));
    if (!home->again)
        TRY(saved_refuse(home->dir));
    TRY(home_take(home));
    TRY(tables_open(&o->tables, moment_plan(moment), home->dir, means, home->again));
    return frames_open(&o->frames, moment, home->dir, home->again);
}

/* The first rank has all files: others look with it, and write particles. */
static int open_none(struct outputs *o, const struct moment *moment, struct running **means)
{
    if (!moment_is_packed(moment))
        return STATUS_DONE;
    TRY(tables_open_none(&o->tables, moment_plan(moment), means));
    return frames_open(&o->frames, moment, NULL, false);
}

int outputs_open(struct outputs **out, const struct moment *moment, const struct home *home,
                 struct run_past *past)
{
    *out = status_alloc(1, sizeof **out);
    if (!*out)
        return STATUS_FAILED;
    (*out)->lock = -1;
    (*out)->balance = &past->balance;
    if (ranks_me() > 0)
        return open_none(*out, moment, &past->means);
    return open_all(*out, moment, home, &past->means);
}

int outputs_keep(struct outputs *o, struct archive *a)
{
    TRY(tables_keep(o->tables, a));
    return frames_keep(o->frames, a);
}

/* Energy of a row that the book explains [J]: that above all fluid in the lowest
 * corner of the domain, or of what moves and is bent, where beams sink or are loaded; no
 * less than that of fluid at U/100. */
static double energy_there(const struct book_sheet *last, const struct plan *plan)
{
    const struct scales *s = plan_scales(plan);
    double lowest = 0, most; /* gravity's potential [J/kg] */

    for (int d = 0; d < DIM; d++)
        lowest += fmin(-s->g[d] * s->low[d], -s->g[d] * s->high[d]);
    most = fmax(last->total - last->mass * lowest, last->energy.kinetic + last->energy.elastic)
         - last->defect;
    return fmax(most, 0.5 * last->mass * 1e-4 * s->speed * s->speed);
}

static void look_for_sunk(struct outputs *o, struct moment *moment, double t, const double *y)
{
    struct observe_sunk now;

    observe_sunk_together(moment, t, y, &now);
    if (now.n > o->balance->sunk.n)
        o->balance->sunk = now;
}

int outputs_rows(struct outputs *o, struct moment *moment, double t, const double *y, int forces)
{
    struct run_balance *b = o->balance;

    observe_sheet(moment, t, y, &b->last);
    if (!b->begun)
        b->first = b->last;
    b->begun = true;
    b->last.defect = book_defect(&b->first, &b->last);
    b->defect_max = fmax(b->defect_max, fabs(b->last.defect));
    b->made = fmax(b->made, b->last.defect);
    b->most = fmax(b->most, energy_there(&b->last, moment_plan(moment)));
    look_for_sunk(o, moment, t, y);
    if (forces == STATUS_DONE)
        tables_look(o->tables, moment, t, y);
    if (ranks_me() > 0)
        return forces;
    return tables_rows(o->tables, moment, t, y, &b->last, forces);
}

int outputs_start(struct outputs *o, struct moment *moment, double t, const double *y)
{
    return tables_readings(o->tables, moment, t, y);
}

/* Running means are taken of all steps. */
bool outputs_reads(const struct plan *plan)
{
    bool reads = false;

    for (int i = 0; i < plan_probes(plan); i++) {
        const char *name;
        reads |= plan_probe(plan, i, &name)->window > 0;
    }
    return reads;
}

int outputs_step(struct outputs *o, struct moment *moment, const struct method_step *step,
                 const double *y)
{
    TRY(tables_step(o->tables, step));
    return tables_readings(o->tables, moment, step->t, y);
}

int outputs_checkpoint(struct outputs *o, double t, const char *because)
{
    return tables_checkpoint(o->tables, t, because);
}

int outputs_profile(struct outputs *o, struct moment *moment, double t, const double *y)
{
    return tables_profile(o->tables, moment, t, y);
}

int outputs_pairing(struct outputs *o, struct moment *moment, double t, const double *y)
{
    return tables_pairing(o->tables, moment, t, y);
}

int outputs_field(struct outputs *o, struct moment *moment, double t, const double *y)
{
    return frames_field(o->frames, moment, t, y);
}

int outputs_snapshot(struct outputs *o, struct moment *moment, double t, const double *y)
{
    return frames_snapshot(o->frames, moment, t, y);
}

const struct book_sheet *outputs_sheet(const struct outputs *o)
{
    return &o->balance->last;
}

double outputs_energy_initial(const struct outputs *o)
{
    return o->balance->first.total;
}

double outputs_defect(const struct outputs *o)
{
    return o->balance->last.defect;
}

double outputs_defect_max(const struct outputs *o)
{
    return o->balance->defect_max;
}

double outputs_energy_made(const struct outputs *o)
{
    return o->balance->made;
}

double outputs_energy_most(const struct outputs *o)
{
    return o->balance->most;
}

const struct observe_sunk *outputs_sunk(const struct outputs *o)
{
    return &o->balance->sunk;
}

double outputs_momentum_defect(const struct outputs *o)
{
    return book_momentum_defect(&o->balance->first, &o->balance->last);
}

int outputs_close(struct outputs **outputs)
{
    struct outputs *o = *outputs;
    int status, closed;

    if (!o)
        return STATUS_DONE;
    status = tables_close(&o->tables);
    closed = frames_close(&o->frames);
    if (o->lock >= 0)
        close(o->lock);
    free(o);
    *outputs = NULL;
    return status != STATUS_DONE ? status : closed;
}
