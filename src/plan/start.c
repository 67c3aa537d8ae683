/* start.c -- y at t = 0: lattice at rest under its own weight. */
#include "plan/inside.h"

#include "matter/eos.h"
#include "plan/disturb.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

/* Depth pressure [Pa] at x under the surface of fluid number f. */
static double depth_pressure(const struct plan *p, int f, const double *x)
{
    const struct settings_fluid *s = &p->in.fluid[f].set;
    double low[DIM], high[DIM], pressure = 0;

    shape_bounds(&s->shape, low, high);
    for (int d = 0; d < DIM; d++) {
        const double g = p->scales.period[d] > 0 ? 0 : p->scales.g[d];
        double top = g < 0 ? high[d] : low[d];
        if (d == DIM - 1 && !isnan(s->surface))
            top = s->surface;
        pressure += p->scales.rho0 * g * (x[d] - top);
    }
    return pressure > 0 ? pressure : 0;
}

/* Pressure [Pa] that fluid number f starts with at x. */
static double start_pressure(const struct plan *p, int f, const double *x)
{
    const struct input_fluid *in = &p->in.fluid[f];
    const struct flow_kind *flow = flow_find(&in->flow);
    const bool weight = strcmp(in->set.initial, "rest") != 0;

    return (weight ? depth_pressure(p, f, x) : 0)
           + (flow && flow->pressure ? flow->pressure(&in->flow, x) : 0);
}

static const struct eos *eos_of(const struct plan *p)
{
    return p->pressure ? p->pressure->self : NULL;
}

/* Is x within the support of the box that holds fluid number f? */
static bool near_fluid(const struct plan *p, int f, const double *x)
{
    double low[DIM], high[DIM];

    shape_bounds(&p->in.fluid[f].set.shape, low, high);
    for (int d = 0; d < DIM; d++)
        if (x[d] < low[d] - p->scales.support || x[d] > high[d] + p->scales.support)
            return false;
    return true;
}

static void start_fluid(const struct plan *p, double *rho)
{
    const struct particles *all = p->particles;

    for (int o = 0, f = 0; o < all->objects; o++) {
        const struct object *ob = &all->object[o];
        if (ob->kind != KIND_FLUID)
            continue;
        for (int i = ob->from; i < ob->from + ob->n; i++)
            if (eos_of(p))
                rho[i] = eos_density(eos_of(p), start_pressure(p, f, all->x0[i]));
        f++;
    }
}

/* Solids beside fluid start with the pressure that it has there. */
double plan_start_pressure(const struct plan *p, const double *x)
{
    double pressure = 0;

    for (int f = 0; f < p->in.fluids; f++)
        if (near_fluid(p, f, x))
            pressure = fmax(pressure, start_pressure(p, f, x));
    return pressure;
}

static void start_solids(const struct plan *p, int k, double *rho)
{
    const struct particles *all = p->particles;

    for (int i = 0; i < particles_count(all, k); i++)
        if (eos_of(p))
            rho[i] = eos_density(eos_of(p), plan_start_pressure(p, all->x0[all->from[k] + i]));
}

void plan_start_press(const struct plan *p, double *y)
{
    const struct plan_part *wall = p->passes.press;

    for (int k = KIND_WALL; k < KINDS && wall; k++)
        if (p->row.density[k] >= 0)
            wall->part->as.wall->press->start(wall->self, p->particles, (enum kind)k,
                                              y + layout_at(&p->layout, p->row.density[k]));
}

void plan_start_density(const struct plan *p, double *y)
{
    for (int k = 0; k < KINDS; k++) {
        double *rho;
        if (p->row.density[k] < 0)
            continue;
        rho = y + layout_at(&p->layout, p->row.density[k]);
        for (int i = 0; i < particles_count(p->particles, k); i++)
            rho[i] = p->scales.rho0;
        if (k == KIND_FLUID)
            start_fluid(p, rho);
        else if (!p->in.walls->as.wall->only)
            start_solids(p, k, rho);
    }
    plan_start_press(p, y);
}

static void start_velocity(const struct input_fluid *in, const double *x, double *u)
{
    const struct flow_kind *flow = flow_find(&in->flow);

    memcpy(u, in->set.velocity, DIM * sizeof *u);
    if (flow)
        flow->velocity(&in->flow, x, u);
}

static void start_motion(const struct plan *p, double *y)
{
    const struct particles *all = p->particles;
    double *x = y + layout_at(&p->layout, p->row.x), *u = y + layout_at(&p->layout, p->row.u);

    for (int o = 0, f = 0; o < all->objects; o++) {
        const struct object *ob = &all->object[o];
        if (ob->kind != KIND_FLUID)
            continue;
        for (int i = ob->from; i < ob->from + ob->n; i++) {
            memcpy(x + (size_t)i * DIM, all->x0[i], DIM * sizeof *x);
            start_velocity(&p->in.fluid[f], all->x0[i], u + (size_t)i * DIM);
        }
        f++;
    }
    disturb_positions(&p->in.disturbance, p->scales.dx, x, particles_count(all, KIND_FLUID));
}

/* Of the fluid at t = 0, the largest [m/s]. */
static double start_speed(const struct plan *p)
{
    const struct particles *all = p->particles;
    double most = 0;

    for (int o = 0, f = 0; o < all->objects; o++) {
        const struct object *ob = &all->object[o];
        if (ob->kind != KIND_FLUID)
            continue;
        for (int i = ob->from; i < ob->from + ob->n; i++) {
            double u[DIM], u2 = 0;
            start_velocity(&p->in.fluid[f], all->x0[i], u);
            for (int d = 0; d < DIM; d++)
                u2 += u[d] * u[d];
            most = fmax(most, sqrt(u2));
        }
        f++;
    }
    return most;
}

void plan_start(const struct plan *p, double *y)
{
    memset(y, 0, (size_t)layout_size(&p->layout) * sizeof *y);
    if (p->row.x >= 0)
        start_motion(p, y);
    plan_start_density(p, y);
    for (int i = 0; i < p->bodies; i++)
        p->body[i].kind->start(p->body[i].body, &p->layout, y);
    if (p->contacts.kind && p->contacts.kind->start)
        p->contacts.kind->start(p->contacts.self, &p->layout, y);
}

/* Twice the energy of the fluid's own fall through the domain, by its mass [m^2/s^2]. */
static double fall(const struct plan *p)
{
    double fall2 = 0;

    for (int i = 0; i < p->in.fluids; i++) {
        double low[DIM], high[DIM];
        shape_bounds(&p->in.fluid[i].set.shape, low, high);
        for (int d = 0; d < DIM; d++) {
            const double g = p->scales.period[d] > 0 ? 0 : p->scales.g[d];
            fall2 = fmax(fall2, 2 * g * (g < 0 ? p->scales.low[d] - high[d]
                                               : p->scales.high[d] - low[d]));
        }
    }
    return fall2;
}

double plan_driven(const struct plan *p)
{
    double most = start_speed(p);

    for (int i = 0; i < p->walls; i++) {
        const double *slides = p->in.wall[i].set.surface;
        double low[DIM], high[DIM], reach[DIM];
        shape_bounds(&p->in.wall[i].set.shape, low, high);
        most = fmax(most, motion_extent(&p->wall[i].motion, low, high, p->in.set.until,
                                              reach));
        most = fmax(most, gsl_hypot3(slides[0], slides[1], slides[2]));
    }
    return most;
}

double plan_speed_expected(const struct plan *p)
{
    return fmax(plan_driven(p), hypot(start_speed(p), sqrt(fall(p))));
}

bool plan_walls_move(const struct plan *p)
{
    for (int i = 0; i < p->walls; i++)
        if (p->wall[i].moves)
            return true;
    return false;
}

bool plan_hydrostatic(const struct plan *p)
{
    for (int i = 0; i < p->in.fluids; i++)
        if (strcmp(p->in.fluid[i].set.initial, "hydrostatic") == 0)
            return true;
    return false;
}

/* How high all fluid would stand in the domain, solids in it left aside [m]. */
static double level(const struct plan *p)
{
    double height = particles_count(p->particles, KIND_FLUID) * pow(p->scales.dx, DIM);

    for (int d = 0; d < DIM - 1; d++)
        height /= p->scales.high[d] - p->scales.low[d];
    return height;
}

bool plan_falls(const struct plan *p)
{
    const double g = -p->scales.g[DIM - 1];

    return g > 0 && fall(p) / (2 * g) > 1.15 * level(p) + 2 * p->scales.dx;
}

double plan_reach(const struct plan *p)
{
    const double g = -p->scales.g[DIM - 1], driven2 = pow(plan_driven(p), 2);
    double top;

    if (!(g > 0))
        return HUGE_VAL;
    top = fall(p) / (2 * g);
    if (plan_falls(p))
        top *= 3;
    return p->scales.low[DIM - 1] + top + driven2 / (2 * g);
}

const char *plan_rim(const struct plan *p, double *rim)
{
    const char *name = NULL;

    *rim = HUGE_VAL;
    for (int i = 0; i < p->in.wall_count; i++)
        if (p->in.wall[i].set.rim < *rim) { /* NaN: none */
            *rim = p->in.wall[i].set.rim;
            name = p->in.wall[i].name;
        }
    return name;
}
