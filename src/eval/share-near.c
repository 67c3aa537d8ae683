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
    const double reach = list_reach(m->own, whole);
    const int *from = m->particles->from;
    int n = whole->from[KIND_WALL];

    for (int k = KIND_WALL; k < KINDS; k++) {
        for (int id = from[k]; id < from[k + 1]; id++) {
            const int row = particles_row_of(m->particles, id);
            if (list_near(m->own, box, reach, list_home(m->own, cloud, k, row)))
                whole->row[n++] = row;
        }
        whole->from[k + 1] = n;
    }
}

/* Ranks that some of own rows of fluid may be near to; returns how many. */
static int name_ranks(const struct moment *m, const struct told *all, double reach, int *rank)
{
    const struct moment_share *s = m->share;
    int n = 0;

    for (int r = 0; r < s->ranks; r++)
        if (r != s->me && list_meets(m->own, &all[r].box, reach, &all[s->me].fluid))
            rank[n++] = r;
    return n;
}

/* Names own rows of fluid, each once for each rank that it is near to; returns how many names there are.
 * At first to and row are NULL: near [own rows] then notes which rows have one.  Then these alone are asked
 * again, for to, row [names]. */
static int name_rows(const struct moment *m, const struct cloud *cloud, const struct told *all, bool *near,
                     int *to, int *row)
{
    const double reach = list_reach(m->own, &m->share->near.whole);
    int rank[m->share->ranks], n = 0;
    const int ranks = name_ranks(m, all, reach, rank), own = moment_rows_of(m, KIND_FLUID);

    for (int i = 0; i < own; i++) {
        const int before = n;
        if (to && !near[i])
            continue;
        const double *x = list_home(m->own, cloud, KIND_FLUID, i);
        for (int r = 0; r < ranks && list_inside(&m->own->def, x); r++)
            if (list_near(m->own, &all[rank[r]].box, reach, x)) {
                if (to) {
                    to[n] = rank[r];
                    row[n] = i;
                }
                n++;
            }
        near[i] = n > before;
    }
    return n;
}

static int make_route(struct moment *m, const struct cloud *cloud, const struct told *all,
                      struct ranks_route **route)
{
    bool *near = (bool *)m->share->pack;
    const int n = name_rows(m, cloud, all, near, NULL, NULL);
    int *to = status_alloc((size_t)n + 1, sizeof *to), *row = status_alloc((size_t)n + 1, sizeof *row);
    int status = to && row ? STATUS_DONE : STATUS_FAILED;

    if (status == STATUS_DONE)
        name_rows(m, cloud, all, near, to, row);
    status = ranks_route_create(route, status, NAMED * sizeof(double), n, to, row);
    free(to);
    free(row);
    return status;
}

/* Fluid that is here: own rows, and those of others that came; in order of ids. */
static void name_fluid(struct moment *m)
{
    struct moment_share *s = m->share;
    struct list_whole *whole = &s->near.whole;
    const size_t n = (size_t)particles_count(m->particles, KIND_FLUID);
    const int own = moment_rows_of(m, KIND_FLUID);
    unsigned char *here = (unsigned char *)s->pack, *at = here; /* [n] by id */

    memset(here, 0, n);
    for (int i = 0; i < own; i++)
        here[particles_id_of(m->particles, i)] = 1;
    for (int i = 0; i < s->near.n; i++)
        here[particles_id_of(m->particles, s->near.row[i])] = 1;
    whole->from[KIND_WALL] = 0;
    while ((at = memchr(at, 1, (size_t)(here + n - at))))
        whole->row[whole->from[KIND_WALL]++] = particles_row_of(m->particles, (int)(at++ - here));
}

/* Rows that come, with their names: they are here from now on. */
static void hear_named(struct moment *m, double *x)
{
    struct moment_share *s = m->share;
    const int own = moment_rows_of(m, KIND_FLUID);

    for (int i = 0; i < own; i++) {
        memcpy(s->pack + (size_t)i * NAMED, x + (size_t)i * DIM, DIM * sizeof *x);
        s->pack[(size_t)i * NAMED + DIM] = particles_id_of(m->particles, i);
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
    struct ranks_route *route;

    hear_bounds(m, cloud, all);
    TRY(make_route(m, cloud, all, &route));
    ranks_route_free(&s->near.route);
    s->near.route = route;
    hear_named(m, x);
    name_solids(m, cloud, &all[s->me].box);
    return STATUS_DONE;
}

/* Places of own rows to where they are near, those of others to x. */
static void hear_places(struct moment_share *s, double *x)
{
    ranks_route_go(s->near.route, DIM * sizeof *x, x, s->all);
    for (int i = 0; i < s->near.n; i++)
        memcpy(x + (size_t)s->near.row[i] * DIM, s->all + (size_t)i * DIM, DIM * sizeof *x);
}

void share_place(const struct moment *m, const double *x)
{
    memcpy(m->share->now.x, x, (size_t)moment_rows_of(m, KIND_FLUID) * DIM * sizeof *x);
}

void share_see_near(struct moment *m, const double *x)
{
    struct moment_share *s = m->share;

    share_place(m, x);
    hear_places(s, s->now.x);
    s->near.seen_n = s->near.n;
    memcpy(s->near.seen, s->near.row, (size_t)s->near.n * sizeof *s->near.row);
}

bool share_harms(struct moment *m, const struct cloud *cloud, double *x)
{
    struct moment_share *s = m->share;
    struct {
        double harm, pairs;
    } mine = { .pairs = 0 }, all[s->ranks];
    double pairs = 0;
    bool harm = false;

    hear_places(s, x);
    mine.harm = drift_harms(m->own, cloud, &mine.pairs);
    for (int r = 0; r < s->ranks; r++)
        s->count[r] = 1;
    ranks_gather(s->count, sizeof mine, &mine, all);
    for (int r = 0; r < s->ranks; r++) {
        harm |= all[r].harm > 0;
        pairs += all[r].pairs;
    }
    return harm || pairs > drift_patience(m->own);
}
