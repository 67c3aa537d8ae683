/* space-still.c -- a list that is told which kinds stand still decides as one that asks them all. */
#include "space.h"

#include "space/drift.h"

#include <math.h>

static const int mixed[KINDS] = { 120, 160, 60, 23, 10 };
static const unsigned still = KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP);

/* All but what stands still go one way, to the others, and each another by so much; sometimes one goes far. */
static void move(struct space_cloud *c, double size)
{
    const double along = -size * space_random();

    for (int i = 0; i < c->n; i++)
        for (int d = 0; d < DIM && !(still & KIND_BIT(space_kind(c, i))); d++)
            c->x[i * DIM + d] += along + 0.2 * size * (space_random() - 0.5);
    if (space_random() < 0.1)
        c->x[(int)(space_random() * c->def.from[KIND_WALL]) * DIM] += 4 * c->def.skin;
}

/* What moves is on one side, what stands still on the other: there are blocks where nothing moves,
 * beside others. */
static void part(struct space_cloud *c)
{
    for (int i = 0; i < c->n; i++) {
        double *x = c->x + i * DIM;

        *x = still & KIND_BIT(space_kind(c, i)) ? 0.58 * *x : 0.6 + 0.4 * *x;
    }
}

static void try_cloud(unsigned seed, bool repeats, int *remade, int *kept)
{
    space_seed(seed);
    for (int e = 0; e < space_engines(); e++) {
        const struct list_engine *lists = space_engine(e)->list;
        struct space_cloud *c = space_cloud(mixed, 0.08 + 0.06 * space_random(), 0.02);
        struct list *told, *asks;

        part(c);
        if (repeats) {
            c->def.period[0] = 1;
            c->def.low[0] = -INFINITY;
            c->def.high[0] = INFINITY;
        }
        assert_int_equal(lists->create(&asks, &c->def), 0);
        c->def.still = still;
        assert_int_equal(lists->create(&told, &c->def), 0);
        for (int k = 0; k < 20; k++) {
            const long builds = asks->builds;

            check(k == 0 || drift_harmless(asks, &c->cloud) == drift_harmless(told, &c->cloud),
                  "what stands still decides, seed %u", seed);
            check(lists->stale(asks, &c->cloud) == lists->stale(told, &c->cloud),
                  "one list is stale, seed %u", seed);
            assert_int_equal(lists->update(asks, &c->cloud), 0);
            assert_int_equal(lists->update(told, &c->cloud), 0);
            check(asks->builds == told->builds, "one list is made anew, seed %u", seed);
            (*(asks->builds > builds ? remade : kept))++;
            move(c, 0.008);
        }
        lists->free(&told);
        lists->free(&asks);
        space_cloud_free(c);
    }
}

void list_need_not_ask_what_stands_still(void **state)
{
    int remade = 0, kept = 0;

    (void)state;
    for (unsigned seed = 1; seed < 40; seed++)
        try_cloud(seed, seed % 2, &remade, &kept);
    check(remade > 40 && kept > 40, "both answers are met: %d and %d", remade, kept);
}
