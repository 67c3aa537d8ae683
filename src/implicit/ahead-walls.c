/* ahead-walls.c -- solids that press by means in the solve for a pressure that looks ahead. */
#include "implicit/ahead.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

int ahead_walls_create(struct ahead *a, bool tension)
{
    const struct plan *p = a->m->plan;
    const size_t solids = (size_t)(a->n - particles_count(p->particles, KIND_FLUID));

    if (!p->passes.press)
        return STATUS_DONE;
    a->walls.from = workspace_lines(solids);
    a->walls.to = workspace_lines(solids);
    if (!a->walls.from || !a->walls.to)
        return STATUS_FAILED;
    if (tension && !(a->walls.least = workspace_lines((size_t)a->n)))
        return STATUS_FAILED;
    return STATUS_DONE;
}

void ahead_walls_bound(struct ahead *a)
{
    const int fluid = a->m->list->start[KIND_FLUID + 1];

    for (int s = 0; a->walls.least && s < a->n; s++)
        a->walls.least[s] = s < fluid ? -INFINITY : 0;
}

/* The number of the solid at a place, by row; its mass. */
static int solid_at(const struct ahead *a, int s, double *m)
{
    const struct particles *all = a->m->particles;
    const int c = a->m->list->order[s];

    *m = all->m[c];
    return c - all->from[KIND_WALL];
}

/* Those in no list have no pressure, and no rate. */
static void clear(struct ahead *a)
{
    const struct particles *all = a->m->particles;

    memset(a->walls.from, 0, (size_t)(all->n - all->from[KIND_WALL]) * sizeof *a->walls.from);
}

void ahead_walls_spread(struct ahead *a, double *v)
{
    const struct plan_part *wall = a->m->plan->passes.press;
    double m;

    if (!wall)
        return;
    clear(a);
    for (int s = a->m->list->start[KIND_WALL]; s < a->listed; s++) {
        const int i = solid_at(a, s, &m);
        a->walls.from[i] = m * v[s];
    }
    wall->part->as.wall->press->spread(wall->self, a->m->work->press, a->walls.from, a->walls.to);
    for (int s = a->m->list->start[KIND_WALL]; s < a->listed; s++) {
        const int i = solid_at(a, s, &m);
        v[s] = a->walls.to[i] / m;
    }
}

void ahead_walls_mean(struct ahead *a, double *v)
{
    const struct plan_part *wall = a->m->plan->passes.press;
    double m;

    if (!wall)
        return;
    clear(a);
    for (int s = a->m->list->start[KIND_WALL]; s < a->listed; s++) {
        const int i = solid_at(a, s, &m);
        a->walls.from[i] = v[s] / m;
    }
    wall->part->as.wall->press->mean(wall->self, a->m->work->press, a->walls.from, a->walls.to);
    for (int s = a->m->list->start[KIND_WALL]; s < a->listed; s++) {
        const int i = solid_at(a, s, &m);
        v[s] = m * a->walls.to[i];
    }
}
