/* memory.c -- counts on a lattice. */
#include "solved/memory.h"

#include <math.h>

/* Share of a full ball that a solid in some three layers has. */
static const double share = 0.6;

double memory_pairs(const struct plan *p, double reach, bool solids)
{
    const double ball = DIM == 2 ? M_PI * reach * reach : 4 * M_PI / 3 * reach * reach * reach;
    const double fluid = particles_count(p->particles, KIND_FLUID);

    return ball * (fluid + (solids ? share * (p->particles->n - fluid) : 0));
}

double memory_list(const struct plan *p, double reach)
{
    const double n = p->particles->n;

    return list_bytes(n, n, memory_pairs(p, reach, true));
}
