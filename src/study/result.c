/* result.c -- what a run cost and how far it is from its reference, from its files. */
#include "study/result.h"

#include "output/aside.h"
#include "output/json-find.h"
#include "study/error.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const result_errors[RESULT_ERRORS] = {
    "position", "front", "tip", "body", "impulse", "force", "probe"
};

/* Passes over pairs, with each product by the matrix of an implicit viscosity as one,
 * though it costs less. */
static double all_passes(const char *path)
{
    const double products = json_find_number(path, "operator_products");

    return json_find_number(path, "pair_passes") + (isfinite(products) ? products : 0);
}

void result_read(struct result *r, const char *dir)
{
    const struct {
        const char *key;
        double *to;
    } wanted[] = {
        { "cpu_s", &r->cpu }, { "wall_s", &r->wall }, { "steps", &r->steps },
        { "rejected", &r->rejected }, { "rhs_explicit", &r->rhs_explicit },
        { "rhs_implicit", &r->rhs_implicit },
        { "mean_step", &r->mean_step }, { "t_end", &r->t_end },
        { "energy_defect", &r->energy_defect },
    };
    char path[ASIDE_PATH];

    snprintf(path, sizeof path, "%.4000s/run.json", dir);
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++)
        *wanted[i].to = json_find_number(path, wanted[i].key);
    r->passes = all_passes(path);
    for (int i = 0; i < RESULT_ERRORS; i++)
        r->error[i] = NAN;
}

/* A table here and one there, compared by `how'. */
static double both(const char *here, const char *there,
                   double (*how)(const struct table *, const struct table *))
{
    struct table a, b;
    double error = NAN;

    table_read(&a, here);
    table_read(&b, there);
    if (a.name && b.name)
        error = how(&a, &b);
    table_free(&a);
    table_free(&b);
    return error;
}

/* The same for the table NAME of two runs. */
static double both_named(const char *dir, const char *reference, const char *name,
                         double (*how)(const struct table *, const struct table *))
{
    char here[ASIDE_PATH], there[ASIDE_PATH];

    snprintf(here, sizeof here, "%.4000s/%s", dir, name);
    snprintf(there, sizeof there, "%.4000s/%s", reference, name);
    return both(here, there, how);
}

void result_compare(struct result *r, const char *dir, int i, const char *reference,
                    int i_reference, double dx)
{
    char here[ASIDE_PATH], there[ASIDE_PATH];

    snprintf(here, sizeof here, "%.4000s/snapshots/%04d.csv", dir, i);
    snprintf(there, sizeof there, "%.4000s/snapshots/%04d.csv", reference, i_reference);
    r->error[RESULT_POSITION] = both(here, there, error_positions) / dx;
    r->error[RESULT_FRONT] = both_named(dir, reference, "front.csv", error_front);
    r->error[RESULT_TIP] = both_named(dir, reference, "beam.csv", error_tip);
    r->error[RESULT_BODY] = both_named(dir, reference, "bodies.csv", error_body);
    r->error[RESULT_IMPULSE] = both_named(dir, reference, "forces.csv", error_impulse);
    r->error[RESULT_FORCE] = both_named(dir, reference, "forces.csv", error_force);
    r->error[RESULT_PROBE] = both_named(dir, reference, "probes.csv", error_probe);
}
