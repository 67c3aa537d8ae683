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

/* It was made, with this status here; one that has no memory for it fails for all. */
static int settle(struct moment *m, const struct cloud *cloud, int status)
{
    int agreed;

    if (status == STATUS_DONE)
        status = workspace_fit(m->work, m->own);
    if (status == STATUS_DONE)
        note_places(m, cloud);
    if (status == STATUS_DONE)
        m->share->near.listed = share_listed(m);
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

/* What this rank brings when all ask each other once, and of each the most that any brings. */
enum flag { MOVED, BACK, NOWHERE, REFUSES, TIME, MINUS_TIME, WISH, HARM, PAIRS, FLAGS };

/* Of a right-hand side, before there is a list. */
struct asked {
    double flag[FLAGS];
    int bad;       /* smallest id of own rows that are nowhere, n: none  */
    bool drifts;   /* flags tell of harm; else nobody has looked for it  */
};

/* Whose displacements were compared knows, too, that its own rows are somewhere, unless it says more. */
static struct share_seen see(const struct evaluation *e, bool drifts)
{
    const struct moment *m = e->m;
    struct share_seen l = { .back = !m->own->stands, .moved = m->share->near.far, .bad = m->share->n };

    if (!drifts || !m->share->near.listed)
        share_see_places(m, &e->view, &l);
    share_see_densities(m, &e->view, &l);
    return l;
}

/* Asks all whether the list fits and whether they are at one time.  What neighbours have is under way
 * meanwhile, for the list that stands mostly does fit. */
static int ask(struct evaluation *e, struct cloud *cloud, struct asked *to)
{
    struct moment *m = e->m;
    struct moment_share *s = m->share;
    struct view *v = &e->view;
    struct share_drift drift = { .harm = DRIFT_NONE };

    to->drifts = s->packed && m->own->stands && s->near.far;
    const struct share_seen l = see(e, to->drifts);
    look_at_share(m, v);
    cloud->x[KIND_FLUID] = v->x[KIND_FLUID];
    cloud->beyond = v->beyond;
    share_halo_begin(m, v);
    if (to->drifts)
        drift = share_drift(m, cloud);
    const double mine[FLAGS] = {
        [MOVED] = l.moved, [BACK] = l.back, [NOWHERE] = l.bad < s->n, [REFUSES] = l.refuses,
        [TIME] = e->t, [MINUS_TIME] = -e->t, [WISH] = s->heard.brings, [HARM] = drift.harm,
        [PAIRS] = drift.pairs,
    };
    memcpy(to->flag, mine, sizeof mine);
    to->bad = l.bad;
    ranks_most(FLAGS, to->flag);
    share_halo_end(s);
    s->near.far = s->near.far || to->flag[MOVED] > 0;
    s->heard.refuses = to->flag[REFUSES] > 0;
    s->heard.apart = to->flag[TIME] != -to->flag[MINUS_TIME];
    s->heard.wish = to->flag[WISH];
    if (!s->heard.apart)
        return STATUS_DONE;
    snprintf(m->refusal, sizeof m->refusal, "ranks have come to different times, %.17g s and %.17g s: "
             "do all run the same program, with the same libraries?", -to->flag[MINUS_TIME], to->flag[TIME]);
    return STATUS_FAILED;
}

/* Would one rank make the list anew?  All ranks ask together. */
static bool is_stale(struct moment *m, const struct cloud *cloud, const struct asked *a)
{
    if (a->flag[BACK] > 0)
        return true;
    if (a->drifts)
        return a->flag[HARM] > 0 || share_is_tired(m, a->flag[PAIRS]);
    return a->flag[MOVED] > 0 && share_harms(m, cloud);
}

/* A position that is nowhere, the first of all ranks. */
static int refuse_nowhere(struct moment *m, int id)
{
    int said = id;

    if (ranks_first(id < m->share->n ? 0 : HUGE_VAL, id, &said, sizeof said) < 0)
        return STATUS_DONE;
    return list_nowhere(m->own, particles_row_of(m->particles, said), said);
}

/* Who has compared displacements alone does not know whether what went too far is nowhere. */
static int look_for_nowhere(struct moment *m, const struct view *v, struct asked *a)
{
    struct share_seen l = { .bad = m->share->n };

    if (a->flag[NOWHERE] > 0)
        return refuse_nowhere(m, a->bad);
    if (a->flag[HARM] < DRIFT_NOWHERE)
        return STATUS_DONE;
    share_see_places(m, v, &l);
    return refuse_nowhere(m, l.bad);
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

/* Where each rank has all of y. */
static int keep_whole(struct moment *m, const struct cloud *cloud, const struct asked *a)
{
    struct moment_share *s = m->share;

    if (a->flag[MOVED] == 0 && a->flag[BACK] == 0 && a->flag[NOWHERE] == 0)
        return STATUS_DONE;
    share_gather(s, m->particles, KIND_FLUID, DIM, s->now.x, s->now.x);
    return remake(m, cloud);
}

int share_list(struct evaluation *e, struct cloud *cloud)
{
    struct moment *m = e->m;
    struct asked a;

    if (m->share->full)
        return remake(m, cloud);
    TRY(ask(e, cloud, &a));
    if (!m->share->packed) {
        TRY(keep_whole(m, cloud, &a));
    } else {
        TRY(look_for_nowhere(m, &e->view, &a));
        if (is_stale(m, cloud, &a))
            TRY(make_at(m, &e->view, cloud));
    }
    share_hear(m, &e->view);
    return STATUS_DONE;
}

int share_list_beside(struct evaluation *e, struct cloud *cloud)
{
    struct moment *m = e->m;
    struct asked a;

    TRY(ask(e, cloud, &a));
    TRY(look_for_nowhere(m, &e->view, &a));
    if (!m->own->stands || !m->share->near.looked || is_stale(m, cloud, &a)) {
        share_set_aside(m->share);
        TRY(make_at(m, &e->view, cloud));
    }
    share_hear(m, &e->view);
    return STATUS_DONE;
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
