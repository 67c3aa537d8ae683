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
    struct moment_share *s = m->share;
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
    s->near.whole.stands = false;
    s->wet.pressed = false;
}

/* --- from all to all -------------------------------------------------------------------- */

void share_gather(struct moment_share *s, const struct particles *p, enum kind k, size_t c,
                  const double *from, double *to)
{
    const int row = p->from[k], mine = s->from[s->me][k];
    const double *at = s->all;

    if (particles_count(p, k) == 0)
        return;
    for (int r = 0; r < s->ranks; r++)
        s->count[r] = s->from[r][k + 1] - s->from[r][k];
    for (int i = 0; i < s->count[s->me]; i++)
        memcpy(s->pack + (size_t)i * c, from + (size_t)(s->row[mine + i] - row) * c, c * sizeof *from);
    ranks_gather(s->count, c * sizeof *from, s->pack, s->all);
    for (int r = 0; r < s->ranks; r++)
        for (int i = s->from[r][k]; i < s->from[r][k + 1]; i++, at += c)
            memcpy(to + (size_t)(s->row[i] - row) * c, at, c * sizeof *to);
}

/* --- where the list was made --------------------------------------------------------------- */

void share_cloud(const struct moment *m, struct cloud *cloud)
{
    const struct particles *p = m->particles;

    memcpy(cloud->from, p->from, sizeof cloud->from);
    memcpy(cloud->row, p->row, sizeof cloud->row);
    cloud->beyond = (struct rows_beyond){ 0 };
    for (int k = 0; k < KINDS; k++)
        cloud->x[k] = share_was(m, k);
}

void share_set_aside(struct moment_share *s)
{
    double *built = s->built;

    s->built = s->near.aside;
    s->near.aside = built;
    s->near.made_aside = !s->near.made_aside;
}

int share_remake(const struct moment *run, struct list *list)
{
    struct cloud cloud;

    share_cloud(run, &cloud);
    return run->plan->engine->sum->list->update(list, &cloud);
}

/* --- rows of y ------------------------------------------------------------------------------ */

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

static const double *hear_whole(struct moment *m, bool all, const double *y)
{
    struct moment_share *s = m->share;
    double *at;

    if (!s || s->full)
        return y;
    for (int r = 0; r < s->ranks; r++)
        s->count[r] = numbers_of(m, r);
    copy_rows(m, s->me, true, (double *)y, s->pack);
    (all ? ranks_gather : ranks_bring)(s->count, sizeof *s->all, s->pack, s->all);
    if (!all && s->me > 0)
        return y;
    moment_take(m, y, s->whole);
    at = s->all;
    for (int r = 0; r < s->ranks; r++)
        at = copy_rows(m, r, false, s->whole, at);
    return s->whole;
}

const double *moment_whole(struct moment *m, const double *y)
{
    return hear_whole(m, true, y);
}

const double *moment_first(struct moment *m, const double *y)
{
    return hear_whole(m, false, y);
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

