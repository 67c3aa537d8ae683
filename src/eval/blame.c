/* blame.c -- when a run fails: for which particle, and which part did most to it in the
 * last accepted state.
 *
 * That is the particle that the last refusal named, if it was of a moment not before that
 * state; else the one of the fluid that is pushed hardest. */
#include "eval/inside.h"

#include "base/status.h"
#include "space/laws.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is being looked at. */
struct blame {
    struct moment *m;
    const struct view *v;
    struct pairs_table *table; /* [KINDS][KINDS] laws of one column            */
    double (*rate)[DIM];       /* [fluid] of one body force [m/s^2]            */
    int particle;                   /* its row, of all kinds                        */
    bool density;              /* its density counts, else its acceleration    */
};

/* What a part does to it: [m/s^2], [kg/m^D/s]. */
struct deed {
    const struct plan_part *part; /* NULL: none                                */
    double rate;                  /* NAN: it has no rate, it makes the density */
};

static double size_of(const double *v)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += v[d] * v[d];
    return sqrt(square);
}

/* The tables with the laws of one column only. */
static void keep_slot(const struct plan *p, int slot, struct pairs_table *table)
{
    for (int i = 0; i < KINDS * KINDS; i++) {
        const struct pairs_table *all = &p->table.all[i];
        struct pairs_table *one = &table[i];

        one->n = 0;
        one->needs = all->needs;
        for (int k = 0; k < all->n; k++)
            if (all->work[k].slot == slot) {
                one->work[one->n] = all->work[k];
                one->work[one->n++].needs = all->needs;
            }
        p->engine->sum->arrange(one, false);
    }
}

/* Sums over pairs by the laws of one column (-1: by all). */
static int sum_of(const struct blame *b, int slot)
{
    const struct plan *p = b->m->plan;
    struct workspace *w = b->m->work;
    struct sum_job job = {
        .list = b->m->list, .record = w->record, .mass = p->table.mass, .table = p->table.all,
        .slots = p->slots,
        .f = w->f, .drho = w->drho, .power = w->power,
    };

    if (slot >= 0) {
        keep_slot(p, slot, b->table);
        job.table = b->table;
    }
    return p->engine->sum->pairs(&job, &w->scratch);
}

static double force_on(const struct blame *b, int s)
{
    return size_of(b->m->work->f + (size_t)s * DIM) / b->m->particles->m[b->m->list->order[s]];
}

static int hardest(const struct blame *b)
{
    const struct list *l = b->m->list;
    double most = -1;
    int where = -1;

    for (int s = l->start[KIND_FLUID]; s < l->start[KIND_FLUID + 1]; s++)
        if (force_on(b, s) > most) {
            most = force_on(b, s);
            where = l->order[s];
        }
    return where;
}

/* By the sums that are there. */
static double rate_now(const struct blame *b)
{
    const int s = b->m->list->slot[b->particle];

    if (s < 0) /* has left the domain */
        return 0;
    return b->density ? fabs(b->m->work->drho[s]) : force_on(b, s);
}

static double field_rate(const struct blame *b, const struct plan_part *part)
{
    const int n = particles_count(b->m->particles, KIND_FLUID);

    if (b->density || b->particle >= b->m->particles->from[KIND_FLUID + 1])
        return 0;
    memset(b->rate, 0, (size_t)n * sizeof *b->rate);
    part->part->as.force->accelerate(part->self, b->v, 0, n, b->rate);
    return size_of(b->rate[b->particle]);
}

static double source_rate(const struct blame *b, const struct plan_part *part)
{
    const int n = particles_count(b->m->particles, KIND_FLUID);
    double *rate = b->rate[0];

    if (!b->density || b->particle >= b->m->particles->from[KIND_FLUID + 1])
        return 0;
    memset(rate, 0, (size_t)n * sizeof *rate);
    part->part->as.source->densify(part->self, b->v, 0, n, rate);
    return fabs(rate[b->particle]);
}

static int part_rate(const struct blame *b, const struct plan_part *part, double *rate)
{
    *rate = 0;
    if (part->part->as.law) {
        TRY(sum_of(b, part->slot));
        *rate = rate_now(b);
    }
    if (part->part->as.force)
        *rate += field_rate(b, part);
    if (part->part->as.source)
        *rate += source_rate(b, part);
    return STATUS_DONE;
}

/* The part that does most; none, if nothing is done or what is done has no size. */
static int find_worst(const struct blame *b, struct deed *worst)
{
    *worst = (struct deed){ 0 };
    for (int i = 0; i < b->m->plan->parts; i++) {
        double rate;
        TRY(part_rate(b, &b->m->plan->part[i], &rate));
        if (!isfinite(rate)) {
            *worst = (struct deed){ NULL, rate };
            return STATUS_DONE;
        }
        if (rate > worst->rate)
            *worst = (struct deed){ &b->m->plan->part[i], rate };
    }
    return STATUS_DONE;
}

/* A density that is no state comes from a part that sums. */
static const struct plan_part *summer(const struct plan *p, enum kind k)
{
    for (int i = p->passes.fields - 1; i >= 0; i--)
        if (p->passes.field[i].meets[k] && !p->passes.field[i].part->part->as.summed->carry)
            return p->passes.field[i].part;
    return NULL;
}

/* A mass that does not fill its site presses all from the start. */
static void doubt_mass(const struct plan *p, char *text, size_t room)
{
    const double site = p->scales.rho0 * pow(p->scales.dx, DIM);

    if (fabs(p->scales.mass / site - 1) > 0.05)
        snprintf(text, room, "; particle_mass = %g, but a site of this spacing holds %g at rest",
                 p->scales.mass, site);
}

/* What the worst part does to it, in words. */
static void name_deed(const struct blame *b, const struct deed *d, char *text, size_t room)
{
    if (!d->part)
        snprintf(text, room, "no single part is to blame: %s", d->rate == 0
                 ? "it has left the domain, or nothing acts on it" : "rates are not finite");
    else if (isnan(d->rate))
        snprintf(text, room, "%s (%s) gives it its density", d->part->path, d->part->part->about);
    else if (b->density)
        snprintf(text, room, "%s (%s) changes its density most, by %.3g kg/m^3 a second",
                 d->part->path, d->part->part->about, d->rate);
    else
        snprintf(text, room, "%s (%s) pushes it most, by %.3g m/s^2", d->part->path,
                 d->part->part->about, d->rate);
}

static void tell(const struct blame *b, const struct deed *d, char *text, size_t room)
{
    static const char *const kinds[] = { "fluid", "wall", "slip wall", "skin", "slip skin" };
    const struct particles *all = b->m->particles;
    const struct object *o = &all->object[all->object_of[b->particle]];
    const int i = b->particle - all->from[o->kind];
    const struct plan *p = b->m->plan;
    char place[PLAN_PLACE], deed[240], mass[160] = "";

    moment_place(b->m, b->v, b->particle, place);
    name_deed(b, d, deed, sizeof deed);
    doubt_mass(p, mass, sizeof mass);
    snprintf(text, room, "at t = %g s, the last accepted state, for %s particle %d (%s) at %s m: "
             "%s; its density is %.4g kg/m^3, its speed %.3g m/s, the sound speed %g m/s%s",
             b->v->t, kinds[o->kind], particles_id_of(all, b->particle), o->name, place, deed,
             b->v->rho[o->kind] ? b->v->rho[o->kind][i] : p->scales.rho0,
             size_of(b->v->u[o->kind] + (size_t)i * DIM), p->scales.c0, mass);
}

/* Which, and what of it: the culprit of the future of this state, or the hardest pushed.
 * Stages after one without an answer have lost their places, so densities come first. */
static int choose(struct blame *b, const struct moment_culprit *culprit)
{
    TRY(sum_of(b, -1));
    b->particle = hardest(b);
    for (int i = MOMENT_COMPLAINTS - 1; i >= 0; i--)
        if (culprit[i].known && culprit[i].t >= b->v->t) {
            b->particle = particles_row_of(b->m->particles, culprit[i].particle);
            b->density = i == MOMENT_DENSITY_OUT;
        }
    return STATUS_DONE;
}

static int blame(struct blame *b, const struct moment_culprit *culprit, char *text, size_t room)
{
    const struct particles *all = b->m->particles;
    struct deed worst = { 0 };

    TRY(choose(b, culprit));
    if (b->particle < 0)
        return STATUS_DONE;
    const enum kind k = all->object[all->object_of[b->particle]].kind;
    if (b->density && b->m->plan->row.density[k] < 0)
        worst = (struct deed){ summer(b->m->plan, k), NAN };
    else
        TRY(find_worst(b, &worst));
    tell(b, &worst, text, room);
    return STATUS_DONE;
}

/* Sums of the state as it is, though its densities be out of bounds. */
static int look(struct blame *b, double t, const double *y, struct view *v)
{
    const struct plan *p = b->m->plan;

    b->table = status_alloc(KINDS * KINDS, sizeof *b->table);
    b->rate = status_alloc((size_t)particles_count(p->particles, KIND_FLUID) + 1,
                           sizeof *b->rate);
    if (!b->table || !b->rate)
        return STATUS_FAILED;
    b->m->density[0] = -HUGE_VAL;
    b->m->density[1] = HUGE_VAL;
    b->v = v;
    return rates_fields(b->m, t, y, v);
}

void observe_blame(struct moment *run, double t, const double *y, char *text, size_t room)
{
    struct blame b = { 0 };
    struct view v;

    text[0] = '\0';
    if (run->plan->row.x < 0)
        return;
    if (moment_create(run->plan, &b.m) == STATUS_DONE) {
        moment_follow(b.m, run);
        if (look(&b, t, y, &v) == STATUS_DONE)
            blame(&b, run->culprit, text, room);
        else
            snprintf(text, room, "no single part: the last accepted state, at t = %g s, is not "
                     "finite; %s", t, b.m->refusal);
    }
    moment_free(&b.m);
    free(b.table);
    free(b.rate);
    status_clear();
}
