/* fill-check.c -- what is refused before a shape is filled. */
#include "fill/fill-private.h"

#include "base/status.h"
#include "fill/fit.h"
#include "fill/lattice.h"
#include "shapes/layers.h"
#include "state/memory.h"
#include <limits.h>
#include <math.h>
#include <string.h>

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

bool fill_in_layers(const struct fill_item *item)
{
    return item->kind != KIND_FLUID && layers_wanted(item->shape);
}

static double estimate(const struct filling *f, int i)
{
    const struct fill_item *item = &f->item[i];

    if (!item->shape)
        return item->points;
    if (fill_in_layers(item))
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
    for (int i = 0; item->point && i < item->points; i++) {
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

static int check_shapes(const struct filling *f)
{
    TRY(check_spacing(f));
    TRY(check_fills(f));
    return check_periods(f);
}

int fill_check(const struct filling *f, double bytes_fluid, double bytes_solid)
{
    TRY(check_shapes(f));
    TRY(check_room(f, bytes_fluid, bytes_solid));
    return fit_check(f->item, f->items, f->scales->dx);
}

int fill_count(const struct fill_item *item, int items, const struct scales *scales,
               double bytes_fluid, double bytes_solid, struct fill_counts *to)
{
    const struct filling f = { .scales = scales, .items = items,
                               .item = (struct fill_item *)item }; /* which stay as they are */

    TRY(check_shapes(&f));
    for (int i = 0; i < items; i++) {
        to->of[i] = estimate(&f, i);
        *(item[i].kind == KIND_FLUID ? &to->fluid : &to->solid) += to->of[i];
    }
    to->known = true;
    TRY(check_room(&f, bytes_fluid, bytes_solid));
    return fit_check(item, items, scales->dx);
}
