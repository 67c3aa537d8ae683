/* outputs.c -- what a run leaves while it goes: tables, particle files, and the balance
 * of its book. */
#include "run/outputs.h"

#include "base/status.h"
#include "eval/slice.h"
#include "output/aside.h"
#include "output/fields.h"
#include "output/snapshot.h"
#include "ranks/ranks.h"
#include "run/columns.h"
#include "run/looks.h"
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
    struct fields *fields;
    struct snapshot *snapshot;
    struct looks *looks;     /* NULL: no rigid bodies */
    struct run_balance *balance; /* the run's */
    struct slice_frame frame; /* of particles in this rank's part of files */
    double *p;               /* their pressure                            */
    unsigned char *kind;     /* of all, on the first rank                 */
};

/* What this rank has of particle files. */
static int open_frame(struct outputs *o, const struct moment *moment)
{
    const size_t n = (size_t)slice_of(moment).n + 1;

    o->frame.x = status_alloc(n, sizeof *o->frame.x);
    o->frame.u = status_alloc(n, sizeof *o->frame.u);
    o->frame.rho = status_alloc(n, sizeof *o->frame.rho);
    o->p = status_alloc(n, sizeof *o->p);
    return o->frame.x && o->frame.u && o->frame.rho && o->p ? STATUS_DONE : STATUS_FAILED;
}

static int open_particles(struct outputs *o, const struct moment *moment, const char *dir, bool again)
{
    const struct plan *plan = moment_plan(moment);
    const struct particles *all = plan_particles(plan);
    const struct scales *s = plan_scales(plan);

    TRY(looks_open(&o->looks, plan));
    if (all->n == 0 && !o->looks)
        return STATUS_DONE;
    TRY(open_frame(o, moment));
    o->kind = status_alloc((size_t)all->n + 1, 1);
    if (!o->kind)
        return STATUS_FAILED;
    for (int k = 0; k < KINDS; k++)
        memset(o->kind + all->from[k], k, particles_count(all, k));
    TRY(fields_open(&o->fields, dir, looks_known(o->looks)));
    TRY(snapshot_open(&o->snapshot, dir, again));
    snapshot_fineness(o->snapshot, 0.3 * looks_grain(plan), 0.5 * (s->low[1] + s->high[1]));
    return STATUS_DONE;
}

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
    return open_particles(o, moment, home->dir, home->again);
}

int outputs_open(struct outputs **out, const struct moment *moment, const struct home *home,
                 struct run_past *past)
{
    *out = status_alloc(1, sizeof **out);
    if (!*out)
        return STATUS_FAILED;
    (*out)->lock = -1;
    (*out)->balance = &past->balance;
    if (ranks_me() > 0) /* the first rank has all files, others write some with it */
        return open_frame(*out, moment);
    return open_all(*out, moment, home, &past->means);
}

int outputs_keep(struct outputs *o, struct archive *a)
{
    TRY(tables_keep(o->tables, a));
    TRY(fields_keep(o->fields, a));
    return snapshot_keep(o->snapshot, a);
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

    observe_sunk(moment, t, y, &now);
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

/* Particles of this rank's part into a frame, in order of ids. */
static int frame_of(struct outputs *o, struct moment *moment, double t, const double *y,
                    struct cloud_frame *f)
{
    const struct plan *plan = moment_plan(moment);
    const struct particles *all = plan_particles(plan);
    const struct slice slice = slice_of(moment);

    TRY(slice_take_frame(moment, t, y, &o->frame));
    plan_pressures(plan, slice.n, o->frame.rho, o->p);
    *f = (struct cloud_frame){ .t = t, .n = all->n, .dim = DIM, .from = slice.from, .here = slice.n,
                               .shared = moment_is_packed(moment), .x = o->frame.x[0],
                               .u = o->frame.u[0], .rho = o->frame.rho, .p = o->p,
                               .dye = all->dye, .kind = o->kind,
                               .looks = looks_at(o->looks, moment, y) };
    return STATUS_DONE;
}

/* Does this rank write particle files? */
static bool takes_part(const struct outputs *o, const struct moment *moment)
{
    return o->fields || (ranks_me() > 0 && moment_is_packed(moment));
}

int outputs_pairing(struct outputs *o, struct moment *moment, double t, const double *y)
{
    return tables_pairing(o->tables, moment, t, y);
}

int outputs_field(struct outputs *o, struct moment *moment, double t, const double *y)
{
    struct cloud_frame f;

    if (!takes_part(o, moment))
        return STATUS_DONE;
    TRY(frame_of(o, moment, t, y, &f));
    return fields_write(o->fields, &f);
}

int outputs_snapshot(struct outputs *o, struct moment *moment, double t, const double *y)
{
    struct cloud_frame f;

    if (!takes_part(o, moment))
        return STATUS_DONE;
    TRY(frame_of(o, moment, t, y, &f));
    return snapshot_write(o->snapshot, &f);
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
    fields_close(&o->fields);
    closed = snapshot_close(&o->snapshot);
    looks_close(&o->looks);
    free(o->frame.x);
    free(o->frame.u);
    free(o->frame.rho);
    free(o->p);
    free(o->kind);
    if (o->lock >= 0)
        close(o->lock);
    free(o);
    *outputs = NULL;
    return status != STATUS_DONE ? status : closed;
}
