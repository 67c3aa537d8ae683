/* front.c -- front and height of the water, spray left out. */
#include "measure/front.h"

#include "measure/probe.h"
#include "ranks/ranks.h"
#include <math.h>

static double foremost(const struct crowd *c)
{
    const struct view *v = crowd_view(c);
    const int n = particles_count(v->p, KIND_FLUID);
    double best = -INFINITY;

    for (int i = 0; i < n; i++) {
        const double x = v->x[KIND_FLUID][DIM * (long)i];
        if (view_has(v, i) && x > best && crowd_is_water(c, i)) /* few are asked for their company */
            best = x;
    }
    return best;
}

void front_find(const struct crowd *c, struct front *out)
{
    const struct scales *s = crowd_view(c)->p->scales;
    const double wall[DIM] = { s->low[0] };

    double found[2] = { foremost(c), probe_height(c, wall, 1) };

    if (crowd_view(c)->mine)
        ranks_most(2, found);
    out->x = found[0] > -INFINITY ? found[0] : NAN;
    out->height = found[1];
}
