/* fill.c -- turns the shapes of a scene into particles: how many, where, whose.
 *
 * Every item is first a list of places of its own; particles are made of what is left of
 * them when fluids have been trimmed. */
#include "state/fill.h"

#include "base/status.h"
#include "state/fit.h"
#include "state/lattice.h"
#include "state/layers.h"
#include "state/memory.h"
#include "state/overlap.h"
#include "state/particles-private.h"
#include "state/trim.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Items sorted by kind: item k becomes object k. */
struct filling {
    const struct scales *scales;
    int items;
    struct fill_item *item; /* [items]                    */
    struct points *points;  /* [items] where they stand   */
};

static void sort_items(struct filling *f, const struct fill_item *item)
{
    int next = 0;

    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < f->items; i++)
            if ((int)item[i].kind == kind)
                f->item[next++] = item[i];
}

static int check_spacing(const struct filling *f)
{
    const double dx = f->scales->dx;

    for (int i = 0; i < f->items; i++)
        if (f->item[i].shape && !(dx > 0 && dx < HUGE_VAL))
            return status_fail(STATUS_BAD_SCENE, "%s: %s.%s cannot be filled with particles %g m"
                               " apart; the spacing must be above 0", f->item[i].where,
                               f->item[i].group, f->item[i].name, dx);
    return STATUS_DONE;
}

/* Layers would start a fluid with uneven distances, and thus with noise. */
static int check_fills(const struct filling *f)
{
    for (int i = 0; i < f->items; i++) {
        const struct fill_item *item = &f->item[i];

        if (item->kind == KIND_FLUID && item->shape && item->shape->fill
            && strcmp(item->shape->fill, "layers") == 0)
            return status_fail(STATUS_BAD_SCENE, "%s: %s.%s: fill = \"layers\" is for walls; a"
                               " fluid starts on a lattice: leave fill out", item->where,
                               item->group, item->name);
    }
    return STATUS_DONE;
}

static bool has_layers(const struct fill_item *item)
{
    return item->kind != KIND_FLUID && layers_wanted(item->shape);
}

static double estimate(const struct filling *f, int i)
{
    const struct fill_item *item = &f->item[i];

    if (!item->shape)
        return item->points;
    if (has_layers(item))
        return layers_estimate(item->shape, f->scales->dx);

    const struct lattice lattice = lattice_make(item->shape, f->scales->dx);
    return lattice_estimate(&lattice);
}

/* The spacing at which count particles become limit [m]. */
static double coarser(const struct filling *f, double count, double limit)
{
    return f->scales->dx * pow(count / limit, 1.0 / DIM);
}

/* Before anything is allocated or walked through: is there room for them? */
static int check_room(const struct filling *f, double bytes_fluid, double bytes_solid)
{
    static const double most = INT_MAX / 4, gib = 1024.0 * 1024 * 1024;
    const double bytes = memory_available("/proc/meminfo");
    double count = 0, need = 0, largest = 0;
    const struct fill_item *item = f->item;

    for (int i = 0; i < f->items; i++) {
        const double n = estimate(f, i);

        count += n;
        need += n * (f->item[i].kind == KIND_FLUID ? bytes_fluid : bytes_solid);
        item = n > largest ? &f->item[i] : item;
        largest = fmax(n, largest);
    }
    if (count > most)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.%s: spacing %.4g m makes about %.3g particles,"
                           " more than this program can number (%.3g); at %.2g m they would be few"
                           " enough", item->where, item->group, item->name, f->scales->dx, count,
                           most, 1.1 * coarser(f, count, most));
    if (bytes > 0 && need > bytes)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.%s: spacing %.4g m makes about %.3g particles,"
                           " which need %.3g GiB of memory, and %.3g GiB are free; at %.2g m they"
                           " would fit", item->where, item->group, item->name, f->scales->dx, count,
                           need / gib, bytes / gib, 1.1 * coarser(f, need, bytes));
    return STATUS_DONE;
}

static int refuse_empty(const struct filling *f, const struct fill_item *item)
{
    return status_fail(STATUS_BAD_SCENE, "%s: %s.%s holds no particle: at the spacing %.4g m no"
                       " site lies inside; make it larger or the spacing smaller", item->where,
                       item->group, item->name, f->scales->dx);
}

/* Where a given item reaches to along d. */
static void reach_of(const struct fill_item *item, int d, double *least, double *most)
{
    double low[DIM], high[DIM];

    *least = HUGE_VAL;
    *most = -HUGE_VAL;
    if (item->shape) {
        shape_bounds(item->shape, low, high);
        *least = low[d];
        *most = high[d];
    }
    for (int i = 0; i < item->points; i++) {
        *least = fmin(*least, item->point[i][d]);
        *most = fmax(*most, item->point[i][d]);
    }
}

/* What sticks out over a side through which it comes in again would overlap with what
 * stands there. */
static int check_periods(const struct filling *f)
{
    const struct scales *s = f->scales;
    double least, most;

    for (int k = 0; k < f->items; k++)
        for (int d = 0; d < DIM; d++) {
            const struct fill_item *item = &f->item[k];
            reach_of(item, d, &least, &most);
            if (s->period[d] > 0 && (least < s->low[d] - 1e-9 * s->period[d]
                                     || most > s->high[d] + 1e-9 * s->period[d]))
                return status_fail(STATUS_BAD_SCENE, "%s: %s.%s reaches over a periodic side: along"
                                   " %c it goes from %g m to %g m, and the domain repeats from %g"
                                   " m to %g m; let it end at the side, or name two parts",
                                   item->where, item->group, item->name, "xyz"[d], least, most,
                                   s->low[d], s->high[d]);
        }
    return STATUS_DONE;
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
            TRY(has_layers(item) ? add_layers(f, k) : add_lattice(f, k));
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
    p->object[k] = (struct object){ .kind = item->kind, .from = from, .n = n };
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
    memcpy(p->x, p->x0, p->n * sizeof *p->x);
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

    TRY(check_spacing(f));
    TRY(check_fills(f));
    TRY(check_periods(f));
    TRY(check_room(f, bytes_fluid, bytes_solid));
    TRY(fit_check(f->item, f->items, f->scales->dx));
    TRY(add_all(f));
    TRY(trim_fluids(f->item, f->items, f->scales->dx, f->points));
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
    if (f.item && f.points) {
        sort_items(&f, item);
        code = fill(&f, bytes_fluid, bytes_solid, out);
    }
    for (int k = 0; f.points && k < items; k++)
        points_free(&f.points[k]);
    free(f.points);
    free(f.item);
    if (code)
        particles_free(out);
    return code;
}
