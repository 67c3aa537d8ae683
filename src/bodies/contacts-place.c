/* contacts-place.c -- where two solids touch, and what pushes them there.
 *
 * Distances are those of cores, so a normal never jumps as long as cores stay apart:
 *   d = r_A + r_B - |p - P_B(p)|,  n = (p - P_B)/|p - P_B|                          (CT1)
 * with p a corner of A's core and P_B the nearest point of B's. */
#include "bodies/contacts-place.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

static double dot(const double *a, const double *b)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

void contacts_guest_make(struct contacts_guest *g, const struct solid *guest,
                         const struct solid_place *guest_at, const struct solid *partner,
                         const struct solid_place *partner_at, const double *apart)
{
    double column[DIM], turned[DIM], v[DIM];

    *g = (struct contacts_guest){ .guest = guest, .partner = partner, .partner_at = partner_at };
    memcpy(g->in.spin, guest_at->spin, sizeof g->in.spin);
    g->touching = guest->core.ball + partner->core.ball + fmax(guest->film, partner->film);
    solid_own(partner_at, apart, g->in.x);
    solid_own(partner_at, partner_at->v, g->base);
    for (int d = 0; d < DIM; d++)
        v[d] = guest_at->v[d] - partner_at->v[d];
    solid_own(partner_at, v, g->in.v);
    for (int k = 0; k < DIM; k++) {
        for (int d = 0; d < DIM; d++)
            column[d] = guest_at->R[d][k];
        solid_own(partner_at, column, turned);
        for (int d = 0; d < DIM; d++)
            g->in.R[d][k] = turned[d];
    }
}

static void set_spot(const struct contacts_guest *g, const double *from, const double *to,
                     double share, struct contacts_spot *s)
{
    double step[DIM], length;

    for (int d = 0; d < DIM; d++)
        step[d] = to[d] - from[d];
    length = sqrt(dot(step, step));
    s->share = share;
    s->carried = 1;
    s->depth = g->touching - length;
    for (int d = 0; d < DIM && length > 0; d++) {
        s->normal[d] = step[d] / length;
        s->point[d] = to[d] - s->normal[d] * g->guest->core.ball;
    }
}

void contacts_guest_place(const struct contacts_guest *g, const double *own, double *to)
{
    solid_space(&g->in, own, to);
    for (int d = 0; d < DIM; d++)
        to[d] += g->in.x[d];
}

int contacts_corner(const struct contacts_guest *g, int i, struct contacts_spot *to)
{
    double own[DIM], at[DIM], nearest[DIM];

    core_corner(&g->guest->core, i, own);
    contacts_guest_place(g, own, at);
    core_nearest(&g->partner->core, at, nearest);
    set_spot(g, nearest, at, 1, to);
    return memcmp(nearest, at, sizeof at) != 0 ? STATUS_DONE : STATUS_FAILED;
}

static double smooth(double x)
{
    const double c = fmin(1, fmax(0, x));

    return c * c * (3 - 2 * c);
}

/* Where it is along an edge of that length, from the nearer end, in 2 balls. */
static double from_end(const struct contacts_guest *g, double s, double length)
{
    return fmin(s, 1 - s) * length / (g->guest->core.ball + g->partner->core.ball);
}

void contacts_edges(const struct contacts_guest *g, int i, int k, struct contacts_spot *to)
{
    double e[2][DIM], f[2][DIM], own[2][DIM], along_e[DIM], along_f[DIM], step[DIM];

    *to = (struct contacts_spot){ .depth = -1 };
    core_edge(&g->guest->core, i, own[0], own[1]);
    core_edge(&g->partner->core, k, f[0], f[1]);
    contacts_guest_place(g, own[0], e[0]);
    contacts_guest_place(g, own[1], e[1]);
    for (int d = 0; d < DIM; d++) {
        along_e[d] = e[1][d] - e[0][d];
        along_f[d] = f[1][d] - f[0][d];
        step[d] = e[0][d] - f[0][d];
    }
    const double ee = dot(along_e, along_e), ff = dot(along_f, along_f);
    const double ef = dot(along_e, along_f), across = ee * ff - ef * ef;
    const double es = dot(along_e, step), fs = dot(along_f, step);
    const double s = (ef * fs - ff * es) / across, t = (ee * fs - ef * es) / across;
    if (!(across > 1e-12 * ee * ff && s > 0 && s < 1 && t > 0 && t < 1))
        return;
    for (int d = 0; d < DIM; d++) {
        e[0][d] += s * along_e[d];
        f[0][d] += t * along_f[d];
    }
    set_spot(g, f[0], e[0], across / (ee * ff) * smooth(from_end(g, s, sqrt(ee)))
                                * smooth(from_end(g, t, sqrt(ff))), to);
}

void contacts_spot_levers(const struct contacts_guest *g, const struct contacts_spot *s,
                          double *guest, double *partner)
{
    double step[DIM], arm[DIM], normal[DIM];

    for (int d = 0; d < DIM; d++)
        step[d] = s->point[d] - g->in.x[d];
    solid_own(&g->in, step, arm);
    solid_own(&g->in, s->normal, normal);
    memset(guest, 0, TURNING_SPINS * sizeof *guest);
    memset(partner, 0, TURNING_SPINS * sizeof *partner);
    turning_moment(arm, normal, guest);
    turning_moment(s->point, s->normal, partner);
}

/* What of 1/m_c is a solid's. */
static double yields(const struct solid *s, const double *lever)
{
    double sum = 1 / s->mass;

    for (int k = 0; k < TURNING_SPINS; k++)
        sum += lever[k] * lever[k] / s->inertia[k];
    return sum;
}

/* The guest's arm in its own frame; how fast the partner's surface moves [m/s]. */
static void fill_place(const struct contacts_guest *g, const struct contacts_spot *s,
                       struct touch_place *at, double *arm, double *surface)
{
    double step[DIM], own[DIM], turned[DIM], of_guest[TURNING_SPINS], of_partner[TURNING_SPINS];

    for (int d = 0; d < DIM; d++)
        step[d] = s->point[d] - g->in.x[d];
    solid_own(&g->in, step, arm);
    contacts_spot_levers(g, s, of_guest, of_partner);
    turning_velocity(g->in.spin, arm, own);
    solid_space(&g->in, own, turned);
    turning_velocity(g->partner_at->spin, s->point, surface);
    memcpy(at->normal, s->normal, sizeof at->normal);
    for (int d = 0; d < DIM; d++) {
        at->velocity[d] = g->in.v[d] + turned[d] - surface[d];
        surface[d] += g->base[d];
    }
    at->depth = s->depth;
    at->rate = -dot(at->velocity, at->normal);
    at->mass = 1 / (yields(g->guest, of_guest) + yields(g->partner, of_partner));
    at->carried = s->carried * at->mass;
}

double contacts_spot_closing(const struct contacts_guest *g, const struct contacts_spot *s)
{
    double arm[DIM], surface[DIM];
    struct touch_place at;

    fill_place(g, s, &at, arm, surface);
    return at.rate;
}

/* force [DIM] in the frame of the partner. */
static void add(const struct contacts_guest *g, const double *point, const double *arm,
                const double *force, struct body_push *on_guest, struct body_push *on_partner)
{
    double space[DIM], own[DIM], back[DIM];

    solid_space(g->partner_at, force, space);
    solid_own(&g->in, force, own);
    for (int d = 0; d < DIM; d++) {
        back[d] = -force[d];
        on_guest->force[d] += space[d];
        on_partner->force[d] -= space[d];
        on_guest->by_walls[d] += isinf(g->partner->mass) ? space[d] : 0;
        on_partner->by_walls[d] -= isinf(g->guest->mass) ? space[d] : 0;
    }
    turning_moment(arm, own, on_guest->moment);
    turning_moment(point, back, on_partner->moment);
}

/* What it gives to those of both that are bodies. */
static double given(const struct contacts_guest *g, const double *force, const double *apart,
                    const double *surface)
{
    double power = 0;

    for (int d = 0; d < DIM; d++) {
        const double of_guest = isinf(g->guest->mass) ? 0 : apart[d] + surface[d];
        power += force[d] * (of_guest - (isinf(g->partner->mass) ? 0 : surface[d]));
    }
    return power;
}

void contacts_guest_press(const struct contacts_guest *g, const double *own, const double *force,
                          struct body_push *on_guest, struct body_push *on_partner,
                          double *power)
{
    double point[DIM], turned[DIM], velocity[DIM], apart[DIM], surface[DIM];

    contacts_guest_place(g, own, point);
    turning_velocity(g->in.spin, own, velocity);
    solid_space(&g->in, velocity, apart);
    turning_velocity(g->partner_at->spin, point, surface);
    solid_space(&g->in, force, turned);
    for (int d = 0; d < DIM; d++) {
        apart[d] += g->in.v[d] - surface[d];
        surface[d] += g->base[d];
    }
    *power += given(g, turned, apart, surface);
    add(g, point, own, turned, on_guest, on_partner);
}

void contacts_spot_push(const struct contacts_guest *g, const struct touch_law *law,
                        const struct contacts_spot *s, const double *xi, double *xi_rate,
                        struct body_push *on_guest, struct body_push *on_partner,
                        double power[2])
{
    double press[DIM], rub[DIM], arm[DIM], surface[DIM];
    struct touch_place at;

    if (!(s->depth > 0 && s->share > 0)) {
        touch_forget(xi, xi_rate);
        return;
    }
    fill_place(g, s, &at, arm, surface);
    touch(law, &at, xi, press, rub, xi_rate);
    for (int d = 0; d < DIM; d++) {
        press[d] *= s->share;
        rub[d] *= s->share;
    }
    power[0] += given(g, press, at.velocity, surface);
    power[1] += given(g, rub, at.velocity, surface);
    for (int d = 0; d < DIM; d++)
        press[d] += rub[d];
    add(g, s->point, arm, press, on_guest, on_partner);
}

double contacts_place_speed(const double *v)
{
    double square = 0;

    for (int d = 0; d < DIM; d++)
        square += v[d] * v[d];
    return sqrt(square);
}
