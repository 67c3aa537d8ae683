/* contact-mean.c -- the mean of numbers of a solid over the kernel, and its transpose. */
#include "walls/contact-mean.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What the rows are made of; afterwards only they are left. */
struct making {
    struct contact_mean *m;
    const struct part_places *at;
    const struct contact_share *share; /* [solids] */
    const int *number;                 /* [solids] among the n, -1 */
    int first, me;                     /* id of the first solid; the row's */
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

static double weight_of(const struct making *k, int j, double r)
{
    if (k->number[j] < 0 || group_of(k, j) != group_of(k, k->me))
        return 0;
    return contact_room_kernel(k->at, r) * alike(&k->share[k->me], &k->share[j]);
}

static void count(void *self, int j, double r, const double *step)
{
    struct making *k = self;

    (void)step;
    k->entries += weight_of(k, j, r) > 0;
}

/* The weight of the pair as the row of the lower number has it. */
static float mirrored(const struct contact_mean *m, int row, int column)
{
    for (long e = m->start[row]; e < m->start[row + 1]; e++)
        if (m->column[e] == column)
            return m->weight[e];
    return 0;
}

static void enter(void *self, int j, double r, const double *step)
{
    struct making *k = self;
    const int row = k->number[k->me], column = k->number[j];
    const double w = weight_of(k, j, r);

    (void)step;
    if (!(w > 0))
        return;
    k->m->column[k->entries] = column;
    k->m->weight[k->entries++] = column < row ? mirrored(k->m, column, row) : (float)w;
}

static int make_rows(struct making *k, const struct contact_cells *solids)
{
    struct contact_mean *m = k->m;
    double *one = status_alloc((unsigned long)m->n + 1, sizeof *one);

    for (int i = 0; i < m->n; i++) {
        m->start[i] = k->entries;
        k->me = m->solid[i];
        contact_cells_visit(solids, solids->x[k->me], count, k);
    }
    m->start[m->n] = k->entries;
    m->column = status_alloc((unsigned long)k->entries + 1, sizeof *m->column);
    m->weight = status_alloc((unsigned long)k->entries + 1, sizeof *m->weight);
    if (!one || !m->column || !m->weight) {
        free(one);
        return STATUS_FAILED;
    }
    k->entries = 0;
    for (int i = 0; i < m->n; i++) {
        k->me = m->solid[i];
        contact_cells_visit(solids, solids->x[k->me], enter, k);
        one[i] = 1;
    }
    for (int i = 0; i < m->n; i++)
        m->inverse[i] = 1 / contact_mean_sum(m, i, one);
    free(one);
    return STATUS_DONE;
}

int contact_mean_create(struct contact_mean *m, const struct part_places *at,
                        const struct contact_cells *solids, const struct contact_share *share)
{
    const int first = at->p->from[KIND_WALL], n = at->p->n - first;
    int *number = status_alloc((unsigned long)n + 1, sizeof *number), status = STATUS_FAILED;

    *m = (struct contact_mean){ 0 };
    m->solid = status_alloc((unsigned long)n + 1, sizeof *m->solid);
    m->start = status_alloc((unsigned long)n + 2, sizeof *m->start);
    m->inverse = status_alloc((unsigned long)n + 1, sizeof *m->inverse);
    if (number && m->solid && m->start && m->inverse) {
        for (int i = 0; i < n; i++) {
            number[i] = share[i].open > 0 ? m->n : -1;
            if (number[i] >= 0)
                m->solid[m->n++] = i;
        }
        status = make_rows(&(struct making){ .m = m, .at = at, .share = share, .number = number,
                                             .first = first },
                           solids);
    }
    free(number);
    if (status != STATUS_DONE)
        contact_mean_free(m);
    return status;
}

void contact_mean_free(struct contact_mean *m)
{
    free(m->solid);
    free(m->start);
    free(m->column);
    free(m->weight);
    free(m->inverse);
    *m = (struct contact_mean){ 0 };
}

double contact_mean_memory(const struct contact_mean *m)
{
    return (double)m->n * (sizeof *m->solid + sizeof *m->start + sizeof *m->inverse)
           + (double)(m->n > 0 ? m->start[m->n] : 0) * (sizeof *m->column + sizeof *m->weight);
}

double contact_mean_sum(const struct contact_mean *m, int i, const double *r)
{
    double sum = 0;

    for (long e = m->start[i]; e < m->start[i + 1]; e++)
        sum += (double)m->weight[e] * r[m->column[e]];
    return sum;
}
