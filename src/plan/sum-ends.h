/* sum-ends.h -- what becomes of the sums of one group of owners: rates in their places, and
 * powers in the book.  For files of sums over pairs, in either precision. */
#ifndef PLAN_SUM_ENDS_H
#define PLAN_SUM_ENDS_H

#include "plan/sum.h"

#include "algebra/exact-rows.h"
#include "space/fetch.h"
#include "space/visit.h"

#include <string.h>

_Static_assert((int)VISIT_GROUPS <= (int)EXACT_ROWS, "rows of a chunk");

/* Powers of the owners of one chunk, by row of the book. */
struct chunk_power {
    int n;                              /* groups that are in it              */
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

/* Do the rates of these owners, a full group of fluid, all go to rows of their own?  On one of many ranks those
 * of others do not. */
LANES_INLINE bool have_rows(const struct sum_job *job, int kind, int first, int owners)
{
    const int *from = job->list->def.from, *order = job->list->order + first;
    int others = 0;

    if (!(owners == LANES && kind == KIND_FLUID && job->rates.u && job->rates.rho))
        return false;
    if (job->rates.rows >= from[KIND_FLUID + 1] - from[KIND_FLUID])
        return true;
    for (int l = 0; l < LANES; l++)
        others |= order[l] >= job->rates.rows;
    return !others;
}

/* Asks for the places to which write_rates() will write: scattered, they would be waited
 * for.  (Left to itself, the compiler drops calls that do nothing else.) */
LANES_INLINE void expect_rates(const struct sum_job *job, int kind, int first, int owners)
{
    const struct sum_rates to = rates_of(job, kind);
    const int *order = job->list->order + first;

    if (have_rows(job, kind, first, owners)) {
        for (int l = 0; l < LANES; l++) {
            __builtin_prefetch(to.u[order[l]], 1);
            __builtin_prefetch(to.rho + order[l], 1);
        }
        return;
    }
    for (int l = 0; l < owners && to.u; l++)
        __builtin_prefetch(to.u[row_of(&to, order[l])], 1);
    for (int l = 0; l < owners && to.rho; l++)
        __builtin_prefetch(to.rho + row_of(&to, order[l]), 1);
}

/* Without a question: see have_rows(). */
LANES_INLINE void write_rows(const struct sum_job *job, int first, const struct sum *all)
{
    const int *order = job->list->order + first;
    double *u[LANES];

    for (int l = 0; l < LANES; l++)
        u[l] = job->rates.u[order[l]];
    fetch_put_two(all->f[0], all->f[1], u);
    for (int d = 2; d < DIM; d++)
        for (int l = 0; l < LANES; l++)
            u[l][d] = all->f[d][l];
    for (int l = 0; l < LANES; l++)
        job->rates.rho[order[l]] = all->drho[l];
}

static inline void write_lanes(const struct sum_job *job, int kind, int first, int owners,
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
    /* one division instead of LANES where masses are alike */
    const lanes im = job->mass > 0 ? lanes_all(1 / job->mass) : 1 / m;

    for (int d = 0; d < DIM && rates_of(job, kind).u; d++)
        all.f[d] *= im;
    if (have_rows(job, kind, first, owners))
        write_rows(job, first, &all);
    else
        write_lanes(job, kind, first, owners, &all);
}

/* The sum of slot s, of those at hand. */
typedef struct sum sum_of_slot(const void *sums, int s);

/* Of slot s, into the book. */
LANES_INLINE void book_power(const struct side *a, const struct sum *part, int s,
                             struct chunk_power *book)
{
    lanes power = a->p2 * part->drho;

    for (int d = 0; d < DIM; d++)
        power += a->v[d] * part->f[d];
    exact_rows_put(&book->rows[s], book->n, power);
}

/* All slots in the order of the book, without what goes apart.  `book`, NULL or not, and `of`
 * are constants. */
LANES_INLINE struct sum add_slots(const struct sum_job *job, const struct side *a, sum_of_slot *of,
                                  const void *sums, struct chunk_power *book)
{
    const int apart = job->apart ? job->apart_slot : -1;
    struct sum all = { 0 };

    for (int s = 0; s < job->slots; s++) {
        const struct sum part = of(sums, s);

        if (book)
            book_power(a, &part, s, book);
        if (s == apart)
            continue;
        for (int d = 0; d < DIM; d++)
            all.f[d] += part.f[d];
        all.drho += part.drho;
    }
    all.drho /= a->m;
    return all;
}

/* Powers are those `later`. */
LANES_INLINE struct sum add_later(const struct sum_job *job, int first, int owners, struct side *a,
                                  sum_of_slot *of, const void *sums, struct chunk_power *book)
{
    const struct sum all = add_slots(job, a, of, sums, NULL);

    look_ahead(job, first, owners, &all, a);
    for (int s = 0; s < job->slots; s++) {
        const struct sum part = of(sums, s);
        book_power(a, &part, s, book);
    }
    return all;
}

/* Adds the sums in order of places, writes the rates, books the power.  `of` is a constant;
 * a's density and 1/rho serve what is later, and its mass where masses differ. */
LANES_INLINE void finish_group(const struct sum_job *job, int kind, int first, int owners,
                               struct side *a, sum_of_slot *of, const void *sums,
                               struct chunk_power *book)
{
    const struct sum all = job->later != 0 ? add_later(job, first, owners, a, of, sums, book)
                                           : add_slots(job, a, of, sums, book);

    book->n++;
    write_rates(job, kind, first, owners, a->m, all);
    if (job->apart)
        set_apart(job, first, owners, of(sums, job->apart_slot));
}

/* No neighbours: rates of exactly 0. */
static inline void clear_slots(const struct sum_job *job, int kind, int first, int owners)
{
    const struct sum_rates to = rates_of(job, kind);
    const int *order = job->list->order + first;
    const size_t n = (size_t)owners;

    for (int l = 0; l < owners && to.u; l++)
        memset(to.u[row_of(&to, order[l])], 0, sizeof *to.u);
    for (int l = 0; l < owners && to.rho; l++)
        to.rho[row_of(&to, order[l])] = 0;
    if (!to.u)
        memset(job->f + (size_t)first * DIM, 0, n * DIM * sizeof *job->f);
    if (!to.rho)
        memset(job->drho + first, 0, n * sizeof *job->drho);
    if (job->apart)
        memset(job->apart + (size_t)first * DIM, 0, n * DIM * sizeof *job->apart);
}

#endif
