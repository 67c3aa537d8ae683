/* vector-store.c -- where the numbers of a vector are: in a store that copies share,
 * and perhaps not yet summed. */
#include "algebra/vector-private.h"

#include "base/threads.h"

#include <stdint.h>
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

/* The same, of what this rank has. */
static bool next_part(const struct vector_family *f, long *from, long to, long *end)
{
    long last;

    while (vector_piece(f, from, to, &last)) {
        if (next_piece(f, from, last, end))
            return true;
        *from = last;
    }
    return false;
}

void vector_sum_block(const struct vector_content *c, long b)
{
    const struct vector_sum *s = &c->sum;
    const double *x[VECTOR_TERMS], *unit = s->unit ? s->unit->data : NULL;
    long from = b * VECTOR_BLOCK, to = from + vector_block_size(c->family->n, b), end;

    for (int k = 0; k < s->terms; k++)
        x[k] = s->x[k]->data;
    for (; next_part(c->family, &from, to, &end); from = end)
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

    for (; next_part(c->family, &from, c->family->n, &end); from = end)
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
        vector_own_copy(c->family, old, c->store->data);
    return c->store->data;
}

/* --- life ---------------------------------------------------------------- */

/* What is never written, rows of other ranks, is 0 and takes no memory: calloc() has it mapped alone. */
static struct vector_store *new_store(long n)
{
    const size_t bytes = (size_t)n * sizeof(double) + 128;
    struct vector_store *store = calloc(1, sizeof *store);

    if (!store)
        return NULL;
    store->memory = calloc(1, bytes);
    if (!store->memory) {
        free(store);
        return NULL;
    }
    store->data = (double *)((char *)store->memory + (64 - (uintptr_t)store->memory % 64));
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
    free(store->memory);
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
    free(f->piece);
    free(f->order);
    free(f->partial);
    free(f);
}
