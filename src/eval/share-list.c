/* share-list.c -- what all ranks ask each other in a right-hand side, and the list of pairs of all. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where particles are, as the list is made: those that are here. */
static void note_places(const struct moment *m, const struct cloud *cloud)
{
    const struct moment_share *s = m->share;
    const struct particles *p = m->particles;
    const double *x = cloud->x[KIND_FLUID];

    if (x == s->built) /* a list that is made where it was */
        return;
    memcpy(s->built, x, (size_t)moment_rows_of(m, KIND_FLUID) * DIM * sizeof *x);
    for (int i = 0; i < s->near.n; i++)
        memcpy(s->built + (size_t)s->near.row[i] * DIM, x + (size_t)s->near.row[i] * DIM, DIM * sizeof *x);
    for (int k = KIND_WALL; k < KINDS; k++)
        if (!share_stands(m, k))
            memcpy(s->built + (size_t)p->from[k] * DIM, p->x + p->from[k],
                   (size_t)particles_count(p, k) * sizeof *p->x);
}

/* Own rows that leave, as they travel: they stand here and there, and are asked for some before. */
static void pack_halo(struct moment_share *s, const struct view *v)
{
    enum { AHEAD = 16 };
    const double *x = v->x[KIND_FLUID], *u = v->u[KIND_FLUID];
    const double *rho = v->rho[KIND_FLUID] ? v->rho[KIND_FLUID] : s->now.rho;
    const int fluid = v->p->from[KIND_FLUID + 1];
    double *to = s->halo.sent;

    for (int i = 0; i < s->halo.leaves; i++) {
        const size_t row = (size_t)s->halo.out[i];
        const size_t later = (size_t)s->halo.out[i + AHEAD < s->halo.leaves ? i + AHEAD : i];
        if (s->halo.out[i] >= fluid) {
            *to++ = s->now.rho[row];
            continue;
        }
        __builtin_prefetch(x + later * DIM);
        __builtin_prefetch(u + later * DIM);
        __builtin_prefetch(rho + later);
        memcpy(to, x + row * DIM, DIM * sizeof *to);
        memcpy(to + DIM, u + row * DIM, DIM * sizeof *to);
        to[2 * DIM] = rho[row];
        to += SHARE_HALO;
    }
}

/* Solids are where they are on all ranks, and have a density alone. */
static void hear_halo(struct moment_share *s, const struct view *v)
{
    const double *from = s->halo.in;

    pack_halo(s, v);
    ranks_route_go(s->route, sizeof *from, s->halo.sent, s->halo.in);
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

/* Own fluid stays where y has it, where it comes first: others are beyond.  All else is read where
 * the halo is, too, from now on. */
static void look_at_share(const struct moment *m, struct view *v)
{
    const struct moment_share *s = m->share;

    if (s->packed) {
        v->beyond = (struct rows_beyond){ s->now.x, s->now.u, s->now.rho, moment_rows_of(m, KIND_FLUID) };
    } else {
        v->x[KIND_FLUID] = s->now.x;
        v->u[KIND_FLUID] = s->now.u;
    }
    for (int k = s->packed ? KIND_WALL : KIND_FLUID; k < KINDS; k++)
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

/* It was made, with this status here; one that has no memory for it fails for all. */
static int settle(struct moment *m, const struct cloud *cloud, int status)
{
    int agreed;

    if (status == STATUS_DONE)
        status = workspace_fit(m->work, m->own);
    if (status == STATUS_DONE)
        note_places(m, cloud);
    agreed = m->share->full ? ranks_agree(status) : share_halo(m, status);
    if (status == STATUS_DONE && agreed != STATUS_DONE)
        m->own->bad = -1;
    return agreed;
}

int share_make(struct moment *m, const struct cloud *cloud, double *x)
{
    int status;

    m->own->bad = -1;
    m->share->near.far = false;
    status = share_near(m, cloud, x);
    if (status == STATUS_DONE)
        status = settle(m, cloud, m->plan->engine->sum->list->make(m->own, cloud));
    if (status != STATUS_DONE) /* what comes from others does not go with it */
        list_forget(m->own);
    return status;
}

/* Of positions that all ranks have, so that all or none make it anew. */
static int remake(struct moment *m, const struct cloud *cloud)
{
    const long builds = m->own->builds;
    const int status = m->plan->engine->sum->list->update(m->own, cloud);

    return status == STATUS_DONE && m->own->builds == builds ? STATUS_DONE : settle(m, cloud, status);
}

/* A position that is nowhere, the first of all ranks. */
static int refuse_nowhere(struct moment *m, int id)
{
    int said = id;

    ranks_first(id < m->share->n ? 0 : HUGE_VAL, id, &said, sizeof said);
    return list_nowhere(m->own, particles_row_of(m->particles, said), said);
}

/* Would one rank make the list anew?  All ranks ask together. */
static bool is_stale(struct moment *m, const struct cloud *cloud, const double *flag)
{
    return flag[1] > 0 || (flag[0] > 0 && share_harms(m, cloud));
}

/* Where the view is: a list is made of one array. */
static int make_at(struct moment *m, const struct view *v, struct cloud *cloud)
{
    double *now = m->share->now.x;

    share_place(m, v->x[KIND_FLUID]);
    cloud->x[KIND_FLUID] = now;
    cloud->beyond = (struct rows_beyond){ 0 };
    return share_make(m, cloud, now);
}

static int keep_list(struct moment *m, const struct view *v, struct cloud *cloud,
                     const struct share_seen *l, const double *flag)
{
    struct moment_share *s = m->share;

    if (!s->packed) { /* each rank has all of y */
        if (fmax(fmax(flag[0], flag[1]), flag[2]) == 0)
            return STATUS_DONE;
        share_gather(s, m->particles, KIND_FLUID, DIM, s->now.x, s->now.x);
        return remake(m, cloud);
    }
    if (flag[2] > 0)
        return refuse_nowhere(m, l->bad);
    return is_stale(m, cloud, flag) ? make_at(m, v, cloud) : STATUS_DONE;
}

enum { FLAGS = 7 };

/* Asks all whether the list fits and whether they are at one time. */
static int ask(struct evaluation *e, struct cloud *cloud, struct share_seen *l, double flag[FLAGS])
{
    struct moment *m = e->m;
    struct moment_share *s = m->share;
    struct view *v = &e->view;

    *l = share_see(m, v);
    const double mine[FLAGS] = { l->moved, l->back, l->bad < s->n, l->refuses, e->t, -e->t,
                                 s->heard.brings };
    memcpy(flag, mine, sizeof mine);
    look_at_share(m, v);
    cloud->x[KIND_FLUID] = v->x[KIND_FLUID];
    cloud->beyond = v->beyond;
    ranks_most(FLAGS, flag);
    s->near.far = s->near.far || flag[0] > 0;
    s->heard.refuses = flag[3] > 0;
    s->heard.apart = flag[4] != -flag[5];
    s->heard.wish = flag[6];
    if (!s->heard.apart)
        return STATUS_DONE;
    snprintf(m->refusal, sizeof m->refusal, "ranks have come to different times, %.17g s and %.17g s: "
             "do all run the same program, with the same libraries?", -flag[5], flag[4]);
    return STATUS_FAILED;
}

/* What neighbours have, now that there is a list. */
static int hear(struct moment *m, const struct view *v)
{
    hear_halo(m->share, v);
    hear_solids(m, v);
    return STATUS_DONE;
}

int share_list(struct evaluation *e, struct cloud *cloud)
{
    struct moment *m = e->m;
    struct share_seen l;
    double flag[FLAGS];

    if (m->share->full)
        return remake(m, cloud);
    TRY(ask(e, cloud, &l, flag));
    TRY(keep_list(m, &e->view, cloud, &l, flag));
    return hear(m, &e->view);
}

int share_list_beside(struct evaluation *e, struct cloud *cloud)
{
    struct moment *m = e->m;
    struct share_seen l;
    double flag[FLAGS];

    TRY(ask(e, cloud, &l, flag));
    if (flag[2] > 0)
        return refuse_nowhere(m, l.bad);
    if (!m->own->stands || !m->share->near.looked || is_stale(m, cloud, flag)) {
        share_set_aside(m->share);
        TRY(make_at(m, &e->view, cloud));
    }
    return hear(m, &e->view);
}

bool moment_wish(struct moment *m, double wish)
{
    if (!m->share || m->share->full)
        return false;
    m->share->heard.brings = wish;
    return true;
}

double moment_heard(const struct moment *m)
{
    return m->share->heard.wish;
}
