/* core.c -- the core of a solid: boxes, lines and points, and polytopes. */
#include "bodies/core.h"

#include <math.h>
#include <string.h>

/* Directions that a box has sides along, to axis [DIM]; how many. */
static int sides(const struct core *c, int *axis)
{
    int n = 0;

    for (int d = 0; d < DIM; d++)
        if (c->half[d] > 0)
            axis[n++] = d;
    return n;
}

bool core_point(const struct core *c)
{
    int axis[DIM];

    return c->hull ? c->hull->corners == 1 : sides(c, axis) == 0;
}

double core_reach(const struct core *c)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += c->half[d] * c->half[d];
    return (c->hull ? polytope_reach(c->hull) : sqrt(square)) + c->ball;
}

/* About the middle of the corners; a box has it at its centre. */
double core_around(const struct core *c, double *middle)
{
    const struct polytope *p = c->hull;
    double most = 0;

    memset(middle, 0, DIM * sizeof *middle);
    if (!p)
        return core_reach(c);
    for (int i = 0; i < p->corners; i++)
        for (int d = 0; d < DIM; d++)
            middle[d] += p->x[i][d] / p->corners;
    for (int i = 0; i < p->corners; i++) {
        double square = 0;
        for (int d = 0; d < DIM; d++)
            square += (p->x[i][d] - middle[d]) * (p->x[i][d] - middle[d]);
        most = fmax(most, square);
    }
    return sqrt(most) + c->ball;
}

int core_corners(const struct core *c)
{
    int axis[DIM];

    return c->hull ? c->hull->corners : 1 << sides(c, axis);
}

/* Of a box as many along each of its sides. */
int core_edges(const struct core *c)
{
    int axis[DIM];
    const int n = sides(c, axis);

    if (DIM == 2)
        return 0;
    return c->hull ? c->hull->edges : n > 0 ? n << (n - 1) : 0;
}

void core_corner(const struct core *c, int i, double *to)
{
    int axis[DIM];
    const int n = sides(c, axis);

    if (c->hull) {
        memcpy(to, c->hull->x[i], DIM * sizeof *to);
        return;
    }
    memset(to, 0, DIM * sizeof *to);
    for (int k = 0; k < n; k++)
        to[axis[k]] = i >> k & 1 ? c->half[axis[k]] : -c->half[axis[k]];
}

/* Those along one side after those along another, by the signs of the rest. */
void core_edge(const struct core *c, int i, double *from, double *to)
{
    int axis[DIM];
    const int n = sides(c, axis), first = c->hull ? 0 : i / (1 << (n - 1));

    if (c->hull) {
        memcpy(from, c->hull->x[c->hull->edge[i][0]], DIM * sizeof *from);
        memcpy(to, c->hull->x[c->hull->edge[i][1]], DIM * sizeof *to);
        return;
    }
    memset(from, 0, DIM * sizeof *from);
    memset(to, 0, DIM * sizeof *to);
    for (int k = 0; k < n; k++) {
        const int d = axis[(first + k) % n];
        from[d] = k == 0 || !(i >> (k - 1) & 1) ? -c->half[d] : c->half[d];
        to[d] = k == 0 ? c->half[d] : from[d];
    }
}

void core_nearest(const struct core *c, const double *x, double *to)
{
    if (c->hull) {
        polytope_nearest(c->hull, x, to);
        return;
    }
    for (int d = 0; d < DIM; d++)
        to[d] = fmin(fmax(x[d], -c->half[d]), c->half[d]);
}

/* From where to where its shadow on an axis goes; it stands at x, turned by R. */
static void shadow(const struct core *c, const double *x, double (*const R)[DIM],
                   const double *axis, double *low, double *high)
{
    double own[DIM] = { 0 }, middle = 0, sum = 0;

    for (int d = 0; d < DIM; d++) {
        middle += x[d] * axis[d];
        for (int k = 0; k < DIM; k++)
            own[k] += R[d][k] * axis[d];
    }
    for (int k = 0; k < DIM; k++)
        sum += c->half[k] * fabs(own[k]);
    *low = c->hull ? HUGE_VAL : middle - sum;
    *high = c->hull ? -HUGE_VAL : middle + sum;
    for (int i = 0; c->hull && i < c->hull->corners; i++) {
        double along = middle;
        for (int k = 0; k < DIM; k++)
            along += own[k] * c->hull->x[i][k];
        *low = fmin(*low, along);
        *high = fmax(*high, along);
    }
}

/* Two cores: the first at the origin, its axes those of space. */
struct two {
    const struct core *core[2];
    const double *x[2];
    double (*R[2])[DIM];
};

static bool parted(const struct two *t, const double *axis)
{
    double low[2], high[2];

    for (int i = 0; i < 2; i++)
        shadow(t->core[i], t->x[i], (double (*const)[DIM])t->R[i], axis, &low[i], &high[i]);
    return low[0] > high[1] || low[1] > high[0];
}

static int faces_of(const struct core *c)
{
    return c->hull ? c->hull->faces : DIM;
}

static int lines_of(const struct core *c)
{
    return c->hull ? c->hull->edges : DIM;
}

/* Normal of face i, or direction of line i, in space. */
static void direction(const struct two *t, int which, int i, bool line, double *to)
{
    const struct core *c = t->core[which];
    const struct polytope *p = c->hull;
    double own[DIM] = { 0 };

    for (int k = 0; k < DIM; k++)
        own[k] = !p ? k == i : line ? p->x[p->edge[i][1]][k] - p->x[p->edge[i][0]][k]
                                    : p->face[i].normal[k];
    for (int d = 0; d < DIM; d++) {
        to[d] = 0;
        for (int k = 0; k < DIM; k++)
            to[d] += t->R[which][d][k] * own[k];
    }
}

static bool parted_by_faces(const struct two *t, int which)
{
    double axis[DIM];

    for (int i = 0; i < faces_of(t->core[which]); i++) {
        direction(t, which, i, false, axis);
        if (parted(t, axis))
            return true;
    }
    return false;
}

/* Across a line of the first and one of the second; parallel ones part nothing. */
static bool parted_by_lines(const struct two *t)
{
    for (int i = 0; DIM == 3 && i < lines_of(t->core[0]); i++)
        for (int k = 0; k < lines_of(t->core[1]); k++) {
            double a[DIM], b[DIM], axis[DIM];
            direction(t, 0, i, true, a);
            direction(t, 1, k, true, b);
            for (int d = 0; d < DIM; d++)
                axis[d] = a[(d + 1) % DIM] * b[(d + 2) % DIM] - a[(d + 2) % DIM] * b[(d + 1) % DIM];
            if (parted(t, axis))
                return true;
        }
    return false;
}

bool core_overlaps(const struct core *a, const struct core *b, const double *x,
                   double (*const R)[DIM])
{
    double origin[DIM] = { 0 }, own[DIM][DIM] = { { 0 } };
    const struct two t = { { a, b }, { origin, x }, { own, (double (*)[DIM])R } };

    if (core_point(a) && core_point(b))
        return false; /* balls have no axes to part by, and points nothing in common */
    for (int d = 0; d < DIM; d++)
        own[d][d] = 1;
    return !parted_by_faces(&t, 0) && !parted_by_faces(&t, 1) && !parted_by_lines(&t);
}
