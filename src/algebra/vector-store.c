/* vector-store.c -- where the numbers of a vector are: in a store that copies share,
 * and perhaps not yet summed. */
#include "algebra/vector-private.h"

#include "base/threads.h"

#include "ranks/ranks.h"

#include <stdlib.h>
#include <string.h>

/* --- sums that are put off ----------------------------------------------- */

/* The next piece of [*from, to) outside of the ranges; false: there is none. */
static bool next_piece(const struct vector_family *f, long *from, long to, long *end)
{
    *end = to;
    for (int k = 0; k < f->ranges && *from < to; k++) {
        const long *range = f->range[k];
        if (*from < range[0]) {
            *end = range[0] < to ? range[0] : to;
            return true;
        }
        if (*from < range[1])
            *from = range[1];
    }
    return *from < to;
}

void vector_sum_block(const struct vector_content *c, long b)
{
    const struct vector_sum *s = &c->sum;
    const double *x[VECTOR_TERMS], *unit = s->unit ? s->unit->data : NULL;
    long from = b * VECTOR_BLOCK, to = from + vector_block_size(c->family->n, b), end;

    for (int k = 0; k < s->terms; k++)
        x[k] = s->x[k]->data;
    for (; next_piece(c->family, &from, to, &end); from = end)
        vector_add_up(c->family->wide, unit, s->terms, s->c, x, from, (int)(end - from),
                      c->store->data);
}

static void forget(struct vector_content *c)
{
    struct vector_family *f = c->family;
    int k = 0;

    while (f->put_off[k] != c)
        k++;
    for (f->sums--; k < f->sums; k++)
        f->put_off[k] = f->put_off[k + 1];
}

void vector_summed(struct vector_content *c)
{
    forget(c);
    c->outside = VECTOR_HERE;
}

static void sum_blocks(struct vector_content *c)
{
#pragma omp for schedule(static) nowait
    for (long b = 0; b < vector_blocks(c->family->n); b++)
        vector_sum_block(c, b);
}

static void sum_up(struct vector_content *c)
{
    THREADS(c->family->n > VECTOR_LONG, sum_blocks(c));
    vector_summed(c);
}

static bool reads(const struct vector_sum *s, const struct vector_store *store)
{
    for (int k = 0; k < s->terms; k++)
        if (s->x[k] == store)
            return true;
    return s->unit == store;
}

/* Does all sums that read a store. */
static void settle_readers(const struct vector_family *f, const struct vector_store *store)
{
    for (int k = f->sums - 1; k >= 0; k--)
        if (reads(&f->put_off[k]->sum, store))
            sum_up(f->put_off[k]);
}

void vector_put_off(struct vector_content *c, const struct vector_sum *sum)
{
    struct vector_family *f = c->family;

    if (f->sums == VECTOR_PUT_OFF)
        sum_up(f->put_off[0]);
    c->sum.unit = sum->unit;
    c->sum.terms = sum->terms;
    memcpy(c->sum.c, sum->c, (size_t)sum->terms * sizeof *sum->c);
    memcpy(c->sum.x, sum->x, (size_t)sum->terms * sizeof *sum->x);
    c->outside = VECTOR_LATER;
    f->put_off[f->sums++] = c;
}

static void write_zeros(struct vector_content *c)
{
    long from = 0, end;

    for (; next_piece(c->family, &from, c->family->n, &end); from = end)
        memset(c->store->data + from, 0, (size_t)(end - from) * sizeof(double));
    c->outside = VECTOR_HERE;
    c->nothing = false;
}

void vector_settle(struct vector_content *c)
{
    if (c->outside == VECTOR_LATER)
        sum_up(c);
    else if (c->outside == VECTOR_ZERO)
        write_zeros(c);
}

/* --- stores -------------------------------------------------------------- */

static void use(struct vector_content *c, struct vector_store *store)
{
    store->users++;
    c->store = store;
    c->serial.data = store->data;
}

static void release(struct vector_content *c)
{
    struct vector_store *store = c->store;

    if (--store->users > 0)
        return;
    settle_readers(c->family, store);
    store->next = c->family->spare;
    c->family->spare = store;
}

/* A store of its own; there always is one, as the family has one for each vector. */
static void take_spare(struct vector_content *c)
{
    struct vector_store *store = c->family->spare;

    c->family->spare = store->next;
    use(c, store);
}

static void touched(struct vector_store *store)
{
    static long times;

    store->written = ++times;
    store->by = 0;
}

double *vector_renew(struct vector_content *c)
{
    if (c->outside == VECTOR_LATER)
        forget(c);
    c->outside = VECTOR_HERE;
    c->nothing = false;
    if (c->store->users > 1) {
        release(c);
        take_spare(c);
    } else {
        settle_readers(c->family, c->store);
    }
    touched(c->store);
    return c->store->data;
}

void vector_share(struct vector_content *from, struct vector_content *to)
{
    vector_settle(from);
    if (to->outside == VECTOR_LATER)
        forget(to);
    to->outside = VECTOR_HERE;
    to->nothing = false;
    if (to->store == from->store)
        return;
    release(to);
    use(to, from->store);
}

/* --- for all ------------------------------------------------------------- */

const double *vector_read(N_Vector v)
{
    vector_settle(vector_content(v));
    return vector_content(v)->store->data;
}

bool vector_same(N_Vector v, N_Vector w)
{
    const double *x = vector_read(v), *y = vector_read(w);
    double differs;

    if (x == y) /* which copies share is the same on all ranks */
        return true;
    differs = memcmp(x, y, (size_t)vector_content(v)->family->n * sizeof *x) != 0;
    ranks_most(1, &differs);
    return differs == 0;
}

double *vector_overwrite(N_Vector v)
{
    return vector_renew(vector_content(v));
}

double *vector_data(N_Vector v)
{
    struct vector_content *c = vector_content(v);
    const double *old;

    vector_settle(c);
    old = c->store->data;
    vector_renew(c);
    if (c->store->data != old)
        vector_copy(c->family->n, old, c->store->data);
    return c->store->data;
}

/* --- life ---------------------------------------------------------------- */

static struct vector_store *new_store(long n)
{
    const size_t bytes = ((size_t)(n > 0 ? n : 1) * sizeof(double) + 63) / 64 * 64;
    struct vector_store *store = calloc(1, sizeof *store);

    if (!store)
        return NULL;
    store->data = aligned_alloc(64, bytes);
    if (!store->data) {
        free(store);
        return NULL;
    }
    return store;
}

bool vector_join(struct vector_content *c, struct vector_family *f)
{
    struct vector_store *store = new_store(f->n);

    if (!store)
        return false;
    c->serial.length = f->n;
    c->family = f;
    f->members++;
    store->other = f->all;
    f->all = store;
    use(c, store);
    touched(store);
    return true;
}

/* A spare store of f is no more. */
static void end_spare(struct vector_family *f)
{
    struct vector_store *store = f->spare, **at = &f->all;

    f->spare = store->next;
    while (*at != store)
        at = &(*at)->other;
    *at = store->other;
    free(store->data);
    free(store);
}

void vector_leave(struct vector_content *c)
{
    struct vector_family *f = c->family;

    if (c->outside == VECTOR_LATER)
        forget(c);
    release(c);
    end_spare(f);
    if (--f->members > 0)
        return;
    free(f->range);
    free(f->order);
    free(f->partial);
    free(f);
}
