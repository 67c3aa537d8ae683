/* sum.c -- sums of laws over pairs, and their powers; lanes are particles.
 *
 * Rates are added in an order that slots alone decide: a lane its own neighbours, laws in
 * table order.  Powers are exact sums, which have no order. */
#include "plan/sum.h"

#include "algebra/exact-rows.h"
#include "base/status.h"
#include "base/threads.h"
#include "effects/fused.h"
#include "space/visit.h"

#include <stdlib.h>
#include <string.h>

_Static_assert((int)VISIT_GROUPS <= (int)EXACT_ROWS, "rows of a chunk");

/* Powers of the owners of one chunk, by row of the book. */
struct chunk_power {
    struct exact_rows rows[SUM_SLOTS];  /* [slots] [W]                         */
};

/* Laws one after the other, each on all rows. */
static void laws_in_turn(const struct pairs_table *table, const struct side *a,
                         struct block *b, struct sum *sum)
{
    for (int i = 0; i < table->n; i++) {
        const struct pairs_work *w = &table->work[i];

        gather_kernel(w->needs, w->kernel, b);
        w->law(w->self, a, b, &sum[w->slot]);
    }
}

static void arrange(struct pairs_table *table, bool fuse)
{
    pairs_laws *const fused = fuse ? fused_laws(table) : NULL;

    table->laws = fused ? fused : laws_in_turn;
}

/* rho dp/drho [Pa] of owners. */
static lanes moduli(const struct sum_job *job, lanes rho, lanes p)
{
    lanes modulus;

    job->moduli(job->eos, LANES, (const double *)&rho, (const double *)&p, (double *)&modulus);
    return modulus;
}

/* Velocities of fluid and p/rho^2 as they will be `later`, to first order; those
 * of solids are not the pairs' to change. */
static void look_ahead(const struct sum_job *job, int first, int owners, const struct sum *all,
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

static void set_apart(const struct sum_job *job, int first, int owners, const struct sum *part)
{
    for (int l = 0; l < owners; l++)
        for (int d = 0; d < DIM; d++)
            job->apart[(size_t)(first + l) * DIM + (size_t)d] = part[job->apart_slot].f[d][l];
}

static struct sum_rates rates_of(const struct sum_job *job, int kind)
{
    return kind == KIND_FLUID ? job->rates : (struct sum_rates){ 0 };
}

/* Asks for the places to which write_rates() will write: scattered, they would be waited
 * for.  (Left to itself, the compiler drops calls that do nothing else.) */
LANES_INLINE void expect_rates(const struct sum_job *job, int kind, int first, int owners)
{
    const struct sum_rates to = rates_of(job, kind);
    const int *order = job->list->order + first;

    for (int l = 0; l < owners && to.u; l++)
        __builtin_prefetch(to.u[order[l]], 1);
    for (int l = 0; l < owners && to.rho; l++)
        __builtin_prefetch(to.rho + order[l], 1);
}

static void write_rates(const struct sum_job *job, int kind, int first, int owners, lanes m,
                        struct sum all)
{
    const struct sum_rates to = rates_of(job, kind);
    const int *order = job->list->order + first;
    const lanes im = 1 / m;

    for (int d = 0; d < DIM && to.u; d++)
        all.f[d] *= im;
    for (int l = 0; l < owners; l++) {
        double *f = to.u ? to.u[order[l]] : job->f + (size_t)(first + l) * DIM;
        double *drho = to.rho ? to.rho + order[l] : job->drho + first + l;

        for (int d = 0; d < DIM; d++)
            f[d] = all.f[d][l];
        *drho = all.drho[l];
    }
}

/* Adds the sums in order of places, writes the rates, books the power. */
static void finish_group(const struct sum_job *job, int kind, int first, int owners,
                         struct side *a, const struct sum *part, struct chunk_power *book)
{
    struct sum all = { 0 };

    for (int s = 0; s < job->slots; s++) {
        if (job->apart && s == job->apart_slot)
            continue;
        for (int d = 0; d < DIM; d++)
            all.f[d] += part[s].f[d];
        all.drho += part[s].drho;
    }
    all.drho /= a->m;
    if (job->later != 0)
        look_ahead(job, first, owners, &all, a);
    for (int s = 0; s < job->slots; s++) {
        lanes power = a->p2 * part[s].drho;

        for (int d = 0; d < DIM; d++)
            power += a->v[d] * part[s].f[d];
        exact_rows_add(&book->rows[s], power);
    }
    write_rates(job, kind, first, owners, a->m, all);
    if (job->apart)
        set_apart(job, first, owners, part);
}

/* No neighbours: rates of exactly 0. */
static void clear_slots(const struct sum_job *job, int kind, int first, int owners)
{
    const struct sum none = { 0 };

    for (int n = 0; n < owners; n += LANES)
        write_rates(job, kind, first + n, owners - n < LANES ? owners - n : LANES,
                    (lanes){0} + 1, none);
    if (job->apart)
        memset(job->apart + (size_t)first * DIM, 0, (size_t)owners * DIM * sizeof *job->apart);
}

static void sum_group(const struct sum_job *job, int g, struct block *b,
                      struct chunk_power *book)
{
    struct visit v = visit_group(job->list, g);
    const struct pairs_table *tables = job->table + (size_t)v.kind * KINDS;
    const int owners = visit_owners(&v);
    struct sum part[SUM_SLOTS];
    struct side a;

    if (v.next == v.last) {
        clear_slots(job, v.kind, v.first, owners);
        return;
    }
    expect_rates(job, v.kind, v.first, owners);
    gather_side(job->record, v.first, v.end, job->list->listed, &a);
    memset(part, 0, (size_t)job->slots * sizeof *part);
    while (visit_segment(&v, VISIT_ALL)) {
        const struct pairs_table *table = &tables[v.segment->partner];

        while (table->n > 0 /* the list also serves summed densities */
               && visit_rows(&v, job->record, table->needs, NULL, &a, b))
            table->laws(table, &a, b, part);
    }
    finish_group(job, v.kind, v.first, owners, &a, part, book);
}

/* A pass over all chunks. */
struct pass {
    const struct sum_job *job;
    struct exact_sum *power; /* [threads][slots] */
    struct exact_cut *cut;   /* [threads][slots] */
};

static void sum_chunk(const void *of, int chunk, int from, int to, struct block *b)
{
    const struct pass *pass = of;
    const int slots = pass->job->slots;
    const size_t mine = (size_t)threads_me() * (size_t)slots;
    struct exact_cut *const cut = pass->cut + mine;
    struct chunk_power book;

    (void)chunk;
    for (int s = 0; s < slots; s++)
        exact_rows_open(&book.rows[s], &cut[s]);
    for (int g = from; g < to; g++)
        sum_group(pass->job, g, b, &book);
    for (int s = 0; s < slots; s++)
        exact_rows_close(&book.rows[s], &cut[s], &pass->power[mine + (size_t)s]);
}

/* Kinds that own nothing have rates of exactly 0. */
static void clear_idle(const struct sum_job *job)
{
    const struct list *list = job->list;

    for (int kind = 0; kind < KINDS; kind++)
        if (list->group_from[kind] == list->group_from[kind + 1])
            clear_slots(job, kind, list->start[kind],
                        list->start[kind + 1] - list->start[kind]);
}

static int make_room(struct sum_scratch *scratch, int slots)
{
    const int threads = threads_most();

    if (threads > scratch->threads || slots != scratch->slots) {
        free(scratch->power);
        free(scratch->cut);
        *scratch = (struct sum_scratch){ .threads = threads, .slots = slots };
        scratch->power = malloc((size_t)threads * (size_t)(slots + 1) * sizeof *scratch->power);
        scratch->cut = calloc((size_t)threads * (size_t)(slots + 1), sizeof *scratch->cut);
    }
    if (!scratch->power || !scratch->cut)
        return status_starved("the power of %d effects cannot be summed", slots);
    memset(scratch->power, 0, (size_t)scratch->threads * (size_t)slots * sizeof *scratch->power);
    return STATUS_DONE;
}

static int sum_pairs(const struct sum_job *job, struct sum_scratch *scratch)
{
    const int slots = job->slots;

    if (slots > SUM_SLOTS)
        return status_fail(STATUS_FAILED, "%d effects act on pairs, %d are possible", slots,
                           SUM_SLOTS);
    TRY(make_room(scratch, slots));
    clear_idle(job);
    visit_chunks(job->list, VISIT_ALL, sum_chunk, &(struct pass){ job, scratch->power, scratch->cut });
    for (int s = 0; s < slots; s++) {
        for (int t = 1; t < scratch->threads; t++)
            exact_sum_merge(&scratch->power[s], &scratch->power[t * slots + s]);
        job->power[s] = exact_sum_value(&scratch->power[s]);
    }
    return STATUS_DONE;
}

const struct sum_engine LANE_NAME(sum_engine) = {
    .lanes = LANES, .list = &LANE_NAME(list_engine), .arrange = arrange, .pairs = sum_pairs,
    .field = LANE_NAME(sum_field),
};
