/* sweep-outputs.c -- a few numbers that tell what a run has shown. */
#include "study/sweep-outputs.h"

#include "base/status.h"
#include "study/bundle.h"
#include "output/force.h"
#include "study/quantity.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const scalar_names[BUNDLE_SCALARS] = { "peak", "peak_t", "mean", "end" };

int sweep_outputs_create(struct sweep_outputs *o, int points)
{
    o->points = points;
    o->output = status_alloc(SWEEP_OUTPUTS, sizeof *o->output);
    return o->output ? STATUS_DONE : STATUS_FAILED;
}

void sweep_outputs_free(struct sweep_outputs *o)
{
    for (int k = 0; k < o->n; k++)
        free(o->output[k].value);
    free(o->output);
    *o = (struct sweep_outputs){0};
}

/* The one of this name, new where no run had it before; NULL: there is no room. */
static struct sweep_output *find(struct sweep_outputs *o, const char *name)
{
    struct sweep_output *found = &o->output[o->n];

    for (int k = 0; k < o->n; k++)
        if (strcmp(o->output[k].name, name) == 0)
            return &o->output[k];
    if (o->n == SWEEP_OUTPUTS || !(found->value = malloc(o->points * sizeof *found->value)))
        return NULL;
    for (int i = 0; i < o->points; i++)
        found->value[i] = NAN;
    snprintf(found->name, sizeof found->name, "%s", name);
    o->n++;
    return found;
}

static bool ends_in(const char *name, const char *end)
{
    const size_t n = strlen(name), k = strlen(end);

    return n >= k && strcmp(name + n - k, end) == 0;
}

/* What is looked at first: how far the water came, how far a beam bent, what a gauge read. */
static bool is_main(const char *table, const char *column, enum bundle_scalar what)
{
    if (strcmp(table, "front") == 0)
        return strcmp(column, "x") == 0 && what == BUNDLE_END;
    if (strcmp(table, "beam") == 0)
        return what == BUNDLE_PEAK && (ends_in(column, ".tip_x") || ends_in(column, ".tip_y"));
    return strcmp(table, "probes") == 0 && what == BUNDLE_AVERAGE;
}

static void take(struct sweep_outputs *o, int i, const struct bundle *b, const char *table,
                 int column, enum bundle_scalar what)
{
    const struct table *t = &b->table[0];
    const double window[2] = { -HUGE_VAL, HUGE_VAL };
    char name[SWEEP_NAME];
    struct sweep_output *to;
    struct sample s;

    snprintf(name, sizeof name, "%s%.90s.%s", strcmp(table, "front") == 0 ? "front." : "",
             t->name[column], scalar_names[what]);
    to = find(o, name);
    if (!to)
        return;
    bundle_scalar(b, column, what, window, &s);
    to->value[i] = s.mean;
    to->main = is_main(table, t->name[column], what);
    if (what == BUNDLE_WHEN)
        snprintf(to->unit, sizeof to->unit, "s");
    else
        table_unit(t, column, to->unit, sizeof to->unit);
}

static void take_force(struct sweep_outputs *o, int i, const struct table *t, int column)
{
    const char *of = t->name[column];
    char name[SWEEP_NAME];
    struct sweep_output *to;

    snprintf(name, sizeof name, "%.*s.force.peak", (int)fmin(90, (double)strlen(of) - 3), of);
    to = find(o, name);
    if (!to)
        return;
    to->value[i] = force_peak(t, column, force_window(t));
    to->main = true;
    table_unit(t, column, to->unit, sizeof to->unit);
    char *impulse = strstr(to->unit, " s"); /* of N s/m */
    if (impulse)
        memmove(impulse, impulse + 2, strlen(impulse + 2) + 1);
}

static void read_table(struct sweep_outputs *o, int i, const struct bundle *b, int number)
{
    const char *table = quantity_tables[number];

    for (int c = 1; c < b->columns; c++) {
        const char *name = b->table[0].name[c];
        const unsigned tells = quantity_find(number, name)->tells;
        if (ends_in(name, ".ix"))
            take_force(o, i, &b->table[0], c);
        for (enum bundle_scalar what = 0; what < BUNDLE_SCALARS; what++)
            if (tells >> what & 1)
                take(o, i, b, table, c, what);
    }
}

void sweep_outputs_read(struct sweep_outputs *o, int i, const struct member_home *h,
                        const struct member *m)
{
    for (int t = 0; quantity_tables[t]; t++) {
        char file[32];
        struct bundle b;
        snprintf(file, sizeof file, "%s.csv", quantity_tables[t]);
        if (bundle_read(&b, h, m, 1, file))
            read_table(o, i, &b, t);
        bundle_free(&b);
    }
}
