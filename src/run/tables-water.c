/* tables-water.c -- the CSV tables of the water: its front, its pairs, probes in it. */
#include "run/tables-water.h"

#include "base/status.h"
#include "measure/crowd.h"
#include "measure/front.h"
#include "measure/pairing.h"
#include "measure/probe.h"
#include "output/series.h"

#include <math.h>
#include <stdlib.h>

struct tables_water {
    struct series *front, *pairs, *probes;
    struct crowd *crowd;     /* NULL: no fluid          */
    struct pairing *pairing; /* NULL: no fluid          */
    double *p;               /* of the fluid, for probes [Pa] */
};

static int open_front(struct tables_water *o, const struct plan *plan, const char *dir,
                      struct columns *h)
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

static int row_front(struct tables_water *o, double t)
{
    struct front front;

    if (!o->front)
        return STATUS_DONE;
    front_find(o->crowd, &front);
    return series_row(o->front, (double[]){ t, front.x, front.height });
}

static int open_pairing(struct tables_water *o, const struct plan *plan, const char *dir,
                        struct columns *h)
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

int tables_water_pairing(struct tables_water *o, struct moment *moment, double t, const double *y)
{
    struct pairing_index found;
    struct view view;

    if (!o->pairing)
        return STATUS_DONE;
    observe_view(moment, t, y, &view);
    pairing_find(o->pairing, &view, &found);
    return series_row(o->pairs, (double[]){ t, found.share, found.mean, found.least });
}

static int open_probes(struct tables_water *o, const struct plan *plan, const char *dir,
                       struct columns *h)
{
    columns_start(h);
    for (int i = 0; i < plan_probes(plan); i++) {
        const char *name;
        const struct settings_probe *p = plan_probe(plan, i, &name);
        columns_add(h, p->what[0] == 'p' ? "Pa" : p->what[0] == 'h' ? "m" : "m/s", "%s", name);
    }
    return columns_open(h, &o->probes, dir, "probes.csv");
}

static double probe_speed(const struct tables_water *o, const struct settings_probe *p)
{
    double u[DIM], u2 = 0;

    probe_velocity(o->crowd, p->at, u);
    for (int d = 0; d < DIM; d++)
        u2 += u[d] * u[d];
    return sqrt(u2);
}

static double probe_value(const struct tables_water *o, const struct settings_probe *p)
{
    if (p->what[0] == 'h')
        return probe_height(o->crowd, p->at, DIM - 1);
    if (p->what[0] == 'v')
        return probe_speed(o, p);
    return probe_pressure(o->crowd, o->p, p->at);
}

static int row_probes(struct tables_water *o, const struct plan *plan, double t)
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

static int open_all(struct tables_water *o, const struct plan *plan, const char *dir,
                    struct columns *h)
{
    o->p = status_alloc((size_t)particles_count(plan_particles(plan), KIND_FLUID) + 1,
                        sizeof *o->p);
    if (!o->p)
        return STATUS_FAILED;
    TRY(open_front(o, plan, dir, h));
    TRY(open_pairing(o, plan, dir, h));
    return open_probes(o, plan, dir, h);
}

int tables_water_open(struct tables_water **out, const struct plan *plan, const char *dir,
                      struct columns *scratch)
{
    *out = status_alloc(1, sizeof **out);
    return *out ? open_all(*out, plan, dir, scratch) : STATUS_FAILED;
}

int tables_water_row(struct tables_water *o, struct moment *moment, double t, const double *y)
{
    struct view view;

    if (!o->crowd)
        return STATUS_DONE;
    observe_view(moment, t, y, &view);
    crowd_update(o->crowd, &view);
    TRY(row_front(o, t));
    return row_probes(o, moment_plan(moment), t);
}

void tables_water_close(struct tables_water **tables, int *status)
{
    struct tables_water *o = *tables;

    if (!o)
        return;
    columns_close(&o->front, status);
    columns_close(&o->pairs, status);
    columns_close(&o->probes, status);
    crowd_free(&o->crowd);
    pairing_free(&o->pairing);
    free(o->p);
    free(o);
    *tables = NULL;
}
