/* share-own.c -- what a rank sees of its own rows before it hears of others. */
#include "eval/share.h"

#include <math.h>
#include <string.h>

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

/* At those in rows from..to-1, x: of the first. */
static void look_at(const struct moment *m, int from, int to, const double *x, struct share_drift *l)
{
    const struct list *list = m->own;
    const double *was = m->share->built + (size_t)from * DIM, limit = list->def.skin / 2;
    const bool stands = list->stands;

    for (int i = from; i < to; i++, x += DIM, was += DIM)
        if (!(stands && list_square(x, was) <= limit * limit && list->slot[i] >= 0))
            look_closer(m, i, x, l);
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
            look_at(m, row, to, k == KIND_FLUID ? v->x[k] + (size_t)row * DIM : p->x[row], &l);
    return l;
}

bool share_refuses(const struct moment *m, const struct view *v)
{
    const double low = m->density[0], high = m->density[1];
    bool all = true;

    for (int k = 0; k < KINDS; k++)
        for (int at = 0, row, to; v->rho[k] && (to = next_rows(m, k, &at, &row)) > 0;)
            for (const double *rho = v->rho[k] + row - v->p->from[k]; row < to; row++, rho++)
                all &= (*rho >= low) & (*rho <= high);
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
