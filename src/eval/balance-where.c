/* balance-where.c -- how heavy each particle is where space is cut: rows of the list that stands. */
#include "eval/share.h"

#include "ranks/ranks.h"

#include <string.h>

/* Rows of each owner: as many as the longest of its group has; weight [n] by row. */
static void count_rows(const struct list *l, double *weight)
{
    for (int g = 0; g < l->groups; g++) {
        const int *first = l->order + l->group_slot[g];
        const int left = l->start[l->group_kind[g] + 1] - l->group_slot[g];

        for (int i = 0; i < l->lanes && i < left; i++)
            if (!l->mine || l->mine[first[i]])
                weight[first[i]] = (double)(l->rows_before[g + 1] - l->rows_before[g]);
    }
}

int balance_where(const struct moment *m, double *rows, struct ranks_cut **out)
{
    const struct moment_share *s = m->share;
    double *x = s->all, *weight = s->pack, sum = 0;
    int n = 0;

    count_rows(m->own, rows);
    for (int i = s->from[s->me][0]; i < s->from[s->me][KINDS]; i++, n++) {
        memcpy(x + (size_t)n * DIM, s->built + (size_t)s->row[i] * DIM, DIM * sizeof *x);
        sum += weight[n] = rows[s->row[i]];
    }
    for (int i = 0; i < n && sum > 0; i++)
        weight[i] *= list_entries(m->own) / sum;
    return ranks_cut_create(out, DIM, n, x, weight);
}
