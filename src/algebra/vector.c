/* vector.c -- life of our vectors, and their table of operations. */
#include "algebra/vector-private.h"

#include "base/status.h"
#include "base/threads.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static N_Vector_ID kind(N_Vector v)
{
    (void)v;
    return SUNDIALS_NVEC_CUSTOM;
}

static sunindextype length(N_Vector v)
{
    return vector_content(v)->family->n;
}

static void space(N_Vector v, sunindextype *numbers, sunindextype *integers)
{
    *numbers = length(v);
    *integers = 1;
}

static void destroy(N_Vector v)
{
    struct vector_content *c = v->content;

    if (c && c->family)
        vector_leave(c);
    free(c);
    v->content = NULL;
    N_VFreeEmpty(v);
}

static void clear_block(const struct vector_family *f, double *data, long b)
{
    const long to = b * VECTOR_BLOCK + vector_block_size(f->n, b);
    long from = b * VECTOR_BLOCK, end;

    for (; vector_piece(f, &from, to, &end); from = end)
        memset(data + from, 0, (size_t)(end - from) * sizeof *data);
}

/* By this thread, which gets them into memory near it. */
static void clear_blocks(const struct vector_family *f, double *data)
{
#pragma omp for schedule(static) nowait
    for (long b = 0; b < vector_blocks(f->n); b++)
        clear_block(f, data, b);
}

static bool fill(N_Vector v, struct vector_family *f)
{
    struct vector_content *c = calloc(1, sizeof *c);

    v->content = c;
    if (!c || !vector_join(c, f))
        return false;
    THREADS(f->n > VECTOR_LONG, clear_blocks(f, c->store->data));
    return true;
}

/* SUNDIALS reads a clone before it looks whether there is one (N_VClone of 6.4.1), so that there
 * is no way back.  It clones when a method is made, and in the first step. */
static void end_starved(N_Vector v)
{
    status_starved("one more vector of %ld numbers cannot be had", (long)length(v));
    fprintf(stderr, "stiffwater: %s\n", status_message());
    exit(STATUS_FAILED);
}

static N_Vector clone(N_Vector v)
{
    N_Vector w = N_VNewEmpty(v->sunctx);

    if (!w || N_VCopyOps(v, w) != 0 || !fill(w, vector_content(v)->family))
        end_starved(v);
    return w;
}

static void set_operations(N_Vector v)
{
    v->ops->nvgetvectorid = kind;
    v->ops->nvgetlength = length;
    v->ops->nvspace = space;
    v->ops->nvclone = clone;
    v->ops->nvdestroy = destroy;
    v->ops->nvlinearcombination = vector_sum_combination;
    v->ops->nvlinearsum = vector_sum_two;
    v->ops->nvscale = vector_sum_scale;
    v->ops->nvconst = vector_sum_constant;
    v->ops->nvwrmsnorm = vector_norm_weighted;
    v->ops->nvdotprod = vector_dot_product;
    vector_serial_operations(v);
}

static struct vector_family *new_family(long n, enum vector_norm norm)
{
    struct vector_family *f = status_alloc(1, sizeof *f);

    if (!f)
        return NULL;
    *f = (struct vector_family){ .norm = norm, .n = n, .largest = -1,
                                  .wide = vector_wide() };
    f->partial = status_alloc(2 * (unsigned long)vector_blocks(n), sizeof *f->partial);
    if (f->partial)
        return f;
    free(f);
    return NULL;
}

static void end_family(struct vector_family *f)
{
    if (f->members > 0)
        return;
    free(f->partial);
    free(f->piece);
    free(f);
}

/* False: no memory. */
static bool take_pieces(struct vector_family *f, const struct vector_own *own)
{
    f->own = *own;
    f->own.piece = NULL;
    f->piece = status_alloc((size_t)own->pieces + 1, sizeof *f->piece);
    if (f->piece && own->pieces > 0)
        memcpy(f->piece, own->piece, (size_t)own->pieces * sizeof *f->piece);
    return f->piece != NULL;
}

N_Vector vector_create(long n, enum vector_norm norm, SUNContext context)
{
    return vector_create_own(n, norm, context, &(struct vector_own){ 0 });
}

N_Vector vector_create_own(long n, enum vector_norm norm, SUNContext context,
                           const struct vector_own *own)
{
    struct vector_family *f = new_family(n, norm);
    N_Vector v = f && take_pieces(f, own) ? N_VNewEmpty(context) : NULL;

    if (v)
        set_operations(v);
    if (v && fill(v, f))
        return v;
    status_starved("a vector of %ld numbers cannot be had", n);
    if (v)
        destroy(v);
    if (f)
        end_family(f);
    return NULL;
}

static int ascending(const void *l, const void *r)
{
    const long *a = l, *b = r;

    return (*a > *b) - (*a < *b);
}

int vector_ranges(N_Vector v, int ranges, const long (*range)[2])
{
    struct vector_family *f = vector_content(v)->family;

    free(f->range);
    f->ranges = 0;
    f->range = status_alloc((unsigned long)ranges + 1, sizeof *f->range);
    if (!f->range)
        return STATUS_FAILED;
    memcpy(f->range, range, (size_t)ranges * sizeof *range);
    qsort(f->range, (size_t)ranges, sizeof *f->range, ascending);
    f->ranges = ranges;
    return STATUS_DONE;
}
