/* lattice.c -- where the particles of a shape stand. */
#include "fill/lattice.h"

#include "shapes/shape-box.h"
#include "shapes/shape-polygon.h"
#include <math.h>
#include <string.h>

static const double most = 1e15; /* sites along an axis: beyond all memory, below LONG_MAX */

bool lattice_fits(double side, double dx, long *n)
{
    const double count = side / dx;

    *n = lrint(fmin(count, most));
    return fabs(count - *n) <= 1e-6 * *n;
}

/* As many sites as fit, spread over the whole side. */
static void spread(struct lattice *l, int d, double low, double high, double dx)
{
    lattice_fits(high - low, dx, &l->n[d]);
    l->origin[d] = low;
    l->pitch[d] = l->n[d] > 0 ? (high - low) / l->n[d] : dx;
}

/* Along the box's own axes. */
static void spread_own(struct lattice *l, int d, double low, double high, double dx)
{
    (void)low;
    (void)high;
    spread(l, d, l->shape->from[d], l->shape->to[d], dx);
}

/* From the lowest corner at the spacing itself, unless that fits the side. */
static void cover(struct lattice *l, int d, double low, double high, double dx)
{
    spread(l, d, low, high, dx);
    if (lattice_fits(high - low, dx, &l->n[d]))
        return;
    l->pitch[d] = dx;
    l->n[d] = lrint(fmin(ceil((high - low) / dx), most));
}

static void centre(struct lattice *l, int d, double low, double high, double dx)
{
    lattice_fits(high - low, dx, &l->n[d]);
    l->pitch[d] = dx;
    l->origin[d] = l->shape->centre[d] - 0.5 * l->n[d] * dx;
}

/* The domain's own lattice, and as many layers of it as the frame has outside. */
static void surround(struct lattice *l, int d, double low, double high, double dx)
{
    const double inner = l->shape->low[d], outer = l->shape->high[d];
    long before, after;

    spread(l, d, inner, outer, dx);
    lattice_fits(inner - low, dx, &before);
    lattice_fits(high - outer, dx, &after);
    l->origin[d] -= before * l->pitch[d];
    l->n[d] += before + after;
}

static double box_count(const struct lattice *l)
{
    double count = 1;

    for (int d = 0; d < DIM; d++)
        count *= l->n[d];
    return count;
}

static double polygon_count(const struct lattice *l)
{
    return shape_polygon_area(&l->shape->points) / (l->pitch[0] * l->pitch[1]);
}

static double disc_count(const struct lattice *l)
{
    return M_PI / 4 * box_count(l);
}

static double sphere_count(const struct lattice *l)
{
    return M_PI / 6 * box_count(l);
}

static double frame_count(const struct lattice *l)
{
    double domain = 1;

    for (int d = 0; d < DIM; d++)
        domain *= rint((l->shape->high[d] - l->shape->low[d]) / l->pitch[d]);
    return box_count(l) - domain;
}

static const struct rules {
    void (*set_axis)(struct lattice *l, int d, double low, double high, double dx);
    double (*count)(const struct lattice *l);
} rules[] = {
    [SHAPE_BOX] = { spread_own, box_count },
    [SHAPE_POLYGON] = { cover, polygon_count },
    [SHAPE_DISC] = { centre, disc_count },
    [SHAPE_SPHERE] = { centre, sphere_count },
    [SHAPE_FRAME] = { surround, frame_count },
};

struct lattice lattice_make(const struct shape *shape, double dx)
{
    struct lattice l = { .shape = shape };
    double low[DIM], high[DIM];

    shape_bounds(shape, low, high);
    for (int d = 0; d < DIM; d++)
        rules[shape->kind].set_axis(&l, d, low[d], high[d], dx);
    return l;
}

double lattice_estimate(const struct lattice *l)
{
    return rules[l->shape->kind].count(l);
}

/* The next site, the first axis fastest; false after the last one. */
static bool advance(const struct lattice *l, long *i)
{
    for (int d = 0; d < DIM; d++) {
        if (++i[d] < l->n[d])
            return true;
        i[d] = 0;
    }
    return false;
}

long lattice_sites(const struct lattice *l, double (*x)[DIM])
{
    long i[DIM] = { 0 }, count = 0;

    if (!(box_count(l) > 0))
        return 0;
    do {
        double site[DIM];

        for (int d = 0; d < DIM; d++)
            site[d] = l->origin[d] + (i[d] + 0.5) * l->pitch[d];
        if (l->shape->kind == SHAPE_BOX)
            shape_box_place(l->shape, site, site);
        if (!shape_contains(l->shape, site))
            continue;
        if (x)
            memcpy(x[count], site, sizeof site);
        count++;
    } while (advance(l, i));
    return count;
}
