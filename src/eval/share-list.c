/* share-list.c -- what all ranks ask each other in a right-hand side, and the list of pairs of all. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* As the list asks itself: did this particle, now at x, move further than half the margin, is it
 * inside and was outside, is it nowhere? */
static bool moved(const struct moment *m, int row, const double *x)
{
    const struct list *l = m->own;
    const double *was = m->share->built + (size_t)row * DIM, limit = l->def.skin / 2;
    double far = 0;

    for (int d = 0; d < DIM; d++)
        far += (x[d] - was[d]) * (x[d] - was[d]);
    return l->slot[row] < 0 ? list_inside(&l->def, x) || !(far < INFINITY) : !(far <= limit * limit);
}

/* May the list be old?  Solids are where they are on all ranks. */
static bool may_be_old(const struct moment *m, const struct view *v)
{
    const struct moment_share *s = m->share;
    const struct particles *p = m->particles;
    const bool solids_move = m->plan->moving_walls || m->plan->bodies > 0;
    bool old = !m->own->stands;

    for (int i = s->from[s->me][KIND_FLUID]; i < s->from[s->me][KIND_FLUID + 1] && !old; i++)
        old = moved(m, s->row[i], v->x[KIND_FLUID] + (size_t)s->row[i] * DIM);
    for (int i = p->from[KIND_WALL]; i < p->n && solids_move && !old; i++)
        old = moved(m, i, p->x[i]);
    return old;
}

/* Is a density of this rank's own rows in y out of bounds?  All have to know before they sum. */
static bool refuses(const struct moment *m, const struct view *v)
{
    const struct moment_share *s = m->share;
    bool all = true;

    for (int k = 0; k < KINDS; k++)
        for (int i = s->from[s->me][k]; i < s->from[s->me][k + 1] && v->rho[k]; i++) {
            const double rho = v->rho[k][s->row[i] - v->p->from[k]];
            all &= rho >= m->density[0] && rho <= m->density[1];
        }
    return !all;
}

/* Where all particles are, as the list is made. */
static void note_places(const struct moment *m, const struct cloud *cloud)
{
    const struct particles *p = m->particles;
    const size_t fluid = (size_t)particles_count(p, KIND_FLUID);

    memcpy(m->share->built, cloud->x[KIND_FLUID], fluid * DIM * sizeof *m->share->built);
    memcpy(m->share->built + fluid * DIM, p->x + fluid, ((size_t)p->n - fluid) * sizeof *p->x);
}

/* Own rows of y, packed as they travel, and by field. */
static void read_own(struct moment_share *s, const struct view *v)
{
    for (int k = 0; k < KINDS; k++)
        for (int i = s->from[s->me][k]; v->rho[k] && i < s->from[s->me][k + 1]; i++) {
            const size_t row = (size_t)s->row[i], at = row - (size_t)v->p->from[k];
            double *to = s->seen + share_seen(s, i);
            to[share_width(k) - 1] = s->now.rho[row] = v->rho[k][at];
            if (k != KIND_FLUID)
                continue;
            memcpy(to, v->x[k] + at * DIM, DIM * sizeof *to);
            memcpy(to + DIM, v->u[k] + at * DIM, DIM * sizeof *to);
            memcpy(s->now.x + row * DIM, to, DIM * sizeof *to);
            memcpy(s->now.u + row * DIM, to + DIM, DIM * sizeof *to);
        }
}

/* Solids are where they are on all ranks, and have a density alone. */
static void hear_halo(struct moment_share *s, const struct view *v)
{
    const double *from = s->halo.in;

    ranks_route_go(s->route, sizeof *s->seen, s->seen, s->halo.in);
    for (int i = 0; i < s->halo.n; i++) {
        const size_t row = (size_t)s->halo.row[i];
        if (s->halo.row[i] < v->p->from[KIND_FLUID + 1]) {
            memcpy(s->now.x + row * DIM, from, DIM * sizeof *from);
            memcpy(s->now.u + row * DIM, from + DIM, DIM * sizeof *from);
            from += 2 * DIM;
        }
        s->now.rho[row] = *from++;
    }
}

/* What is in y is read where the halo is, too, from now on. */
static void look_at_share(const struct moment_share *s, struct view *v)
{
    v->x[KIND_FLUID] = s->now.x;
    v->u[KIND_FLUID] = s->now.u;
    for (int k = 0; k < KINDS; k++)
        if (v->rho[k])
            v->rho[k] = s->now.rho + v->p->from[k];
}

/* From all to all. */
static void hear_solids(struct moment *m, const struct view *v)
{
    for (int k = KIND_WALL; k < KINDS; k++)
        if (v->rho[k] && particles_count(v->p, (enum kind)k) > 0 && !share_comes(m, k))
            share_gather(m->share, v->p, (enum kind)k, 1, v->rho[k], m->share->now.rho + v->p->from[k]);
}

int share_remake(const struct moment *run, struct list *list)
{
    const struct particles *p = run->particles;
    struct cloud cloud = { 0 };

    memcpy(cloud.from, p->from, sizeof cloud.from);
    memcpy(cloud.row, p->row, sizeof cloud.row);
    for (int k = 0; k < KINDS; k++)
        cloud.x[k] = run->share->built + (size_t)p->from[k] * DIM;
    return run->plan->engine->sum->list->update(list, &cloud);
}

/* Of positions that all ranks have, so that all or none make it anew; one that has no memory for it
 * fails for all. */
static int remake(struct moment *m, const struct cloud *cloud)
{
    const long builds = m->own->builds;
    int status = m->plan->engine->sum->list->update(m->own, cloud), agreed;

    if (status == STATUS_DONE && m->own->builds == builds)
        return STATUS_DONE;
    if (status == STATUS_DONE)
        status = workspace_fit(m->work, m->own);
    if (status == STATUS_DONE)
        note_places(m, cloud);
    agreed = m->share->full ? ranks_agree(status) : share_halo(m, status);
    if (status == STATUS_DONE && agreed != STATUS_DONE)
        m->own->bad = -1;
    return agreed;
}

int share_list(struct evaluation *e, struct cloud *cloud)
{
    struct moment *m = e->m;
    struct moment_share *s = m->share;
    struct view *v = &e->view;
    double flag[5];

    if (s->full)
        return remake(m, cloud);
    flag[0] = may_be_old(m, v);
    flag[1] = refuses(m, v);
    flag[2] = e->t;
    flag[3] = -e->t;
    flag[4] = s->wish;
    read_own(s, v);
    look_at_share(s, v);
    cloud->x[KIND_FLUID] = s->now.x;
    ranks_most(5, flag);
    s->heard.refuses = flag[1] > 0;
    s->heard.apart = flag[2] != -flag[3];
    s->heard.wish = flag[4];
    if (s->heard.apart) {
        snprintf(m->refusal, sizeof m->refusal, "ranks have come to different times, %.17g s and %.17g s: "
                 "do all run the same program, with the same libraries?", -flag[3], flag[2]);
        return STATUS_FAILED;
    }
    if (flag[0] > 0) {
        share_gather(s, v->p, KIND_FLUID, DIM, s->now.x, s->now.x);
        TRY(remake(m, cloud));
    }
    hear_halo(s, v);
    hear_solids(m, v);
    return STATUS_DONE;
}

bool moment_wish(struct moment *m, double wish)
{
    if (!m->share || m->share->full)
        return false;
    m->share->wish = wish;
    return true;
}

double moment_heard(const struct moment *m)
{
    return m->share->heard.wish;
}
