/* space-rows.c -- rows in any order: by ids, the pair list is the same. */
#include "space.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const int mixed[KINDS] = { 150, 61, 30, 23, 10 };

/* The particles of `ids`, whose rows ascend by id, in other rows. */
struct shuffled {
    const struct space_cloud *ids;
    struct cloud cloud;
    double *x;                 /* [n][DIM] by row                            */
    int *row[KINDS], *from[KINDS]; /* [count of kind] by id; by row: the row before */
};

static int count_of(const struct shuffled *s, int kind)
{
    return s->ids->def.from[kind + 1] - s->ids->def.from[kind];
}

/* Row, among all, of an id. */
static int row_of(const struct shuffled *s, int id)
{
    const int kind = space_kind(s->ids, id), from = s->ids->def.from[kind];

    return from + s->row[kind][id - from];
}

/* Positions of all ids to their rows. */
static void carry(struct shuffled *s)
{
    for (int id = 0; id < s->ids->n; id++)
        memcpy(s->x + row_of(s, id) * DIM, s->ids->x + id * DIM, DIM * sizeof *s->x);
}

/* Other rows; notes which rows they were. */
static void shuffle(struct shuffled *s)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const int n = count_of(s, kind);
        int *row = s->row[kind], *old = test_malloc(((size_t)n + 1) * sizeof *old);

        memcpy(old, row, (size_t)n * sizeof *old);
        for (int i = n - 1; i > 0; i--) {
            const int k = (int)(space_random() * (i + 1)), swap = row[i];
            row[i] = row[k];
            row[k] = swap;
        }
        for (int i = 0; i < n; i++)
            s->from[kind][row[i]] = old[i];
        test_free(old);
    }
    carry(s);
}

static struct shuffled *shuffled(const struct space_cloud *ids)
{
    struct shuffled *s = test_calloc(1, sizeof *s);

    s->ids = ids;
    s->x = test_malloc(((size_t)ids->n + 1) * DIM * sizeof *s->x);
    s->cloud = ids->cloud;
    for (int kind = 0; kind < KINDS; kind++) {
        const size_t bytes = ((size_t)count_of(s, kind) + 1) * sizeof(int);

        s->cloud.x[kind] = s->x + ids->def.from[kind] * DIM;
        s->cloud.row[kind] = s->row[kind] = test_malloc(bytes);
        s->from[kind] = test_malloc(bytes);
        for (int i = 0; i < count_of(s, kind); i++)
            s->row[kind][i] = i;
    }
    shuffle(s);
    return s;
}

static void shuffled_free(struct shuffled *s)
{
    for (int kind = 0; kind < KINDS; kind++) {
        test_free(s->row[kind]);
        test_free(s->from[kind]);
    }
    test_free(s->x);
    test_free(s);
}

static void same_rows(const struct list *a, const struct list *b)
{
    assert_memory_equal(a->segment_from, b->segment_from, (size_t)(a->groups + 1) * sizeof(int));
    for (int k = 0; k < a->segment_from[a->groups]; k++) {
        const struct list_segment *of = &a->segment[k], *other = &b->segment[k];

        assert_int_equal(of->partner, other->partner);
        assert_int_equal(of->rows, other->rows);
        assert_memory_equal(of->j, other->j, (size_t)(of->rows * a->lanes) * sizeof(int));
    }
}

/* a speaks of ids, b of rows. */
static void same_lists(const struct shuffled *s, const struct list *a, const struct list *b)
{
    assert_int_equal(a->listed, b->listed);
    assert_int_equal(a->builds, b->builds);
    assert_int_equal(a->groups, b->groups);
    assert_memory_equal(a->start, b->start, sizeof a->start);
    assert_memory_equal(a->image, b->image, sizeof a->image);
    for (int i = 0; i < a->listed; i++)
        check(b->order[i] == row_of(s, a->order[i]), "place %d holds row %d instead of %d", i,
              b->order[i], row_of(s, a->order[i]));
    for (int id = 0; id < a->n; id++)
        assert_int_equal(a->slot[id], b->slot[row_of(s, id)]);
    assert_int_equal(a->offset == NULL, b->offset == NULL);
    if (a->offset)
        assert_memory_equal(a->offset, b->offset, (size_t)a->listed * sizeof *a->offset);
    same_rows(a, b);
}

/* Crowded cells, several particles in one place, some outside of the box, directions in
 * `which` (bits) periodic. */
static struct space_cloud *cloud_of(unsigned seed, unsigned which)
{
    struct space_cloud *c;

    space_seed(seed);
    c = space_cloud(mixed, 0.05 + 0.3 * space_random(), 0.02 * (seed % 3));
    for (int i = 0; i < c->n; i += 17)
        memcpy(c->x + i * DIM, c->x + (i + 5) % c->n * DIM, DIM * sizeof *c->x);
    for (int d = 0; d < DIM; d++)
        if (which & 1u << d) {
            c->def.period[d] = 1;
            c->def.side[d] = -0.3;
            c->def.low[d] = -INFINITY;
            c->def.high[d] = INFINITY;
        } else {
            for (int i = 0; i < c->n; i += 9)
                c->x[i * DIM + d] += i % 2 ? 1 : -3;
        }
    return c;
}

static void make(const struct list_engine *engine, struct shuffled *s, struct list **a,
                 struct list **b)
{
    assert_int_equal(engine->create(a, &s->ids->def), 0);
    assert_int_equal(engine->create(b, &s->ids->def), 0);
    assert_int_equal(engine->update(*a, &s->ids->cloud), 0);
    assert_int_equal(engine->update(*b, &s->cloud), 0);
}

void rows_change_no_list(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed < 30; seed++)
        for (int e = 0; e < space_engines(); e++) {
            const struct list_engine *engine = space_engine(e)->list;
            struct space_cloud *c = cloud_of(seed, seed % (1u << DIM));
            struct shuffled *s = shuffled(c);
            struct list *a, *b;

            make(engine, s, &a, &b);
            same_lists(s, a, b);
            engine->free(&a);
            engine->free(&b);
            shuffled_free(s);
            space_cloud_free(c);
        }
}

/* Random walks of kinds that move: rows change between rebuilds, which stay where they were. */
static void walk(const struct list_engine *engine, struct space_cloud *c, struct shuffled *s)
{
    enum { MOVES = 60 };
    struct list *a, *b;

    make(engine, s, &a, &b);
    for (int move = 0; move < MOVES; move++) {
        for (int i = 0; i < c->n; i++)
            for (int d = 0; d < DIM && !(c->def.still & KIND_BIT(space_kind(c, i))); d++)
                c->x[i * DIM + d] += 0.01 * (space_random() - 0.5);
        if (move % 4 == 0) {
            shuffle(s);
            assert_int_equal(engine->rearrange(b, (const int *const *)s->from, s->cloud.row), 0);
            same_lists(s, a, b);
        }
        carry(s);
        assert_int_equal(engine->stale(a, &c->cloud), engine->stale(b, &s->cloud));
        assert_int_equal(engine->update(a, &c->cloud), 0);
        assert_int_equal(engine->update(b, &s->cloud), 0);
        same_lists(s, a, b);
    }
    check(a->builds > 3 && a->builds < MOVES - 10, "%ld rebuilds of %d moves", a->builds, MOVES);
    engine->free(&a);
    engine->free(&b);
}

void rows_move_under_a_list(void **state)
{
    (void)state;
    for (unsigned which = 0; which < 1u << DIM; which++)
        for (int e = 0; e < space_engines(); e++) {
            struct space_cloud *c = cloud_of(2, which);
            struct shuffled *s = shuffled(c);

            c->def.still = which == 1 ? KIND_BIT(KIND_WALL) : 0;
            walk(space_engine(e)->list, c, s);
            shuffled_free(s);
            space_cloud_free(c);
        }
}

void rows_tell_the_smallest_bad_id(void **state)
{
    static const int bad[] = { 170, 200, 151 };
    struct space_cloud *c = cloud_of(4, 0);
    struct shuffled *s = shuffled(c);

    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        const struct list_engine *engine = space_engine(e)->list;
        struct list *a, *b;

        make(engine, s, &a, &b);
        for (int k = 0; k < 3; k++)
            c->x[bad[k] * DIM + 1] = k ? NAN : INFINITY;
        for (int times = 0; times < 20; times++) {
            shuffle(s);
            assert_int_equal(engine->rearrange(b, (const int *const *)s->from, s->cloud.row), 0);
            assert_int_not_equal(engine->update(a, &c->cloud), 0);
            assert_int_not_equal(engine->update(b, &s->cloud), 0);
            assert_int_equal(a->bad, 151);
            assert_int_equal(b->bad, row_of(s, 151));
        }
        for (int k = 0; k < 3; k++)
            c->x[bad[k] * DIM + 1] = 0.5;
        carry(s);
        engine->free(&a);
        engine->free(&b);
    }
    shuffled_free(s);
    space_cloud_free(c);
}
