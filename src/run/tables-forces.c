/* tables-forces.c -- the CSV tables of forces on walls, beams and panels. */
#include "run/tables-forces.h"

#include "base/status.h"
#include "output/series.h"

#include <stdlib.h>

static const char axes[] = "xyz";

/* In 2D everything that has mass or force is per metre of depth. */
#if DIM == 2
#define UNIT(whole) whole "/m"
#else
#define UNIT(whole) whole
#endif

struct tables_forces {
    struct series *forces, *panels;
};

static bool solid(const struct object *o)
{
    return o->kind != KIND_FLUID;
}

static void add_force(struct columns *h, const char *name)
{
    for (int d = 0; d < DIM; d++)
        columns_add(h, UNIT("N"), "%s.f%c", name, axes[d]);
    for (int d = 0; d < DIM; d++)
        columns_add(h, UNIT("N s"), "%s.i%c", name, axes[d]);
}

static int open_forces(struct tables_forces *o, const struct plan *plan, const char *dir,
                       struct columns *h)
{
    const struct particles *all = plan_particles(plan);

    columns_start(h);
    for (int i = 0; i < all->objects; i++)
        if (solid(&all->object[i]))
            add_force(h, all->object[i].name);
    return columns_open(h, &o->forces, dir, "forces.csv");
}

/* In 2D a moment is counter-clockwise, about the axis across the plane. */
static int open_panels(struct tables_forces *o, const struct plan *plan, const char *dir,
                       struct columns *h)
{
    columns_start(h);
    for (int i = 0; i < plan_panels(plan); i++) {
        const char *name = plan_panel_name(plan, i);
        add_force(h, name);
        for (int d = DIM == 2 ? 2 : 0; d < 3; d++)
            columns_add(h, UNIT("N m"), "%s.m%c", name, axes[d]);
        if (plan_panel_drags(plan, i))
            columns_add(h, UNIT("N"), "%s.drag", name);
    }
    return columns_open(h, &o->panels, dir, "panels.csv");
}

int tables_forces_open(struct tables_forces **out, const struct plan *plan, const char *dir,
                       struct columns *scratch)
{
    *out = status_alloc(1, sizeof **out);
    if (!*out)
        return STATUS_FAILED;
    TRY(open_forces(*out, plan, dir, scratch));
    return open_panels(*out, plan, dir, scratch);
}

static int add_both(const double *force, const double *impulse, double *v, int n)
{
    for (int d = 0; d < DIM; d++)
        v[n++] = force[d];
    for (int d = 0; d < DIM; d++)
        v[n++] = impulse[d];
    return n;
}

static int row_forces(struct tables_forces *o, struct moment *moment, double t, const double *y)
{
    const struct plan *plan = moment_plan(moment);
    const struct particles *all = plan_particles(plan);
    double v[COLUMNS_MOST];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < all->objects; i++)
        if (solid(&all->object[i]))
            n = add_both(observe_force(moment, i), plan_impulse(plan, y, i), v, n);
    return o->forces ? series_row(o->forces, v) : STATUS_DONE;
}

static int row_panels(struct tables_forces *o, struct moment *moment, double t, const double *y)
{
    const struct plan *plan = moment_plan(moment);
    double v[COLUMNS_MOST];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < plan_panels(plan); i++) {
        struct observe_panel p;
        observe_panel(moment, i, &p);
        n = add_both(p.force, plan_panel_impulse(plan, y, i), v, n);
        for (int d = DIM == 2 ? 2 : 0; d < 3; d++)
            v[n++] = p.turn[d];
        if (plan_panel_drags(plan, i))
            v[n++] = p.drag;
    }
    return o->panels ? series_row(o->panels, v) : STATUS_DONE;
}

int tables_forces_row(struct tables_forces *o, struct moment *moment, double t, const double *y)
{
    TRY(row_forces(o, moment, t, y));
    return row_panels(o, moment, t, y);
}

int tables_forces_keep(struct tables_forces *o, struct archive *a)
{
    TRY(series_keep(o->forces, a, "forces.csv"));
    return series_keep(o->panels, a, "panels.csv");
}

void tables_forces_close(struct tables_forces **tables, int *status)
{
    struct tables_forces *o = *tables;

    if (!o)
        return;
    columns_close(&o->forces, status);
    columns_close(&o->panels, status);
    free(o);
    *tables = NULL;
}
