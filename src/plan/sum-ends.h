/* sum-ends.h -- what becomes of the sums of one group of owners: rates in their places, and
 * powers in the book.  For files of sums over pairs, in either precision. */
#ifndef PLAN_SUM_ENDS_H
#define PLAN_SUM_ENDS_H

#include "plan/sum.h"

#include "algebra/exact-rows.h"
#include "space/visit.h"

#include <string.h>

_Static_assert((int)VISIT_GROUPS <= (int)EXACT_ROWS, "rows of a chunk");

/* Powers of the owners of one chunk, by row of the book. */
struct chunk_power {
    struct exact_rows rows[SUM_SLOTS];  /* [slots] [W]                         */
};

/* rho dp/drho [Pa] of owners. */
static inline lanes moduli(const struct sum_job *job, lanes rho, lanes p)
{
    lanes modulus;

    job->moduli(job->eos, LANES, (const double *)&rho, (const double *)&p, (double *)&modulus);
    return modulus;
}

/* Velocities of fluid and p/rho^2 as they will be `later`, to first order; those
 * of solids are not the pairs' to change. */
static inline void look_ahead(const struct sum_job *job, int first, int owners, const struct sum *all,
                       struct side *a)
{
    const lanes p = a->p2 * a->rho * a->rho, irho = a->irho, time = job->later / a->m;

    const bool fluid = first < job->list->start[KIND_FLUID + 1];

    if (job->moduli && (fluid || !job->fluid_only))
        a->p2 += job->later * ((moduli(job, a->rho, p) - 2 * p) * (irho * irho * irho)) * all->drho;
    if (!job->push || !fluid)
        return;
    for (int d = 0; d < DIM; d++) {
        a->v[d] += time * all->f[d];
        for (int l = 0; l < owners; l++)
            a->v[d][l] += job->later * job->push[job->list->order[first + l]][d];
    }
}

static inline void set_apart(const struct sum_job *job, int first, int owners, struct sum part)
{
    for (int l = 0; l < owners; l++)
        for (int d = 0; d < DIM; d++)
            job->apart[(size_t)(first + l) * DIM + (size_t)d] = part.f[d][l];
}

static inline struct sum_rates rates_of(const struct sum_job *job, int kind)
{
    return kind == KIND_FLUID ? job->rates : (struct sum_rates){ 0 };
}

static inline int row_of(const struct sum_rates *to, int row)
{
    return row < to->rows ? row : to->rows;
}

/* Asks for the places to which write_rates() will write: scattered, they would be waited
 * for.  (Left to itself, the compiler drops calls that do nothing else.) */
LANES_INLINE void expect_rates(const struct sum_job *job, int kind, int first, int owners)
{
    const struct sum_rates to = rates_of(job, kind);
    const int *order = job->list->order + first;

    for (int l = 0; l < owners && to.u; l++)
        __builtin_prefetch(to.u[row_of(&to, order[l])], 1);
    for (int l = 0; l < owners && to.rho; l++)
        __builtin_prefetch(to.rho + row_of(&to, order[l]), 1);
}

/* Written out for a full group, whose number of owners is a constant. */
LANES_INLINE void write_lanes(const struct sum_job *job, int kind, int first, int owners,
                              const struct sum *all)
{
    const struct sum_rates to = rates_of(job, kind);
    const int *order = job->list->order + first;

    for (int l = 0; l < owners; l++) {
        double *f = to.u ? to.u[row_of(&to, order[l])] : job->f + (size_t)(first + l) * DIM;

        for (int d = 0; d < DIM; d++)
            f[d] = all->f[d][l];
    }
    for (int l = 0; l < owners; l++)
        *(to.rho ? to.rho + row_of(&to, order[l]) : job->drho + first + l) = all->drho[l];
}

static inline void write_rates(const struct sum_job *job, int kind, int first, int owners, lanes m,
                        struct sum all)
{
    const lanes im = 1 / m;

    for (int d = 0; d < DIM && rates_of(job, kind).u; d++)
        all.f[d] *= im;
    if (owners == LANES)
        write_lanes(job, kind, first, LANES, &all);
    else
        write_lanes(job, kind, first, owners, &all);
}

/* The sum of slot s, of those at hand. */
typedef struct sum sum_of_slot(const void *sums, int s);

/* Adds the sums in order of places, writes the rates, books the power.  `of` is a constant. */
LANES_INLINE void finish_group(const struct sum_job *job, int kind, int first, int owners,
                               struct side *a, sum_of_slot *of, const void *sums,
                               struct chunk_power *book)
{
    struct sum all = { 0 };

    for (int s = 0; s < job->slots; s++) {
        const struct sum part = of(sums, s);

        if (job->apart && s == job->apart_slot)
            continue;
        for (int d = 0; d < DIM; d++)
            all.f[d] += part.f[d];
        all.drho += part.drho;
    }
    all.drho /= a->m;
    if (job->later != 0)
        look_ahead(job, first, owners, &all, a);
    for (int s = 0; s < job->slots; s++) {
        const struct sum part = of(sums, s);
        lanes power = a->p2 * part.drho;

        for (int d = 0; d < DIM; d++)
            power += a->v[d] * part.f[d];
        exact_rows_add(&book->rows[s], power);
    }
    write_rates(job, kind, first, owners, a->m, all);
    if (job->apart)
        set_apart(job, first, owners, of(sums, job->apart_slot));
}

/* No neighbours: rates of exactly 0. */
static inline void clear_slots(const struct sum_job *job, int kind, int first, int owners)
{
    const struct sum none = { 0 };

    for (int n = 0; n < owners; n += LANES)
        write_rates(job, kind, first + n, owners - n < LANES ? owners - n : LANES,
                    (lanes){0} + 1, none);
    if (job->apart)
        memset(job->apart + (size_t)first * DIM, 0, (size_t)owners * DIM * sizeof *job->apart);
}

#endif
