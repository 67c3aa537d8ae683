/* share-list.c -- the list of pairs of all ranks, and what its rows need of others. */
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

/* Do numbers of this kind come from neighbours that have them in y?  Where solids press by more than
 * a density of their own, they read those of others than neighbours. */
static bool comes(const struct moment *m, int kind)
{
    return kind == KIND_FLUID || (m->plan->row.density[kind] >= 0 && !m->plan->passes.press);
}

/* Marks rows that others own and that are neighbours of rows here. */
static void mark_needed(const struct moment *m, bool *needed)
{
    const struct moment_share *s = m->share;
    const struct list *l = m->own;

    for (int g = 0; g < l->groups; g++)
        for (int k = l->segment_from[g]; k < l->segment_from[g + 1]; k++) {
            const struct list_segment *of = &l->segment[k];
            for (int i = 0; comes(m, of->partner) && i < of->rows * l->lanes; i++) {
                const int j = list_place(of->j[i]);
                if (j < l->listed && s->owner[l->order[j]] != s->me)
                    needed[l->order[j]] = true;
            }
        }
}

/* What a rank asks another for. */
struct request {
    int rank, row;
};

static int ascending(const void *l, const void *r)
{
    const int *a = l, *b = r;

    return (*a > *b) - (*a < *b);
}

/* The number of a row among those of this rank, which are ascending. */
static int own_number(const struct moment_share *s, int row)
{
    const int *own = s->row + s->from[s->me][0];
    const size_t n = (size_t)(s->from[s->me][KINDS] - s->from[s->me][0]);

    return (int)((const int *)bsearch(&row, own, n, sizeof *own, ascending) - own);
}

/* Owners hear who needs which of their rows, and so know what to send to whom. */
static int answer(struct moment_share *s, const struct request *asked, int n)
{
    int *to = status_alloc((size_t)n + 1, sizeof *to), *row = status_alloc((size_t)n + 1, sizeof *row);
    int status = ranks_agree(to && row ? STATUS_DONE : STATUS_FAILED);

    for (int i = 0; i < n && status == STATUS_DONE; i++) {
        to[i] = asked[i].rank;
        row[i] = own_number(s, asked[i].row);
    }
    ranks_route_free(&s->route);
    if (status == STATUS_DONE)
        status = ranks_route_create(&s->route, SHARE_HALO * sizeof(double), n, to, row);
    free(to);
    free(row);
    return status;
}

/* Asks for s->halo [n], sorted by owner. */
static int request(struct moment_share *s, int n)
{
    struct request *mine = status_alloc((size_t)n + 1, sizeof *mine), *asked = NULL;
    int *to = status_alloc((size_t)n + 1, sizeof *to), *row = status_alloc((size_t)n + 1, sizeof *row);
    struct ranks_route *questions = NULL;
    int status;

    free(s->in);
    s->in = status_alloc((size_t)n + 1, SHARE_HALO * sizeof *s->in);
    status = ranks_agree(mine && to && row && s->in ? STATUS_DONE : STATUS_FAILED);

    for (int i = 0; i < n && status == STATUS_DONE; i++) {
        mine[i] = (struct request){ s->me, s->halo[i] };
        to[i] = s->owner[s->halo[i]];
        row[i] = i;
    }
    if (status == STATUS_DONE)
        status = ranks_route_create(&questions, sizeof *mine, n, to, row);
    if (status == STATUS_DONE) {
        asked = status_alloc((size_t)ranks_route_coming(questions) + 1, sizeof *asked);
        status = ranks_agree(asked ? STATUS_DONE : STATUS_FAILED);
    }
    if (status == STATUS_DONE) {
        ranks_route_go(questions, sizeof *mine, mine, asked);
        status = answer(s, asked, ranks_route_coming(questions));
    }
    ranks_route_free(&questions);
    free(mine);
    free(asked);
    free(to);
    free(row);
    return status;
}

/* Where all particles are, as the list is made. */
static void note_places(const struct moment *m, const struct cloud *cloud)
{
    const struct particles *p = m->particles;
    const size_t fluid = (size_t)particles_count(p, KIND_FLUID);

    memcpy(m->share->built, cloud->x[KIND_FLUID], fluid * DIM * sizeof *m->share->built);
    memcpy(m->share->built + fluid * DIM, p->x + fluid, ((size_t)p->n - fluid) * sizeof *p->x);
}

int share_halo(struct moment *m)
{
    struct moment_share *s = m->share;
    bool *needed = status_alloc((size_t)s->n + 1, sizeof *needed);
    int n = 0;

    TRY(ranks_agree(needed ? STATUS_DONE : STATUS_FAILED));
    mark_needed(m, needed);
    for (int r = 0; r < s->ranks; r++)
        for (int i = s->from[r][0]; i < s->from[r][KINDS]; i++)
            if (needed[s->row[i]])
                s->halo[n++] = s->row[i];
    free(needed);
    return request(s, n);
}

/* Own rows of y, packed as they travel, and by field. */
static void read_own(struct moment_share *s, const struct view *v)
{
    for (int k = 0; k < KINDS; k++)
        for (int i = s->from[s->me][k]; v->rho[k] && i < s->from[s->me][k + 1]; i++) {
            const size_t row = (size_t)s->row[i], at = row - (size_t)v->p->from[k];
            double *to = s->seen + (size_t)(i - s->from[s->me][0]) * SHARE_HALO;
            to[2 * DIM] = s->rho[row] = v->rho[k][at];
            if (k != KIND_FLUID)
                continue;
            memcpy(to, v->x[k] + at * DIM, DIM * sizeof *to);
            memcpy(to + DIM, v->u[k] + at * DIM, DIM * sizeof *to);
            memcpy(s->x + row * DIM, to, DIM * sizeof *to);
            memcpy(s->u + row * DIM, to + DIM, DIM * sizeof *to);
        }
}

/* Solids are where they are on all ranks, and have a density alone. */
static void hear_halo(struct moment_share *s, const struct view *v)
{
    const int n = ranks_route_coming(s->route);

    ranks_route_go(s->route, SHARE_HALO * sizeof *s->seen, s->seen, s->in);
    for (int i = 0; i < n; i++) {
        const size_t row = (size_t)s->halo[i];
        const double *from = s->in + (size_t)i * SHARE_HALO;
        s->rho[row] = from[2 * DIM];
        if (s->halo[i] >= v->p->from[KIND_FLUID + 1])
            continue;
        memcpy(s->x + row * DIM, from, DIM * sizeof *from);
        memcpy(s->u + row * DIM, from + DIM, DIM * sizeof *from);
    }
}

/* What is in y is read where the halo is, too, from now on. */
static void look_at_share(const struct moment_share *s, struct view *v)
{
    v->x[KIND_FLUID] = s->x;
    v->u[KIND_FLUID] = s->u;
    for (int k = 0; k < KINDS; k++)
        if (v->rho[k])
            v->rho[k] = s->rho + v->p->from[k];
}

/* From all to all. */
static void hear_solids(struct moment *m, const struct view *v)
{
    for (int k = KIND_WALL; k < KINDS; k++)
        if (v->rho[k] && particles_count(v->p, (enum kind)k) > 0 && !comes(m, k))
            share_gather(m->share, v->p, (enum kind)k, 1, v->rho[k], m->share->rho + v->p->from[k]);
}

int share_remake(const struct moment *run, struct list *list)
{
    const struct particles *p = run->particles;
    struct cloud cloud = { 0 };

    memcpy(cloud.from, p->from, sizeof cloud.from);
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
    agreed = ranks_agree(status);
    if (status == STATUS_DONE && agreed != STATUS_DONE)
        m->own->bad = -1;
    TRY(agreed);
    note_places(m, cloud);
    return m->share->full ? STATUS_DONE : share_halo(m);
}

int share_list(struct evaluation *e, struct cloud *cloud)
{
    struct moment *m = e->m;
    struct moment_share *s = m->share;
    struct view *v = &e->view;
    double flag[4];

    if (s->full)
        return remake(m, cloud);
    flag[0] = may_be_old(m, v);
    flag[1] = refuses(m, v);
    flag[2] = e->t;
    flag[3] = -e->t;
    read_own(s, v);
    look_at_share(s, v);
    cloud->x[KIND_FLUID] = s->x;
    ranks_most(4, flag);
    s->refuses = flag[1] > 0;
    s->apart = flag[2] != -flag[3];
    if (s->apart) {
        snprintf(m->refusal, sizeof m->refusal, "ranks have come to different times, %.17g s and %.17g s: "
                 "do all run the same program, with the same libraries?", -flag[3], flag[2]);
        return STATUS_FAILED;
    }
    if (flag[0] > 0) {
        share_gather(s, v->p, KIND_FLUID, DIM, s->x, s->x);
        TRY(remake(m, cloud));
    }
    hear_halo(s, v);
    hear_solids(m, v);
    return STATUS_DONE;
}
