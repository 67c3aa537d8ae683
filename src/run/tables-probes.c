/* tables-probes.c -- the CSV tables of probes: readings, their running means, profiles. */
#include "run/tables-probes.h"

#include "base/status.h"
#include "measure/probe-area.h"
#include "measure/probe.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdlib.h>

struct gauge { /* a probe with the points it reads at */
    const char *name;
    const struct settings_probe *set;
    int points, mean;         /* mean: its column of running means, -1: none   */
    double (*x)[DIM];         /* [points] [m]                                 */
    double *value, read;      /* [points] there; their mean, at the last look */
};

struct tables_probes {
    const struct plan *plan;
    struct series *probes, *profiles;
    int n;
    struct gauge *gauge;      /* [n]                                          */
    struct running **means;   /* the run's; *means NULL: no probe has one     */
    double *p;                /* of the fluid [Pa]                            */
};

/* --- what they read ---------------------------------------------------------------- */

static double length_of(const double *u)
{
    double u2 = 0;

    for (int d = 0; d < DIM; d++)
        u2 += u[d] * u[d];
    return sqrt(u2);
}

/* Levels at points x [n]. */
static void read_heights(const struct crowd *c, int n, const double (*x)[DIM], double *value)
{
    for (int i = 0; i < n; i++)
        value[i] = probe_height(c, x[i], DIM - 1);
    if (crowd_view(c)->mine)
        ranks_most(n, value);
}

/* Pressures or speeds. */
static void read_means(const struct tables_probes *o, const struct crowd *c, bool speed, int n,
                       const double (*x)[DIM], double *value)
{
    struct probe_sums sums[PROBE_SHARED];
    double u[DIM];

    for (int i = 0; i < n; i++)
        if (speed)
            probe_sum_velocity(c, x[i], &sums[i]);
        else
            probe_sum_pressure(c, o->p, x[i], &sums[i]);
    if (crowd_view(c)->mine)
        probe_share(n, sums);
    for (int i = 0; i < n; i++) {
        if (speed)
            probe_mean_velocity(&sums[i], u);
        value[i] = speed ? length_of(u) : probe_mean_pressure(c, &sums[i]);
    }
}

/* At all points of a gauge, into g->value. */
static void read_gauge(const struct tables_probes *o, const struct crowd *c, const struct gauge *g)
{
    for (int from = 0; from < g->points; from += PROBE_SHARED) {
        const int n = g->points - from < PROBE_SHARED ? g->points - from : PROBE_SHARED;
        const double (*x)[DIM] = (const double (*)[DIM])g->x + from;
        if (g->set->what[0] == 'h')
            read_heights(c, n, x, g->value + from);
        else
            read_means(o, c, g->set->what[0] == 'v', n, x, g->value + from);
    }
}

static double reading(const struct tables_probes *o, const struct crowd *c,
                      const struct gauge *g)
{
    double sum = 0;

    read_gauge(o, c, g);
    for (int i = 0; i < g->points; i++)
        sum += g->value[i];
    return sum / g->points;
}

static void look(struct tables_probes *o, const struct crowd *c)
{
    const struct view *v = crowd_view(c);

    plan_pressures(o->plan, particles_count(v->p, KIND_FLUID) - v->others, v->rho[KIND_FLUID], o->p);
}

/* --- files ------------------------------------------------------------------------- */

static const char *unit_of(const struct gauge *g)
{
    return g->set->what[0] == 'p' ? "Pa" : g->set->what[0] == 'h' ? "m" : "m/s";
}

static int make_gauges(struct tables_probes *o)
{
    const double step = plan_scales(o->plan)->dx / 2;

    o->n = plan_probes(o->plan);
    if (!(o->gauge = status_alloc((unsigned long)o->n + 1, sizeof *o->gauge)))
        return STATUS_FAILED;
    for (int i = 0; i < o->n; i++) {
        struct gauge *g = &o->gauge[i];
        g->set = plan_probe(o->plan, i, &g->name);
        g->points = probe_area(g->set, step, NULL);
        g->x = status_alloc((unsigned long)g->points, sizeof *g->x);
        g->value = status_alloc((unsigned long)g->points, sizeof *g->value);
        if (!g->x || !g->value)
            return STATUS_FAILED;
        probe_area(g->set, step, g->x);
    }
    return STATUS_DONE;
}

static int make_means(struct tables_probes *o)
{
    double *window = status_alloc((unsigned long)o->n + 1, sizeof *window);
    int n = 0, status;

    if (!window)
        return STATUS_FAILED;
    for (int i = 0; i < o->n; i++) {
        struct gauge *g = &o->gauge[i];
        g->mean = g->set->window > 0 ? n : -1;
        if (g->mean >= 0)
            window[n++] = g->set->window;
    }
    status = n > 0 && !*o->means ? running_create(n, window, o->means) : STATUS_DONE;
    free(window);
    return status;
}

static int open_probes(struct tables_probes *o, const char *dir, struct columns *h)
{
    columns_start(h);
    for (int i = 0; i < o->n; i++) {
        const struct gauge *g = &o->gauge[i];
        columns_add(h, unit_of(g), "%s", g->name);
        if (g->mean >= 0)
            columns_add(h, unit_of(g), "%s.mean", g->name);
    }
    return columns_open(h, &o->probes, dir, "probes.csv");
}

static int open_profiles(struct tables_probes *o, const char *dir, struct columns *h)
{
    bool any = false;

    for (int i = 0; i < o->n; i++)
        any |= o->gauge[i].set->profile;
    if (!any)
        return STATUS_DONE;
    columns_start(h);
    columns_add(h, "", "probe");
    for (int d = 0; d < DIM; d++)
        columns_add(h, "m", "%c", "xyz"[d]);
    columns_add(h, "Pa or m/s", "value");
    return columns_open(h, &o->profiles, dir, "profiles.csv");
}

int tables_probes_open(struct tables_probes **out, const struct plan *plan, const char *dir,
                       struct columns *scratch, struct running **means)
{
    struct tables_probes *o = *out = status_alloc(1, sizeof **out);
    const int fluid = particles_count(plan_particles(plan), KIND_FLUID);

    if (!o)
        return STATUS_FAILED;
    o->plan = plan;
    o->means = means;
    if (!(o->p = status_alloc((unsigned long)fluid + 1, sizeof *o->p)))
        return STATUS_FAILED;
    TRY(make_gauges(o));
    TRY(make_means(o));
    TRY(open_probes(o, dir, scratch));
    return open_profiles(o, dir, scratch);
}

bool tables_probes_step(const struct tables_probes *o)
{
    return *o->means != NULL;
}

int tables_probes_read(struct tables_probes *o, const struct crowd *c, double t)
{
    double v[COLUMNS_MOST];

    look(o, c);
    for (int i = 0; i < o->n; i++)
        if (o->gauge[i].mean >= 0)
            v[o->gauge[i].mean] = reading(o, c, &o->gauge[i]);
    return running_add(*o->means, t, v);
}

void tables_probes_look(struct tables_probes *o, const struct crowd *c)
{
    if (o->n == 0)
        return;
    look(o, c);
    for (int i = 0; i < o->n; i++)
        o->gauge[i].read = reading(o, c, &o->gauge[i]);
}

int tables_probes_row(struct tables_probes *o, double t)
{
    double v[COLUMNS_MOST];
    int n = 0;

    if (!o->probes)
        return STATUS_DONE;
    v[n++] = t;
    for (int i = 0; i < o->n; i++) {
        v[n++] = o->gauge[i].read;
        if (o->gauge[i].mean >= 0)
            v[n++] = running_mean(*o->means, o->gauge[i].mean, t);
    }
    return series_row(o->probes, v);
}

static int profile_of(struct tables_probes *o, const struct crowd *c, const struct gauge *g,
                      double t)
{
    read_gauge(o, c, g);
    for (int i = 0; i < g->points; i++) {
        double v[DIM + 3] = { t };
        const char *text[DIM + 3] = { [1] = g->name };
        for (int d = 0; d < DIM; d++)
            v[2 + d] = g->x[i][d];
        v[2 + DIM] = g->value[i];
        TRY(series_text_row(o->profiles, v, text));
    }
    return STATUS_DONE;
}

int tables_probes_profile(struct tables_probes *o, const struct crowd *c, double t)
{
    if (!o->profiles)
        return STATUS_DONE;
    look(o, c);
    for (int i = 0; i < o->n; i++)
        if (o->gauge[i].set->profile)
            TRY(profile_of(o, c, &o->gauge[i], t));
    return STATUS_DONE;
}

int tables_probes_keep(struct tables_probes *o, struct archive *a)
{
    TRY(series_keep(o->probes, a, "probes.csv"));
    return series_keep(o->profiles, a, "profiles.csv");
}

void tables_probes_close(struct tables_probes **tables, int *status)
{
    struct tables_probes *o = *tables;

    if (!o)
        return;
    columns_close(&o->probes, status);
    columns_close(&o->profiles, status);
    for (int i = 0; o->gauge && i < o->n; i++) {
        free(o->gauge[i].x);
        free(o->gauge[i].value);
    }
    free(o->gauge);
    free(o->p);
    free(o);
    *tables = NULL;
}
