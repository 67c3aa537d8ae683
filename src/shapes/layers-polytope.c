/* layers-polytope.c -- points in layers below the faces of a convex polytope. */
#include "shapes/layers-polytope.h"

#include "base/status.h"
#include "shapes/layers.h"

#include <math.h>
#include <string.h>

#if DIM == 3

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double step(const double *a, const double *b, double *to)
{
    for (int d = 0; d < 3; d++)
        to[d] = b[d] - a[d];
    return sqrt(dot(to, to));
}

/* In n steps, without the ends. */
static int add_between(const double *a, const double *b, long n, struct points *to)
{
    double along[3], x[3];

    step(a, b, along);
    for (long i = 1; i < n; i++) {
        for (int d = 0; d < 3; d++)
            x[d] = a[d] + along[d] * (double)i / (double)n;
        TRY(points_add(to, x));
    }
    return STATUS_DONE;
}

static const double *corner(const struct polytope *p, const struct polytope_face *f, int i)
{
    return p->x[p->loop[f->first + i % f->corners]];
}

/* Rows lie along the longest edge, `along`; `across` points into the face. */
static const double *base_of(const struct polytope *p, const struct polytope_face *f,
                             double *along, double *across)
{
    double e[3], most = 0;
    int best = 0;

    for (int i = 0; i < f->corners; i++) {
        const double length = step(corner(p, f, i), corner(p, f, i + 1), e);
        if (length > most * (1 + 1e-9)) {
            most = length;
            best = i;
            memcpy(along, e, sizeof e);
        }
    }
    for (int d = 0; d < 3; d++)
        along[d] /= most;
    for (int d = 0; d < 3; d++)
        across[d] = f->normal[(d + 1) % 3] * along[(d + 2) % 3]
                  - f->normal[(d + 2) % 3] * along[(d + 1) % 3];
    return corner(p, f, best);
}

/* A row that crosses the face at the height `up`: where the strips of half a spacing end that
 * points of the border stand for. */
static void ends_of(const struct polytope *p, const struct polytope_face *f, const double *base,
                    const double *along, const double *across, double up, double dx, double end[2])
{
    double e[3];

    end[0] = HUGE_VAL;
    end[1] = -HUGE_VAL;
    for (int i = 0; i < f->corners; i++) {
        const double *a = corner(p, f, i), *b = corner(p, f, i + 1);
        step(base, a, e);
        const double from = dot(e, across), at = dot(e, along);
        step(base, b, e);
        const double rise = dot(e, across) - from, run = dot(e, along) - at;
        const double part = (up - from) / rise, strip = 0.5 * dx * hypot(rise, run) / fabs(rise);
        if (rise == 0 || part < 0 || part > 1)
            continue;
        if (rise < 0)
            end[0] = at + part * run + strip;
        else
            end[1] = at + part * run - strip;
    }
}

/* In the middle of n even parts. */
static double in_part(double from, double to, long i, long n)
{
    return from + (to - from) * ((double)i + 0.5) / (double)n;
}

static int add_face(const struct polytope *p, const struct polytope_face *f, double dx,
                    struct points *to)
{
    double along[3] = { 0 }, across[3], e[3], height = 0, end[2], x[3];
    const double *base = base_of(p, f, along, across);

    for (int i = 0; i < f->corners; i++) {
        step(base, corner(p, f, i), e);
        height = fmax(height, dot(e, across));
    }
    for (long i = 0, rows = lrint(height / dx - 1); i < rows; i++) {
        const double up = in_part(0.5 * dx, height - 0.5 * dx, i, rows);
        ends_of(p, f, base, along, across, up, dx, end);
        for (long k = 0, n = lrint(fmax(0, end[1] - end[0]) / dx); k < n; k++) {
            const double at = in_part(end[0], end[1], k, n);
            for (int d = 0; d < 3; d++)
                x[d] = base[d] + up * across[d] + at * along[d];
            TRY(points_add(to, x));
        }
    }
    return STATUS_DONE;
}

/* Corners that are nearer than half a spacing to one that is there are one with that. */
static int add_corners(const struct polytope *p, double dx, struct points *to)
{
    const long before = to->n;
    double e[3];

    for (int i = 0; i < p->corners; i++) {
        bool is_new = true;
        for (long k = before; k < to->n && is_new; k++)
            is_new = step(to->x[k], p->x[i], e) > 0.5 * dx;
        if (is_new)
            TRY(points_add(to, p->x[i]));
    }
    return STATUS_DONE;
}

/* Edges of the outermost layer have no step much longer than dx, as fluid meets them. */
static int add_layer(const struct polytope *p, double dx, bool outermost, struct points *to)
{
    double e[3];

    TRY(add_corners(p, dx, to));
    for (int i = 0; i < p->edges; i++) {
        const double *a = p->x[p->edge[i][0]], *b = p->x[p->edge[i][1]];
        const double length = step(a, b, e);
        TRY(add_between(a, b, outermost ? layers_steps(length, dx) : lrint(length / dx), to));
    }
    for (int i = 0; i < p->faces; i++)
        TRY(add_face(p, &p->face[i], dx, to));
    return STATUS_DONE;
}

/* A middle that is thinner than half a spacing is a point. */
static int add_middle(const struct polytope *p, double depth, double dx, struct points *to)
{
    struct polytope_moments m;
    double deepest;

    TRY(polytope_deepest(p, &deepest));
    polytope_moments(p, &m);
    return depth < deepest + 0.25 * dx ? points_add(to, m.centre) : STATUS_DONE;
}

int layers_polytope(const struct polytope *p, double dx, long layers, struct points *to)
{
    for (long k = 0; k < layers; k++) {
        struct polytope left;
        int code;

        TRY(polytope_shrink(p, (k + 0.5) * dx, &left));
        if (left.corners == 0)
            return add_middle(p, (k + 0.5) * dx, dx, to);
        code = add_layer(&left, dx, k == 0, to);
        polytope_free(&left);
        TRY(code);
    }
    return STATUS_DONE;
}

#endif
