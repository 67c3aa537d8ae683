/* share-make.c -- who owns which rows, and the memory of that. */
#include "eval/share.h"

#include "algebra/exact-sum.h"
#include "base/status.h"
#include "ranks/ranks.h"

#include <stdlib.h>

static const double solid_work = 0.25; /* of that for a particle of the fluid: fewer neighbours */

void share_free(struct moment_share **share)
{
    struct moment_share *s = *share;

    if (!s)
        return;
    ranks_route_free(&s->route);
    balance_free(&s->move);
    free(s->mine);
    free(s->owner);
    free(s->row);
    free(s->from);
    free(s->count);
    free(s->seen);
    free(s->x);
    free(s->u);
    free(s->rho);
    free(s->built);
    free(s->halo);
    free(s->in);
    free(s->pack);
    free(s->all);
    free(s->whole);
    free(s->power);
    free(s);
    *share = NULL;
}

static int take_memory(struct moment_share *s, const struct moment *m)
{
    const size_t n = (size_t)s->n + 1, ranks = (size_t)s->ranks;
    const size_t powers = (size_t)m->plan->slots * EXACT_SUM_WORDS;

    s->mine = status_alloc(n, sizeof *s->mine);
    s->owner = status_alloc(n, sizeof *s->owner);
    s->row = status_alloc(n, sizeof *s->row);
    s->from = status_alloc(ranks, sizeof *s->from);
    s->count = status_alloc(ranks, sizeof *s->count);
    s->x = status_alloc(n, DIM * sizeof *s->x);
    s->u = status_alloc(n, DIM * sizeof *s->u);
    s->rho = status_alloc(n, sizeof *s->rho);
    s->built = status_alloc(n, DIM * sizeof *s->built);
    s->halo = status_alloc(n, sizeof *s->halo);
    s->pack = status_alloc(n * SHARE_HALO + powers, sizeof *s->pack);
    s->all = status_alloc(n * SHARE_HALO + ranks * powers, sizeof *s->all);
    s->power = status_alloc((size_t)m->plan->slots + 1, sizeof *s->power);
    s->whole = status_alloc((size_t)layout_size(&m->layout) + 1, sizeof *s->whole);
    return s->mine && s->owner && s->row && s->from && s->count && s->x && s->u
        && s->rho && s->built && s->halo && s->pack && s->all && s->power && s->whole
               ? STATUS_DONE : STATUS_FAILED;
}

/* Where a particle is at the start. */
static const double *place_of(const struct moment *m, const double *y, int row)
{
    const struct particles *p = m->particles;

    return row < p->from[KIND_FLUID + 1] ? y + layout_at(&m->layout, m->plan->row.x) + (size_t)row * DIM
                                         : p->x[row];
}

/* Each rank brings its part of the particles to the cut. */
static int cut(const struct moment *m, const double *y, struct ranks_cut **out)
{
    const struct moment_share *s = m->share;
    double *x = s->all, *weight = s->pack;
    int n = 0;

    for (int i = s->me; i < s->n; i += s->ranks, n++) {
        const double *at = place_of(m, y, i);
        for (int d = 0; d < DIM; d++)
            x[(size_t)n * DIM + d] = at[d];
        weight[n] = i < m->particles->from[KIND_FLUID + 1] ? 1 : solid_work;
    }
    return ranks_cut_create(out, DIM, n, x, weight);
}

static void own_first(const struct moment *m, const double *y, const struct ranks_cut *cuts)
{
    const struct moment_share *s = m->share;

    for (int i = 0; i < s->n; i++) {
        s->owner[i] = ranks_cut_owner(cuts, place_of(m, y, i));
        s->rho[i] = m->particles->scales->rho0; /* of rows that are never heard of */
    }
    share_own(m, s->owner);
}

int moment_share(struct moment *m, const double *y)
{
    struct moment_share *s;
    struct ranks_cut *cuts;

    if (ranks_count() == 1)
        return STATUS_DONE;
    s = m->share = status_alloc(1, sizeof *s);
    if (s)
        *s = (struct moment_share){ .ranks = ranks_count(), .me = ranks_me(), .n = m->particles->n,
                                    .balance = balance_start() };
    TRY(ranks_agree(s ? take_memory(s, m) : STATUS_FAILED));
    TRY(cut(m, y, &cuts));
    own_first(m, y, cuts);
    ranks_cut_free(&cuts);
    TRY(ranks_agree(share_fit_own(s)));
    m->own->mine = s->mine;
    return STATUS_DONE;
}

const char *moment_share_lacks(const struct plan *p)
{
    const struct plan_part *force = NULL;

    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.force && !p->part[i].part->as.force->weight)
            force = &p->part[i];
    return p->row.x < 0 ? "a scene without fluid"
         : p->solver || p->stiff ? "an implicit viscosity"
         : plan_ahead(p) > 0 ? "a pressure that looks ahead"
         : p->passes.fields > 0 ? "summed densities, drifts and walls that sum over the fluid"
         : p->face ? "a viscosity that sticks at faces"
         : p->passes.filters ? "densities that are filtered between steps"
         : force ? "body forces beside the weight"
         : NULL;
}
