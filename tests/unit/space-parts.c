/* space-parts.c -- lists of parts of the particles, as many ranks have them, against the list of all. */
#include "space.h"

#include "space/drift.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS = 3, MOST = 400, SEEN = 1 << 16 };

static const int mixed[KINDS] = { 190, 61, 30, 23, 10 };

/* What a rank has. */
struct share {
    struct list *list;
    struct list_whole whole;
    struct list_bounds box;
    bool mine[MOST];
    int row[MOST];
};

/* Slices along x, but that some stand far from the others of theirs. */
static int owner_of(const struct space_cloud *c, int i)
{
    return space_random() < 0.01 ? i % PARTS : (int)fmin(PARTS - 1, fmax(0, floor(PARTS * c->x[i * DIM])));
}

static void open_parts(const struct list_engine *e, const struct space_cloud *c, struct share *part)
{
    for (int r = 0; r < PARTS; r++) {
        memset(&part[r], 0, sizeof part[r]);
        assert_int_equal(e->create(&part[r].list, &c->def), 0);
        part[r].whole.row = part[r].row;
        part[r].list->mine = part[r].mine;
        part[r].list->whole = &part[r].whole;
    }
    for (int i = 0; i < c->n; i++)
        part[owner_of(c, i)].mine[i] = true;
}

/* What ranks tell each other. */
static void combine(struct space_cloud *c, struct share *part)
{
    struct list_bounds fluid[PARTS], images[PARTS];

    for (int r = 0; r < PARTS; r++) {
        list_bounds(part[r].list, &c->cloud, &part[r].whole, &part[r].box);
        fluid[r] = part[r].whole.of[KIND_FLUID];
        images[r] = part[r].whole.images[KIND_FLUID];
    }
    for (int r = 0; r < PARTS; r++)
        for (int other = 0; other < PARTS; other++)
            if (other != r) {
                list_widen(&part[r].whole.of[KIND_FLUID], &fluid[other]);
                list_widen(&part[r].whole.images[KIND_FLUID], &images[other]);
            }
}

/* All solids, and fluid that is the rank's own or near to that. */
static void name_here(const struct space_cloud *c, struct share *part)
{
    const struct list_zone zone = list_zone(part->list, &part->box, list_reach(part->list, &part->whole));
    int n = 0;

    for (int kind = 0; kind < KINDS; kind++) {
        for (int k = 0; k < c->def.from[kind + 1] - c->def.from[kind]; k++) {
            const int i = c->def.from[kind] + (c->cloud.row[kind] ? c->cloud.row[kind][k] : k);
            if (kind != KIND_FLUID || part->mine[i]
                || list_near(&zone, list_home(part->list, &c->cloud, kind, i)))
                part->row[n++] = i;
        }
        part->whole.from[kind + 1] = n;
    }
}

static void make_parts(const struct list_engine *e, struct space_cloud *c, struct share *part)
{
    combine(c, part);
    for (int r = 0; r < PARTS; r++) {
        name_here(c, &part[r]);
        assert_int_equal(e->make(part[r].list, &c->cloud), 0);
    }
}

/* Neighbours of the particle in a row, in order, each with where its place stands; returns how many
 * numbers. */
static int neighbours(const struct list *l, int row, double *to)
{
    const int place = l->slot[row];
    int n = 0;

    for (int g = 0; g < l->groups; g++) {
        const int lane = place - l->group_slot[g];
        if (lane < 0 || lane >= l->lanes)
            continue;
        for (int s = l->segment_from[g]; s < l->segment_from[g + 1]; s++)
            for (int k = 0; k < l->segment[s].rows; k++) {
                const int j = list_place(l->segment[s].j[k * l->lanes + lane]);
                if (j == l->listed)
                    continue;
                to[n++] = l->order[j];
                for (int d = 0; d < DIM; d++)
                    to[n++] = l->offset ? l->offset[j][d] : 0;
                assert_true(n < SEEN - DIM - 1);
            }
    }
    return n;
}

static void check_same(const struct space_cloud *c, const struct list *whole, const struct share *part)
{
    static double all[SEEN], some[SEEN];

    for (int i = 0; i < c->n; i++) {
        check((whole->slot[i] < 0) == (part->mine[i] && part->list->slot[i] < 0) || !part->mine[i],
              "particle %d is left out by one alone", i);
        if (!part->mine[i] || whole->slot[i] < 0)
            continue;
        const int n = neighbours(whole, i, all);
        check(n == neighbours(part->list, i, some) && memcmp(all, some, (size_t)n * sizeof *all) == 0,
              "particle %d has other neighbours, or in another order", i);
        check(list_order(whole, i) == list_order(part->list, i), "particle %d is sorted by another cell", i);
    }
}

/* Those that are not here have no place. */
static void check_absent(const struct space_cloud *c, const struct share *part)
{
    bool here[MOST] = { false };

    for (int k = 0; k < part->whole.from[KINDS]; k++)
        here[part->row[k]] = true;
    for (int i = 0; i < c->n; i++)
        check(here[i] || part->list->slot[i] < 0, "particle %d has a place and is not here", i);
}

/* The worst that a part finds; adds pairs that all looked at. */
static enum drift_harm worst_harm(const struct space_cloud *c, const struct share *part, double *pairs)
{
    enum drift_harm worst = DRIFT_NONE;

    for (int r = 0; r < PARTS; r++) {
        const enum drift_harm harm = drift_harms(part[r].list, &c->cloud, pairs);
        worst = harm > worst ? harm : worst;
    }
    return worst;
}

/* As ranks decide together. */
static bool parts_harmed(const struct space_cloud *c, const struct share *part)
{
    double pairs = 0;

    return worst_harm(c, part, &pairs) != DRIFT_NONE || pairs > drift_patience(part[0].list);
}

/* Of each fluid particle in the list some part can tell that it is nowhere, or far away. */
static void check_gone(struct space_cloud *c, const struct list *whole, const struct share *part)
{
    const int i = (int)(space_random() * c->def.from[KIND_FLUID + 1]);
    double *x = c->x + (size_t)i * DIM, was = *x, pairs = 0;

    if (whole->slot[i] < 0)
        return;
    *x = NAN;
    check(worst_harm(c, part, &pairs) == DRIFT_NOWHERE, "particle %d is nowhere", i);
    *x = was + 3 * c->def.skin;
    check(worst_harm(c, part, &pairs) == DRIFT_MISSING, "particle %d is far away", i);
    *x = was;
}

/* All go one way, and each another by so much; sometimes one goes far. */
static void move(struct space_cloud *c, double size)
{
    const double along = size * space_random();

    for (int i = 0; i < c->n * DIM; i++)
        c->x[i] += along + size * (space_random() - 0.5);
    if (space_random() < 0.1)
        c->x[(int)(space_random() * c->n) * DIM] += 4 * c->def.skin;
}

/* Lists of all and of parts are the same when they are made, and whether they still serve. */
static void follow(const struct list_engine *lists, struct space_cloud *c, struct list *whole,
                   struct share *part, int *harmed, int *harmless)
{
    assert_int_equal(lists->make(whole, &c->cloud), 0);
    make_parts(lists, c, part);
    for (int r = 0; r < PARTS; r++) {
        check_same(c, whole, &part[r]);
        check_absent(c, &part[r]);
    }
    check_gone(c, whole, part);
    for (int k = 0; k < 12; k++) {
        const bool fine = drift_harmless(whole, &c->cloud);
        check(fine != parts_harmed(c, part), "parts decide otherwise");
        (*(fine ? harmless : harmed))++;
        move(c, 0.004);
    }
}

static void try_cloud(unsigned seed, bool repeats, int *harmed, int *harmless)
{
    space_seed(seed);
    for (int e = 0; e < space_engines(); e++) {
        const struct list_engine *lists = space_engine(e)->list;
        struct space_cloud *c = space_cloud(mixed, 0.08 + 0.06 * space_random(), 0.02);
        struct list *whole;
        struct share part[PARTS];

        if (repeats) {
            c->def.period[0] = 1;
            c->def.low[0] = -INFINITY;
            c->def.high[0] = INFINITY;
        } else {
            c->def.high[0] = 0.97; /* some are outside */
        }
        assert_int_equal(lists->create(&whole, &c->def), 0);
        open_parts(lists, c, part);
        for (int times = 0; times < 3; times++) /* some come near that were not, and go */
            follow(lists, c, whole, part, harmed, harmless);
        for (int r = 0; r < PARTS; r++)
            lists->free(&part[r].list);
        lists->free(&whole);
        space_cloud_free(c);
    }
}

void list_of_parts_is_that_of_all(void **state)
{
    int harmed = 0, harmless = 0;

    (void)state;
    for (unsigned seed = 1; seed < 40; seed++)
        try_cloud(seed, seed % 2, &harmed, &harmless);
    check(harmed > 20 && harmless > 20, "both answers are met: %d and %d", harmed, harmless);
}
