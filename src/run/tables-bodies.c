/* tables-bodies.c -- the CSV tables of beams, beam.csv, and of rigid bodies, bodies.csv. */
#include "run/tables-bodies.h"

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

struct tables_bodies {
    struct series *beams, *rigid;
};

static int open_beams(struct tables_bodies *o, const struct plan *plan, const char *dir,
                      struct columns *h)
{
    columns_start(h);
    for (int i = 0; i < plan_bodies(plan); i++) {
        const char *name = plan_body_name(plan, i);
        if (plan_body_rigid(plan, i))
            continue;
        columns_add(h, "m", "%s.tip_x", name);
        columns_add(h, "m", "%s.tip_y", name);
        columns_add(h, "m", "%s.mid_x", name);
        columns_add(h, "m", "%s.mid_y", name);
        columns_add(h, "rad", "%s.tip_angle", name);
        columns_add(h, UNIT("N"), "%s.root_force", name);
        columns_add(h, UNIT("N m"), "%s.root_moment", name);
    }
    return columns_open(h, &o->beams, dir, "beam.csv");
}

static void add_axes(struct columns *h, const char *unit, const char *name, const char *what)
{
    for (int d = 0; d < DIM; d++)
        columns_add(h, unit, "%s.%s%c", name, what, axes[d]);
}

/* In 2D a turn, a spin and a moment are counter-clockwise, about the axis across the plane. */
static void add_turning(struct columns *h, const char *name)
{
#if DIM == 2
    columns_add(h, "rad", "%s.angle", name);
    columns_add(h, "rad/s", "%s.spin", name);
#else
    for (int i = 0; i < 4; i++)
        columns_add(h, "", "%s.q%c", name, "wxyz"[i]);
    add_axes(h, "rad/s", name, "spin_");
#endif
}

static int open_rigid(struct tables_bodies *o, const struct plan *plan, const char *dir,
                      struct columns *h)
{
    columns_start(h);
    for (int i = 0; i < plan_bodies(plan); i++) {
        const char *name = plan_body_name(plan, i);
        if (!plan_body_rigid(plan, i))
            continue;
        add_axes(h, "m", name, "");
        add_axes(h, "m/s", name, "v");
        add_turning(h, name);
        add_axes(h, UNIT("N"), name, "f");
        for (int d = DIM == 2 ? 2 : 0; d < 3; d++)
            columns_add(h, UNIT("N m"), "%s.m%c", name, axes[d]);
        add_axes(h, UNIT("N"), name, "contact_");
        if (plan_body_tied(plan, i))
            add_axes(h, UNIT("N"), name, "support_");
    }
    return columns_open(h, &o->rigid, dir, "bodies.csv");
}

int tables_bodies_open(struct tables_bodies **out, const struct plan *plan, const char *dir,
                       struct columns *scratch)
{
    *out = status_alloc(1, sizeof **out);
    if (!*out)
        return STATUS_FAILED;
    TRY(open_beams(*out, plan, dir, scratch));
    return open_rigid(*out, plan, dir, scratch);
}

int tables_bodies_keep(struct tables_bodies *o, struct archive *a)
{
    TRY(series_keep(o->beams, a, "beam.csv"));
    return series_keep(o->rigid, a, "bodies.csv");
}

static int row_beams(struct tables_bodies *o, struct moment *moment, double t, const double *y)
{
    const struct plan *plan = moment_plan(moment);
    double v[COLUMNS_MOST];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < plan_bodies(plan); i++) {
        struct body_view b;
        if (plan_body_rigid(plan, i))
            continue;
        observe_body(moment, i, t, y, &b);
        v[n++] = b.tip[0];
        v[n++] = b.tip[1];
        v[n++] = b.mid[0];
        v[n++] = b.mid[1];
        v[n++] = b.tip_angle;
        v[n++] = b.root_force;
        v[n++] = b.root_moment;
    }
    return o->beams ? series_row(o->beams, v) : STATUS_DONE;
}

static int put(double *v, int n, const double *from, int count)
{
    for (int i = 0; i < count; i++)
        v[n++] = from[i];
    return n;
}

static int row_rigid(struct tables_bodies *o, struct moment *moment, double t, const double *y)
{
    const struct plan *plan = moment_plan(moment);
    double v[COLUMNS_MOST];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < plan_bodies(plan); i++) {
        struct body_pose b;
        if (!plan_body_rigid(plan, i))
            continue;
        observe_pose(moment, i, y, &b);
        n = put(v, n, b.x, DIM);
        n = put(v, n, b.v, DIM);
        n = put(v, n, b.turn, DIM == 2 ? 1 : 4);
        n = put(v, n, b.spin, DIM == 2 ? 1 : 3);
        n = put(v, n, b.force, DIM);
        n = DIM == 2 ? put(v, n, b.moment + 2, 1) : put(v, n, b.moment, 3);
        n = put(v, n, b.contact, DIM);
        n = plan_body_tied(plan, i) ? put(v, n, b.support, DIM) : n;
    }
    return o->rigid ? series_row(o->rigid, v) : STATUS_DONE;
}

int tables_bodies_row(struct tables_bodies *o, struct moment *moment, double t, const double *y)
{
    TRY(row_beams(o, moment, t, y));
    return row_rigid(o, moment, t, y);
}

void tables_bodies_close(struct tables_bodies **tables, int *status)
{
    struct tables_bodies *o = *tables;

    if (!o)
        return;
    columns_close(&o->beams, status);
    columns_close(&o->rigid, status);
    free(o);
    *tables = NULL;
}
