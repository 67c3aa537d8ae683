/* share-solids.c -- forces on solids, and powers, from all to all.
 *
 * Solids that nothing meets in the list (wet.h) have a force of exactly +0 on all ranks, and that of solids
 * between each other is found by each rank for itself: neither is sent. */
#include "eval/share.h"

#include "algebra/exact-sum.h"
#include "ranks/ranks.h"

#include <string.h>

int share_wet(struct moment *m, int *id)
{
    const struct moment_share *s = m->share;
    const int first = m->particles->from[KIND_WALL];
    int n = 0;

    wet_mark(m);
    for (int i = first; i < s->n; i++)
        if (m->work->wet.has[i - first])
            id[n++] = i;
    return n;
}

void share_hear_wet(struct moment *m, const int *count, const int *id)
{
    struct moment_share *s = m->share;

    s->wet.from[0] = 0;
    for (int r = 0; r < s->ranks; r++)
        s->wet.from[r + 1] = s->wet.from[r] + count[r];
    ranks_gather(count, sizeof *id, id, s->wet.row);
    for (int i = 0; i < s->wet.from[s->ranks]; i++)
        s->wet.row[i] = particles_row_of(m->particles, s->wet.row[i]);
}

/* Of solids that this rank sends forces of; returns what comes behind. */
static double *pack_forces(const struct moment *m, double *to)
{
    const int solids = m->particles->from[KIND_WALL];
    const struct moment_share *s = m->share;
    double (*f)[DIM] = m->work->wet.f;

    for (int i = s->wet.from[s->me]; i < s->wet.from[s->me + 1]; i++, to += DIM)
        memcpy(to, f[s->wet.row[i] - solids], sizeof *f);
    return to;
}

/* The same of any rank, to where forces are, unless they are there; returns what comes behind. */
static const double *take_forces(const struct moment *m, int rank, const double *from)
{
    const int solids = m->particles->from[KIND_WALL];
    const struct moment_share *s = m->share;
    double (*f)[DIM] = m->work->wet.f;
    const int first = s->wet.from[rank], n = s->wet.from[rank + 1] - first;

    for (int i = 0; rank != s->me && i < n; i++)
        memcpy(f[s->wet.row[first + i] - solids], from + (size_t)i * DIM, sizeof *f);
    return from + (size_t)n * DIM;
}

/* A part of one rank, as it travels, goes to the sums of all; returns what comes behind. */
static const double *add_powers(const struct moment *m, const double *from)
{
    for (int k = 0; k < m->plan->slots; k++, from += EXACT_SUM_WORDS) {
        struct exact_sum one = { .full = 1 };
        memcpy(one.word, from, sizeof one.word);
        exact_sum_merge(&m->share->power[k], &one);
    }
    return from;
}

static void pack_powers(const struct moment *m, double *to)
{
    for (int k = 0; k < m->plan->slots; k++, to += EXACT_SUM_WORDS) {
        exact_sum_carry(&m->share->power[k]);
        memcpy(to, m->share->power[k].word, sizeof m->share->power[k].word);
        m->share->power[k] = (struct exact_sum){ .full = 0 };
    }
}

struct exact_sum *share_parts(const struct evaluation *e)
{
    const struct moment *m = e->m;
    const bool follow = e->ask->sides != ASK_IMPLICIT && e->ask->rates != ASK_DENSITIES;
    const bool read = e->job.apart || e->job.ahead != 0 || plan_ahead(m->plan) > 0; /* before */

    return m->share && !m->share->full && follow && !read ? m->share->power : NULL;
}

void share_forces(struct evaluation *e)
{
    struct moment *m = e->m;
    struct moment_share *s = m->share;
    const bool powers = share_parts(e) != NULL;
    const int words = powers ? m->plan->slots * EXACT_SUM_WORDS : 0;
    const double *at = s->all;
    double *mine = s->all;

    for (int r = 0; r < s->ranks; r++) {
        s->count[r] = (s->wet.from[r + 1] - s->wet.from[r]) * DIM + words;
        mine += r < s->me ? s->count[r] : 0;
    }
    mine = pack_forces(m, mine);
    if (powers)
        pack_powers(m, mine);
    ranks_gather(s->count, sizeof *s->all, NULL, s->all);
    for (int r = 0; r < s->ranks; r++) {
        at = take_forces(m, r, at);
        if (powers)
            at = add_powers(m, at);
    }
    for (int k = 0; powers && k < m->plan->slots; k++)
        m->work->power[k] = exact_sum_value(&s->power[k]);
}
