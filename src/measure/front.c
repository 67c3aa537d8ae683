/* front.c -- front and height of the water, spray left out. */
#include "measure/front.h"

#include "measure/probe.h"
#include <math.h>

static double foremost(const struct crowd *c)
{
    const struct view *v = crowd_view(c);
    const int n = particles_count(v->p, KIND_FLUID);
    double best = -INFINITY;

    for (int i = 0; i < n; i++) {
        const double x = v->x[KIND_FLUID][DIM * (long)i];
        if (x > best && crowd_is_water(c, i)) /* few are asked for their company */
            best = x;
    }
    return best > -INFINITY ? best : NAN;
}

void front_find(const struct crowd *c, struct front *out)
{
    const struct scales *s = crowd_view(c)->p->scales;
    const double wall[DIM] = { s->low[0] };

    out->x = foremost(c);
    out->height = probe_height(c, wall, 1);
}
