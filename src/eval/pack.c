/* pack.c -- records of all particles in the order of the list, with the pressure
 * of the equation of state; refuses densities out of bounds. */
#include "eval/pack.h"
#include "eval/share.h"

#include "base/status.h"
#include "base/threads.h"
#include "space/record-pack.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

enum { CHUNK = PACK_CHUNK, BLOCK = PACK_BLOCK, BLOCKS = PACK_BLOCKS };

void pack_far(const struct plan *p, int number, double *r)
{
    const double edge = p->scales.period[0] > 0 ? p->scales.high[0] : p->list_def.high[0];

    for (int i = 0; i < RECORD; i++)
        r[i] = 0;
    r[RECORD_X] = edge + (10.0 + 2.0 * number) * p->scales.support;
    r[RECORD_RHO] = p->scales.rho0;
    r[RECORD_M] = 1;
    r[RECORD_IRHO] = 1 / p->scales.rho0;
}

/* The position of a place, its particle at x; offset NULL: nothing is periodic. */
static void write_place(double *r, const double *x, const double *offset)
{
    r[RECORD_X] = offset ? x[0] + offset[0] : x[0];
    r[RECORD_X + 1] = offset ? x[1] + offset[1] : x[1];
#if DIM == 3
    r[RECORD_Z] = offset ? x[2] + offset[2] : x[2];
#endif
}

/* What stands outside of the box since the list was made. */
static void send_away(const struct moment *m, const struct view *v, int k, const struct record_source *of,
                      int from, int to)
{
    for (int s = from; s < to; s++)
        if (!list_inside(of->def, view_x(v, k, of->order[s] - of->first)))
            pack_far(m->plan, s + 1, m->work->record + (size_t)s * RECORD);
}

/* p/rho^2 that solids press with, or that a sum has given. */
static void put_pressure(const struct record_source *of, int from, int to, const double *p2,
                         double *record)
{
    for (int s = from; s < to; s++)
        record[(size_t)s * RECORD + RECORD_P2] = p2[of->order[s] - of->first];
}

/* The first density out of bounds, of the place `from` and following; there is one. */
static int first_bad(const struct moment *m, const double *rho, int from)
{
    while (*rho >= m->density[0] && *rho <= m->density[1]) {
        rho++;
        from++;
    }
    return from;
}

/* Places from..to-1, all of kind k, and of them some beyond?  Returns the first with a density out
 * of bounds, or -1. */
static int pack_chunk(const struct moment *m, const struct view *v, int k, bool beyond, int from, int to)
{
    const struct plan *p = m->plan;
    const struct record_source of = {
        .order = m->list->order, .first = v->p->from[k], .x = v->x[k], .u = v->u[k],
        .m = v->p->m, .mass = p->table.mass, .rho = v->rho[k], .rho0 = p->scales.rho0,
        .bounds = { m->density[0], m->density[1] },
        .beyond = beyond ? v->beyond : (struct rows_beyond){ 0 },
        .offset = (const double (*)[DIM])m->list->offset, .def = &p->list_def,
    };
    double rho[CHUNK], press[CHUNK];

    if (!p->engine->sum->densities(&of, from, to, rho))
        return first_bad(m, rho, from);
    if (p->pressure)
        p->pressure->part->as.pressure->pressures(p->pressure->self, to - from, rho, press);
    else
        memset(press, 0, sizeof press);
    const bool inside = p->engine->sum->pack(&of, from, to, rho, press, m->work->record);
    if (v->p2[k])
        put_pressure(&of, from, to, v->p2[k], m->work->record);
    if (!inside)
        send_away(m, v, k, &of, from, to);
    return -1;
}

/* Images from..to-1 of kind k have all but their place of their originals; these are
 * scattered, and asked for first. */
static void copy_chunk(const struct moment *m, const struct view *v, int k, int from, int to)
{
    const struct plan *p = m->plan;
    const struct list *l = m->list;
    const double *original[CHUNK];

    for (int s = from; s < to; s++) {
        const int c = l->order[s];
        original[s - from] = m->work->record + (size_t)l->slot[c] * RECORD;
        __builtin_prefetch(original[s - from]);
        __builtin_prefetch(original[s - from] + RECORD - 1);
        __builtin_prefetch(view_x(v, k, c - v->p->from[k]));
    }
    for (int s = from; s < to; s++) {
        const double *x = view_x(v, k, l->order[s] - v->p->from[k]);
        double *r = m->work->record + (size_t)s * RECORD;
        if (!list_inside(&p->list_def, x)) { /* already far, but its image is not */
            pack_far(p, s + 1, r);
            continue;
        }
        memcpy(r, original[s - from], RECORD * sizeof *r);
        write_place(r, x, l->offset[s]);
    }
}

/* By this thread. */
static void copy_chunks(const struct moment *m, const struct view *v, int k, int from, int to)
{
#pragma omp for schedule(static) nowait
    for (int s = from; s < to; s += CHUNK)
        copy_chunk(m, v, k, s, s + CHUNK < to ? s + CHUNK : to);
}

static void copy_images(const struct moment *m, const struct view *v, int k)
{
    const int from = m->list->image[k], to = m->list->image[k + 1];

    THREADS(to - from > 4 * CHUNK, copy_chunks(m, v, k, from, to));
}

static int refuse_density(struct moment *m, const struct view *v, int slot)
{
    static const char *const kinds[] = { "fluid", "wall", "slip wall", "skin", "slip skin" };
    const int c = m->list->order[slot];
    const struct object *o = &v->p->object[v->p->object_of[c]];
    const int particle = particles_id_of(v->p, c);
    const double rho = *view_rho(v, o->kind, c - v->p->from[o->kind]);
    char place[PLAN_PLACE];

    moment_place(m, v, c, place);
    snprintf(m->refusal, sizeof m->refusal,
             "density %g kg/m^3 of %s particle %d (%s) at %s m at t = %g s lies outside %g to %g; %s",
             rho, kinds[o->kind], particle, o->name, place, v->t, m->density[0], m->density[1],
             isnan(rho) ? "a pressure, force or speed before it was too large for a number"
                        : "particles were pushed together or torn apart faster than the step could "
                          "follow");
    moment_note(m, MOMENT_DENSITY_OUT, particle, v->t);
    return STATUS_FAILED;
}

static struct pack_chunks cut(const struct list *l, unsigned kinds)
{
    struct pack_chunks c = { 0 };

    for (int k = 0; k < KINDS; k++) {
        const int n = kinds & KIND_BIT(k) ? l->start[k + 1] - l->start[k] : 0;

        c.of[k] = c.n;
        c.n += (n + CHUNK - 1) / CHUNK;
    }
    c.of[KINDS] = c.n;
    return c;
}

/* Blocks first..last-1 of a chunk of kind k, as busy as that. */
static int pack_blocks(const struct moment *m, const struct view *v, int k, int chunk, enum pack_busy busy, int first,
                       int last)
{
    const int start = m->list->start[k] + chunk * CHUNK, end = m->list->start[k + 1];
    const int from = start + first * BLOCK, to = start + last * BLOCK;

    return from < end ? pack_chunk(m, v, k, k == KIND_FLUID && busy == PACK_BUSY, from, to < end ? to : end) : -1;
}

static int pack_one(const struct moment *m, const struct view *v, const struct pack_chunks *c, int chunk)
{
    const unsigned char *busy = c->busy ? c->busy + (size_t)chunk * BLOCKS : NULL;
    int k = 0, bad = -1;

    while (chunk >= c->of[k + 1])
        k++;
    if (!busy)
        return pack_blocks(m, v, k, chunk - c->of[k], PACK_BUSY, 0, BLOCKS);
    for (int first = 0, last; first < BLOCKS && bad < 0; first = last) {
        for (last = first + 1; last < BLOCKS && busy[last] == busy[first];)
            last++;
        if (busy[first] != PACK_IDLE)
            bad = pack_blocks(m, v, k, chunk - c->of[k], busy[first], first, last);
    }
    return bad;
}

static void pack_all(const struct moment *m, const struct view *v, const struct pack_chunks *chunks,
                     atomic_int *bad)
{
#pragma omp for schedule(static) nowait
    for (int c = 0; c < chunks->n; c++) {
        const int at = pack_one(m, v, chunks, c);
        for (int old = *bad; at >= 0 && at < old;) /* keep the smallest place */
            if (atomic_compare_exchange_weak(bad, &old, at))
                break;
    }
}

int moment_pack(struct moment *m, const struct view *v, unsigned kinds)
{
    const struct list *l = m->list;
    struct workspace *w = m->work;
    struct pack_chunks chunks = cut(l, kinds);
    const bool spares = pack_spares(m, kinds), packed = w->busy.list == l && w->busy.builds == l->builds;
    atomic_int bad = l->listed;

    chunks.busy = spares && packed ? w->busy.of : NULL;
    THREADS(chunks.n > 4, pack_all(m, v, &chunks, &bad));
    for (int k = 0; k < KINDS && l->offset; k++)
        if (kinds & KIND_BIT(k))
            copy_images(m, v, k);
    pack_far(m->plan, 0, w->record + (size_t)l->listed * RECORD);
    if (bad < l->listed)
        return refuse_density(m, v, bad);
    if (spares && !packed)
        pack_note(m, &chunks);
    return STATUS_DONE;
}

int passes_records(struct evaluation *e, const struct plan_field *of)
{
    const int status = moment_pack(e->m, &e->view, KIND_BIT(KINDS) - 1);

    (void)of;
    return e->m->share ? share_agree(e->m, status) : status;
}
