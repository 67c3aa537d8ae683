/* share-near.c -- particles that a rank has in its list: its own, and those of others near a box around
 * its own.
 *
 * A list wants two of each block of space (space/drift.h) around own ones, so that this rank can judge
 * for all whether one of its pairs may be missing.  Places of others come when a list is made, and
 * when one moved so far that this is in doubt.  What follows from all particles, grids, number and
 * patience, is told by all in a gather of some numbers each. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { NAMED = DIM + 1 }; /* numbers of a row as it travels first: place, id */

/* What a rank tells of its own: fluid, its images, and all there is, in the domain. */
struct told {
    struct list_bounds fluid, images, box;
};

/* Of all ranks, what none knows alone. */
static void hear_bounds(struct moment *m, const struct cloud *cloud, struct told *all)
{
    struct moment_share *s = m->share;
    struct list_whole *whole = &s->near.whole;
    struct told mine;

    list_bounds(m->own, cloud, whole, &mine.box);
    mine.fluid = whole->of[KIND_FLUID];
    mine.images = whole->images[KIND_FLUID];
    for (int r = 0; r < s->ranks; r++)
        s->count[r] = 1;
    ranks_gather(s->count, sizeof mine, &mine, all);
    for (int r = 0; r < s->ranks; r++)
        if (r != s->me) {
            list_widen(&whole->of[KIND_FLUID], &all[r].fluid);
            list_widen(&whole->images[KIND_FLUID], &all[r].images);
        }
}

/* Solids near own particles, which all ranks know, are here. */
static void name_solids(struct moment *m, const struct cloud *cloud, const struct list_bounds *box)
{
    struct list_whole *whole = &m->share->near.whole;
    const struct list_zone zone = list_zone(m->own, box, list_reach(m->own, whole));
    const int *from = m->particles->from;
    int n = whole->from[KIND_WALL];

    for (int k = KIND_WALL; k < KINDS; k++) {
        const double *home = list_home(m->own, cloud, k, from[k]);
        for (int id = 0; id < from[k + 1] - from[k]; id++) {
            const int row = particles_row(m->particles, (enum kind)k, id);
            if (list_near(&zone, home + (size_t)row * DIM))
                whole->row[n++] = from[k] + row;
        }
        whole->from[k + 1] = n;
    }
}

/* Around ranks that some of own rows of fluid may be near to. */
struct zones {
    int n, *rank;
    struct list_zone *of;
};

static void find_zones(const struct moment *m, const struct told *all, struct zones *z)
{
    const double reach = list_reach(m->own, &m->share->near.whole);
    const struct moment_share *s = m->share;

    for (int r = 0; r < s->ranks; r++) {
        z->of[z->n] = list_zone(m->own, &all[r].box, reach);
        z->rank[z->n] = r;
        z->n += r != s->me && list_meets(&z->of[z->n], &all[s->me].fluid);
    }
}

/* Names own rows of fluid, each once for each rank that it is near to; returns how many names there are.
 * At first `to` is NULL: near [own rows] then notes which rows have one.  Then these alone are asked
 * again, for `to` and row [names]. */
static int name_rows(const struct moment *m, const struct cloud *cloud, const struct zones *z, bool *near,
                     int *to, int *row)
{
    const int own = moment_rows_of(m, KIND_FLUID);
    const double *x = list_home(m->own, cloud, KIND_FLUID, 0);
    int n = 0;

    for (int i = 0; i < own; i++, x += DIM) {
        const int before = n;
        if (to && !near[i])
            continue;
        for (int r = 0; r < z->n; r++)
            if (list_near(&z->of[r], x) && list_inside(&m->own->def, x)) {
                if (to) {
                    to[n] = z->rank[r];
                    row[n] = i;
                }
                n++;
            }
        near[i] = n > before;
    }
    return n;
}

/* Rows that leave, and how: as they are packed, one after the other. */
static int make_route(struct moment *m, const struct cloud *cloud, const struct told *all)
{
    struct moment_share *s = m->share;
    struct ranks_route *made;
    bool *near = (bool *)s->pack;
    int rank[s->ranks], n, *to, *at, *out, status;
    struct list_zone zone[s->ranks];
    struct zones z = { 0, rank, zone };

    find_zones(m, all, &z);
    memset(near, 0, (size_t)moment_rows_of(m, KIND_FLUID) * sizeof *near);
    n = name_rows(m, cloud, &z, near, NULL, NULL);
    to = status_alloc((size_t)n + 1, sizeof *to);
    at = status_alloc((size_t)n + 1, sizeof *at);
    out = status_alloc((size_t)n + 1, sizeof *out);
    status = to && at && out ? STATUS_DONE : STATUS_FAILED;
    if (status == STATUS_DONE)
        name_rows(m, cloud, &z, near, to, out);
    for (int i = 0; i < n && at; i++)
        at[i] = i;
    status = ranks_route_create(&made, status, NAMED * sizeof(double), n, to, at);
    free(to);
    free(at);
    if (status != STATUS_DONE) {
        free(out);
        return status;
    }
    ranks_route_free(&s->near.route);
    free(s->near.out);
    s->near.route = made;
    s->near.out = out;
    s->near.leaves = n;
    return STATUS_DONE;
}

enum { BITS = 64 };

static inline void set_bit(uint64_t *bits, int i)
{
    bits[i / BITS] |= UINT64_C(1) << (i % BITS);
}

/* Fluid that is here: own rows, and those of others that came; in order of ids. */
static void name_fluid(struct moment *m)
{
    struct moment_share *s = m->share;
    struct list_whole *whole = &s->near.whole;
    const struct particles *p = m->particles;
    const int n = particles_count(p, KIND_FLUID), own = moment_rows_of(m, KIND_FLUID);
    uint64_t *here = (uint64_t *)s->pack; /* a bit for each id */
    int rows = 0;

    memset(here, 0, ((size_t)n / BITS + 1) * sizeof *here);
    for (int i = 0; i < own; i++)
        set_bit(here, particles_id_of(p, i));
    for (int i = 0; i < s->near.n; i++)
        set_bit(here, particles_id_of(p, s->near.row[i]));
    for (int k = 0; k <= n / BITS; k++)
        for (uint64_t some = here[k]; some; some &= some - 1)
            whole->row[rows++] = particles_row(p, KIND_FLUID, k * BITS + __builtin_ctzll(some));
    whole->from[KIND_WALL] = rows;
}

/* Rows that come, with their names: they are here from now on. */
static void hear_named(struct moment *m, double *x)
{
    struct moment_share *s = m->share;
    double *to = s->pack;

    for (int i = 0; i < s->near.leaves; i++, to += NAMED) {
        memcpy(to, x + (size_t)s->near.out[i] * DIM, DIM * sizeof *x);
        to[DIM] = particles_id_of(m->particles, s->near.out[i]);
    }
    ranks_route_go(s->near.route, NAMED * sizeof *x, s->pack, s->all);
    s->near.n = ranks_route_coming(s->near.route);
    for (int i = 0; i < s->near.n; i++) {
        const double *one = s->all + (size_t)i * NAMED;
        const int row = s->near.row[i] = particles_row_of(m->particles, (int)one[DIM]);
        memcpy(x + (size_t)row * DIM, one, DIM * sizeof *x);
    }
    name_fluid(m);
}

int share_near(struct moment *m, const struct cloud *cloud, double *x)
{
    struct moment_share *s = m->share;
    struct told all[s->ranks];

    hear_bounds(m, cloud, all);
    TRY(make_route(m, cloud, all));
    hear_named(m, x);
    name_solids(m, cloud, &all[s->me].box);
    return STATUS_DONE;
}

/* Places of own rows, at x, to where they are near, those of others to `to`. */
static void hear_places(struct moment_share *s, const double *x, double *to)
{
    for (int i = 0; i < s->near.leaves; i++)
        memcpy(s->pack + (size_t)i * DIM, x + (size_t)s->near.out[i] * DIM, DIM * sizeof *x);
    ranks_route_go(s->near.route, DIM * sizeof *x, s->pack, s->all);
    for (int i = 0; i < s->near.n; i++)
        memcpy(to + (size_t)s->near.row[i] * DIM, s->all + (size_t)i * DIM, DIM * sizeof *to);
}

void share_place(const struct moment *m, const double *x)
{
    memcpy(m->share->now.x, x, (size_t)moment_rows_of(m, KIND_FLUID) * DIM * sizeof *x);
}

void share_see_near(struct moment *m, const double *x)
{
    struct moment_share *s = m->share;

    share_place(m, x);
    hear_places(s, x, s->now.x);
    s->near.seen_n = s->near.n;
    memcpy(s->near.seen, s->near.row, (size_t)s->near.n * sizeof *s->near.row);
}

struct share_drift share_drift(struct moment *m, const struct cloud *cloud)
{
    struct moment_share *s = m->share;

    hear_places(s, cloud->x[KIND_FLUID], s->now.x);
    s->near.drift = (struct share_drift){ 0 };
    s->near.drift.harm = drift_harms(m->own, cloud, &s->near.drift.pairs);
    return s->near.drift;
}

/* What each has found. */
static bool is_harm(struct moment *m)
{
    struct moment_share *s = m->share;
    struct share_drift all[s->ranks];
    double pairs = 0;
    bool harm = false;

    for (int r = 0; r < s->ranks; r++)
        s->count[r] = 1;
    ranks_gather(s->count, sizeof *all, &s->near.drift, all);
    for (int r = 0; r < s->ranks; r++) {
        harm |= all[r].harm != DRIFT_NONE;
        pairs += all[r].pairs;
    }
    return harm || pairs > drift_patience(m->own);
}

bool share_harms(struct moment *m, const struct cloud *cloud)
{
    share_drift(m, cloud);
    return is_harm(m);
}

bool share_is_tired(struct moment *m, double most)
{
    return most * m->share->ranks > drift_patience(m->own) && is_harm(m);
}
