/* share-hear.c -- what a right-hand side hears of neighbours that others own.
 *
 * The halo is under way while all ask each other whether the list fits (share-list.c): a rank waits once
 * for both.  Where the list is made anew then, another halo goes. */
#include "eval/share.h"

#include "ranks/ranks.h"

#include <string.h>

/* Own rows that leave, as they travel: they stand here and there, and are asked for some before. */
static void pack_halo(struct moment_share *s, const struct view *v)
{
    enum { AHEAD = 16 };
    const double *x = v->x[KIND_FLUID], *u = v->u[KIND_FLUID];
    const double *rho = v->rho[KIND_FLUID] ? v->rho[KIND_FLUID] : s->now.rho;
    const int fluid = v->p->from[KIND_FLUID + 1];
    double *to = s->halo.sent;

    for (int i = 0; i < s->halo.leaves; i++) {
        const size_t row = (size_t)s->halo.out[i];
        const size_t later = (size_t)s->halo.out[i + AHEAD < s->halo.leaves ? i + AHEAD : i];
        if (s->halo.out[i] >= fluid) {
            *to++ = s->now.rho[row];
            continue;
        }
        __builtin_prefetch(x + later * DIM);
        __builtin_prefetch(u + later * DIM);
        __builtin_prefetch(rho + later);
        memcpy(to, x + row * DIM, DIM * sizeof *to);
        memcpy(to + DIM, u + row * DIM, DIM * sizeof *to);
        to[2 * DIM] = rho[row];
        to += SHARE_HALO;
    }
}

void share_halo_begin(struct moment *m, const struct view *v)
{
    struct moment_share *s = m->share;

    s->halo.goes = m->own->stands && s->route;
    if (!s->halo.goes)
        return;
    pack_halo(s, v);
    ranks_route_begin(s->route, sizeof *s->halo.sent, s->halo.sent, s->halo.in);
}

void share_halo_end(struct moment_share *s)
{
    if (s->halo.goes)
        ranks_route_end(s->route);
}

/* Solids are where they are on all ranks, and have a density alone. */
static void spread_halo(struct moment_share *s, const struct view *v)
{
    const double *from = s->halo.in;

    for (int i = 0; i < s->halo.n; i++) {
        const size_t row = (size_t)s->halo.row[i];
        if (s->halo.row[i] < v->p->from[KIND_FLUID + 1]) {
            memcpy(s->now.x + row * DIM, from, DIM * sizeof *from);
            memcpy(s->now.u + row * DIM, from + DIM, DIM * sizeof *from);
            from += 2 * DIM;
        }
        s->now.rho[row] = *from++;
    }
}

/* From all to all. */
static void hear_solids(struct moment *m, const struct view *v)
{
    for (int k = KIND_WALL; k < KINDS; k++)
        if (v->rho[k] && particles_count(v->p, (enum kind)k) > 0 && !share_comes(m, k))
            share_gather(m->share, v->p, (enum kind)k, 1, v->rho[k], m->share->now.rho + v->p->from[k]);
}

void share_hear(struct moment *m, const struct view *v)
{
    struct moment_share *s = m->share;

    if (!s->halo.goes) { /* the list is another since */
        share_halo_begin(m, v);
        share_halo_end(s);
    }
    spread_halo(s, v);
    hear_solids(m, v);
}
