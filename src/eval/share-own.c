/* share-own.c -- what a rank sees of its own rows before it hears of others. */
#include "eval/share.h"

#include "space/reach.h"

#include <math.h>
#include <string.h>

enum { STRETCH = 64 }; /* particles that are looked at together */
static const double anywhere = 1e150; /* m: its square is a number */

static bool is_finite(const double *x)
{
    bool good = true;

    for (int d = 0; d < DIM; d++)
        good &= isfinite(x[d]) != 0;
    return good;
}

/* At a particle that moved far, was left out, or is nowhere. */
static void look_closer(const struct moment *m, int row, const double *x, struct share_drift *l)
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

/* At n particles from `row` on, one by one; x, was: of the first, now and when the list was made. */
static void look_at_each(const struct moment *m, int row, int n, const double *x, const double *was,
                         struct share_drift *l)
{
    const struct list *list = m->own;
    const double limit = list->def.skin / 2;

    for (int i = row; i < row + n; i++, x += DIM, was += DIM)
        if (!(list->stands && list_square(x, was) <= limit * limit && list->slot[i] >= 0))
            look_closer(m, i, x, l);
}

/* Is there nothing to see in a stretch?  Once one has moved, only who is nowhere or was left out
 * matters: what is far from where it was need not be known. */
static bool is_quiet(const struct list *list, const double *was, int row, const double *x, bool moved)
{
    const double limit = moved ? anywhere : list->def.skin / 2;
    struct reach r = reach_none();
    int left_out = 0;

    for (int i = 0; i < STRETCH; i++)
        left_out |= list->slot[row + i];
    for (int i = 0; i < STRETCH * DIM; i += DIM)
        reach_take(&r, less(coords_at(x + i), coords_at(was + i)));
    return left_out >= 0 && reach_within(&r, limit);
}

/* At those in rows from..to-1, likewise. */
static void look_at(const struct moment *m, int from, int to, const double *x, const double *was,
                    struct share_drift *l)
{
    const struct list *list = m->own;

    for (int row = from; row < to; row += STRETCH, x += STRETCH * DIM, was += STRETCH * DIM)
        if (to - row < STRETCH || !list->stands || !is_quiet(list, was, row, x, l->moved))
            look_at_each(m, row, to - row < STRETCH ? to - row : STRETCH, x, was, l);
}

/* Own rows of a kind, stretch by stretch: returns where the next one ends, *row: where it begins; 0: there
 * are no more.  *at: 0 at first.  Where own rows stand before others they are one stretch, else each is one. */
static int next_rows(const struct moment *m, int k, int *at, int *row)
{
    const struct moment_share *s = m->share;
    const int n = s->from[s->me][k + 1] - s->from[s->me][k];

    if (*at >= n)
        return 0;
    if (own_packs(m, k)) {
        *row = m->particles->from[k];
        *at = n;
        return *row + n;
    }
    *row = s->row[s->from[s->me][k] + (*at)++];
    return *row + 1;
}

struct share_drift share_drift(const struct moment *m, const struct view *v)
{
    const struct particles *p = m->particles;
    const bool solids_move = m->plan->moving_walls || m->plan->bodies > 0 || !m->own->stands;
    struct share_drift l = { .back = !m->own->stands, .bad = m->share->n };

    for (int k = 0; k < (solids_move ? KINDS : KIND_FLUID + 1); k++)
        for (int at = 0, row, to; (to = next_rows(m, k, &at, &row)) > 0;)
            look_at(m, row, to, k == KIND_FLUID ? v->x[k] + (size_t)row * DIM : p->x[row],
                    share_was(m, k) + (size_t)(row - p->from[k]) * DIM, &l);
    return l;
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

bool share_refuses(const struct moment *m, const struct view *v)
{
    bool all = true;

    for (int k = 0; k < KINDS; k++)
        for (int at = 0, row, to; v->rho[k] && (to = next_rows(m, k, &at, &row)) > 0;)
            all &= are_within(v->rho[k] + row - v->p->from[k], to - row, m->density);
    return !all;
}

void share_read(const struct moment *m, const struct view *v)
{
    const struct moment_share *s = m->share;
    const size_t number = sizeof *s->now.x;

    for (int k = 0; k < KINDS; k++)
        for (int at = 0, row, to; v->rho[k] && (to = next_rows(m, k, &at, &row)) > 0;) {
            const size_t n = (size_t)(to - row), first = (size_t)(row - v->p->from[k]);
            memcpy(s->now.rho + row, v->rho[k] + first, n * number);
            if (k != KIND_FLUID)
                continue;
            memcpy(s->now.x + first * DIM, v->x[k] + first * DIM, n * DIM * number);
            memcpy(s->now.u + first * DIM, v->u[k] + first * DIM, n * DIM * number);
        }
}
