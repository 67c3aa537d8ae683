/* share-looks.c -- what all ranks hear after a step of what each has seen in its own rows: a gather of
 * some numbers each, and no question to all. */
#include "eval/share.h"

#include "ranks/ranks.h"

#include <math.h>

/* Rows of the same width of all ranks; mine [width], all [ranks][width]. */
static void gather(const struct moment *m, size_t bytes, const void *mine, void *all)
{
    struct moment_share *s = m->share;

    for (int r = 0; r < s->ranks; r++)
        s->count[r] = 1;
    ranks_gather(s->count, bytes, mine, all);
}

void moment_most(const struct moment *m, int n, double *x)
{
    if (!moment_is_packed(m))
        return;
    double all[m->share->ranks][n];

    gather(m, sizeof *all, x, all);
    for (int r = 0; r < m->share->ranks; r++)
        for (int i = 0; i < n; i++)
            x[i] = all[r][i] > x[i] ? all[r][i] : x[i];
}

/* What was found at no particle is the same on all. */
static bool before(const struct limit *a, const struct limit *b)
{
    return a->found > b->found || (a->found == b->found && a->where < b->where);
}

void share_limits(const struct moment *m, int n, struct limit *limit)
{
    if (!moment_is_packed(m) || n == 0)
        return;
    struct {
        double rate, found;
        int where;
    } mine[n], all[m->share->ranks][n];

    for (int i = 0; i < n; i++) {
        mine[i].rate = limit[i].rate;
        mine[i].found = limit[i].found;
        mine[i].where = limit[i].where;
    }
    gather(m, sizeof *all, mine, all);
    for (int r = 0; r < m->share->ranks; r++)
        for (int i = 0; i < n; i++) {
            const struct limit one = { .rate = all[r][i].rate, .found = all[r][i].found,
                                       .where = all[r][i].where };
            if (!before(&one, &limit[i]))
                continue;
            limit[i].rate = one.rate;
            limit[i].found = one.found;
            limit[i].where = one.where;
        }
}
