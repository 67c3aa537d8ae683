/* contacts-near.c -- where solids are, and which of them are near each other.
 *
 * A cell is as wide as the two largest balls and the gap, so that those of a pair that is near are
 * neighbours; cells are kept in buckets by a sum of their numbers. */
#include "bodies/contacts-near.h"

#include "base/status.h"
#include "state/period.h"

#include <math.h>
#include <stdlib.h>

static const double farthest = 1e9; /* cells: beyond it all is one; keeps to whole numbers */

/* For the pair with the most places. */
static int take_spots(const struct contacts *c, struct contacts_spots *to)
{
    int most = 1;

    for (int i = 0; i < c->pairs; i++)
        most = c->pair[i].places > most ? c->pair[i].places : most;
    to->spot = status_alloc((size_t)most, sizeof *to->spot);
    to->which = status_alloc((size_t)most, sizeof *to->which);
    to->place = status_alloc((size_t)most, sizeof *to->place);
    return to->spot && to->which && to->place ? STATUS_DONE : STATUS_FAILED;
}

static int take_memory(const struct contacts *c, struct contacts_work *w)
{
    const size_t movers = (size_t)c->movers + 1, pairs = (size_t)c->pairs + 1;

    w->buckets = 1;
    while (w->buckets < 2 * c->movers)
        w->buckets *= 2;
    w->cell = status_alloc(movers, sizeof *w->cell);
    w->next = status_alloc(movers, sizeof *w->next);
    w->first = status_alloc((size_t)w->buckets, sizeof *w->first);
    w->found = status_alloc((size_t)c->solids + 1, sizeof *w->found);
    w->pair = status_alloc(pairs, sizeof *w->pair);
    w->seat_of = status_alloc(pairs, sizeof *w->seat_of);
    w->bent = status_alloc((size_t)c->seats.block * DIM * 2 + 1, sizeof *w->bent);
    if (!w->cell || !w->next || !w->first || !w->found || !w->pair || !w->seat_of || !w->bent)
        return STATUS_FAILED;
    for (int i = 0; i < c->pairs; i++)
        w->seat_of[i] = -1;
    return take_spots(c, &w->spots);
}

int contacts_near_create(const struct contacts *c, struct contacts_work **out)
{
    *out = status_alloc(1, sizeof **out);
    if (*out && take_memory(c, *out) == STATUS_DONE)
        return STATUS_DONE;
    contacts_near_free(out);
    return STATUS_FAILED;
}

void contacts_near_free(struct contacts_work **work)
{
    struct contacts_work *w = *work;

    if (!w)
        return;
    free(w->cell);
    free(w->first);
    free(w->next);
    free(w->found);
    free(w->pair);
    free(w->seat_of);
    free(w->bent);
    free(w->spots.spot);
    free(w->spots.which);
    free(w->spots.place);
    free(w);
    *work = NULL;
}

/* Once a pass: a body may be of many pairs. */
void contacts_near_place(const struct contacts *c, const struct contacts_moment *m)
{
    for (int i = 0; i < c->movers; i++) {
        struct contacts_body *b = &m->body[c->part_of[i]];
        b->kind->role.solid->stand(b->body, m->layout, m->y, &b->at);
    }
}

const struct solid_place *contacts_near_of(const struct contacts *c,
                                           const struct contacts_moment *m, int i,
                                           struct solid_place *room)
{
    const int body = c->part_of[i];

    if (body < c->bodies)
        return &m->body[body].at;
    if (body == c->bodies + c->walls)
        *room = c->solid[i].start;
    else
        solid_carry(&m->wall[body - c->bodies].by, &c->solid[i].start, room);
    return room;
}

/* --- the grid ----------------------------------------------------------------------- */

struct grid {
    double wide[DIM]; /* of a cell [m]                                             */
    long round[DIM];  /* cells after which a direction repeats; 0: it does not     */
};

/* A direction that repeats has whole cells; fewer than three are all neighbours. */
static struct grid make_grid(const struct contacts *c, double gap)
{
    struct grid g;

    for (int d = 0; d < DIM; d++) {
        const double period = c->scales.period[d], wide = 2 * c->most.around + c->most.film + gap;
        g.wide[d] = wide;
        g.round[d] = 0;
        if (!(period > 0))
            continue;
        g.round[d] = (long)fmax(1, fmin(farthest, floor(period / wide)));
        g.round[d] = g.round[d] < 3 ? 1 : g.round[d];
        g.wide[d] = period / (double)g.round[d];
    }
    return g;
}

static long around(const struct grid *g, int d, long cell)
{
    const long n = g->round[d];

    return n > 0 ? (cell % n + n) % n : cell;
}

static int bucket_of(const struct contacts_work *w, const long *cell)
{
    unsigned long sum = 0;

    for (int d = 0; d < DIM; d++)
        sum = sum * 73 + (unsigned long)cell[d];
    return (int)((sum * 0x9E3779B97F4A7C15UL >> 33) & (unsigned long)(w->buckets - 1));
}

static void fill(const struct contacts *c, const struct contacts_moment *m, const struct grid *g)
{
    struct contacts_work *w = m->work;

    for (int i = 0; i < w->buckets; i++)
        w->first[i] = -1;
    for (int i = 0; i < c->movers; i++) {
        double x[DIM];
        contacts_pair_middle(&c->solid[i], &m->body[c->part_of[i]].at, x);
        period_home(&c->scales, x, x);
        for (int d = 0; d < DIM; d++) {
            const double at = (x[d] - c->scales.low[d]) / g->wide[d];
            w->cell[i][d] = around(g, d, (long)floor(fmax(-farthest, fmin(farthest, at))));
        }
        const int bucket = bucket_of(w, w->cell[i]);
        w->next[i] = w->first[bucket];
        w->first[bucket] = i;
    }
}

static bool same_cell(const long *a, const long *b)
{
    for (int d = 0; d < DIM; d++)
        if (a[d] != b[d])
            return false;
    return true;
}

/* Bodies after i in that cell that it feels. */
static int take_cell(const struct contacts *c, struct contacts_work *w, int i, const long *cell, int n)
{
    for (int j = w->first[bucket_of(w, cell)]; j >= 0; j = w->next[j])
        if (j > i && same_cell(w->cell[j], cell) && contacts_list_pair(c, i, j) >= 0)
            w->found[n++] = contacts_list_pair(c, i, j);
    return n;
}

/* Steps to a neighbour that a direction has: one where it is a single cell that repeats. */
static int take_around(const struct contacts *c, struct contacts_work *w, const struct grid *g, int i)
{
    int n = 0, all = 1;

    for (int d = 0; d < DIM; d++)
        all *= 3;
    for (int k = 0; k < all; k++) {
        long cell[DIM];
        bool again = false;
        for (int d = 0, rest = k; d < DIM; d++, rest /= 3) {
            cell[d] = around(g, d, w->cell[i][d] + rest % 3 - 1);
            again = again || (g->round[d] == 1 && rest % 3 != 1);
        }
        n = again ? n : take_cell(c, w, i, cell, n);
    }
    return n;
}

static void sort(int *a, int n)
{
    for (int i = 1; i < n; i++) {
        const int one = a[i];
        int k = i;
        for (; k > 0 && a[k - 1] > one; k--)
            a[k] = a[k - 1];
        a[k] = one;
    }
}

void contacts_near_find(const struct contacts *c, const struct contacts_moment *m, double gap)
{
    const struct grid grid = make_grid(c, gap);
    struct contacts_work *w = m->work;

    fill(c, m, &grid);
    w->near = 0;
    for (int i = 0; i < c->movers; i++) {
        int n = take_around(c, w, &grid, i);
        for (int j = c->movers; j < c->solids; j++)
            if (contacts_list_pair(c, i, j) >= 0)
                w->found[n++] = contacts_list_pair(c, i, j);
        sort(w->found, n);
        for (int k = 0; k < n; k++)
            w->pair[w->near++] = w->found[k];
    }
}
