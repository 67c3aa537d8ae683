/* share-full.c -- ranks that have all rows of y and of rates each, and share sums over pairs.
 *
 * What solves, adds up over particles in an order, or reads at each particle what was summed
 * at its neighbours, does so with the numbers and in the order of one rank, for itself. */
#include "eval/share.h"

#include "base/status.h"
#include "plan/sum.h"
#include "ranks/ranks.h"

#include <string.h>

bool moment_is_full(const struct moment *m)
{
    return m->share && m->share->full;
}

int moment_agree(const struct moment *m, int status)
{
    double fails = status != STATUS_DONE;

    if (!m->share)
        return status;
    ranks_most(1, &fails); /* a small question, as it is asked in each solve */
    return fails > 0 ? ranks_agree(status) : STATUS_DONE;
}

/* Most are one number or a vector, which registers move. */
static inline void copy_row(size_t width, const double *from, double *to)
{
    if (width == 1)
        *to = *from;
    else if (width == DIM)
        memcpy(to, from, DIM * sizeof *to);
    else
        memcpy(to, from, width * sizeof *to);
}

/* Places of each rank's rows, in their order: all ranks have the same list. */
static void sort_places(struct moment *m)
{
    struct moment_share *s = m->share;
    const struct list *l = m->own;

    if (s->places.builds == l->builds)
        return;
    memset(s->places.n, 0, (size_t)s->ranks * sizeof *s->places.n);
    for (int k = 0; k < KINDS; k++)
        for (int at = l->start[k]; at < l->start[k + 1]; at++) {
            const int r = s->owner[particles_id_of(m->particles, l->order[at])];
            s->places.place[s->from[r][k] + s->places.n[r][k]++] = at;
        }
    s->places.builds = l->builds;
}

/* Copies numbers of a rank's rows of some kinds between their places and a message, in which room is left
 * behind for rows that are in no list. */
static void copy_places(const struct moment_share *s, int rank, unsigned kinds, size_t width, bool pack,
                        double *place, double *message)
{
    for (int k = 0; k < KINDS; k++) {
        const int *at = s->places.place + s->from[rank][k];
        const int n = kinds & KIND_BIT(k) ? s->places.n[rank][k] : 0;
        for (int i = 0; i < n; i++, message += width) {
            double *one = place + (size_t)at[i] * width;
            copy_row(width, pack ? one : message, pack ? message : one);
        }
    }
}

static void count_rows(const struct moment_share *s, unsigned kinds)
{
    for (int r = 0; r < s->ranks; r++) {
        s->count[r] = 0;
        for (int k = 0; k < KINDS; k++)
            s->count[r] += kinds & KIND_BIT(k) ? s->from[r][k + 1] - s->from[r][k] : 0;
    }
}

void share_complete(void *others, unsigned kinds, int width, double *to)
{
    struct moment *m = others;
    struct moment_share *s = m->share;
    const size_t c = (size_t)width;
    double *from = s->all;

    for (int k = 0; k < KINDS; k++)
        if (m->own->group_from[k] == m->own->group_from[k + 1])
            kinds &= ~KIND_BIT(k);
    count_rows(s, kinds);
    sort_places(m);
    copy_places(s, s->me, kinds, c, true, to, s->pack);
    ranks_gather(s->count, c * sizeof *to, s->pack, s->all);
    for (int r = 0; r < s->ranks; from += (size_t)s->count[r++] * c)
        if (r != s->me) /* its own are there */
            copy_places(s, r, kinds, c, false, to, from);
}

/* Where a row's force, its rate of density and its force apart are; NULL: nowhere. */
struct outcome {
    double *f, *rho, *apart;
};

static struct outcome outcome_of(const struct moment *m, const struct sum_job *job, int row)
{
    const int place = m->own->slot[row];
    const bool fluid = row < m->particles->from[KIND_FLUID + 1];
    struct outcome of = { 0 };

    if (place < 0)
        return of;
    of.f = fluid && job->rates.u ? job->rates.u[row] : job->f + (size_t)place * DIM;
    of.rho = fluid && job->rates.rho ? job->rates.rho + row : job->drho + place;
    of.apart = job->apart ? job->apart + (size_t)place * DIM : NULL;
    return of;
}

static void copy_outcome(const struct outcome *of, bool pack, double *message)
{
    if (!of->f)
        return;
    memcpy(pack ? message : of->f, pack ? of->f : message, DIM * sizeof *message);
    memcpy(pack ? message + DIM : of->rho, pack ? of->rho : message + DIM, sizeof *message);
    message += DIM + 1;
    if (of->apart)
        memcpy(pack ? message : of->apart, pack ? of->apart : message, DIM * sizeof *message);
}

void share_laws(struct moment *m, const struct sum_job *job)
{
    struct moment_share *s = m->share;
    const size_t c = DIM + 1 + (job->apart ? DIM : 0);
    const int mine = s->from[s->me][0];

    count_rows(s, KIND_BIT(KINDS) - 1);
    for (int i = 0; i < s->count[s->me]; i++) {
        const struct outcome of = outcome_of(m, job, s->row[mine + i]);
        copy_outcome(&of, true, s->pack + (size_t)i * c);
    }
    ranks_gather(s->count, c * sizeof *s->all, s->pack, s->all);
    for (int i = 0; i < s->n; i++) {
        const struct outcome of = outcome_of(m, job, s->row[i]);
        copy_outcome(&of, false, s->all + (size_t)i * c);
    }
}
