/* space-images.c -- directions that repeat: the list against every pair and its nearest
 * image. */
#include "space.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const int mixed[KINDS] = { 150, 61, 30, 23, 10 };

/* Directions in `which` (bits) repeat after `length`, from -0.3 on. */
static void repeat(struct space_cloud *c, unsigned which, double length)
{
    for (int d = 0; d < DIM; d++)
        if (which & 1u << d) {
            c->def.period[d] = length;
            c->def.side[d] = -0.3;
            c->def.low[d] = -INFINITY;
            c->def.high[d] = INFINITY;
        }
}

/* Some stand whole lengths away. */
static void scatter(struct space_cloud *c)
{
    for (int i = 0; i < c->n * DIM; i++)
        if (c->def.period[i % DIM] > 0)
            c->x[i] += floor(7 * space_random() - 3) * c->def.period[i % DIM];
}

static double nearest2(const struct space_cloud *c, int i, int j)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++) {
        const double length = c->def.period[d];
        double x = c->x[i * DIM + d] - c->x[j * DIM + d];
        x -= length > 0 ? length * round(x / length) : 0;
        r2 += x * x;
    }
    return r2;
}

/* Of two places, where offsets put them. */
static double between2(const struct list *list, const struct space_cloud *c, int a, int b)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++) {
        const double x = c->x[list->order[a] * DIM + d] + list->offset[a][d]
                       - c->x[list->order[b] * DIM + d] - list->offset[b][d];
        r2 += x * x;
    }
    return r2;
}

/* listed[i * n + j]: how often j, itself or an image within the radius, is a neighbour
 * of owner i. */
static void mark(const struct list *list, const struct space_cloud *c, double radius,
                 char *listed)
{
    memset(listed, 0, (size_t)c->n * (size_t)c->n);
    for (int g = 0; g < list->groups; g++)
        for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++) {
            const struct list_segment *part = &list->segment[s];
            const int first = list->group_slot[g];

            for (int k = 0; k < part->rows * list->lanes; k++) {
                const int j = list_place(part->j[k]), owner = first + k % list->lanes;
                if (j == list->listed)
                    continue;
                check((j >= list->start[part->partner] && j < list->start[part->partner + 1])
                          || (j >= list->image[part->partner]
                              && j < list->image[part->partner + 1]),
                      "the segment is of one kind and its images");
                check(j != owner, "no particle is its own neighbour");
                listed[list->order[owner] * c->n + list->order[j]]
                    += between2(list, c, owner, j) < radius * radius;
            }
        }
}

static void check_pairs(const struct space_cloud *c, const char *listed, double radius)
{
    for (int i = 0; i < c->n; i++)
        for (int j = 0; j < c->n; j++) {
            const bool near = nearest2(c, i, j) < radius * radius && i != j;
            const bool acts = c->def.acts[space_kind(c, i)] & KIND_BIT(space_kind(c, j));
            check(listed[i * c->n + j] == (near && acts), "pair %d %d at %.17g is listed %d times",
                  i, j, sqrt(nearest2(c, i, j)), listed[i * c->n + j]);
        }
}

static void check_places(const struct list *list, const struct space_cloud *c)
{
    for (int s = 0; s < list->listed; s++)
        for (int d = 0; d < DIM; d++) {
            const double place = c->x[list->order[s] * DIM + d] + list->offset[s][d];
            const double length = c->def.period[d], over = s < list->image[0] ? 1e-9 : 0.5;
            check(!(length > 0) || (place >= -0.3 - over * length && place <= -0.3
                                                                     + (1 + over) * length),
                  "place %d is at %g along %d", s, place, d);
            check(length > 0 || list->offset[s][d] == 0, "only what repeats is moved");
        }
    assert_int_equal(list->image[0], list->start[KINDS]);
    assert_int_equal(list->image[KINDS], list->listed);
}

/* Any directions, any supports up to half a length. */
void images_find_all(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed < 40; seed++)
        for (int e = 0; e < space_engines(); e++) {
            const struct list_engine *engine = space_engine(e)->list;
            struct space_cloud *c;
            struct list *list;
            char *listed;

            space_seed(seed);
            c = space_cloud(mixed, 0.05 + 0.4 * space_random(), 0.02 * (seed % 3));
            repeat(c, 1 + seed % ((1u << DIM) - 1), 1.0);
            scatter(c);
            listed = test_malloc((size_t)c->n * (size_t)c->n);
            assert_int_equal(engine->create(&list, &c->def), 0);
            assert_int_equal(engine->update(list, &c->cloud), 0);
            check_places(list, c);
            mark(list, c, c->def.support + c->def.skin, listed);
            check_pairs(c, listed, c->def.support + c->def.skin);
            test_free(listed);
            engine->free(&list);
            space_cloud_free(c);
        }
}

/* Two on either side of a side, not listed: when they run to each other the list is made
 * anew, when they drift along together it is not. */
void images_meet_across_a_side(void **state)
{
    static const int two[KINDS] = { 2 };

    (void)state;
    for (int e = 0; e < space_engines(); e++)
        for (int d = 0; d < DIM; d++)
            for (int together = 0; together < 2; together++) {
                const struct list_engine *engine = space_engine(e)->list;
                struct space_cloud *c = space_cloud(two, 0.2, 0.05);
                struct list *list;

                repeat(c, (1u << DIM) - 1, 1.0);
                for (int i = 0; i < 2; i++)
                    for (int k = 0; k < DIM; k++)
                        c->x[i * DIM + k] = k != d ? 0.1 : i ? -0.3 + 0.16 : 3.7 - 0.1;
                assert_int_equal(engine->create(&list, &c->def), 0);
                assert_int_equal(engine->update(list, &c->cloud), 0);
                c->x[d] += together ? 0.09 : 0.04;
                c->x[DIM + d] += together ? 0.09 : -0.04;
                assert_int_equal(engine->update(list, &c->cloud), 0);
                check(list->builds == (together ? 1 : 2), "%ld lists along %d, %s", list->builds, d,
                      together ? "together" : "to each other");
                engine->free(&list);
                space_cloud_free(c);
            }
}

/* Random walks without end: whenever update() is content, no pair within H is missing. */
void images_miss_nobody_moving(void **state)
{
    enum { MOVES = 2000 };
    static const int few[KINDS] = { 40, 12, 0, 5, 3 };

    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        const struct list_engine *engine = space_engine(e)->list;
        struct space_cloud *c = space_cloud(few, 0.3, 0.05);
        char *listed = test_malloc((size_t)c->n * (size_t)c->n);
        struct list *list;

        repeat(c, (1u << DIM) - 1, 1.0);
        assert_int_equal(engine->create(&list, &c->def), 0);
        for (int move = 0; move < MOVES; move++) {
            for (int i = 0; i < c->n * DIM; i++)
                c->x[i] += 0.02 * (space_random() - 0.5) + 0.004 * (i % DIM == 0);
            assert_int_equal(engine->update(list, &c->cloud), 0);
            mark(list, c, c->def.support, listed);
            check_pairs(c, listed, c->def.support);
        }
        check(list->builds > MOVES / 50 && list->builds < MOVES / 2,
              "%ld rebuilds: the margin does its work", list->builds);
        test_free(listed);
        engine->free(&list);
        space_cloud_free(c);
    }
}
