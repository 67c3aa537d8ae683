/* view.c -- moves solids to the moment and says where everything is. */
#include "eval/passes.h"

#include "base/status.h"
#include "state/period.h"

#include <stdio.h>
#include <string.h>

static void move_wall(struct particles *all, const struct plan_wall *w, double t)
{
    struct object *o = &all->object[w->object];
    struct motion_place place;

    motion_at(&w->motion, t, &place);
    for (int d = 0; d < DIM; d++) {
        o->a[d] = place.a[d];
        o->centre[d] = w->motion.pivot[d] + place.shift[d];
    }
    o->omega = place.omega;
    o->alpha = place.alpha;
    for (int i = o->from; i < o->from + o->n; i++) {
        const int c = particles_row_of(all, i);
        motion_point(&w->motion, &place, all->x0[c], all->x[c], all->u[c]);
    }
}

/* Points of a skin come in order of ids. */
static void move_skin(struct moment *m, const struct moment_body *b, double t, const double *y)
{
    struct particles *all = m->particles;
    const struct object *o = &all->object[b->object];
    double (*x)[DIM] = m->work->points, (*u)[DIM] = m->work->speeds;

    if (!all->id[o->kind]) { /* rows are ids */
        b->kind->move(b->body, b->work, &m->layout, t, y, all->x + o->from, all->u + o->from);
        return;
    }
    b->kind->move(b->body, b->work, &m->layout, t, y, x, u);
    for (int j = 0; j < o->n; j++) {
        const int c = particles_row_of(all, o->from + j);
        memcpy(all->x[c], x[j], sizeof x[j]);
        memcpy(all->u[c], u[j], sizeof u[j]);
    }
}

static void move_solids(struct moment *m, double t, const double *y)
{
    const struct plan *p = m->plan;
    struct particles *all = m->particles;

    for (int i = 0; i < p->walls; i++)
        if (p->wall[i].moves)
            move_wall(all, &p->wall[i], t);
    for (int i = 0; i < p->bodies; i++)
        if (m->body[i].object >= 0)
            move_skin(m, &m->body[i], t, y);
}

void moment_view(struct moment *m, double t, const double *y, struct view *v)
{
    const struct plan_rows *row = &m->plan->row;
    struct particles *all = m->particles;

    move_solids(m, t, y);
    *v = (struct view){ .p = all, .t = t };
    for (int k = 0; k < KINDS; k++) {
        const bool fluid = k == KIND_FLUID;
        if (particles_count(all, k) == 0)
            continue;
        v->x[k] = fluid ? y + layout_at(&m->layout, row->x) : all->x[all->from[k]];
        v->u[k] = fluid ? y + layout_at(&m->layout, row->u) : all->u[all->from[k]];
        if (row->density[k] >= 0)
            v->rho[k] = y + layout_at(&m->layout, row->density[k]);
        v->stores[k] = v->rho[k] != NULL;
    }
}

int passes_motion(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    moment_view(e->m, e->t, e->y, &e->view);
    return STATUS_DONE;
}

void moment_place(const struct moment *m, const struct view *v, int c, char text[PLAN_PLACE])
{
    const enum kind k = v->p->object[v->p->object_of[c]].kind;
    double x[DIM];
    int n;

    period_home(&m->plan->scales, view_x(v, k, c - v->p->from[k]), x);
    n = snprintf(text, PLAN_PLACE, "(%g", x[0]);
    for (int d = 1; d < DIM; d++)
        n += snprintf(text + n, PLAN_PLACE - n, ", %g", x[d]);
    snprintf(text + n, PLAN_PLACE - n, ")");
}
