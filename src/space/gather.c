/* gather.c -- fetches records and forms the rows. */
#include "space/gather.h"

#include "space/fetch.h"
#include "space/list.h"
#include "space/record.h"

#include <stdbool.h>
#include <stddef.h>

/* All that LANES records hold. */
LANES_INLINE void fetch_records(const double *const of[LANES], struct side *s)
{
#if DIM == 2
    fetch_four(of, RECORD_X, &s->x[0], &s->x[1], &s->v[0], &s->v[1]);
    fetch_four(of, RECORD_RHO, &s->rho, &s->p2, &s->m, &s->irho);
#else
    fetch_four(of, RECORD_X, &s->x[0], &s->x[1], &s->x[2], &s->rho);
    fetch_four(of, RECORD_V, &s->v[0], &s->v[1], &s->v[2], &s->p2);
    fetch_two(of, RECORD_M, &s->m, &s->irho);
#endif
}

/* Those that a row of the list names. */
LANES_INLINE void whole(const double *record, const int *j, struct side *s)
{
    const double *of[LANES];

    for (int l = 0; l < LANES; l++)
        of[l] = list_at(record, j[l], RECORD);
    fetch_records(of, s);
}

/* Those of places one after the other: no address but the first need be formed. */
LANES_INLINE void whole_run(const double *first, struct side *s)
{
    const double *of[LANES];

    for (int l = 0; l < LANES; l++)
        of[l] = first + l * RECORD;
    fetch_records(of, s);
}

LANES_INLINE lanes dot(const lanes *a, const lanes *b)
{
    lanes sum = a[0] * b[0];

    for (int d = 1; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

/* One row but for its r, of which r^2 is returned; `needs` is a constant, so what is not needed
 * is not even loaded. */
LANES_INLINE lanes gather_row(const double *record, const int *j, const struct side *a,
                             struct block *b, int k, unsigned needs)
{
    struct side of;
    lanes x[DIM], v[DIM];

    whole(record, j, &of);
    gather_separation(a->x, of.x, x);
    const lanes r2 = dot(x, x);
    b->r2[k] = r2;
    b->mm[k] = a->m * of.m;
    for (int d = 0; d < DIM; d++) {
        b->x[d][k] = x[d];
        v[d] = a->v[d] - of.v[d];
        if (needs & NEED_V)
            b->v[d][k] = v[d];
    }
    if (needs & NEED_XV)
        b->xv[k] = dot(x, v);
    if (needs & NEED_RHO) {
        b->rho[k] = of.rho;
        b->p2[k] = of.p2;
    }
    if (needs & NEED_IRHO)
        b->irho[k] = of.irho;
    if (needs & NEED_MASS)
        b->m[k] = of.m;
    return r2;
}

/* The root is taken here because here it hides behind the loads, and a row later than the rest
 * because then what comes behind it need not wait for it. */
LANES_INLINE void gather(const double *record, const int *j, int n, const struct side *a,
                         struct block *b, unsigned needs)
{
    lanes last = { 0 };

    for (int k = 0; k < n; k++, j += LANES) {
        const lanes r2 = gather_row(record, j, a, b, k, needs);

        if (k > 0)
            b->r[k - 1] = lanes_sqrt(last);
        last = r2;
    }
    if (n > 0)
        b->r[n - 1] = lanes_sqrt(last);
}

#define GATHER(name, needs)                                                                \
    static void name(const double *record, const int *j, int n, const struct side *a,      \
                     struct block *b)                                                      \
    {                                                                                      \
        gather(record, j, n, a, b, needs);                                                 \
    }

GATHER(gather_place, 0)
GATHER(gather_place_rho, NEED_RHO)
GATHER(gather_approach, NEED_XV)
GATHER(gather_approach_rho, NEED_XV | NEED_RHO)
GATHER(gather_approach_all_rho, NEED_XV | NEED_RHO | NEED_IRHO)
GATHER(gather_all, NEED_XV | NEED_RHO | NEED_V | NEED_IRHO | NEED_MASS)

gather_rows *gather_choose(unsigned needs)
{
    const bool rho = needs & (NEED_RHO | NEED_P2);

    if (needs & (NEED_MASS | NEED_V))
        return gather_all;
    if (needs & NEED_IRHO)
        return gather_approach_all_rho;
    if (needs & NEED_XV)
        return rho ? gather_approach_rho : gather_approach;
    return rho ? gather_place_rho : gather_place;
}

void gather_side(const double *record, int first, int end, int dummy, struct side *a)
{
    int j[LANES];

    if (first + LANES <= end) {
        whole_run(record + (size_t)first * RECORD, a);
        return;
    }
    for (int l = 0; l < LANES; l++)
        j[l] = list_entry(first + l < end ? first + l : dummy);
    whole(record, j, a);
    for (int l = 0; l < LANES; l++)
        for (int d = 0; d < DIM; d++)
            if (first + l >= end)
                a->x[d][l] = -a->x[d][l];
}
