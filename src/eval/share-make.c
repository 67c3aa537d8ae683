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
    ranks_route_free(&s->near.route);
    free(s->near.out);
    free(s->near.row);
    free(s->near.seen);
    free(s->near.whole.row);
    free(s->near.aside);
    balance_free(&s->move);
    free(s->mine);
    free(s->owner);
    free(s->row);
    free(s->from);
    free(s->count);
    free(s->places.place);
    free(s->places.n);
    free(s->now.x);
    free(s->now.u);
    free(s->now.rho);
    free(s->built);
    share_free_halo(&s->halo);
    free(s->wet.row);
    free(s->wet.from);
    free(s->pack);
    free(s->all);
    free(s->whole);
    free(s->power);
    free(s);
    *share = NULL;
}

/* What messages are packed in, and who owns what. */
static int take_common(struct moment_share *s, const struct moment *m)
{
    const size_t n = (size_t)s->n + 1, ranks = (size_t)s->ranks;
    const size_t powers = (size_t)m->plan->slots * EXACT_SUM_WORDS;

    s->mine = status_alloc(n, sizeof *s->mine);
    s->owner = status_alloc(n, sizeof *s->owner);
    s->row = status_alloc(n, sizeof *s->row);
    s->from = status_alloc(ranks, sizeof *s->from);
    s->count = status_alloc(ranks, sizeof *s->count);
    s->built = status_alloc(n, DIM * sizeof *s->built);
    s->pack = status_alloc(n * SHARE_WIDEST + powers, sizeof *s->pack);
    s->all = status_alloc(n * SHARE_WIDEST + ranks * powers, sizeof *s->all);
    return s->mine && s->owner && s->row && s->from && s->count && s->built && s->pack && s->all
               ? STATUS_DONE : STATUS_FAILED;
}

static int take_places(struct moment_share *s)
{
    s->places.place = status_alloc((size_t)s->n + 1, sizeof *s->places.place);
    s->places.n = status_alloc((size_t)s->ranks, sizeof *s->places.n);
    return s->places.place && s->places.n ? STATUS_DONE : STATUS_FAILED;
}

static int take_memory(struct moment_share *s, const struct moment *m)
{
    const size_t n = (size_t)s->n + 1;

    TRY(take_common(s, m));
    if (s->full)
        return take_places(s);
    s->now.x = status_alloc(n, DIM * sizeof *s->now.x);
    s->now.u = status_alloc(n, DIM * sizeof *s->now.u);
    s->now.rho = status_alloc(n, sizeof *s->now.rho);
    s->near.row = status_alloc(n, sizeof *s->near.row);
    s->near.seen = status_alloc(n, sizeof *s->near.seen);
    s->near.aside = status_alloc(n, DIM * sizeof *s->near.aside);
    s->near.whole.row = status_alloc(n, sizeof *s->near.whole.row);
    s->wet.row = status_alloc((size_t)(s->n - m->particles->from[KIND_WALL]) + 1, sizeof *s->wet.row);
    s->wet.from = status_alloc((size_t)s->ranks + 1, sizeof *s->wet.from);
    s->power = status_alloc((size_t)m->plan->slots + 1, sizeof *s->power);
    s->whole = status_alloc((size_t)layout_size(&m->layout) + 1, sizeof *s->whole);
    return s->near.row && s->near.seen && s->near.aside && s->near.whole.row && s->now.x && s->now.u && s->now.rho
                   && s->wet.row && s->wet.from && s->power && s->whole
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

static void find_owners(const struct moment *m, const double *y, const struct ranks_cut *cuts)
{
    const struct moment_share *s = m->share;

    for (int i = 0; i < s->n; i++) {
        s->owner[i] = ranks_cut_owner(cuts, place_of(m, y, i));
        if (!s->full)
            s->now.rho[i] = m->particles->scales->rho0; /* of rows that are never heard of */
    }
}

/* Does a pass read numbers of all particles, or a filter between two steps? */
static bool wants_all(const struct plan *p)
{
    bool all = p->passes.filters;

    for (int i = 0; i < p->passes.n; i++)
        all |= p->passes.pass[i].pass->all && p->passes.pass[i].pass->all(p);
    return all;
}

/* Sums that all have to hear of. */
static void attach(struct moment *m)
{
    m->own->mine = m->share->mine;
    if (m->share->packed)
        m->own->whole = &m->share->near.whole;
    if (!m->share->full)
        return;
    m->own->complete = share_complete;
    m->own->others = m;
}

int moment_share(struct moment *m, double *y, enum moment_rows rows)
{
    struct moment_share *s;
    struct ranks_cut *cuts;

    if (ranks_count() == 1 || m->plan->row.x < 0) /* all do what there is to do without fluid */
        return STATUS_DONE;
    s = m->share = status_alloc(1, sizeof *s);
    if (s)
        *s = (struct moment_share){ .ranks = ranks_count(), .me = ranks_me(), .n = m->particles->n,
                                    .full = rows == MOMENT_ALL || wants_all(m->plan),
                                    .balance = balance_start() };
    TRY(ranks_agree(s ? take_memory(s, m) : STATUS_FAILED));
    TRY(cut(m, y, &cuts));
    find_owners(m, y, cuts);
    ranks_cut_free(&cuts);
    s->packed = !s->full && rows == MOMENT_OWN;
    if (s->packed)
        TRY(own_divide(m, s->owner, y));
    share_own(m, s->owner);
    if (!s->packed)
        balance_never(m);
    attach(m);
    return STATUS_DONE;
}

void moment_unshare(struct moment *m)
{
    if (!m->share)
        return;
    m->own->mine = NULL;
    m->own->complete = NULL;
    m->own->others = NULL;
    share_free(&m->share);
}
