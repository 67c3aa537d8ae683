/* memory.c -- counts on a lattice. */
#include "solved/memory.h"

#include <math.h>

/* Points of the lattice nearer than `reach` to one of them, of those between layers low and high beside it. */
static double count(double reach, int low, int high)
{
    const int far = (int)reach, deep = DIM == 3 ? far : 0;
    double n = 0;

    for (int i = low > -far ? low : -far; i <= high && i <= far; i++)
        for (int j = -far; j <= far; j++)
            for (int k = -deep; k <= deep; k++)
                n += i * i + j * j + k * k <= reach * reach;
    return n - 1;
}

/* The mean over the layers of a wall, half of which has fluid before it. */
static double of_solid(const struct plan *p, double reach)
{
    const int layers = (int)ceil(p->in.kernel.support);
    double sum = 0;

    for (int i = 0; i < layers; i++)
        sum += count(reach, -(int)reach, layers - 1 - i) + count(reach, -i, layers - 1 - i);
    return sum / (2 * layers);
}

double memory_pairs(const struct plan *p, double reach, bool solids)
{
    const double fluid = particles_count(p->particles, KIND_FLUID);

    return fluid * count(reach, -(int)reach, (int)reach) + (solids ? (p->particles->n - fluid) * of_solid(p, reach) : 0);
}

double memory_list(const struct plan *p, double reach)
{
    const double n = p->particles->n;

    return list_bytes(n, n, memory_pairs(p, reach, true));
}
