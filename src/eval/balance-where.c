/* balance-where.c -- space cut anew: how heavy each particle is, by rows of the list that stands, and
 * whose it is then. */
#include "eval/share.h"

#include "base/status.h"
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

/* By own particles, with what they weigh. */
static int cut(const struct moment *m, double *rows, struct ranks_cut **out)
{
    const struct moment_share *s = m->share;
    double *x = s->all, *weight = s->pack, sum = 0;
    int n = 0;

    count_rows(m->own, rows);
    for (int k = 0; k < KINDS; k++) {
        const double *was = share_was(m, k);
        for (int i = s->from[s->me][k]; i < s->from[s->me][k + 1]; i++, n++) {
            const size_t row = (size_t)(s->row[i] - m->particles->from[k]);
            memcpy(x + (size_t)n * DIM, was + row * DIM, DIM * sizeof *x);
            sum += weight[n] = rows[s->row[i]];
        }
    }
    for (int i = 0; i < n && sum > 0; i++)
        weight[i] *= list_entries(m->own) / sum;
    return ranks_cut_create(out, DIM, n, x, weight);
}

/* A particle that changes its owner. */
struct change {
    int id, owner;
};

/* Own particles that this cut gives to others; returns how many. */
static int find_changes(const struct moment *m, const struct ranks_cut *cuts, struct change *to)
{
    const struct moment_share *s = m->share;
    int n = 0;

    for (int k = 0; k < KINDS; k++) {
        const double *was = share_was(m, k);
        for (int i = s->from[s->me][k]; i < s->from[s->me][k + 1]; i++) {
            const size_t row = (size_t)(s->row[i] - m->particles->from[k]);
            const int owner = ranks_cut_owner(cuts, was + row * DIM);
            if (owner != s->me)
                to[n++] = (struct change){ particles_id_of(m->particles, s->row[i]), owner };
        }
    }
    return n;
}

/* All hear of those of all ranks: how many particles move by this cut. */
static long find_owners(const struct moment *m, const struct ranks_cut *cuts, int *owner)
{
    struct moment_share *s = m->share;
    struct change *mine = (struct change *)s->pack, *all = (struct change *)s->all;
    int own = find_changes(m, cuts, mine), changes[s->ranks];
    long moved = 0;

    for (int r = 0; r < s->ranks; r++)
        s->count[r] = 1;
    ranks_gather(s->count, sizeof own, &own, changes);
    ranks_gather(changes, sizeof *mine, mine, all);
    for (int r = 0; r < s->ranks; r++)
        moved += changes[r];
    memcpy(owner, s->owner, (size_t)s->n * sizeof *owner);
    for (long i = 0; i < moved; i++)
        owner[all[i].id] = all[i].owner;
    return moved;
}

int balance_where(const struct moment *m, double *rows, int *owner, long *moved)
{
    struct ranks_cut *cuts;

    TRY(cut(m, rows, &cuts));
    *moved = find_owners(m, cuts, owner);
    ranks_cut_free(&cuts);
    return STATUS_DONE;
}
