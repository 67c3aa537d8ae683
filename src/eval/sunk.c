/* sunk.c -- fluid that is where solids are.
 *
 * In a wall or a rigid body: deeper in its shape than half a spacing, where its first particles
 * stand.  In a beam, which is there in two dimensions: behind the outermost layer of its skin; a
 * particle there is surrounded by points of the skin, so that no half of its neighbourhood is
 * free of them. */
#include "eval/block.h"
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "space/list.h"
#include "shapes/buckets.h"
#include "state/period.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NEAR = 64 };

static const double half = 0.5;    /* [dx] */
static const double around = 1.5;  /* neighbours on a skin: the diagonal, too [dx] */
static const double slack = 0.05;  /* on the layer itself is not behind it [rad] */

/* Directions in which points of one skin are seen from x. */
struct sight {
    const struct particles *p;
    const double *x;
    int object, n;
    double angle[NEAR]; /* [rad], sorted */
};

/* Keeps them all: none is the one that is looked for. */
static bool keep(const void *self, int j)
{
    struct sight *s = (struct sight *)self;
    const double *x = s->p->x[s->p->from[KIND_SKIN] + j];
    const double angle = atan2(x[1] - s->x[1], x[0] - s->x[0]);
    int i = s->n;

    if (s->p->object_of[s->p->from[KIND_SKIN] + j] != s->object || s->n == NEAR)
        return false;
    for (; i > 0 && s->angle[i - 1] > angle; i--)
        s->angle[i] = s->angle[i - 1];
    s->angle[i] = angle;
    s->n++;
    return false;
}

static bool is_surrounded(const struct sight *s)
{
    double widest = 0;

    for (int i = 1; i < s->n; i++)
        widest = fmax(widest, s->angle[i] - s->angle[i - 1]);
    if (s->n < 3)
        return false;
    return fmax(widest, 2 * M_PI - (s->angle[s->n - 1] - s->angle[0])) < M_PI - slack;
}

static bool in_skin(const struct moment *m, const struct buckets *skins, int object,
                    const double *x)
{
    struct sight s = { .p = m->particles, .x = x, .object = object };

    buckets_find(skins, x, around * m->plan->scales.dx, keep, &s);
    return is_surrounded(&s);
}

/* A rigid body where it is. */
struct rigid {
    bool known;                /* it is one                        */
    double reach;              /* from its centre [m]              */
    struct solid_place at;
};

static void stand(const struct moment *m, const double *y, int i, struct rigid *to)
{
    const struct moment_body *b = &m->body[i];
    const struct body_solid *role = b->kind->role.solid;

    *to = (struct rigid){ .known = role != NULL };
    if (!role)
        return;
    role->stand(b->body, &m->layout, y, &to->at);
    for (int k = 0; k < role->solids(b->body); k++) {
        struct solid solid;
        role->facts(b->body, k, &solid);
        to->reach = fmax(to->reach, core_reach(&solid.core));
    }
}

static bool in_rigid(const struct moment_body *b, const struct rigid *r, const struct scales *s,
                     const double *x)
{
    double step[DIM], own[DIM], square = 0;

    for (int d = 0; d < DIM; d++) {
        step[d] = period_nearest(s, d, x[d] - r->at.x[d]);
        square += step[d] * step[d];
    }
    if (square > r->reach * r->reach)
        return false;
    solid_own(&r->at, step, own);
    return b->kind->role.solid->depth(b->body, own) > half * s->dx;
}

/* Where all solids are. */
struct places {
    struct block *block;     /* [walls]  */
    struct rigid *rigid;     /* [bodies] */
    struct buckets skins;
};

/* Object that x is in, -1: none. */
static int solid_at(const struct moment *m, const struct places *at, const double *x)
{
    const struct plan *p = m->plan;

    for (int i = 0; i < p->walls; i++)
        if (block_holds(&at->block[i], x, half * p->scales.dx))
            return p->wall[i].object;
    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].object >= 0
            && (at->rigid[i].known ? in_rigid(&m->body[i], &at->rigid[i], &p->scales, x)
                                   : in_skin(m, &at->skins, p->body[i].object, x)))
            return p->body[i].object;
    return -1;
}

/* The first of all by id; object: -1, none. */
struct first {
    int particle, object;
    char place[PLAN_PLACE];
};

static int count(const struct moment *m, const struct view *v, const struct places *at,
                 struct first *first)
{
    const struct plan *p = m->plan;
    int n = 0;

    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++) {
        const double *now = v->x[KIND_FLUID] + (size_t)i * DIM;
        const int id = particles_id_of(v->p, i);
        double x[DIM];
        int solid;

        if (!view_has(v, i) || !list_inside(&p->list_def, now))
            continue;
        period_home(&p->scales, now, x);
        if ((solid = solid_at(m, at, x)) < 0)
            continue;
        if (n++ > 0 && id > first->particle)
            continue;
        first->particle = id;
        first->object = solid;
        moment_place(m, v, i, first->place);
    }
    return n;
}

static void free_places(struct places *at)
{
    buckets_free(&at->skins);
    free(at->block);
    free(at->rigid);
}

static int make_places(const struct moment *m, double t, const double *y, struct places *at)
{
    const struct particles *all = m->particles;
    const struct plan *p = m->plan;

    *at = (struct places){ .block = status_alloc(p->walls + 1, sizeof *at->block),
                           .rigid = status_alloc(p->bodies + 1, sizeof *at->rigid) };
    if (!at->block || !at->rigid)
        return STATUS_FAILED;
    for (int i = 0; i < p->walls; i++)
        block_make(&at->block[i], p, i, t);
    for (int i = 0; i < p->bodies; i++)
        stand(m, y, i, &at->rigid[i]);
    return buckets_create(&at->skins, (const double (*)[DIM])all->x + all->from[KIND_SKIN],
                          all->n - all->from[KIND_SKIN], around * p->scales.dx);
}

/* What there is in the rows of a view. */
static int look(struct moment *run, const struct view *v, const double *y, struct first *first)
{
    struct places at;
    int n = 0;

    *first = (struct first){ .particle = -1, .object = -1 };
    if (make_places(run, v->t, y, &at) == STATUS_DONE)
        n = count(run, v, &at, first);
    free_places(&at);
    return n;
}

static void tell(const struct moment *run, double t, long n, const struct first *first,
                 struct observe_sunk *out)
{
    *out = (struct observe_sunk){ .n = (int)n, .t = t, .particle = first->particle };
    if (first->object >= 0)
        out->solid = run->particles->object[first->object].name;
    memcpy(out->place, first->place, sizeof out->place);
}

void observe_sunk(struct moment *run, double t, const double *y, struct observe_sunk *out)
{
    struct first first;
    struct view v;
    int n;

    *out = (struct observe_sunk){ .t = t, .particle = -1 };
    if (run->plan->row.x < 0)
        return;
    moment_view(run, t, y, &v);
    n = look(run, &v, y, &first);
    tell(run, t, n, &first, out);
}

void observe_sunk_together(struct moment *run, double t, const double *y, struct observe_sunk *out)
{
    struct first first;
    struct view v;
    int64_t n;

    if (!moment_is_packed(run)) {
        observe_sunk(run, t, y, out);
        return;
    }
    moment_view(run, t, y, &v);
    v.mine = run->share->mine;
    n = look(run, &v, y, &first);
    ranks_add(1, &n);
    if (n > 0)
        ranks_first(first.object >= 0 ? 0 : HUGE_VAL, first.particle, &first, sizeof first);
    tell(run, t, n, &first, out);
}
