/* probe-area.c -- points of equal weight over a segment, a rectangle or a disc. */
#include "measure/probe-area.h"

#include <math.h>
#include <string.h>

/* The box from `at` to `to`, flat in all directions in which they agree; in 2D the
 * straight line between them. */
static int over_box(const struct settings_probe *p, double step, double (*x)[DIM])
{
    int many[3] = { 1, 1, 1 }, n = 0;
    double length = 0;

    for (int d = 0; d < DIM; d++) {
        many[d] = (int)fmax(ceil(fabs(p->to[d] - p->at[d]) / step - 1e-9), 1);
        length = hypot(length, p->to[d] - p->at[d]);
    }
    if (DIM == 2) {
        many[0] = (int)fmax(ceil(length / step - 1e-9), 1);
        many[1] = 1;
    }
    for (int i = 0; i < many[0]; i++)
        for (int j = 0; j < many[1]; j++)
            for (int k = 0; k < many[2]; k++, n++) {
                const double share[3] = { (i + 0.5) / many[0], (j + 0.5) / many[1],
                                          (k + 0.5) / many[2] };
                for (int d = 0; x && d < DIM; d++)
                    x[n][d] = p->at[d] + share[DIM == 2 ? 0 : d] * (p->to[d] - p->at[d]);
            }
    return n;
}

/* Two directions across the normal, at right angles, all of length 1. */
static void across(const double *normal, double a[3], double b[3])
{
    const double length = hypot(hypot(normal[0], normal[1]), normal[2]);
    int least = 0;
    double m[3], size;

    for (int d = 0; d < 3; d++) {
        m[d] = normal[d] / length;
        least = fabs(m[d]) < fabs(m[least]) ? d : least;
    }
    size = sqrt(1 - m[least] * m[least]);
    for (int d = 0; d < 3; d++)
        a[d] = ((d == least) - m[least] * m[d]) / size;
    for (int d = 0; d < 3; d++)
        b[d] = m[(d + 1) % 3] * a[(d + 2) % 3] - m[(d + 2) % 3] * a[(d + 1) % 3];
}

/* Ring k has 4 (2 k + 1) points: as large a part of the disc for each. */
static int over_disc(const struct settings_probe *p, double step, double (*x)[DIM])
{
    const int rings = (int)fmax(ceil(p->radius / step - 1e-9), 1);
    double a[3], b[3];
    int n = 0;

    across(p->normal, a, b);
    for (int k = 0; k < rings; k++)
        for (int i = 0; i < 4 * (2 * k + 1); i++, n++) {
            const double r = (k + 0.5) * p->radius / rings;
            const double turn = 2 * M_PI * (i + 0.5) / (4 * (2 * k + 1));
            for (int d = 0; x && d < DIM; d++)
                x[n][d] = p->at[d] + r * (cos(turn) * a[d] + sin(turn) * b[d]);
        }
    return n;
}

int probe_area(const struct settings_probe *p, double step, double (*x)[DIM])
{
    if (DIM == 3 && p->radius > 0)
        return over_disc(p, step, x);
    if (!isnan(p->to[0]))
        return over_box(p, step, x);
    if (x)
        memcpy(x[0], p->at, sizeof x[0]);
    return 1;
}
