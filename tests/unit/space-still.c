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

/* Kinds that stand still kept their places, those of the other list were sorted. */
static void compare_places(const struct list *told, const struct list *asks, unsigned seed)
{
    check(told->listed == asks->listed, "as many are listed, seed %u", seed);
    for (int kind = 0; kind <= KINDS; kind++)
        check(told->start[kind] == asks->start[kind], "kind %d starts there, seed %u", kind, seed);
    for (int s = 0; s < told->listed; s++)
        check(told->order[s] == asks->order[s], "place %d has that row, seed %u", s, seed);
    for (int i = 0; i < told->n; i++)
        check(told->slot[i] == asks->slot[i], "row %d has that place, seed %u", i, seed);
    check(list_entries(told) == list_entries(asks), "as many entries, seed %u", seed);
}

static int try_cloud(unsigned seed, bool repeats, int *remade, int *kept)
{
    int left = 0;

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

            check(!asks->stands || drift_harmless(asks, &c->cloud) == drift_harmless(told, &c->cloud),
                  "what stands still decides, seed %u", seed);
            check(lists->stale(asks, &c->cloud) == lists->stale(told, &c->cloud),
                  "one list is stale, seed %u", seed);
            assert_int_equal(lists->update(asks, &c->cloud), 0);
            assert_int_equal(lists->update(told, &c->cloud), 0);
            check(asks->builds == told->builds, "one list is made anew, seed %u", seed);
            compare_places(told, asks, seed);
            left += told->start[KIND_WALL] < mixed[KIND_FLUID];
            (*(asks->builds > builds ? remade : kept))++;
            move(c, 0.008);
            if (k % 7 == 6) {
                list_forget(told);
                list_forget(asks);
            }
        }
        lists->free(&told);
        lists->free(&asks);
        space_cloud_free(c);
    }
    return left;
}

void list_need_not_ask_what_stands_still(void **state)
{
    int remade = 0, kept = 0, left = 0;

    (void)state;
    for (unsigned seed = 1; seed < 40; seed++)
        left += try_cloud(seed, seed % 2, &remade, &kept);
    check(left > 40, "places of others change where some leave the domain: %d", left);
    check(remade > 40 && kept > 40, "both answers are met: %d and %d", remade, kept);
}
