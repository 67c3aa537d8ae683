/* vector-own.c -- what a rank has of y, and which entry all ranks speak of. */
#include "algebra/vector-private.h"

#include "ranks/ranks.h"

#include <float.h>
#include <math.h>
#include <string.h>

void vector_take(N_Vector v, const double *x)
{
    vector_own_copy(vector_content(v)->family, x, vector_overwrite(v));
}

long vector_own_leading(const struct vector_family *f, const double *x, const double *weight,
                        const double *partial, long lead)
{
    long first = -1;

    for (long b = lead; b < vector_blocks(f->n); b++) {
        const long to = b * VECTOR_BLOCK + vector_block_size(f->n, b);
        long i = b * VECTOR_BLOCK, end;

        for (; partial[b] == partial[lead] && vector_piece(f, &i, to, &end); i = end)
            for (; i < end; i++) {
                const double e = fabs(x[i] * weight[i]);
                const long name = (e <= DBL_MAX ? e : INFINITY) == partial[lead]
                                      ? f->own.common(f->own.self, i) : -1;
                first = name >= 0 && (first < 0 || name < first) ? name : first;
            }
    }
    return first < 0 ? f->n - 1 : first;
}

bool vector_same(N_Vector v, N_Vector w)
{
    const double *x = vector_read(v), *y = vector_read(w);
    const struct vector_family *f = vector_content(v)->family;
    double differs = 0;
    long from = 0, end;

    if (x == y) /* which copies share is the same on all ranks */
        return true;
    for (; vector_piece(f, &from, f->n, &end) && differs == 0; from = end)
        differs = memcmp(x + from, y + from, (size_t)(end - from) * sizeof *x) != 0;
    ranks_most(1, &differs);
    return differs == 0;
}

/* --- what is no number ---------------------------------------------------------------------- */

/* The first of all ranks, who each bring the name of theirs. */
static long of_all(const struct vector_own *own, long bad)
{
    if (ranks_first(bad < 0 ? HUGE_VAL : 0, bad, &bad, sizeof bad) < 0)
        return -1;
    return own->pieces > 0 ? own->here(own->self, bad) : bad;
}

/* By the name that all ranks give it. */
static long bad_of_own(const struct vector_own *own, const long (*piece)[2], const double *x)
{
    long first = -1;

    for (int k = 0; k < own->pieces; k++)
        for (long i = piece[k][0]; i < piece[k][1]; i++)
            if (!(fabs(x[i]) <= DBL_MAX)) {
                const long name = own->common(own->self, i);
                first = first < 0 || name < first ? name : first;
            }
    return first;
}

static long bad_here(const struct vector_family *f, const double *x)
{
    const long bad = vector_first_bad(f->n, x);
    long i = 0;

    if (bad < 0 || !f->order)
        return bad;
    while (fabs(x[f->order[i]]) <= DBL_MAX)
        i++;
    return f->order[i];
}

/* No finite norm has an entry that is not; all ranks know it. */
long vector_bad(N_Vector v)
{
    const struct vector_family *f = vector_content(v)->family;
    const struct vector_store *s = vector_content(v)->store;

    vector_settle(vector_content(v));
    if (s->by && s->norm <= DBL_MAX)
        return -1;
    return of_all(&f->own, f->own.pieces > 0
                               ? bad_of_own(&f->own, (const long (*)[2])f->piece, s->data)
                               : bad_here(f, s->data));
}

long vector_bad_anywhere(long n, const double *x, const struct vector_own *own)
{
    return of_all(own, own->pieces > 0 ? bad_of_own(own, own->piece, x) : vector_first_bad(n, x));
}
