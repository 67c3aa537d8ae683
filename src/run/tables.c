/* tables.c -- the CSV tables of a run: their names and units, and a row of each. */
#include "run/tables.h"

#include "base/status.h"
#include "measure/crowd.h"
#include "measure/front.h"
#include "measure/pairing.h"
#include "measure/probe.h"
#include "output/series.h"
#include "run/columns.h"

#include <math.h>
#include <stdlib.h>

static const char axes[] = "xyz";

/* In 2D everything that has mass or force is per metre of depth. */
#if DIM == 2
#define UNIT(whole) whole "/m"
#else
#define UNIT(whole) whole
#endif

struct tables {
    struct series *book, *front, *pairs, *forces, *beam, *probes, *steps;
    struct crowd *crowd;     /* NULL: no fluid          */
    struct pairing *pairing; /* NULL: no fluid          */
    double *p;               /* of the fluid, for probes [Pa] */
};

static int open_book(struct tables *o, struct plan *plan, const char *dir, struct columns *h)
{
    static const char *const parts[] = { "kinetic", "potential", "internal", "elastic" };
    char work[PLAN_WORKS][80];
    const int works = plan_work_names(plan, work);

    columns_start(h);
    for (int i = 0; i < 4; i++)
        columns_add(h, UNIT("J"), "%s", parts[i]);
    for (int i = 0; i < works; i++)
        columns_add(h, UNIT("J"), "%s", work[i]);
    columns_add(h, UNIT("J"), "pressure_defect");
    columns_add(h, UNIT("J"), "total");
    columns_add(h, UNIT("J"), "defect");
    columns_add(h, UNIT("kg"), "mass");
    for (int d = 0; d < DIM; d++)
        columns_add(h, UNIT("kg m/s"), "momentum_%c", axes[d]);
    return columns_open(h, &o->book, dir, "book.csv");
}

static bool solid(const struct object *o)
{
    return o->kind != KIND_FLUID;
}

static int open_forces(struct tables *o, struct plan *plan, const char *dir, struct columns *h)
{
    const struct particles *all = plan_particles(plan);

    columns_start(h);
    for (int i = 0; i < all->objects; i++) {
        if (!solid(&all->object[i]))
            continue;
        for (int d = 0; d < DIM; d++)
            columns_add(h, UNIT("N"), "%s.f%c", all->object[i].name, axes[d]);
        for (int d = 0; d < DIM; d++)
            columns_add(h, UNIT("N s"), "%s.i%c", all->object[i].name, axes[d]);
    }
    return columns_open(h, &o->forces, dir, "forces.csv");
}

static int open_beam(struct tables *o, struct plan *plan, const char *dir, struct columns *h)
{
    columns_start(h);
    for (int i = 0; i < plan_bodies(plan); i++) {
        const char *name = plan_body_name(plan, i);
        columns_add(h, "m", "%s.tip_x", name);
        columns_add(h, "m", "%s.tip_y", name);
        columns_add(h, "m", "%s.mid_x", name);
        columns_add(h, "m", "%s.mid_y", name);
        columns_add(h, "rad", "%s.tip_angle", name);
        columns_add(h, UNIT("N"), "%s.root_force", name);
        columns_add(h, UNIT("N m"), "%s.root_moment", name);
    }
    return columns_open(h, &o->beam, dir, "beam.csv");
}

static int open_probes(struct tables *o, struct plan *plan, const char *dir, struct columns *h)
{
    columns_start(h);
    for (int i = 0; i < plan_probes(plan); i++) {
        const char *name;
        const struct settings_probe *p = plan_probe(plan, i, &name);
        columns_add(h, p->what[0] == 'p' ? "Pa" : p->what[0] == 'h' ? "m" : "m/s", "%s", name);
    }
    return columns_open(h, &o->probes, dir, "probes.csv");
}

static int open_front(struct tables *o, struct plan *plan, const char *dir, struct columns *h)
{
    const struct scales *s = plan_scales(plan);

    if (particles_count(plan_particles(plan), KIND_FLUID) == 0)
        return columns_none(dir, "front.csv");
    TRY(crowd_create(plan_particles(plan), &o->crowd));
    if (s->period[0] > 0 || s->period[DIM - 1] > 0) /* no foremost, no highest */
        return columns_none(dir, "front.csv");
    columns_start(h);
    columns_add(h, "m", "x");
    columns_add(h, "m", "height");
    return columns_open(h, &o->front, dir, "front.csv");
}

static int open_pairing(struct tables *o, struct plan *plan, const char *dir, struct columns *h)
{
    if (!o->crowd)
        return columns_none(dir, "pairing.csv");
    TRY(pairing_create(plan_particles(plan), &o->pairing));
    columns_start(h);
    columns_add(h, "", "pairing");
    columns_add(h, "", "nearest_mean");
    columns_add(h, "", "nearest_least");
    return columns_open(h, &o->pairs, dir, "pairing.csv");
}

static int open_steps(struct tables *o, const char *dir, struct columns *h)
{
    columns_start(h);
    columns_add(h, "s", "h");
    columns_add(h, "", "limiter");
    columns_add(h, "", "where");
    columns_add(h, "", "rejected");
    return columns_open(h, &o->steps, dir, "steps.csv");
}

static int open_all(struct tables *o, struct plan *plan, const char *dir, struct columns *h)
{
    o->p = status_alloc((size_t)particles_count(plan_particles(plan), KIND_FLUID) + 1,
                        sizeof *o->p);
    if (!o->p)
        return STATUS_FAILED;
    TRY(open_book(o, plan, dir, h));
    TRY(open_front(o, plan, dir, h));
    TRY(open_pairing(o, plan, dir, h));
    TRY(open_forces(o, plan, dir, h));
    TRY(open_beam(o, plan, dir, h));
    TRY(open_probes(o, plan, dir, h));
    return open_steps(o, dir, h);
}

int tables_open(struct tables **out, struct plan *plan, const char *dir)
{
    struct columns *h = status_alloc(1, sizeof *h);
    int status;

    *out = status_alloc(1, sizeof **out);
    status = *out && h ? open_all(*out, plan, dir, h) : STATUS_FAILED;
    free(h);
    return status;
}

static int row_book(struct tables *o, const struct plan_sheet *s, double defect)
{
    double v[COLUMNS_MOST];
    int n = 0;

    v[n++] = s->t;
    v[n++] = s->energy.kinetic;
    v[n++] = s->energy.potential;
    v[n++] = s->energy.internal;
    v[n++] = s->energy.elastic;
    for (int i = 0; i < s->works; i++)
        v[n++] = s->work[i];
    v[n++] = s->pressure_defect;
    v[n++] = s->total;
    v[n++] = defect;
    v[n++] = s->mass;
    for (int d = 0; d < DIM; d++)
        v[n++] = s->momentum[d];
    return series_row(o->book, v);
}

static int row_forces(struct tables *o, struct plan *plan, double t, const double *y)
{
    const struct particles *all = plan_particles(plan);
    double v[COLUMNS_MOST];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < all->objects; i++) {
        if (!solid(&all->object[i]))
            continue;
        for (int d = 0; d < DIM; d++)
            v[n++] = plan_force(plan, i)[d];
        for (int d = 0; d < DIM; d++)
            v[n++] = plan_impulse(plan, y, i)[d];
    }
    return o->forces ? series_row(o->forces, v) : STATUS_DONE;
}

static int row_beam(struct tables *o, struct plan *plan, double t, const double *y)
{
    double v[COLUMNS_MOST];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < plan_bodies(plan); i++) {
        struct body_view b;
        plan_body_view(plan, i, t, y, &b);
        v[n++] = b.tip[0];
        v[n++] = b.tip[1];
        v[n++] = b.mid[0];
        v[n++] = b.mid[1];
        v[n++] = b.tip_angle;
        v[n++] = b.root_force;
        v[n++] = b.root_moment;
    }
    return o->beam ? series_row(o->beam, v) : STATUS_DONE;
}

static double probe_speed(const struct tables *o, const struct settings_probe *p)
{
    double u[DIM], u2 = 0;

    probe_velocity(o->crowd, p->at, u);
    for (int d = 0; d < DIM; d++)
        u2 += u[d] * u[d];
    return sqrt(u2);
}

static double probe_value(const struct tables *o, const struct settings_probe *p)
{
    if (p->what[0] == 'h')
        return probe_height(o->crowd, p->at, DIM - 1);
    if (p->what[0] == 'v')
        return probe_speed(o, p);
    return probe_pressure(o->crowd, o->p, p->at);
}

static int row_front(struct tables *o, double t)
{
    struct front front;

    if (!o->front)
        return STATUS_DONE;
    front_find(o->crowd, &front);
    return series_row(o->front, (double[]){ t, front.x, front.height });
}

static int row_probes(struct tables *o, struct plan *plan, double t)
{
    double v[COLUMNS_MOST];
    int n = 0;

    if (!o->probes)
        return STATUS_DONE;
    plan_pressures(plan, particles_count(plan_particles(plan), KIND_FLUID),
                   crowd_view(o->crowd)->rho[KIND_FLUID], o->p);
    v[n++] = t;
    for (int i = 0; i < plan_probes(plan); i++) {
        const char *name;
        const struct settings_probe *p = plan_probe(plan, i, &name);
        v[n++] = probe_value(o, p);
    }
    return series_row(o->probes, v);
}

static int row_water(struct tables *o, struct plan *plan, double t, const double *y)
{
    struct view view;

    if (!o->crowd)
        return STATUS_DONE;
    plan_view(plan, t, y, &view);
    crowd_update(o->crowd, &view);
    TRY(row_front(o, t));
    return row_probes(o, plan, t);
}

int tables_pairing(struct tables *o, struct plan *plan, double t, const double *y)
{
    struct pairing_index found;
    struct view view;

    if (!o->pairing)
        return STATUS_DONE;
    plan_view(plan, t, y, &view);
    pairing_find(o->pairing, &view, &found);
    return series_row(o->pairs, (double[]){ t, found.share, found.mean, found.least });
}

int tables_rows(struct tables *o, struct plan *plan, double t, const double *y,
                const struct plan_sheet *sheet, double defect)
{
    TRY(row_book(o, sheet, defect));
    TRY(plan_observe(plan, t, y));
    TRY(row_forces(o, plan, t, y));
    TRY(row_beam(o, plan, t, y));
    return row_water(o, plan, t, y);
}

int tables_step(struct tables *o, const struct method_step *step)
{
    static const char *const limiters[] = { "error", "stability", "output" };
    const double v[] = { step->t, step->h, 0, 0, (double)step->rejected };
    const char *text[] = { NULL, NULL, limiters[step->limiter], step->where, NULL };

    return series_text_row(o->steps, v, text);
}

static void keep_first(int *first, int status)
{
    if (*first == STATUS_DONE)
        *first = status;
}

int tables_close(struct tables **tables)
{
    struct tables *o = *tables;
    int status = STATUS_DONE;

    if (!o)
        return STATUS_DONE;
    keep_first(&status, series_close(&o->book));
    keep_first(&status, series_close(&o->front));
    keep_first(&status, series_close(&o->pairs));
    keep_first(&status, series_close(&o->forces));
    keep_first(&status, series_close(&o->beam));
    keep_first(&status, series_close(&o->probes));
    keep_first(&status, series_close(&o->steps));
    crowd_free(&o->crowd);
    pairing_free(&o->pairing);
    free(o->p);
    free(o);
    *tables = NULL;
    return status;
}
