/* frames.c -- all particles at chosen times, each rank its part of them. */
#include "run/frames.h"

#include "base/status.h"
#include "eval/slice.h"
#include "output/fields.h"
#include "output/snapshot.h"
#include "ranks/ranks.h"
#include "run/looks.h"

#include <stdlib.h>
#include <string.h>

struct frames {
    struct fields *fields;     /* on the first rank                         */
    struct snapshot *snapshot;
    struct looks *looks;       /* NULL: no rigid bodies                     */
    struct slice_frame slice;  /* of particles in this rank's part of files */
    double *p;                 /* their pressure                            */
    unsigned char *kind;       /* of all, on the first rank                 */
};

static int take_slice(struct frames *f, const struct moment *moment)
{
    const size_t n = (size_t)slice_of(moment).n + 1;

    f->slice.x = status_alloc(n, sizeof *f->slice.x);
    f->slice.u = status_alloc(n, sizeof *f->slice.u);
    f->slice.rho = status_alloc(n, sizeof *f->slice.rho);
    f->p = status_alloc(n, sizeof *f->p);
    return f->slice.x && f->slice.u && f->slice.rho && f->p ? STATUS_DONE : STATUS_FAILED;
}

static int take_kinds(struct frames *f, const struct particles *all)
{
    f->kind = status_alloc((size_t)all->n + 1, 1);
    if (!f->kind)
        return STATUS_FAILED;
    for (int k = 0; k < KINDS; k++)
        memset(f->kind + all->from[k], k, particles_count(all, k));
    return STATUS_DONE;
}

static int open_files(struct frames *f, const struct moment *moment, const char *dir, bool again)
{
    const struct plan *plan = moment_plan(moment);
    const struct particles *all = plan_particles(plan);
    const struct scales *s = plan_scales(plan);

    TRY(looks_open(&f->looks, plan));
    if (all->n == 0 && !f->looks)
        return STATUS_DONE;
    TRY(take_slice(f, moment));
    TRY(take_kinds(f, all));
    TRY(fields_open(&f->fields, dir, looks_known(f->looks)));
    TRY(snapshot_open(&f->snapshot, dir, again));
    snapshot_fineness(f->snapshot, 0.3 * looks_grain(plan), 0.5 * (s->low[1] + s->high[1]));
    return STATUS_DONE;
}

int frames_open(struct frames **out, const struct moment *moment, const char *dir, bool again)
{
    *out = status_alloc(1, sizeof **out);
    if (!*out)
        return STATUS_FAILED;
    return dir ? open_files(*out, moment, dir, again) : take_slice(*out, moment);
}

int frames_keep(struct frames *f, struct archive *a)
{
    TRY(fields_keep(f->fields, a));
    return snapshot_keep(f->snapshot, a);
}

/* Particles of this rank's part, in order of ids. */
static int make(struct frames *f, struct moment *moment, double t, const double *y,
                struct cloud_frame *to)
{
    const struct plan *plan = moment_plan(moment);
    const struct particles *all = plan_particles(plan);
    const struct slice part = slice_of(moment);

    TRY(slice_take_frame(moment, t, y, &f->slice));
    plan_pressures(plan, part.n, f->slice.rho, f->p);
    *to = (struct cloud_frame){ .t = t, .n = all->n, .dim = DIM, .from = part.from, .here = part.n,
                                .shared = moment_is_packed(moment), .x = f->slice.x[0],
                                .u = f->slice.u[0], .rho = f->slice.rho, .p = f->p,
                                .dye = all->dye, .kind = f->kind,
                                .looks = looks_at(f->looks, moment, y) };
    return STATUS_DONE;
}

/* Does this rank write particle files? */
static bool takes_part(const struct frames *f, const struct moment *moment)
{
    return f && (f->fields || (ranks_me() > 0 && moment_is_packed(moment)));
}

int frames_field(struct frames *f, struct moment *moment, double t, const double *y)
{
    struct cloud_frame now;

    if (!takes_part(f, moment))
        return STATUS_DONE;
    TRY(make(f, moment, t, y, &now));
    return fields_write(f->fields, &now);
}

int frames_snapshot(struct frames *f, struct moment *moment, double t, const double *y)
{
    struct cloud_frame now;

    if (!takes_part(f, moment))
        return STATUS_DONE;
    TRY(make(f, moment, t, y, &now));
    return snapshot_write(f->snapshot, &now);
}

int frames_close(struct frames **frames)
{
    struct frames *f = *frames;
    int status;

    if (!f)
        return STATUS_DONE;
    fields_close(&f->fields);
    status = snapshot_close(&f->snapshot);
    looks_close(&f->looks);
    free(f->slice.x);
    free(f->slice.u);
    free(f->slice.rho);
    free(f->p);
    free(f->kind);
    free(f);
    *frames = NULL;
    return status;
}
