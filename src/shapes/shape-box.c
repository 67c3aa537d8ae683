/* shape-box.c -- boxes that may be turned: there and back, and how far they reach.
 *
 *   x = m + R (own - m),  R = (c -s; s c) in the first two coordinates
 *
 * with m the centre, c = cos(angle), s = sin(angle).  The third coordinate, up,
 * stays as it is. */
#include "shapes/shape-box.h"

#include <math.h>
#include <string.h>

/* Cosine and sine; whole quarters are taken off first, so that those are exact. */
static void turn_of(const struct shape *s, double *cosine, double *sine)
{
    const double turns = round(s->angle / 90), rest = (s->angle - 90 * turns) * M_PI / 180;
    const int quarter = ((int)turns % 4 + 4) % 4;
    const double c = cos(rest), n = sin(rest);
    const double to[4][2] = { { c, n }, { -n, c }, { -c, -n }, { n, -c } };

    *cosine = to[quarter][0];
    *sine = to[quarter][1];
}

static double middle(const struct shape *s, int d)
{
    return 0.5 * (s->from[d] + s->to[d]);
}

static void turn(const struct shape *s, double cosine, double sine, const double *x, double *to)
{
    const double a = x[0] - middle(s, 0), b = x[1] - middle(s, 1);

    memmove(to, x, DIM * sizeof *to);
    if (cosine == 1) /* not even rounding */
        return;
    to[0] = middle(s, 0) + (cosine * a - sine * b);
    to[1] = middle(s, 1) + (sine * a + cosine * b);
}

void shape_box_own(const struct shape *s, const double *x, double *own)
{
    double cosine, sine;

    turn_of(s, &cosine, &sine);
    turn(s, cosine, -sine, x, own);
}

void shape_box_place(const struct shape *s, const double *own, double *x)
{
    double cosine, sine;

    turn_of(s, &cosine, &sine);
    turn(s, cosine, sine, own, x);
}

void shape_box_bounds(const struct shape *s, double *low, double *high)
{
    const double a = 0.5 * (s->to[0] - s->from[0]), b = 0.5 * (s->to[1] - s->from[1]);
    double cosine, sine;

    memcpy(low, s->from, DIM * sizeof *low);
    memcpy(high, s->to, DIM * sizeof *high);
    turn_of(s, &cosine, &sine);
    if (cosine == 1)
        return;
    const double reach[2] = { fabs(cosine) * a + fabs(sine) * b,
                              fabs(sine) * a + fabs(cosine) * b };
    for (int d = 0; d < 2; d++) {
        low[d] = middle(s, d) - reach[d];
        high[d] = middle(s, d) + reach[d];
    }
}
