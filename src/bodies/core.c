/* core.c -- the core of a solid: boxes and points. */
#include "bodies/core.h"

#include <math.h>

bool core_point(const struct core *c)
{
    bool none = true;

    for (int d = 0; d < DIM; d++)
        none &= !(c->half[d] > 0);
    return none;
}

double core_reach(const struct core *c)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += c->half[d] * c->half[d];
    return sqrt(square) + c->ball;
}

int core_corners(const struct core *c)
{
    return core_point(c) ? 1 : 1 << DIM;
}

int core_edges(const struct core *c)
{
    return DIM == 2 || core_point(c) ? 0 : 12;
}

void core_corner(const struct core *c, int i, double *to)
{
    for (int d = 0; d < DIM; d++)
        to[d] = i >> d & 1 ? c->half[d] : -c->half[d];
}

/* Four along each axis, by the signs of the other two. */
void core_edge(const struct core *c, int i, double *from, double *to)
{
    const int axis = i / 4;

    for (int k = 0; k < DIM; k++) {
        const int d = (axis + k) % DIM;
        from[d] = k == 0 || !(i >> (k - 1) & 1) ? -c->half[d] : c->half[d];
        to[d] = k == 0 ? c->half[d] : from[d];
    }
}

void core_nearest(const struct core *c, const double *x, double *to)
{
    for (int d = 0; d < DIM; d++)
        to[d] = fmin(fmax(x[d], -c->half[d]), c->half[d]);
}

/* Half of the shadow of a box on an axis; its own axes are the columns of R. */
static double shadow(const struct core *c, double (*const R)[DIM], const double *axis)
{
    double sum = 0;

    for (int k = 0; k < DIM; k++) {
        double along = 0;
        for (int d = 0; d < DIM; d++)
            along += R[d][k] * axis[d];
        sum += c->half[k] * fabs(along);
    }
    return sum;
}

static bool parted(const struct core *a, const struct core *b, const double *x,
                   double (*const R)[DIM], const double *axis)
{
    double own[DIM][DIM] = { { 0 } }, gap = 0;

    for (int d = 0; d < DIM; d++) {
        own[d][d] = 1;
        gap += x[d] * axis[d];
    }
    return fabs(gap) > shadow(a, own, axis) + shadow(b, R, axis);
}

/* The cross product of axis i of the first and axis k of the second. */
static bool parted_by_edges(const struct core *a, const struct core *b, const double *x,
                            double (*const R)[DIM], int i, int k)
{
    double axis[DIM] = { 0 };

    axis[(i + 1) % DIM] = -R[(i + 2) % DIM][k];
    axis[(i + 2) % DIM] = R[(i + 1) % DIM][k];
    return parted(a, b, x, R, axis);
}

bool core_overlaps(const struct core *a, const struct core *b, const double *x,
                   double (*const R)[DIM])
{
    for (int i = 0; i < DIM; i++) {
        double face[DIM] = { 0 }, other[DIM];
        face[i] = 1;
        for (int d = 0; d < DIM; d++)
            other[d] = R[d][i];
        if (parted(a, b, x, R, face) || parted(a, b, x, R, other))
            return false;
        for (int k = 0; k < DIM && DIM == 3; k++)
            if (parted_by_edges(a, b, x, R, i, k))
                return false;
    }
    return true;
}
