/* rigid-skin.c -- where the points that the water meets stand in a rigid body. */
#include "bodies/rigid-skin.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

static int box(const struct rigid_def *d, double spacing, int layers, double (*arm)[DIM])
{
    int count[DIM], all = 1, n = 0;

    for (int k = 0; k < DIM; k++) {
        count[k] = (int)fmax(1, round(d->size[k] / spacing));
        all *= count[k];
    }
    for (int i = 0; i < all; i++) {
        double x[DIM];
        bool shallow = false;
        for (int k = 0, rest = i; k < DIM; rest /= count[k++]) {
            const int j = rest % count[k];
            shallow |= j < layers || count[k] - 1 - j < layers;
            x[k] = ((j + 0.5) / count[k] - 0.5) * d->size[k];
        }
        if (!shallow)
            continue;
        for (int k = 0; arm && k < DIM; k++)
            arm[n][k] = x[k];
        n++;
    }
    return n;
}

/* Point i of n on a circle; on a sphere along a spiral of equal areas (Swinbank, Purser,
 * Q. J. Roy. Meteorol. Soc. 132 (2006) 1769-1793). */
static void around(int i, int n, double radius, double *to)
{
#if DIM == 2
    to[0] = radius * cos(2 * pi * i / n);
    to[1] = radius * sin(2 * pi * i / n);
#else
    const double up = 1 - (2 * i + 1.0) / n, across = sqrt(1 - up * up);
    const double turn = pi * (3 - sqrt(5)) * i;
    to[0] = radius * across * cos(turn);
    to[1] = radius * across * sin(turn);
    to[2] = radius * up;
#endif
}

static int rings(const struct rigid_def *d, double spacing, int layers, double (*arm)[DIM])
{
    int n = 0;

    for (int k = 0; k < layers; k++) {
        const double radius = d->radius - (k + 0.5) * spacing;
        const double q = radius / spacing;
        if (radius <= -0.5 * spacing)
            break;
        const bool middle = q < 0.25;
        const int m = middle ? 1 : (int)round(DIM == 2 ? 2 * pi * q : 4 * pi * q * q);
        for (int i = 0; arm && i < m; i++)
            around(i, m, middle ? 0 : radius, arm[n + i]);
        n += m;
    }
    return n;
}

int rigid_skin(const struct rigid_def *d, double spacing, int layers, double (*arm)[DIM])
{
    if (!(spacing > 0))
        return 0;
    return rigid_def_round(d) ? rings(d, spacing, layers, arm) : box(d, spacing, layers, arm);
}

bool rigid_skin_holds(const struct rigid_def *def, const double *x)
{
    double q[TURNING_NUMBERS], R[DIM][DIM], square = 0;
    bool in = true;

    rigid_def_turned(def, q);
    turning_matrix(q, R);
    for (int k = 0; k < DIM; k++) {
        double own = 0;
        for (int d = 0; d < DIM; d++)
            own += R[d][k] * (x[d] - def->at[d]);
        in &= fabs(own) <= 0.5 * def->size[k];
        square += own * own;
    }
    return rigid_def_round(def) ? square <= def->radius * def->radius : in;
}
