/* fill.c -- turns the shapes of a scene into particles: how many, where, of which object.
 *
 * Every item is first a list of places of its own; particles are made of what is left of
 * them when fluids have made room. */
#include "fill/fill-private.h"

#include "base/status.h"
#include "fill/carve.h"
#include "fill/lattice.h"
#include "shapes/layers.h"
#include "fill/overlap.h"
#include "state/particles-private.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void sort_items(struct filling *f, const struct fill_item *item)
{
    int next = 0;

    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < f->items; i++)
            if ((int)item[i].kind == kind)
                f->item[next++] = item[i];
}

static int refuse_empty(const struct filling *f, const struct fill_item *item)
{
    return status_fail(STATUS_BAD_SCENE, "%s: %s.%s holds no particle: at the spacing %.4g m no"
                       " site lies inside; make it larger or the spacing smaller", item->where,
                       item->group, item->name, f->scales->dx);
}

static int add_lattice(const struct filling *f, int k)
{
    const struct lattice lattice = lattice_make(f->item[k].shape, f->scales->dx);
    const long n = lattice_sites(&lattice, NULL);

    TRY(points_reserve(&f->points[k], n));
    f->points[k].n = lattice_sites(&lattice, f->points[k].x);
    return STATUS_DONE;
}

/* A shape too thin for layers may hold a site all the same. */
static int add_layers(const struct filling *f, int k)
{
    const struct fill_item *item = &f->item[k];
    struct points *points = &f->points[k];
    double x[DIM] = { 0 };
    bool bare;

    TRY(layers_fill(item->shape, f->scales->dx, points));
    if (points->n == 0)
        TRY(add_lattice(f, k));
    TRY(layers_bare(item->shape, f->scales->dx, points, x, &bare));
    if (bare && points->n > 0)
        status_warn("%s: %s.%s is too thin near (%g, %g) m to be filled at the spacing %.4g m and"
                    " lets fluid through there; make it thicker or the spacing smaller",
                    item->where, item->group, item->name, x[0], x[1], f->scales->dx);
    return STATUS_DONE;
}

static int add_given(const struct fill_item *item, struct points *points)
{
    TRY(points_reserve(points, item->points));
    if (item->points > 0)
        memcpy(points->x, item->point, item->points * sizeof *item->point);
    points->n = item->points;
    return STATUS_DONE;
}

static int add_all(const struct filling *f)
{
    for (int k = 0; k < f->items; k++) {
        const struct fill_item *item = &f->item[k];

        if (!item->shape)
            TRY(add_given(item, &f->points[k]));
        else
            TRY(fill_in_layers(item) ? add_layers(f, k) : add_lattice(f, k));
    }
    return STATUS_DONE;
}

static int count_all(const struct filling *f, int *total)
{
    *total = 0;
    for (int k = 0; k < f->items; k++) {
        const struct fill_item *item = &f->item[k];

        if (f->points[k].n == 0 && (item->shape || item->kind == KIND_FLUID))
            return refuse_empty(f, item);
        *total += (int)f->points[k].n;
    }
    return STATUS_DONE;
}

/* Places object k from particle `from` on; returns how many. */
static int place_object(const struct filling *f, struct particles *p, int k, int from)
{
    const struct fill_item *item = &f->item[k];
    const int n = (int)f->points[k].n;

    if (n > 0)
        memcpy(p->x0 + from, f->points[k].x, n * sizeof *p->x0);
    p->object[k] = (struct object){ .kind = item->kind, .from = from, .n = n,
                                    .carved = (int)f->carved[k].n, .carver = f->carved[k].most };
    memcpy(p->object[k].name, item->name, sizeof item->name);
    for (int i = from; i < from + n; i++) {
        p->object_of[i] = k;
        p->m[i] = f->scales->mass;
    }
    return n;
}

static void place_all(const struct filling *f, struct particles *p)
{
    int from = 0;

    for (int k = 0; k < f->items; k++) {
        from += place_object(f, p, k, from);
        for (int kind = f->item[k].kind; kind < KINDS; kind++)
            p->from[kind + 1] = from;
    }
}

static int check_domain(const struct filling *f, const struct particles *p)
{
    const double *low = f->scales->low, *high = f->scales->high;

    for (int i = 0; i < p->from[KIND_FLUID + 1]; i++)
        for (int d = 0; d < DIM; d++)
            if (!(low[d] <= p->x0[i][d] && p->x0[i][d] <= high[d])) {
                const struct fill_item *item = &f->item[p->object_of[i]];

                return status_fail(STATUS_BAD_SCENE, "%s: %s.%s reaches out of the domain: along %c"
                                   " a particle stands at %g m, the domain goes from %g m to %g m;"
                                   " shrink or move the fluid, or make the domain larger",
                                   item->where, item->group, item->name, "xyz"[d], p->x0[i][d],
                                   low[d], high[d]);
            }
    return STATUS_DONE;
}

static int fill(const struct filling *f, double bytes_fluid, double bytes_solid,
                struct particles **out)
{
    int n;

    TRY(fill_check(f, bytes_fluid, bytes_solid));
    TRY(add_all(f));
    TRY(carve_fluids(f->item, f->items, f->scales, f->points, f->carved));
    TRY(count_all(f, &n));
    TRY(particles_create(n, f->items, f->scales, out));
    place_all(f, *out);
    TRY(check_domain(f, *out));
    return overlap_check(*out, f->item, f->scales->dx);
}

int fill_particles(const struct fill_item *item, int items, const struct scales *scales,
                   double bytes_fluid, double bytes_solid, struct particles **out)
{
    struct filling f = { .scales = scales, .items = items };
    int code = STATUS_FAILED;

    *out = NULL;
    f.item = status_alloc(items, sizeof *f.item);
    f.points = status_alloc(items, sizeof *f.points);
    f.carved = status_alloc(items, sizeof *f.carved);
    if (f.item && f.points && f.carved) {
        sort_items(&f, item);
        code = fill(&f, bytes_fluid, bytes_solid, out);
    }
    for (int k = 0; f.points && k < items; k++)
        points_free(&f.points[k]);
    free(f.carved);
    free(f.points);
    free(f.item);
    if (code)
        particles_free(out);
    return code;
}
