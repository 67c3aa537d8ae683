/* tables-water.c -- the CSV tables of the water: its front, its pairs, probes in it. */
#include "run/tables-water.h"

#include "base/status.h"
#include "measure/crowd.h"
#include "measure/front.h"
#include "measure/pairing.h"
#include "output/series.h"
#include "run/tables-probes.h"

#include <stdbool.h>
#include <stdlib.h>

struct tables_water {
    struct series *front, *pairs;
    struct tables_probes *probes;
    struct crowd *crowd;     /* NULL: no fluid          */
    struct pairing *pairing; /* NULL: no fluid          */
    struct front found;      /* at the last look        */
    bool has_front;
};

static int open_front(struct tables_water *o, const struct plan *plan, const char *dir,
                      struct columns *h)
{
    const struct scales *s = plan_scales(plan);

    if (particles_count(plan_particles(plan), KIND_FLUID) == 0)
        return STATUS_DONE;
    TRY(crowd_create(plan_particles(plan), &o->crowd));
    if (s->period[0] > 0 || s->period[DIM - 1] > 0) /* no foremost, no highest */
        return STATUS_DONE;
    o->has_front = true;
    columns_start(h);
    columns_add(h, "m", "x");
    columns_add(h, "m", "height");
    return columns_open(h, &o->front, dir, "front.csv");
}

static int open_pairing(struct tables_water *o, const struct plan *plan, const char *dir,
                        struct columns *h)
{
    if (!o->crowd || h->tried)
        return STATUS_DONE;
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

static int open_all(struct tables_water *o, const struct plan *plan, const char *dir,
                    struct columns *h, struct running **means)
{
    TRY(open_front(o, plan, dir, h));
    TRY(open_pairing(o, plan, dir, h));
    return tables_probes_open(&o->probes, plan, dir, h, means);
}

int tables_water_open(struct tables_water **out, const struct plan *plan, const char *dir,
                      struct columns *scratch, struct running **means)
{
    *out = status_alloc(1, sizeof **out);
    return *out ? open_all(*out, plan, dir, scratch, means) : STATUS_FAILED;
}

static void look(struct tables_water *o, struct moment *moment, double t, const double *y)
{
    struct view view;

    observe_view(moment, t, y, &view);
    crowd_update(o->crowd, &view);
}

void tables_water_look(struct tables_water *o, struct moment *moment, double t, const double *y)
{
    struct view view;

    if (!o->crowd)
        return;
    observe_near(moment, t, y, &view);
    crowd_update(o->crowd, &view);
    if (o->has_front)
        front_find(o->crowd, &o->found);
    tables_probes_look(o->probes, o->crowd);
}

int tables_water_row(struct tables_water *o, double t)
{
    if (o->front)
        TRY(series_row(o->front, (double[]){ t, o->found.x, o->found.height }));
    return tables_probes_row(o->probes, t);
}

int tables_water_step(struct tables_water *o, struct moment *moment, double t, const double *y)
{
    if (!o->crowd || !tables_probes_step(o->probes))
        return STATUS_DONE;
    look(o, moment, t, y);
    return tables_probes_read(o->probes, o->crowd, t);
}

int tables_water_profile(struct tables_water *o, struct moment *moment, double t, const double *y)
{
    if (!o->crowd)
        return STATUS_DONE;
    look(o, moment, t, y);
    return tables_probes_profile(o->probes, o->crowd, t);
}

int tables_water_keep(struct tables_water *o, struct archive *a)
{
    TRY(series_keep(o->front, a, "front.csv"));
    TRY(series_keep(o->pairs, a, "pairing.csv"));
    return tables_probes_keep(o->probes, a);
}

void tables_water_close(struct tables_water **tables, int *status)
{
    struct tables_water *o = *tables;

    if (!o)
        return;
    columns_close(&o->front, status);
    columns_close(&o->pairs, status);
    tables_probes_close(&o->probes, status);
    crowd_free(&o->crowd);
    pairing_free(&o->pairing);
    free(o);
    *tables = NULL;
}
