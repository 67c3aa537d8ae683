/* control.c -- step-size control. */
#include "time/control.h"

#include "time/method.h"
#include <math.h>
#include <string.h>

static const double least_error = 1e-8; /* no error counts as smaller: 0 has no logarithm */

void control_start(struct control *c, const struct control_row *row, int order, int embedded,
                   const struct method_pace *pace)
{
    *c = (struct control){ .row = row, .k = (order < embedded ? order : embedded) + 1,
                           .before = { 1, 1 } };
    if (pace && pace->h > 0)
        memcpy(c->before, pace->error, sizeof c->before);
}

struct method_pace control_pace(const struct control *c, double h)
{
    return (struct method_pace){ .h = h, .error = { c->before[0], c->before[1] } };
}

/* A rejected step is repeated with the length that its own error asks for: the
 * filter above would hardly shorten it. */
static double shorter(const struct control *c, double h, double e)
{
    const double f = 0.9 * pow(e / c->row->aim, -1.0 / c->k);

    return h * fmin(fmax(f, 0.2), 0.9); /* not finite: 0.2 */
}

double control_next(struct control *c, double h, double e)
{
    const double *b = c->row->b, scaled = fmax(e / c->row->aim, least_error);
    double f;

    if (!(e <= c->row->accept))
        return shorter(c, h, e);
    f = pow(scaled, -b[0] / c->k) * pow(c->before[0], -b[1] / c->k)
      * pow(c->before[1], -b[2] / c->k);
    c->before[1] = c->before[0];
    c->before[0] = scaled;
    return h * fmin(1 + atan(f - 1), c->row->growth);
}
