/* shape-box.c -- boxes that may be turned: there and back, and how far they reach.
 *
 *   x = m + R (own - m),  R v = v_k + cos(angle) (v - v_k) + sin(angle) k x v
 *
 * with m the centre, k the axis and v_k = (v . k) k (Rodrigues; Goldstein, Classical
 * Mechanics, 1980, 4-7).  A coordinate along the axis itself stays as it is. */
#include "shapes/shape-box.h"

#include "base/status.h"
#include "shapes/shape-kind.h"
#include <math.h>
#include <string.h>

/* How a box is turned: once for many places. */
struct turn {
    double axis[3], cosine, sine;
};

/* Cosine and sine; whole quarters are taken off first, so that those are exact. */
static struct turn turn_of(const struct shape *s)
{
    const double turns = round(s->angle / 90), rest = (s->angle - 90 * turns) * M_PI / 180;
    const int quarter = ((int)turns % 4 + 4) % 4;
    const double c = cos(rest), n = sin(rest);
    const double to[4][2] = { { c, n }, { -n, c }, { -c, -n }, { n, -c } };
    struct turn t = { .cosine = to[quarter][0], .sine = to[quarter][1] };

    shape_axis(s, t.axis);
    return t;
}

static double middle(const struct shape *s, int d)
{
    return 0.5 * (s->from[d] + s->to[d]);
}

/* Component d of R v. */
static double turned(const struct turn *t, const double *v, int d)
{
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    const double *k = t->axis, along = k[d] * (v[0] * k[0] + v[1] * k[1] + v[2] * k[2]);

    return along + (t->cosine * (v[d] - along) + t->sine * (k[e] * v[f] - k[f] * v[e]));
}

static void turn(const struct shape *s, const struct turn *t, const double *x, double *to)
{
    double v[3] = { 0 };

    for (int d = 0; d < DIM; d++)
        v[d] = x[d] - middle(s, d);
    memmove(to, x, DIM * sizeof *to);
    for (int d = 0; d < DIM && t->cosine != 1; d++) /* else not even rounding */
        if (fabs(t->axis[d]) != 1)
            to[d] = middle(s, d) + turned(t, v, d);
}

void shape_box_own(const struct shape *s, const double *x, double *own)
{
    struct turn back = turn_of(s);

    back.sine = -back.sine;
    turn(s, &back, x, own);
}

void shape_box_place(const struct shape *s, const double *own, double *x)
{
    const struct turn t = turn_of(s);

    turn(s, &t, own, x);
}

static void bounds(const struct shape *s, double *low, double *high)
{
    const struct turn t = turn_of(s);

    memcpy(low, s->from, DIM * sizeof *low);
    memcpy(high, s->to, DIM * sizeof *high);
    for (int d = 0; d < DIM && t.cosine != 1; d++) {
        double reach = 0;

        for (int e = 0; e < DIM; e++) {
            const double unit[3] = { e == 0, e == 1, e == 2 };
            reach += fabs(turned(&t, unit, d)) * (0.5 * (s->to[e] - s->from[e]));
        }
        if (fabs(t.axis[d]) != 1) {
            low[d] = middle(s, d) - reach;
            high[d] = middle(s, d) + reach;
        }
    }
}

static int check(struct shape *s, const char *path, const char *where)
{
    if (!shape_is_place(s->from) || !shape_is_place(s->to))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a box needs from and to, its lowest and"
                           " highest corner", where, path);
    for (int d = 0; d < DIM; d++)
        if (!(s->from[d] < s->to[d]))
            return status_fail(STATUS_BAD_SCENE, "%s: %s: to must lie beyond from in every"
                               " direction, but along %c from is %g m and to is %g m", where,
                               path, "xyz"[d], s->from[d], s->to[d]);
    return shape_check_axis(s, path, where);
}

static bool contains(const struct shape *s, const double *x)
{
    double own[DIM];

    shape_box_own(s, x, own);
    return shape_between(s->from, s->to, own);
}

static double depth(const struct shape *s, const double *x)
{
    double own[DIM];

    shape_box_own(s, x, own);
    return shape_to_faces(s->from, s->to, own);
}

static double side(const struct shape *s, int d)
{
    return s->to[d] - s->from[d];
}

static double volume(const struct shape *s)
{
    double product = 1;

    for (int d = 0; d < DIM; d++)
        product *= side(s, d);
    return product;
}

static struct shape_rows rows(const struct shape *s, int d, double dx)
{
    return shape_rows_spread(s->from[d], s->to[d], dx);
}

const struct shape_kind shape_box = {
    .name = "box", .keys = DIM == 2 ? " from to angle " : " from to angle axis ", .check = check, .contains = contains,
    .depth = depth, .bounds = bounds, .volume = volume, .rows = rows, .place = shape_box_place,
    .own = shape_box_own, .side = side,
};
