/* fill.c -- turns the shapes of a scene into particles: how many, where, whose. */
#include "state/fill.h"

#include "base/status.h"
#include "state/fit.h"
#include "state/lattice.h"
#include "state/memory.h"
#include "state/overlap.h"
#include "state/particles-private.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Items sorted by kind: item k becomes object k. */
struct filling {
    const struct scales *scales;
    int items;
    struct fill_item *item;
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

static double estimate(const struct filling *f, int i)
{
    const struct fill_item *item = &f->item[i];

    if (!item->shape)
        return item->points;

    const struct lattice lattice = lattice_make(item->shape, f->scales->dx);
    return lattice_estimate(&lattice);
}

/* The spacing at which count particles become limit [m]. */
static double coarser(const struct filling *f, double count, double limit)
{
    return f->scales->dx * pow(count / limit, 1.0 / DIM);
}

/* Before anything is allocated or walked through: is there room for them? */
static int check_room(const struct filling *f, double bytes_each)
{
    static const double most = INT_MAX / 4, gib = 1024.0 * 1024 * 1024;
    const double bytes = memory_available("/proc/meminfo");
    double count = 0, largest = 0;
    const struct fill_item *item = f->item;

    for (int i = 0; i < f->items; i++) {
        const double n = estimate(f, i);

        count += n;
        item = n > largest ? &f->item[i] : item;
        largest = fmax(n, largest);
    }
    if (count > most)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.%s: spacing %.4g m makes about %.3g particles,"
                           " more than this program can number (%.3g); at %.2g m they would be few"
                           " enough", item->where, item->group, item->name, f->scales->dx, count,
                           most, 1.1 * coarser(f, count, most));
    if (bytes > 0 && count * bytes_each > bytes)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.%s: spacing %.4g m makes about %.3g particles,"
                           " which need %.3g GiB of memory, and %.3g GiB are free; at %.2g m they"
                           " would fit", item->where, item->group, item->name, f->scales->dx, count,
                           count * bytes_each / gib, bytes / gib,
                           1.1 * coarser(f, count * bytes_each, bytes));
    return STATUS_DONE;
}

static int refuse_empty(const struct filling *f, const struct fill_item *item)
{
    return status_fail(STATUS_BAD_SCENE, "%s: %s.%s holds no particle: at the spacing %.4g m no"
                       " site lies inside; make it larger or the spacing smaller", item->where,
                       item->group, item->name, f->scales->dx);
}

static int count_all(const struct filling *f, int *total)
{
    *total = 0;
    for (int i = 0; i < f->items; i++) {
        const struct fill_item *item = &f->item[i];
        long n = item->points;

        if (item->shape) {
            const struct lattice lattice = lattice_make(item->shape, f->scales->dx);
            n = lattice_sites(&lattice, NULL);
        }
        if (n == 0 && (item->shape || item->kind == KIND_FLUID))
            return refuse_empty(f, item);
        *total += (int)n;
    }
    return STATUS_DONE;
}

/* Places object k from particle `from` on; returns how many. */
static int place_object(const struct filling *f, struct particles *p, int k, int from)
{
    const struct fill_item *item = &f->item[k];
    int n = item->points;

    if (item->shape) {
        const struct lattice lattice = lattice_make(item->shape, f->scales->dx);
        n = (int)lattice_sites(&lattice, p->x0 + from);
    } else if (n > 0) {
        memcpy(p->x0 + from, item->point, n * sizeof *item->point);
    }
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

static int fill(const struct filling *f, double bytes_each, struct particles **out)
{
    int n;

    TRY(check_spacing(f));
    TRY(check_room(f, bytes_each));
    TRY(fit_check(f->item, f->items, f->scales->dx));
    TRY(count_all(f, &n));
    TRY(particles_create(n, f->items, f->scales, out));
    place_all(f, *out);
    TRY(check_domain(f, *out));
    return overlap_check(*out, f->item, f->scales->dx);
}

int fill_particles(const struct fill_item *item, int items, const struct scales *scales,
                   double bytes_each, struct particles **out)
{
    struct filling f = { .scales = scales, .items = items };
    int code = STATUS_FAILED;

    *out = NULL;
    f.item = status_alloc(items, sizeof *f.item);
    if (f.item) {
        sort_items(&f, item);
        code = fill(&f, bytes_each, out);
        free(f.item);
    }
    if (code)
        particles_free(out);
    return code;
}
