/* lattice.c -- where the particles of a shape stand. */
#include "fill/lattice.h"

#include "shapes/shape-kind.h"
#include <math.h>
#include <string.h>

struct lattice lattice_make(const struct shape *shape, double dx)
{
    struct lattice l = { .shape = shape };

    for (int d = 0; d < DIM; d++)
        l.axis[d] = shape_kind(shape)->rows(shape, d, dx);
    return l;
}

double lattice_estimate(const struct lattice *l)
{
    double cell = 1, all = 1;

    for (int d = 0; d < DIM; d++) {
        cell *= l->axis[d].pitch;
        all *= l->axis[d].n;
    }
    return fmin(all, shape_kind(l->shape)->volume(l->shape) / cell);
}

/* The next site, the first axis fastest; false after the last one. */
static bool advance(const struct lattice *l, long *i)
{
    for (int d = 0; d < DIM; d++) {
        if (++i[d] < l->axis[d].n)
            return true;
        i[d] = 0;
    }
    return false;
}

long lattice_sites(const struct lattice *l, double (*x)[DIM])
{
    const struct shape_kind *kind = shape_kind(l->shape);
    long i[DIM] = { 0 }, count = 0;

    for (int d = 0; d < DIM; d++)
        if (!(l->axis[d].n > 0))
            return 0;
    do {
        double site[DIM];

        for (int d = 0; d < DIM; d++)
            site[d] = l->axis[d].origin + (i[d] + 0.5) * l->axis[d].pitch;
        if (kind->place)
            kind->place(l->shape, site, site);
        if (!kind->contains(l->shape, site))
            continue;
        if (x)
            memcpy(x[count], site, sizeof site);
        count++;
    } while (advance(l, i));
    return count;
}
