/* vector-rearrange.c -- rows of y change places in all vectors of a family.
 *
 * Sums that are put off, zeros that are not written and norms that are known stay what
 * they are: all that they refer to moves alike. */
#include "algebra/vector-private.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <stdlib.h>
#include <string.h>

/* What moving one block after the other needs. */
struct scratch {
    double *x;             /* a block's numbers                                */
    int *to;               /* [rows] where a row goes                          */
};

static long end_of(const struct vector_rows *b)
{
    return b->offset + (long)b->n * b->components;
}

/* Inside or outside of each range as a whole? Vectors differ in what they hold there. */
static bool apart(const struct vector_family *f, const struct vector_rows *b)
{
    for (int k = 0; k < f->ranges; k++) {
        const long from = f->range[k][0], to = f->range[k][1];

        if (!(end_of(b) <= from || b->offset >= to || (b->offset >= from && end_of(b) <= to)))
            return false;
    }
    return true;
}

/* Fills to[], the inverse of from[]; false: there is none. */
static bool invert(const struct vector_rows *b, int *to)
{
    memset(to, -1, (size_t)b->n * sizeof *to);
    for (int i = 0; i < b->n; i++) {
        if (b->from[i] < 0 || b->from[i] >= b->n || to[b->from[i]] >= 0)
            return false;
        to[b->from[i]] = i;
    }
    return true;
}

static int check(const struct vector_family *f, int blocks, const struct vector_rows *block,
                 struct scratch *s)
{
    for (int k = 0; k < blocks; k++)
        if (!apart(f, &block[k]) || (block[k].from && !invert(&block[k], s->to)))
            return status_fail(STATUS_FAILED, "rows %ld to %ld of a vector cannot change places "
                               "like that", block[k].offset, end_of(&block[k]) - 1);
    return STATUS_DONE;
}

/* What comes, and what moves, goes where rows have left, or behind all that were there. */
static void travel(const struct vector_rows *b, double *x)
{
    const struct vector_travel *t = b->travel;
    const size_t c = (size_t)b->components, row = c * sizeof *x;

    ranks_route_go(t->route, row, x, t->room);
    for (int i = 0; i < t->leaving; i++)
        memset(x + (size_t)t->out[i] * c, 0, row);
    for (int i = 0; i < t->moving; i++) {
        memcpy(x + (size_t)t->now[i] * c, x + (size_t)t->was[i] * c, row);
        memset(x + (size_t)t->was[i] * c, 0, row);
    }
    for (int i = 0; i < t->coming; i++)
        memcpy(x + (size_t)t->in[i] * c, t->room + (size_t)i * c, row);
}

static void move_block(const struct vector_rows *b, double *data, double *scratch)
{
    const size_t c = (size_t)b->components, row = c * sizeof *data;
    double *x = data + b->offset;

    if (!b->from) {
        travel(b, x);
        return;
    }
    memcpy(scratch, x, (size_t)b->n * row);
    for (int i = 0; i < b->n; i++)
        memcpy(x + (size_t)i * c, scratch + (size_t)b->from[i] * c, row);
}

/* Where entry i goes. */
static long moved(const struct vector_rows *b, const int *to, long i)
{
    if (i < b->offset || i >= end_of(b))
        return i;
    to = b->from ? to : b->travel->to;
    i -= b->offset;
    return b->offset + (long)to[i / b->components] * b->components + i % b->components;
}

/* Rows of this rank end elsewhere from now on; returns where they ended. */
static long end_anew(struct vector_family *f, const struct vector_rows *b, long now)
{
    for (int k = 0; k < f->own.pieces && !b->from; k++)
        if (f->piece[k][0] == b->offset) {
            const long last = f->piece[k][1];
            f->piece[k][1] = now;
            return last;
        }
    return now;
}

/* What is no vector's just now is 0, too, where rows are no longer here. */
static void rearrange(struct vector_family *f, const struct vector_rows *b, struct scratch *s)
{
    const long now = b->from ? end_of(b) : b->offset + (long)b->travel->rows * b->components;
    const long last = end_anew(f, b, now);

    if (b->from)
        invert(b, s->to);
    for (struct vector_store *store = f->all; store; store = store->other) {
        if (store->users == 0) {
            if (last > now)
                memset(store->data + now, 0, (size_t)(last - now) * sizeof *store->data);
            continue;
        }
        move_block(b, store->data, s->x);
        store->largest = moved(b, s->to, store->largest);
    }
    f->largest = moved(b, s->to, f->largest);
    for (long i = 0; i < f->n && b->from; i++)
        f->order[i] = moved(b, s->to, f->order[i]);
}

static bool stay(int blocks, const struct vector_rows *block)
{
    bool all = true;

    for (int k = 0; k < blocks; k++)
        all &= block[k].from == NULL;
    return all;
}

/* False: no memory. */
static bool make_room(struct vector_family *f, int blocks, const struct vector_rows *block,
                      struct scratch *s)
{
    size_t entries = 1, rows = 1;

    if (stay(blocks, block))
        return true;
    for (int k = 0; k < blocks; k++) {
        const size_t n = (size_t)block[k].n, all = n * (size_t)block[k].components;

        rows = n > rows ? n : rows;
        entries = all > entries ? all : entries;
    }
    s->x = malloc(entries * sizeof *s->x);
    s->to = malloc(rows * sizeof *s->to);
    if (!s->x || !s->to)
        return false;
    if (f->order)
        return true;
    f->order = malloc(((size_t)f->n + 1) * sizeof *f->order);
    for (long i = 0; i < f->n && f->order; i++)
        f->order[i] = i;
    return f->order != NULL;
}

int vector_rearrange(N_Vector v, int blocks, const struct vector_rows *block)
{
    struct vector_family *f = vector_content(v)->family;
    struct scratch s = { 0 };
    int status = STATUS_DONE;

    if (!make_room(f, blocks, block, &s))
        status = status_starved("%ld numbers cannot change places", f->n);
    if (status == STATUS_DONE)
        status = check(f, blocks, block, &s);
    for (int k = 0; k < blocks && status == STATUS_DONE; k++)
        rearrange(f, &block[k], &s);
    free(s.x);
    free(s.to);
    return status;
}

int vector_rows_move(int blocks, const struct vector_rows *block, int arrays, double *const *x)
{
    size_t entries = 1;
    const bool here = stay(blocks, block);
    double *scratch = NULL;

    for (int k = 0; k < blocks; k++) {
        const size_t all = (size_t)block[k].n * (size_t)block[k].components;
        entries = all > entries ? all : entries;
    }
    if (!here && !(scratch = status_alloc(entries, sizeof *scratch)))
        return STATUS_FAILED;
    for (int i = 0; i < arrays; i++)
        for (int k = 0; k < blocks && x[i]; k++)
            move_block(&block[k], x[i], scratch);
    free(scratch);
    return STATUS_DONE;
}

long vector_rows_moved(int blocks, const struct vector_rows *block, long i)
{
    for (int k = 0; k < blocks; k++) {
        const struct vector_rows *b = &block[k];

        if (!b->from) {
            i = moved(b, NULL, i);
            continue;
        }
        for (int to = 0; to < b->n && i >= b->offset && i < end_of(b); to++)
            if (b->from[to] == (i - b->offset) / b->components)
                return b->offset + (long)to * b->components + (i - b->offset) % b->components;
    }
    return i;
}
