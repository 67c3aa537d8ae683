/* contact-mean.c -- the mean of numbers of a solid over the kernel, and its transpose. */
#include "walls/contact-mean.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "walls/contact-order.h"
#include "walls/contact-together.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the rows are made of; afterwards only they are left.  Each thread has a copy for the
 * row that it works on. */
struct making {
    struct contact_mean *m;
    const struct part_places *at;
    const struct contact_share *share; /* [solids] */
    const int *number;                 /* [solids] among the n, -1 */
    int first, me;                     /* id of the first solid; the row's */
    double cell;                       /* dx^D */
    long entries;                      /* so far */
};

static int group_of(const struct making *k, int i)
{
    return k->at->solid[k->at->p->object_of[k->first + i]].group;
}

/* How much alike the sides are to which two particles have the water. */
static double alike(const struct contact_share *a, const struct contact_share *b)
{
    double off = 0;

    for (int d = 0; d < DIM; d++)
        off += pow(a->normal[d] / a->open - b->normal[d] / b->open, 2);
    return fmax(0, 1 - off);
}

/* Some at the edge of the kernel are too small for a float, and are none. */
static float weight_of(const struct making *k, int j, double r)
{
    if (r >= k->at->kernel->support || k->number[j] < 0 || group_of(k, j) != group_of(k, k->me))
        return 0;
    return (float)(contact_room_kernel(k->at, k->cell, r) * alike(&k->share[k->me], &k->share[j]));
}

static void count(void *self, int j, double r, const double *step)
{
    struct making *k = self;

    (void)step;
    k->entries += weight_of(k, j, r) > 0;
}

/* The weight of the pair as the row of the lower solid has it. */
static float mirrored(const struct contact_mean *m, int row, int column)
{
    for (long e = 0; e < contact_mean_length(m, row / CONTACT_ROWS); e++)
        if (m->column[contact_mean_at(m, row, e)] == column)
            return m->weight[contact_mean_at(m, row, e)];
    return 0;
}

static void enter(void *self, int j, double r, const double *step)
{
    struct making *k = self;
    const int row = k->number[k->me], column = k->number[j];
    const float w = weight_of(k, j, r);

    (void)step;
    if (!(w > 0))
        return;
    const long at = contact_mean_at(k->m, row, k->entries++);
    k->m->column[at] = column;
    k->m->weight[at] = w;
}

/* A slice is as long as the longest of its rows. */
static void measure_rows(const struct making *all, const struct contact_cells *solids)
{
    struct contact_mean *m = all->m;
    const struct contact_part part = contact_together_part(all->at, m->slices);
    long entries = 0;

#pragma omp parallel for schedule(dynamic, 64) reduction(+ : entries)
    for (int slice = part.from; slice < part.to; slice++) {
        long longest = 0;
        for (int i = slice * CONTACT_ROWS; i < m->n && i < (slice + 1) * CONTACT_ROWS; i++) {
            struct making k = *all;
            k.me = m->solid[i];
            contact_cells_visit(solids, solids->x[k.me], count, &k);
            longest = k.entries > longest ? k.entries : longest;
            entries += k.entries;
        }
        m->start[slice + 1] = longest * CONTACT_ROWS;
    }
    m->entries = contact_together_sum(all->at, entries);
    contact_together_hear(all->at, m->slices, sizeof *m->start, m->start + 1);
    for (int slice = 0; slice < m->slices; slice++)
        m->start[slice + 1] += m->start[slice];
}

/* Filling names a particle of its own slice, so that it asks for none that is not there. */
static void fill_rows(const struct making *all, const struct contact_cells *solids)
{
    struct contact_mean *m = all->m;
    const struct contact_part part = contact_together_part(all->at, m->slices);

#pragma omp parallel for schedule(dynamic, 64)
    for (int i = part.from * CONTACT_ROWS; i < part.to * CONTACT_ROWS; i++) {
        const int own = i < m->n ? i : m->n - 1;
        struct making k = *all;
        k.me = m->solid[own];
        if (i < m->n)
            contact_cells_visit(solids, solids->x[k.me], enter, &k);
        for (long e = k.entries; e < contact_mean_length(m, i / CONTACT_ROWS); e++)
            m->column[contact_mean_at(m, i, e)] = own;
    }
    contact_together_hear_uneven(all->at, m->slices, m->start, CONTACT_ROWS, CONTACT_ROWS * sizeof *m->column,
                                 m->column);
    contact_together_hear_uneven(all->at, m->slices, m->start, CONTACT_ROWS, CONTACT_ROWS * sizeof *m->weight,
                                 m->weight);
}

/* What rounding made of a pair seen from its two sides becomes one number; those that are read
 * here are not written here. */
static void mirror_rows(struct contact_mean *m)
{
#pragma omp parallel for schedule(dynamic, 64)
    for (int i = 0; i < m->n; i++)
        for (long e = 0; e < contact_mean_length(m, i / CONTACT_ROWS); e++) {
            const long at = contact_mean_at(m, i, e);
            if (m->weight[at] > 0 && m->solid[m->column[at]] < m->solid[i])
                m->weight[at] = mirrored(m, m->column[at], i);
        }
}

/* Those that are read by each slice, into m->reads where that is there; how many. */
static long find_reads(struct contact_mean *m, int *seen)
{
    long n = 0;

    for (int s = 0; s < m->slices; s++)
        seen[s] = -1;
    for (int s = 0; s < m->slices; s++) {
        m->reads_from[s] = n;
        for (long e = m->start[s]; e < m->start[s + 1]; e++) {
            const int other = m->column[e] / CONTACT_ROWS;
            if (seen[other] == s)
                continue;
            seen[other] = s;
            if (m->reads)
                m->reads[n] = other;
            n++;
        }
    }
    m->reads_from[m->slices] = n;
    return n;
}

static int list_reads(struct contact_mean *m)
{
    int *seen = status_alloc((unsigned long)m->slices + 1, sizeof *seen);

    m->reads_from = status_alloc((unsigned long)m->slices + 1, sizeof *m->reads_from);
    if (seen && m->reads_from)
        m->reads = status_alloc((unsigned long)find_reads(m, seen) + 1, sizeof *m->reads);
    if (m->reads)
        find_reads(m, seen);
    free(seen);
    return m->reads ? STATUS_DONE : STATUS_FAILED;
}

static void weigh_rows(struct contact_mean *m, double *one)
{
    for (int i = 0; i < m->n; i++)
        one[i] = 1;
    for (int slice = 0; slice < m->slices; slice++) {
        double sum[CONTACT_ROWS];
        contact_mean_sums(m, slice, one, sum);
        for (int k = 0; k < CONTACT_ROWS; k++)
            m->inverse[slice * CONTACT_ROWS + k] = sum[k] > 0 ? 1 / sum[k] : 0;
    }
}

static int make_rows(const struct making *k, const struct contact_cells *solids)
{
    struct contact_mean *m = k->m;
    double *one = status_alloc((unsigned long)m->n + 1, sizeof *one);
    int status;

    measure_rows(k, solids);
    m->column = status_alloc((unsigned long)m->start[m->slices] + 1, sizeof *m->column);
    m->weight = status_alloc((unsigned long)m->start[m->slices] + 1, sizeof *m->weight);
    status = contact_together_agree(k->at, one && m->column && m->weight ? STATUS_DONE : STATUS_FAILED);
    if (status == STATUS_DONE) {
        fill_rows(k, solids);
        mirror_rows(m);
        weigh_rows(m, one);
        status = list_reads(m);
    }
    free(one);
    return status;
}

/* Which particles water can reach, in an order of their own; number [solids], -1: none of them. */
static int number_solids(struct contact_mean *m, const struct part_places *at,
                         const struct contact_share *share, int solids, int *number)
{
    for (int i = 0; i < solids; i++) {
        number[i] = -1;
        if (share[i].open > 0)
            m->solid[m->n++] = i;
    }
    m->slices = (m->n + CONTACT_ROWS - 1) / CONTACT_ROWS;
    TRY(contact_order_sort(at, m->n, m->solid));
    for (int i = 0; i < m->n; i++)
        number[m->solid[i]] = i;
    for (int i = 0, k = 0; i < solids; i++)
        if (number[i] >= 0)
            m->by_solid[k++] = number[i];
    return STATUS_DONE;
}

int contact_mean_create(struct contact_mean *m, const struct part_places *at,
                        const struct contact_cells *solids, const struct contact_share *share)
{
    const int first = at->p->from[KIND_WALL], n = at->p->n - first;
    int *number = status_alloc((unsigned long)n + 1, sizeof *number), status = STATUS_FAILED;

    *m = (struct contact_mean){ 0 };
    m->solid = status_alloc((unsigned long)n + 1, sizeof *m->solid);
    m->by_solid = status_alloc((unsigned long)n + 1, sizeof *m->by_solid);
    m->start = status_alloc((unsigned long)n + 2, sizeof *m->start);
    m->inverse = status_alloc((unsigned long)n + CONTACT_ROWS, sizeof *m->inverse);
    if (number && m->solid && m->by_solid && m->start && m->inverse)
        status = number_solids(m, at, share, n, number);
    status = contact_together_agree(at, status);
    if (status == STATUS_DONE)
        status = make_rows(&(struct making){ .m = m, .at = at, .share = share, .number = number,
                                             .first = first,
                                             .cell = contact_room_cell(at) },
                           solids);
    free(number);
    if (status != STATUS_DONE)
        contact_mean_free(m);
    return status;
}

void contact_mean_free(struct contact_mean *m)
{
    free(m->solid);
    free(m->by_solid);
    free(m->start);
    free(m->column);
    free(m->weight);
    free(m->inverse);
    free(m->reads_from);
    free(m->reads);
    *m = (struct contact_mean){ 0 };
}

double contact_mean_memory(const struct contact_mean *m)
{
    return (double)m->n * (sizeof *m->solid + sizeof *m->by_solid + sizeof *m->inverse)
           + (double)m->slices * (sizeof *m->start + sizeof *m->reads_from)
           + (double)(m->slices > 0 ? m->reads_from[m->slices] : 0) * sizeof *m->reads
           + (double)(m->slices > 0 ? m->start[m->slices] : 0)
                 * (sizeof *m->column + sizeof *m->weight);
}

void contact_mean_show(const struct contact_mean *m, part_see *see, void *whose)
{
    const size_t n = (size_t)m->n, slices = (size_t)m->slices, numbers = (size_t)m->start[m->slices];

    see(whose, m->solid, n * sizeof *m->solid);
    see(whose, m->by_solid, n * sizeof *m->by_solid);
    see(whose, m->start, slices * sizeof *m->start);
    see(whose, m->column, numbers * sizeof *m->column);
    see(whose, m->weight, numbers * sizeof *m->weight);
    see(whose, m->inverse, n * sizeof *m->inverse);
    see(whose, m->reads_from, slices * sizeof *m->reads_from);
    see(whose, m->reads, (size_t)m->reads_from[m->slices] * sizeof *m->reads);
}
