/* layers-polygon.c -- rows of points inside the outline of a polygon, each at one depth.
 *
 * The row at depth d is a closed chain: every edge moved inwards by d, joined at the
 * mitre c + d (n + n')/(1 + n.n') of the corner c, n and n' being the inward normals of
 * its edges.  Where the solid goes round a sharp notch (more than `mitred`) the mitre is
 * far away and an arc of radius d about the corner takes its place.  The chain is cut at
 * angular corners, which get a point each, and the runs between them are divided
 * evenly.  Towards a tip more points stand on its bisector, where no row can follow.  A row that
 * is strict has arcs at all notches, and no more than itself.
 *
 * Chains of deep rows cross themselves and each other where the shape is thin: points
 * that are nearer to the outline than their depth says are left out, and layers-merge.c
 * makes one of two that are too near to each other. */
#include "shapes/layers-private.h"

#include "base/status.h"
#include "shapes/shape-polygon.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ARC = 10 }; /* vertices of an arc, at most */

static const double degree = M_PI / 180;
static const double angular = 40;   /* a corner that turns more gets a point [deg]     */
static const double mitred = 100;   /* a notch that turns more gets an arc [deg]       */
static const double short_of = 0.45; /* a point may miss its depth by so much [dx]     */
static const double chord = 0.02;    /* ... [its depth], where a chord stands for an arc */

struct vertex {
    double x[2]; /* [m] */
    bool angular;
};

struct rows {
    const struct param_points *outline;
    double sign;          /* 1: corners go round anticlockwise                   */
    double dx, depth;     /* spacing, depth of the row in work             [m]   */
    double length;        /* of the outline                                [m]   */
    bool strict;          /* no point nearer to the outline than its depth       */
    int vertices;
    struct vertex *chain; /* [vertices] of that row, anticlockwise               */
    int row, runs;        /* how many, or the number of the last                 */
    struct points at;     /* points of all rows so far                           */
    long room;
    struct layers_tag *tag;      /* [at.n]                                              */
};

/* Corner i of the outline, anticlockwise. */
static const double *corner(const struct rows *r, int i)
{
    const int n = r->outline->n, k = (i % n + n) % n;

    return r->outline->x[r->sign > 0 ? k : (n - k) % n];
}

/* Adds a point unless it is outside or `miss` nearer to the outline than its depth. */
static int add_point(struct rows *r, const double *x, int run, double miss)
{
    double at[3] = { x[0], x[1] };

    if (r->strict)
        miss = chord * r->depth;
    if (!shape_polygon_contains(r->outline, x)
        || shape_polygon_distance(r->outline, x) < r->depth - miss)
        return STATUS_DONE;
    if (r->at.n == r->room) {
        struct layers_tag *more = status_alloc(2 * r->room + 64, sizeof *more);

        if (!more)
            return STATUS_FAILED;
        if (r->room > 0)
            memcpy(more, r->tag, r->room * sizeof *more);
        free(r->tag);
        r->tag = more;
        r->room = 2 * r->room + 64;
    }
    r->tag[r->at.n] = (struct layers_tag){ r->row, run };
    return points_add(&r->at, at);
}

static void add_vertex(struct rows *r, double x, double y, bool is_angular)
{
    r->chain[r->vertices++] = (struct vertex){ { x, y }, is_angular };
}

static void normal_of(const double *a, const double *b, double *n)
{
    const double length = hypot(b[0] - a[0], b[1] - a[1]);

    n[0] = -(b[1] - a[1]) / length;
    n[1] = (b[0] - a[0]) / length;
}

/* Points from the mitre towards the tip c: to half a spacing before it in the first
 * row, in deeper ones as far as they are no nearer to the row before than allowed. */
static int add_tip(struct rows *r, const double *c, const double *mitre)
{
    const double far = hypot(mitre[0] - c[0], mitre[1] - c[1]), dx = r->dx;
    const bool first = r->row == 1;
    const double end = first ? 0.5 * dx : far * (r->depth - 0.4 * dx) / r->depth;
    const int n = (int)floor((far - end) / dx + (first ? 0.6 : 0.2));
    const double step = fmin(fmax((far - end) / (n * dx), 0.7), 1) * dx;

    r->runs++;
    for (int i = 1; i <= n; i++) {
        const double part = (far - i * step) / far;
        const double x[2] = { c[0] + part * (mitre[0] - c[0]), c[1] + part * (mitre[1] - c[1]) };

        TRY(add_point(r, x, r->runs, first ? r->depth : 0.5 * dx));
    }
    return STATUS_DONE;
}

static int turn_corner(struct rows *r, int i)
{
    const double *c = corner(r, i), d = r->depth;
    double n[2], m[2]; /* normals of the edges before and after */

    normal_of(corner(r, i - 1), c, n);
    normal_of(c, corner(r, i + 1), m);
    const double cosine = n[0] * m[0] + n[1] * m[1];
    const double turn = atan2(n[0] * m[1] - n[1] * m[0], cosine);

    if (turn < -(r->strict ? 0 : mitred) * degree) {
        for (int k = 0; k < ARC; k++) {
            const double a = turn * k / (ARC - 1), u = cos(a), v = sin(a);
            add_vertex(r, c[0] + d * (u * n[0] - v * n[1]), c[1] + d * (v * n[0] + u * n[1]),
                       false);
        }
        return STATUS_DONE;
    }
    /* The mitre of a needle is outside anyway: no further than the outline is long. */
    const double f = d / fmax(1 + cosine, 2 * d * d / (r->length * r->length));
    add_vertex(r, c[0] + f * (n[0] + m[0]), c[1] + f * (n[1] + m[1]),
               fabs(turn) > angular * degree);
    if (r->strict || !(turn > angular * degree))
        return STATUS_DONE;
    return add_tip(r, c, r->chain[r->vertices - 1].x);
}

static const double *vertex(const struct rows *r, int i)
{
    return r->chain[i % r->vertices].x;
}

static double length_of(const double *a, const double *b)
{
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* Points between the vertices `from` and `to`, evenly along the chain.  The fluid meets
 * the first row, so that there a step too short is better than one too long. */
static int divide_run(struct rows *r, int from, int to)
{
    double length = 0, before = 0;
    int v = from;

    for (int i = from; i < to; i++)
        length += length_of(vertex(r, i), vertex(r, i + 1));
    const long n = r->row == 1 ? layers_steps(length, r->dx) : lrint(length / r->dx);

    r->runs++;
    for (long k = 1; k < n; k++) {
        const double s = length * k / n;
        double x[2], part, step = length_of(vertex(r, v), vertex(r, v + 1));

        while (before + step < s && v + 1 < to) {
            before += step;
            v++;
            step = length_of(vertex(r, v), vertex(r, v + 1));
        }
        part = (s - before) / step;
        for (int d = 0; d < 2; d++)
            x[d] = vertex(r, v)[d] + part * (vertex(r, v + 1)[d] - vertex(r, v)[d]);
        TRY(add_point(r, x, r->runs, short_of * r->dx));
    }
    return STATUS_DONE;
}

/* From one angular vertex to the next; a chain without any starts at its first. */
static int divide_chain(struct rows *r)
{
    int first = 0, last;

    while (first < r->vertices && !r->chain[first].angular)
        first++;
    if (first == r->vertices)
        r->chain[first = 0].angular = true;
    for (int i = 0; i < r->vertices; i++)
        if (r->chain[i].angular)
            TRY(add_point(r, r->chain[i].x, 0, short_of * r->dx));
    last = first;
    for (int i = first + 1; i <= first + r->vertices; i++)
        if (r->chain[i % r->vertices].angular) {
            TRY(divide_run(r, last, i));
            last = i;
        }
    return STATUS_DONE;
}

static int add_row(struct rows *r, double depth)
{
    r->row++;
    r->depth = depth;
    r->vertices = 0;
    for (int i = 0; i < r->outline->n; i++)
        TRY(turn_corner(r, i));
    return divide_chain(r);
}

static int add_rows(struct rows *r, long layers)
{
    for (long k = 0; k < layers; k++) {
        const long before = r->at.n;

        TRY(add_row(r, (k + 0.5) * r->dx));
        if (r->at.n == before)
            break; /* deeper than the shape */
    }
    return STATUS_DONE;
}

static int start(struct rows *r, const struct param_points *outline, double dx)
{
    *r = (struct rows){ .outline = outline, .dx = dx, .sign = shape_polygon_turning(outline),
                        .length = shape_polygon_length(outline) };
    r->chain = status_alloc((unsigned long)outline->n * ARC, sizeof *r->chain);
    return r->chain ? STATUS_DONE : STATUS_FAILED;
}

/* Gives its points, made one where rows meet, unless `code` says that they are not all there. */
static int finish(struct rows *r, int code, struct points *to)
{
    if (code == STATUS_DONE)
        code = layers_merge(&r->at, r->tag, r->dx, to);
    free(r->chain);
    free(r->tag);
    points_free(&r->at);
    return code;
}

int layers_polygon(const struct shape *s, double dx, long layers, struct points *to)
{
    struct rows r;

    TRY(start(&r, &s->points, dx));
    return finish(&r, add_rows(&r, layers), to);
}

int layers_row(const struct param_points *outline, double depth, double dx, struct points *to)
{
    struct rows r;

    TRY(start(&r, outline, dx));
    r.strict = true;
    return finish(&r, add_row(&r, depth), to);
}
