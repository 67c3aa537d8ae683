/* skin.c -- where the points that the water meets stand beside a beam. */
#include "bodies/skin.h"

#include "base/status.h"

#include <math.h>

static const double most = 5e6;

int skin_check(double points, const char *path)
{
    if (points <= most)
        return STATUS_DONE;
    return status_fail_with(STATUS_BAD_SCENE,
                            (struct status_advice){ .remedy = "make it shorter, or the spacing "
                                                              "larger" },
                            "%s: about %.3g particles would stand in it for the water, and a body "
                            "may have %.3g", path, points, most);
}

double skin_size(const struct skin_def *d)
{
    return d->spacing > 0 ? d->length / d->spacing * d->layers : 0;
}

static int rows(const struct skin_def *d)
{
    return d->spacing > 0 ? (int)fmax(1, round(d->length / d->spacing)) : 0;
}

int skin_points(const struct skin_def *d)
{
    return rows(d) * d->layers;
}

void skin_site(const struct skin_def *d, int i, double *s, double *eta)
{
    *s = (i / d->layers + 0.5) * d->length / rows(d);
    *eta = (i % d->layers - (d->layers - 1) / 2.0) * d->spacing;
}

bool skin_held(const struct skin_def *d, bool root, bool tip, int i)
{
    const double reach = (0.5 * d->layers + 1) * d->spacing;
    double s, eta;

    skin_site(d, i, &s, &eta);
    return (root && s < reach) || (tip && d->length - s < reach);
}
