/* share-own.c -- what a rank sees of its own rows before it hears of others.
 *
 * Rows of y come from far away in memory, so they are read once: what is asked of them is asked of some at
 * a time, as they are copied to where those of others will be. */
#include "eval/share.h"

#include "space/reach.h"

#include <math.h>
#include <string.h>

enum { STRETCH = 64 }; /* rows that are looked at together */
static const double anywhere = 1e150; /* m: its square is a number */

static bool is_finite(const double *x)
{
    bool good = true;

    for (int d = 0; d < DIM; d++)
        good &= isfinite(x[d]) != 0;
    return good;
}

/* At a particle that moved far, was left out, or is nowhere. */
static void look_closer(const struct moment *m, int row, const double *x, struct share_seen *l)
{
    const struct list *list = m->own;

    if (!is_finite(x)) {
        const int id = particles_id_of(m->particles, row);
        l->bad = id < l->bad ? id : l->bad;
    } else if (list->stands) {
        l->moved |= list->slot[row] >= 0;
        l->back |= list->slot[row] < 0 && list_inside(&list->def, x);
    }
}

/* Is there nothing to see at a stretch?  Once one has moved, only who is nowhere or was left out
 * matters: what is far from where it was need not be known. */
static bool is_quiet(const struct list *list, const double *was, int row, const double *x, bool moved)
{
    struct reach r = reach_none();
    int left_out = 0;

    for (int i = 0; i < STRETCH; i++)
        left_out |= list->slot[row + i];
    if (!moved)
        return left_out >= 0 && reach_all_within(x, was, STRETCH, list->def.skin / 2);
    for (int i = 0; i < STRETCH * DIM; i += DIM)
        reach_take(&r, coords_at(x + i));
    return left_out >= 0 && reach_within(&r, anywhere);
}

/* At n rows from `row` on; x, was: of the first, now and when the list was made. */
static void look_at(const struct moment *m, int row, int n, const double *x, const double *was,
                    struct share_seen *l)
{
    const struct list *list = m->own;
    const double limit = list->def.skin / 2;

    if (n == STRETCH && list->stands && is_quiet(list, was, row, x, l->moved))
        return;
    for (int i = row; i < row + n; i++, x += DIM, was += DIM)
        if (!(list->stands && list_square(x, was) <= limit * limit && list->slot[i] >= 0))
            look_closer(m, i, x, l);
}

/* Of so many densities, are all in bounds?  One that is no number stays in the sum. */
static bool are_within(const double *rho, int n, const double *bound)
{
    struct reach r = reach_none();
    double least[DIM], most[DIM];
    bool good = true;
    int i = 0;

    for (; i + DIM <= n; i += DIM)
        reach_take(&r, coords_at(rho + i));
    coords_put(r.least, least);
    coords_put(r.most, most);
    for (int d = 0; d < DIM; d++)
        good &= least[d] >= bound[0] && most[d] <= bound[1];
    for (; i < n; i++)
        good &= rho[i] >= bound[0] && rho[i] <= bound[1];
    return good && length2(r.sum) >= 0;
}

/* Own rows of a kind, some at a time: returns how many come next, *row: from which on; 0: there are no
 * more.  *at: 0 at first.  Where own rows do not stand before others each comes alone. */
static int next_rows(const struct moment *m, int k, int *at, int *row)
{
    const struct moment_share *s = m->share;
    const int left = s->from[s->me][k + 1] - s->from[s->me][k] - *at;
    const int n = !own_packs(m, k) ? left > 0 : left < STRETCH ? left : STRETCH;

    *row = own_packs(m, k) ? m->particles->from[k] + *at : n > 0 ? s->row[s->from[s->me][k] + *at] : 0;
    *at += n;
    return n;
}

/* Is a kind somewhere else than when the list was made, or may be? */
static bool may_move(const struct moment *m, int k)
{
    return k == KIND_FLUID || m->plan->moving_walls || m->plan->bodies > 0 || !m->own->stands;
}

void share_see_places(const struct moment *m, const struct view *v, struct share_seen *l)
{
    for (int k = 0; k < KINDS; k++)
        for (int at = 0, row, n; may_move(m, k) && (n = next_rows(m, k, &at, &row)) > 0;) {
            const size_t first = (size_t)(row - v->p->from[k]) * DIM;
            look_at(m, row, n, k == KIND_FLUID ? v->x[k] + first : v->p->x[row], share_was(m, k) + first, l);
        }
}

/* What is not read where y has it is copied. */
static void keep(const struct moment *m, const struct view *v, int k, int row, int n)
{
    const size_t first = (size_t)(row - v->p->from[k]), number = sizeof(double), numbers = (size_t)n * number;
    const struct moment_share *s = m->share;

    if (k == KIND_FLUID && s->packed)
        return;
    if (v->rho[k])
        memcpy(s->now.rho + row, v->rho[k] + first, numbers);
    if (k != KIND_FLUID)
        return;
    memcpy(s->now.x + first * DIM, v->x[k] + first * DIM, DIM * numbers);
    memcpy(s->now.u + first * DIM, v->u[k] + first * DIM, DIM * numbers);
}

void share_see_densities(const struct moment *m, const struct view *v, struct share_seen *l)
{
    for (int k = 0; k < KINDS; k++)
        for (int at = 0, row, n; (n = next_rows(m, k, &at, &row)) > 0; keep(m, v, k, row, n))
            if (v->rho[k])
                l->refuses |= !are_within(v->rho[k] + (row - v->p->from[k]), n, m->density);
}

bool share_listed(const struct moment *m)
{
    bool all = true;

    for (int k = 0; k < KINDS; k++)
        for (int at = 0, row, n; may_move(m, k) && (n = next_rows(m, k, &at, &row)) > 0;)
            for (int i = row; i < row + n; i++)
                all &= m->own->slot[i] >= 0;
    return all;
}
