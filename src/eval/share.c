/* share.c -- who owns what, and what ranks have to tell all others: rows, refusals. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- who owns what ---------------------------------------------------------------------- */

void share_own(const struct moment *m, const int *owner)
{
    const struct moment_share *s = m->share;
    const struct particles *p = m->particles;
    int n = 0;

    for (int i = 0; i < s->n; i++) {
        s->owner[i] = owner[i];
        s->mine[particles_row_of(p, i)] = owner[i] == s->me;
    }
    for (int r = 0; r < s->ranks; r++) {
        for (int k = 0; k < KINDS; k++) {
            s->from[r][k] = n;
            for (int i = p->from[k]; i < p->from[k + 1]; i++)
                if (s->owner[i] == r)
                    s->row[n++] = particles_row_of(p, i);
        }
        s->from[r][KINDS] = n;
    }
}

int share_fit_own(struct moment_share *s)
{
    free(s->seen);
    s->seen = status_alloc((size_t)share_seen(s, s->from[s->me][KINDS]) + 1, sizeof *s->seen);
    return s->seen ? STATUS_DONE : STATUS_FAILED;
}

/* --- from all to all -------------------------------------------------------------------- */

/* Rows of the kinds first .. last - 1, counted from the first of them on; with none, nothing. */
static void gather(struct moment_share *s, const struct particles *p, int first, int last, size_t c,
                   const double *from, double *to)
{
    const int row = p->from[first], mine = s->from[s->me][first];
    const double *at = s->all;

    if (p->from[last] == row)
        return;
    for (int r = 0; r < s->ranks; r++)
        s->count[r] = s->from[r][last] - s->from[r][first];
    for (int i = 0; i < s->count[s->me]; i++)
        memcpy(s->pack + (size_t)i * c, from + (size_t)(s->row[mine + i] - row) * c, c * sizeof *from);
    ranks_gather(s->count, c * sizeof *from, s->pack, s->all);
    for (int r = 0; r < s->ranks; r++)
        for (int i = s->from[r][first]; i < s->from[r][last]; i++, at += c)
            memcpy(to + (size_t)(s->row[i] - row) * c, at, c * sizeof *to);
}

void share_gather(struct moment_share *s, const struct particles *p, enum kind k, size_t c,
                  const double *from, double *to)
{
    gather(s, p, (int)k, (int)k + 1, c, from, to);
}

/* Where the list was made, of rows that were not near, too: for a moment that looks, and for a cut. */
void share_built(struct moment *m)
{
    struct moment_share *s = m->share;

    if (!s->packed || s->near.known == s->near.made)
        return;
    share_gather(s, m->particles, KIND_FLUID, DIM, s->built, s->built);
    s->near.known = s->near.made;
}

/* Rows of y that a rank has, between y and a message; returns what comes behind. */
static double *copy_rows(const struct moment *m, int rank, bool pack, double *y, double *to)
{
    const struct moment_share *s = m->share;
    const struct layout *l = &m->layout;

    for (int i = 0; i < l->rows; i++) {
        const int k = moment_kind(m, i);
        const size_t c = (size_t)l->row[i].components;
        for (int j = k < KINDS ? s->from[rank][k] : 0; k < KINDS && j < s->from[rank][k + 1]; j++, to += c) {
            double *at = y + l->row[i].offset + (size_t)(s->row[j] - m->particles->from[k]) * c;
            memcpy(pack ? to : at, pack ? at : to, c * sizeof *at);
        }
    }
    return to;
}

/* How many numbers of y a rank has. */
static int numbers_of(const struct moment *m, int rank)
{
    const struct layout *l = &m->layout;
    int n = 0;

    for (int i = 0; i < l->rows; i++) {
        const int k = moment_kind(m, i);
        if (k < KINDS)
            n += l->row[i].components * (m->share->from[rank][k + 1] - m->share->from[rank][k]);
    }
    return n;
}

const double *moment_whole(struct moment *m, const double *y)
{
    struct moment_share *s = m->share;
    double *at;

    if (!s || s->full)
        return y;
    share_built(m);
    memmove(s->whole, y, (size_t)layout_size(&m->layout) * sizeof *y);
    for (int r = 0; r < s->ranks; r++)
        s->count[r] = numbers_of(m, r);
    copy_rows(m, s->me, true, s->whole, s->pack);
    ranks_gather(s->count, sizeof *s->all, s->pack, s->all);
    at = s->all;
    for (int r = 0; r < s->ranks; r++)
        at = copy_rows(m, r, false, s->whole, at);
    return s->whole;
}

void share_silence(const struct moment *m, double *ydot)
{
    const struct moment_share *s = m->share;
    const struct layout *l = &m->layout;

    for (int i = 0; i < l->rows; i++) {
        const int k = moment_kind(m, i);
        const size_t c = (size_t)l->row[i].components;
        for (int j = 0; k < KINDS && !own_packs(m, k) && j < l->row[i].n; j++)
            if (!s->mine[m->particles->from[k] + j])
                memset(ydot + l->row[i].offset + (size_t)j * c, 0, c * sizeof *ydot);
    }
}

/* Rows that leave the halo keep what they had there, which may not be refused for ever. */
static void forget_refused(const struct moment *m)
{
    double *rho = m->share->now.rho;

    for (int i = 0; i < m->share->n; i++)
        if (!(rho[i] >= m->density[0] && rho[i] <= m->density[1]))
            rho[i] = m->particles->scales->rho0;
}

int share_agree(struct moment *m, int status)
{
    struct {
        char refusal[sizeof m->refusal];
        struct moment_culprit culprit[MOMENT_COMPLAINTS];
    } said;
    const int id = m->culprit[MOMENT_DENSITY_OUT].particle;
    const bool refuses = status != STATUS_DONE;
    const double place = refuses ? list_order(m->own, particles_row_of(m->particles, id)) : HUGE_VAL;

    if (!m->share->heard.refuses)
        return status;
    forget_refused(m);
    memcpy(said.refusal, m->refusal, sizeof said.refusal);
    memcpy(said.culprit, m->culprit, sizeof said.culprit);
    if (ranks_first(place, id, &said, sizeof said) < 0)
        return STATUS_DONE;
    memcpy(m->refusal, said.refusal, sizeof said.refusal);
    memcpy(m->culprit, said.culprit, sizeof said.culprit);
    return STATUS_FAILED;
}

