/* contacts-beams.c -- the skins of two beams that touch.
 *
 * Both are told to each other, as points and as an axis, each time with half of the force.  A push
 * on the axis goes to the two rows of points beside it, and its velocity is theirs, with the same
 * weights: momentum and power are kept to rounding.  xi is kept in the frame of space. */
#include "bodies/contacts-beams.h"

#include "base/status.h"
#include "bodies/contacts-place.h"
#include "state/period.h"

#include <math.h>
#include <string.h>

static const double half = 0.5; /* of the force, each way */

void contacts_beams_make(struct contacts_beams *p, const struct contacts_body *body,
                         const struct contacts_body *other, const struct contacts_rub *rub,
                         const struct scales *s)
{
    const struct body_surface *a = body->kind->watch->surface(body->body);
    const struct body_surface *b = other->kind->watch->surface(other->body);
    const double weight[2] = { body->kind->weight(body->body), other->kind->weight(other->body) };
    const double mass = 1 / (1 / weight[0] + 1 / weight[1]), ball = 0.5 * s->dx;

    p->points = body->points;
    p->across = b->across;
    p->rows = other->points / b->across;
    p->trim = fmin(0.5 * (p->across - 1), 0.5 * (p->rows - 1));
    p->point = solid_ball(ball, weight[0] / body->points);
    p->line = solid_ball(ball * p->across, weight[1] / p->rows);
    p->depth = touch_softness(s->speed, s->c0) * 2 * ball;
    p->law = touch_law(mass, s->speed, p->depth, touch_mixed(rub->restitution, a->restitution, b->restitution),
                       touch_mixed(rub->friction, a->friction, b->friction));
    p->slow = touch_rate(s->speed, touch_softest * 2 * ball);
    p->rate = touch_rate(s->speed, p->depth) * sqrt(2 * mass / fmin(p->point.mass, p->line.mass));
}

/* The place of an axis that is nearest to a point: a share `part` of the way from a row on. */
struct foot {
    int row;
    double part, square; /* [1]; how far away [m^2]  */
    double apart[DIM];   /* from there to the point [m] */
};

/* The axis in row i lies between the outermost points of that. */
static void axis(const struct contacts_beams *p, const struct contacts_body *b, int i, double *x)
{
    const double *low = b->x[i * p->across], *high = b->x[(i + 1) * p->across - 1];

    for (int d = 0; d < DIM; d++)
        x[d] = 0.5 * (low[d] + high[d]);
}

static void look_at(const struct contacts_beams *p, const struct scales *s,
                    const struct contacts_body *b, const double *x, int row, struct foot *best)
{
    const double low = fmax(0, p->trim - row), high = fmin(1, p->rows - 1 - p->trim - row);
    double a[DIM], c[DIM], to[DIM], along[DIM], dot = 0, length = 0, square = 0, part;

    axis(p, b, row, a);
    axis(p, b, row + 1, c);
    for (int d = 0; d < DIM; d++) {
        along[d] = period_nearest(s, d, c[d] - a[d]);
        to[d] = period_nearest(s, d, x[d] - a[d]);
        dot += to[d] * along[d];
        length += along[d] * along[d];
    }
    part = fmin(fmax(length > 0 ? dot / length : 0, low), high);
    for (int d = 0; d < DIM; d++) {
        to[d] -= part * along[d];
        square += to[d] * to[d];
    }
    if (!(square < best->square))
        return;
    *best = (struct foot){ .row = row, .part = part, .square = square };
    memcpy(best->apart, to, sizeof to);
}

static struct foot find(const struct contacts_beams *p, const struct scales *s,
                        const struct contacts_body *b, const double *x)
{
    const int first = (int)p->trim, last = p->rows - 2 - first;
    struct foot best = { .square = HUGE_VAL };

    for (int row = first; row <= last; row++)
        look_at(p, s, b, x, row, &best);
    return best;
}

/* The box around the skin of b; nothing outside of it by more than `gap` is near.  Where a
 * direction repeats it tells nothing. */
static void bounds(const struct contacts_body *b, double gap, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = HUGE_VAL;
        high[d] = -HUGE_VAL;
        for (int i = 0; i < b->points; i++) {
            low[d] = fmin(low[d], b->x[i][d] - gap);
            high[d] = fmax(high[d], b->x[i][d] + gap);
        }
    }
}

static bool outside(const struct scales *s, const double *x, const double *low, const double *high)
{
    for (int d = 0; d < DIM; d++)
        if (!(s->period[d] > 0) && !(low[d] <= x[d] && x[d] <= high[d]))
            return true;
    return false;
}

/* Is point x nearer to the axis than `reach`? */
static bool is_near(const struct contacts_beams *p, const struct scales *s,
                    const struct contacts_body *b, const double *x, const double box[2][DIM],
                    double reach, struct foot *f)
{
    if (outside(s, x, box[0], box[1]))
        return false;
    *f = find(p, s, b, x);
    return f->square < reach * reach;
}

/* Of the axis at a foot; as forces go back by. */
static double weight(const struct contacts_beams *p, const struct foot *f, int i)
{
    return (i < p->across ? 1 - f->part : f->part) / p->across;
}

/* Point j at the axis; what is kept of the way from one to the other stands in *g, which lends
 * the two places. */
static void make_guest(const struct contacts_beams *p, const struct contacts_body *body,
                       const struct contacts_body *other, int j, const struct foot *f,
                       struct solid_place at[2], struct contacts_guest *g)
{
    const int first = f->row * p->across;

    memset(at, 0, 2 * sizeof *at);
    for (int d = 0; d < DIM; d++) {
        at[0].R[d][d] = at[1].R[d][d] = 1;
        at[0].x[d] = body->x[j][d];
        at[0].v[d] = body->u[j][d];
        at[1].x[d] = body->x[j][d] - f->apart[d];
        for (int i = 0; i < 2 * p->across; i++)
            at[1].v[d] += weight(p, f, i) * other->u[first + i][d];
    }
    contacts_guest_make(g, &p->point, &at[0], &p->line, &at[1], f->apart);
}

/* Forces act at the point, as on skins at solids.  A point that has come as far as the axis is
 * beyond all contact. */
static int touch_at(const struct contacts_beams *p, const struct contacts_guest *g,
                    struct contacts_spot *spot)
{
    TRY(contacts_corner(g, 0, spot));
    memcpy(spot->point, g->in.x, sizeof spot->point);
    spot->share = half;
    return spot->depth < p->line.core.ball ? STATUS_DONE : STATUS_FAILED;
}

int contacts_beams_meet(const struct contacts_beams *p, const struct scales *s,
                        struct contacts_body *body, struct contacts_body *other, const double *xi,
                        double *xi_rate, double power[2])
{
    const double reach = p->point.core.ball + p->line.core.ball;
    double box[2][DIM];

    bounds(other, reach, box[0], box[1]);
    for (int j = 0; j < p->points; j++) {
        struct body_push on_point = { .force = { 0 } }, on_line = { .force = { 0 } };
        struct solid_place at[2];
        struct contacts_guest g;
        struct contacts_spot spot;
        struct foot f;
        if (!is_near(p, s, other, body->x[j], (const double (*)[DIM])box, reach, &f))
            continue;
        make_guest(p, body, other, j, &f, at, &g);
        TRY(touch_at(p, &g, &spot));
        contacts_spot_push(&g, &p->law, &spot, xi + j * DIM, xi_rate + j * DIM, &on_point, &on_line,
                           power);
        for (int d = 0; d < DIM; d++) {
            body->force[j][d] += on_point.force[d];
            for (int i = 0; i < 2 * p->across; i++)
                other->force[f.row * p->across + i][d] += weight(p, &f, i) * on_line.force[d];
        }
    }
    return STATUS_DONE;
}

static double fastest(const struct contacts_body *b)
{
    double speed = 0;

    for (int i = 0; i < b->points; i++)
        speed = fmax(speed, contacts_place_speed(b->u[i]));
    return speed;
}

double contacts_beams_rate(const struct contacts_beams *p, const struct scales *s,
                           const struct contacts_body *body, const struct contacts_body *other)
{
    const double gap = touch_window(p->slow, fastest(body) + fastest(other));
    const double reach = p->point.core.ball + p->line.core.ball + gap;
    double box[2][DIM], rate = 0;

    bounds(other, reach, box[0], box[1]);
    for (int j = 0; j < p->points; j++) {
        struct solid_place at[2];
        struct contacts_guest g;
        struct contacts_spot spot;
        struct foot f;
        if (!is_near(p, s, other, body->x[j], (const double (*)[DIM])box, reach, &f))
            continue;
        make_guest(p, body, other, j, &f, at, &g);
        if (touch_at(p, &g, &spot) != STATUS_DONE)
            continue;
        rate = fmax(rate, fmax(p->rate, touch_coming(spot.depth, contacts_spot_closing(&g, &spot), p->depth)));
    }
    return rate;
}
