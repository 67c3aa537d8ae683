/* space-list.c -- the pair list against every pair there is. */
#include "space.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const int mixed[KINDS] = { 150, 61, 30, 23, 10 };

static struct list *make(const struct list_engine *e, struct space_cloud *c)
{
    struct list *list;

    assert_int_equal(e->create(&list, &c->def), 0);
    assert_int_equal(e->update(list, &c->cloud), 0);
    return list;
}

/* listed[i * n + j]: j is a neighbour of owner i; also checks the rows. */
static void mark(const struct list *list, const struct space_cloud *c, char *listed)
{
    memset(listed, 0, (size_t)c->n * (size_t)c->n);
    for (int g = 0; g < list->groups; g++) {
        const int kind = list->group_kind[g], end = list->start[kind + 1];

        for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++) {
            const struct list_segment *part = &list->segment[s];

            for (int l = 0; l < list->lanes; l++) {
                const int owner = list->group_slot[g] + l;
                int last = -1;

                for (int k = 0; k < part->rows; k++) {
                    const int j = list_place(part->j[k * list->lanes + l]);

                    check(j > last || j == list->listed, "places ascend, padding last");
                    check(j == list->listed || owner < end, "these rows have no owner");
                    last = j;
                    if (j == list->listed)
                        continue;
                    check(j != owner, "no particle is its own neighbour");
                    check(j >= list->start[part->partner] && j < list->start[part->partner + 1],
                          "the segment is of one kind");
                    listed[list->order[owner] * c->n + list->order[j]] = 1;
                }
            }
        }
    }
}

static int expects(const struct space_cloud *c, int i, int j)
{
    return i != j && (c->def.acts[space_kind(c, i)] & KIND_BIT(space_kind(c, j)))
        && list_inside(&c->def, c->x + i * DIM) && list_inside(&c->def, c->x + j * DIM);
}

/* All pairs nearer than `radius` are there, none beyond `limit`. */
static void check_pairs(const struct space_cloud *c, const char *listed, double radius,
                        double limit)
{
    for (int i = 0; i < c->n; i++)
        for (int j = 0; j < c->n; j++) {
            const double r2 = space_distance2(c, i, j);
            const int there = listed[i * c->n + j];

            if (expects(c, i, j) && r2 < radius * radius)
                check(there, "pair %d %d at %.17g is missing", i, j, sqrt(r2));
            if (there)
                check(expects(c, i, j) && r2 <= limit * limit, "pair %d %d at %.17g is listed",
                      i, j, sqrt(r2));
        }
}

static void check_orders(const struct list *list, const struct space_cloud *c)
{
    int inside = 0;

    for (int i = 0; i < c->n; i++) {
        const int s = list->slot[i], k = space_kind(c, i);

        check((s >= 0) == list_inside(&c->def, c->x + i * DIM), "particles outside have no place");
        if (s < 0)
            continue;
        inside++;
        check(list->order[s] == i && s >= list->start[k] && s < list->start[k + 1],
              "place and row are inverse, kinds are ranges");
    }
    assert_int_equal(inside, list->listed);
}

static void check_fresh(const struct space_cloud *c, const struct list *list)
{
    const double radius = c->def.support + c->def.skin;
    char *listed = test_malloc((size_t)c->n * (size_t)c->n + 1);
    double far = 0; /* coordinates have 16 digits */

    for (int i = 0; i < c->n * DIM; i++)
        far = list_inside(&c->def, c->x + i / DIM * DIM) ? fmax(far, fabs(c->x[i])) : far;
    check_orders(list, c);
    mark(list, c, listed);
    check_pairs(c, listed, radius, radius * (1 + 1e-3) + 4e-15 * far);
    test_free(listed);
}

/* Builds with every engine, checks, and frees the cloud. */
static void check_cloud(struct space_cloud *c)
{
    for (int e = 0; e < space_engines(); e++) {
        struct list *list = make(space_engine(e)->list, c);

        check_fresh(c, list);
        space_engine(e)->list->free(&list);
        assert_null(list);
    }
    space_cloud_free(c);
}

void list_finds_all(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed < 20; seed++) {
        space_seed(seed);
        check_cloud(space_cloud(mixed, 0.05 + 0.3 * space_random(), 0.03 * (seed % 3)));
    }
}

/* None, one, all in one point, a lattice that meets the cells' borders. */
void list_takes_odd_clouds(void **state)
{
    static const int none[KINDS] = { 0 }, one[KINDS] = { 1 }, some[KINDS] = { 37, 5, 0, 0, 3 };
    static const int square[KINDS] = { DIM == 2 ? 256 : 216 };
    struct space_cloud *c;

    (void)state;
    check_cloud(space_cloud(none, 0.1, 0.01));
    check_cloud(space_cloud(one, 0.1, 0.01));
    c = space_cloud(some, 0.1, 0);
    for (int i = 0; i < c->n * DIM; i++)
        c->x[i] = 0.5;
    check_cloud(c);
    c = space_cloud(square, DIM == 2 ? 0.125 : 0.25, DIM == 2 ? 0.0625 : 0.125);
    for (int i = 0, side = DIM == 2 ? 16 : 6; i < c->n; i++)
        for (int d = 0, left = i; d < DIM; d++, left /= side)
            c->x[i * DIM + d] = (DIM == 2 ? 0.0625 : 0.125) * (left % side);
    check_cloud(c);
}

void list_keeps_outsiders_out(void **state)
{
    struct space_cloud *c;

    (void)state;
    space_seed(7);
    c = space_cloud(mixed, 0.15, 0.02);
    for (int i = 0; i < c->n; i += 3)
        c->x[i * DIM + i % DIM] += i % 2 ? 1 : -1e12;
    check_cloud(c);
}

/* The order does not depend on the lane width; nor do the useful pairs. */
void list_sorts_the_same(void **state)
{
    struct space_cloud *c = space_cloud(mixed, 0.15, 0.02);
    struct list *first = make(space_engine(0)->list, c);

    (void)state;
    for (int e = 1; e < space_engines(); e++) {
        struct list *other = make(space_engine(e)->list, c);

        assert_memory_equal(first->order, other->order, (size_t)first->listed * sizeof(int));
        space_engine(e)->list->free(&other);
    }
    space_engine(0)->list->free(&first);
    space_cloud_free(c);
}

/* All but the first move along by this. */
static void shift(struct space_cloud *c, double by)
{
    for (int i = DIM; i < c->n * DIM; i++)
        c->x[i] += by;
}

/* A rebuild happens when a pair is missing, a particle moved further than two
 * margins, or came in. */
void list_knows_when_stale(void **state)
{
    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        const struct list_engine *engine = space_engine(e)->list;
        struct space_cloud *c = space_cloud(mixed, 0.15, 0.02);
        struct list *list;

        for (int i = 0; i < c->n * DIM; i++)
            c->x[i] = 0.1 + 0.8 * c->x[i];
        c->x[0] = -1;
        assert_int_equal(engine->create(&list, &c->def), 0);
        assert_true(engine->stale(list, &c->cloud));
        assert_int_equal(engine->update(list, &c->cloud), 0);
        assert_int_equal(list->builds, 1);
        assert_false(engine->stale(list, &c->cloud));
        shift(c, 0.039 / sqrt(DIM));
        assert_false(engine->stale(list, &c->cloud));
        shift(c, 0.002 / sqrt(DIM));
        assert_true(engine->stale(list, &c->cloud));
        shift(c, -0.041 / sqrt(DIM));
        assert_false(engine->stale(list, &c->cloud));
        c->x[5 * DIM + 1] += 0.0199;
        c->x[0] = -2;
        assert_int_equal(engine->update(list, &c->cloud), 0);
        assert_int_equal(list->builds, 1);
        c->x[5 * DIM + 1] += 0.0202;
        assert_true(engine->stale(list, &c->cloud));
        assert_int_equal(engine->update(list, &c->cloud), 0);
        assert_int_equal(list->builds, 2);
        c->x[0] = 0;
        assert_int_equal(engine->update(list, &c->cloud), 0);
        assert_int_equal(list->builds, 3);
        assert_true(list->slot[0] >= 0);
        c->x[0] = -0.009; /* gone, but not far enough for a rebuild */
        assert_int_equal(engine->update(list, &c->cloud), 0);
        assert_int_equal(list->builds, 3);
        engine->free(&list);
        space_cloud_free(c);
    }
}

void list_reports_bad_positions(void **state)
{
    static const double bad[] = { NAN, INFINITY, -INFINITY };

    (void)state;
    for (int e = 0; e < space_engines(); e++)
        for (int b = 0; b < 3; b++) {
            const struct list_engine *engine = space_engine(e)->list;
            struct space_cloud *c = space_cloud(mixed, 0.15, 0.02);
            struct list *list = make(engine, c);
            const double good = c->x[17 * DIM], y = c->x[200 * DIM + 1];

            c->x[200 * DIM + 1] = bad[b];
            c->x[17 * DIM] = bad[b];
            assert_true(engine->update(list, &c->cloud) != 0);
            assert_int_equal(list->bad, 17);
            c->x[17 * DIM] = good;
            assert_true(engine->update(list, &c->cloud) != 0);
            assert_int_equal(list->bad, 200);
            c->x[200 * DIM + 1] = y < 0.5 ? y + 0.3 : y - 0.3; /* a rebuild */
            assert_int_equal(engine->update(list, &c->cloud), 0);
            assert_int_equal(list->bad, -1);
            check_fresh(c, list);
            engine->free(&list);
            space_cloud_free(c);
        }
}

/* A huge box and a tiny support: time and memory stay small, all is found. */
void list_bounds_its_grid(void **state)
{
    static const int few[KINDS] = { 100, 20 };
    struct space_cloud *c = space_cloud(few, 1e-3, 1e-4);

    (void)state;
    for (int d = 0; d < DIM; d++) {
        c->def.low[d] = -1e9;
        c->def.high[d] = 1e9;
    }
    for (int i = 0; i < c->n * DIM; i++)
        c->x[i] = (i / DIM) % 5 ? 3e8 + 4e-3 * c->x[i] : 1e9 * (2 * c->x[i] - 1);
    check_cloud(c);
}

/* Random walks: whenever update() is content, no pair within H is missing. */
void list_misses_nobody_moving(void **state)
{
    enum { MOVES = 10000 };
    static const int few[KINDS] = { 40, 12, 0, 5, 3 };

    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        const struct list_engine *engine = space_engine(e)->list;
        struct space_cloud *c = space_cloud(few, 0.3, 0.05);
        struct list *list = make(engine, c);
        char *listed = test_malloc((size_t)c->n * (size_t)c->n);
        long builds = 0;

        for (int move = 0; move < MOVES; move++) {
            for (int i = 0; i < c->n * DIM; i++) {
                c->x[i] += 0.02 * (space_random() - 0.5);
                c->x[i] = fmin(1, fmax(0, c->x[i]));
            }
            assert_int_equal(engine->update(list, &c->cloud), 0);
            if (list->builds != builds)
                mark(list, c, listed);
            builds = list->builds;
            check_pairs(c, listed, c->def.support, 2);
        }
        check(builds > MOVES / 50 && builds < MOVES, "%ld rebuilds: the margin does its work",
              builds);
        test_free(listed);
        engine->free(&list);
        space_cloud_free(c);
    }
}
