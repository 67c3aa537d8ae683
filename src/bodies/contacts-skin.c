/* contacts-skin.c -- the skin of a beam that touches a solid. */
#include "bodies/contacts-skin.h"

#include "base/status.h"
#include "bodies/contacts-place.h"
#include "state/period.h"

#include <math.h>
#include <string.h>

/* The law is that of the whole beam; what shakes fastest is one point. */
void contacts_skin_make(struct contacts_skin *p, const struct contacts_body *body,
                        const struct body_surface *surface, const struct solid *solid,
                        const struct contacts_rub *rub, const struct scales *s)
{
    const double weight = body->kind->weight(body->body);
    const double mass = 1 / (1 / weight + 1 / solid->mass), ball = 0.5 * s->dx;

    p->solid = solid;
    p->points = body->points;
    p->point = solid_ball(ball, weight / body->points);
    p->depth = touch_softness(s->speed, s->c0) * 2 * ball;
    p->law = touch_law(mass, s->speed, p->depth,
                       touch_mixed(rub->restitution, surface->restitution, solid->restitution),
                       touch_mixed(rub->friction, surface->friction, solid->friction));
    p->slow = touch_rate(s->speed, touch_softest * 2 * ball);
    p->rate = touch_rate(s->speed, p->depth) * sqrt(2 * mass / p->point.mass);
}

/* Point j, in the frame of the solid; false: it is more than `gap` away. */
static bool near(const struct contacts_skin *p, const struct scales *s,
                 const struct contacts_body *body, int j, const struct solid_place *at, double gap,
                 struct solid_place *place, struct contacts_guest *g)
{
    const double reach = p->solid->flat ? HUGE_VAL
                                        : core_reach(&p->solid->core) + p->point.core.ball + gap;
    double apart[DIM], square = 0;

    for (int d = 0; d < DIM; d++) {
        apart[d] = period_nearest(s, d, body->x[j][d] - at->x[d]);
        square += apart[d] * apart[d];
        place->x[d] = body->x[j][d];
        place->v[d] = body->u[j][d];
    }
    if (square >= reach * reach)
        return false;
    contacts_guest_make(g, &p->point, place, p->solid, at, apart);
    return true;
}

/* Both forces act at the point itself: a ball in the skin does not turn. */
static int touch_at(const struct contacts_guest *g, struct contacts_spot *spot)
{
    TRY(contacts_corner(g, 0, spot));
    memcpy(spot->point, g->in.x, sizeof spot->point);
    return STATUS_DONE;
}

/* What a wall holds may turn into it. */
static bool is_held(const struct contacts_skin *p, const struct contacts_body *body, int j)
{
    const struct body_watch *watch = body->kind->watch;

    return isinf(p->solid->mass) && watch && watch->held && watch->held(body->body, j);
}

int contacts_skin_meet(const struct contacts_skin *p, const struct scales *s,
                       struct contacts_body *body, const struct solid_place *at, const double *xi,
                       double *xi_rate, struct body_push *on_solid, double power[2])
{
    struct solid_place place = { .R = { { 1 } } };

    for (int d = 0; d < DIM; d++)
        place.R[d][d] = 1;
    for (int j = 0; j < p->points; j++) {
        struct body_push on_point = { .force = { 0 } };
        struct contacts_guest g;
        struct contacts_spot spot;
        if (is_held(p, body, j) || !near(p, s, body, j, at, 0, &place, &g)) {
            touch_forget(xi + j * DIM, xi_rate + j * DIM);
            continue;
        }
        TRY(touch_at(&g, &spot));
        contacts_spot_push(&g, &p->law, &spot, xi + j * DIM, xi_rate + j * DIM, &on_point,
                           on_solid, power);
        for (int d = 0; d < DIM; d++) {
            body->force[j][d] += on_point.force[d];
            body->push.by_walls[d] += on_point.by_walls[d];
        }
    }
    return STATUS_DONE;
}

double contacts_skin_rate(const struct contacts_skin *p, const struct scales *s,
                          const struct contacts_body *body, const struct solid_place *at)
{
    struct solid_place place = { .R = { { 1 } } };
    double rate = 0;

    for (int d = 0; d < DIM; d++)
        place.R[d][d] = 1;
    for (int j = 0; j < p->points; j++) {
        const double gap = touch_window(p->slow, contacts_place_speed(body->u[j]) + contacts_place_speed(at->v));
        struct contacts_guest g;
        struct contacts_spot spot;
        if (is_held(p, body, j) || !near(p, s, body, j, at, gap, &place, &g)
            || touch_at(&g, &spot) != STATUS_DONE || !(spot.depth > -gap))
            continue;
        rate = fmax(rate, fmax(p->rate, touch_coming(spot.depth, contacts_spot_closing(&g, &spot),
                                                     p->depth)));
    }
    return rate;
}
