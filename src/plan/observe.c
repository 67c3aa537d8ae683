/* observe.c -- looking at a plan without disturbing the run. */
#include "plan/observe.h"

#include "base/status.h"
#include "plan/inside.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The run's list if it fits the moment, else the observer's own.  The first look
 * makes that: a run takes at its start what it may need later. */
static int choose(struct plan *p, const struct view *v, struct plan_workspace **w)
{
    struct cloud cloud = { 0 };

    memcpy(cloud.from, v->p->from, sizeof cloud.from);
    memcpy(cloud.x, v->x, sizeof cloud.x);
    *w = &p->main;
    if (p->particles->n == 0
        || (p->observer.list && !p->engine->sum->list->stale(p->main.list, &cloud)))
        return STATUS_DONE;
    *w = &p->observer;
    return p->observer.list ? STATUS_DONE : plan_observer_make(p);
}

/* Densities out of bounds are looked at all the same: who asks for a view wants
 * to see what is there. */
void plan_view(struct plan *p, double t, const double *y, struct view *v)
{
    struct plan_workspace *w;

    plan_view_make(p, t, y, v);
    if (p->fields == 0)
        return;
    if (choose(p, v, &w) == STATUS_DONE)
        plan_fields(p, w, v);
    for (int k = 0; k < KINDS; k++) /* a position that is not finite has no sums */
        if (!v->rho[k])
            v->rho[k] = p->main.rho + p->particles->from[k];
}

/* Forces on skins for who looks; those of the run come back by the same again. */
static void swap_forces(struct plan *p)
{
    for (int i = 0; i < p->bodies; i++) {
        double (*force)[DIM] = p->body[i].force;
        p->body[i].force = p->body[i].seen;
        p->body[i].seen = force;
    }
}

int plan_observe(struct plan *p, double t, const double *y)
{
    struct plan_workspace *w;
    struct view v;
    int status;

    plan_view_make(p, t, y, &v);
    TRY(choose(p, &v, &w));
    swap_forces(p);
    status = plan_rates(p, w, PLAN_ALL, t, y, p->scratch);
    swap_forces(p);
    return status == STATUS_DONE ? status : status_fail(STATUS_FAILED, "%s", p->refusal);
}

const double *plan_force(const struct plan *p, int object)
{
    return p->force[object];
}

int plan_bodies(const struct plan *p)
{
    return p->bodies;
}

const char *plan_body_name(const struct plan *p, int body)
{
    return p->body[body].name;
}

void plan_body_view(struct plan *p, int body, double t, const double *y, struct body_view *out)
{
    const struct plan_body *b = &p->body[body];

    b->kind->show(b->body, &p->layout, t, y, (const double (*)[DIM])b->seen, out);
}

const double *plan_impulse(const struct plan *p, const double *y, int object)
{
    return y + layout_at(&p->layout, p->book.row) + p->book.impulse + object * DIM;
}

void plan_pressures(const struct plan *p, int n, const double *rho, double *press)
{
    memset(press, 0, n * sizeof *press);
    if (p->pressure)
        p->pressure->part->pressure(p->pressure->self, n, rho, press);
}

const struct particles *plan_particles(const struct plan *p)
{
    return p->particles;
}

const struct scales *plan_scales(const struct plan *p)
{
    return &p->scales;
}

const struct settings *plan_settings(const struct plan *p)
{
    return &p->in.set;
}

const struct settings_output *plan_output(const struct plan *p)
{
    return &p->in.output;
}

int plan_probes(const struct plan *p)
{
    return p->in.probes;
}

const struct settings_probe *plan_probe(const struct plan *p, int i, const char **name)
{
    *name = p->in.probe[i].name;
    return &p->in.probe[i].set;
}

int plan_escaped(struct plan *p, double t, const double *y)
{
    struct view v;
    int n = 0;

    plan_view_make(p, t, y, &v);
    for (int i = 0; i < particles_count(v.p, KIND_FLUID); i++)
        n += !list_inside(&p->list_def, v.x[KIND_FLUID] + (size_t)i * DIM);
    return n;
}

/* The fluid particle that moves fastest, and its speed [m/s]. */
static int fastest(const struct view *v, double *speed)
{
    int who = -1;

    *speed = 0;
    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++) {
        const double *u = v->u[KIND_FLUID] + (size_t)i * DIM;
        double u2 = 0;
        for (int d = 0; d < DIM; d++)
            u2 += u[d] * u[d];
        if (!(u2 > *speed * *speed))
            continue;
        *speed = sqrt(u2);
        who = i;
    }
    return who;
}

const char *plan_runaway(struct plan *p, double t, const double *y)
{
    static char text[400];
    char place[PLAN_PLACE];
    struct view v;
    double speed;
    int i;

    plan_view_make(p, t, y, &v);
    i = fastest(&v, &speed);
    if (!(speed > p->in.eos.fastest * p->scales.c0))
        return NULL;
    plan_place(p, &v, i, place);
    p->culprit[PLAN_TOO_FAST] = (struct plan_culprit){ true, i, t };
    snprintf(text, sizeof text, "the fluid has run away: at t = %g s particle %d (%s) at %s m "
             "moves at %.4g m/s, %.3g times the sound speed of %g m/s (eos.fastest = %g); take a "
             "higher eos.c0 if that speed is real", t, i,
             v.p->object[v.p->object_of[i]].name, place, speed,
             speed / p->scales.c0, p->scales.c0, p->in.eos.fastest);
    return text;
}

int plan_lanes(const struct plan *p)
{
    return p->engine->lanes;
}

double plan_speed_expected(const struct plan *p)
{
    double most = plan_start_speed(p), fall2 = 0;

    for (int i = 0; i < p->in.fluids; i++) {
        double low[DIM], high[DIM];
        shape_bounds(&p->in.fluid[i].set.shape, low, high);
        for (int d = 0; d < DIM; d++) {
            const double g = p->scales.period[d] > 0 ? 0 : p->scales.g[d];
            fall2 = fmax(fall2, 2 * g * (g < 0 ? p->scales.low[d] - high[d]
                                               : p->scales.high[d] - low[d]));
        }
    }
    for (int i = 0; i < p->walls; i++) {
        const double *slides = p->in.wall[i].set.surface;
        double low[DIM], high[DIM], reach[DIM];
        shape_bounds(&p->in.wall[i].set.shape, low, high);
        most = fmax(most, walls_motion_extent(&p->wall[i].motion, low, high, p->in.set.until,
                                              reach));
        most = fmax(most, gsl_hypot3(slides[0], slides[1], slides[2]));
    }
    return fmax(most, sqrt(fall2));
}

int plan_parts(const struct plan *p)
{
    return p->parts;
}

const struct part *plan_part(const struct plan *p, int i, const char **path)
{
    *path = p->part[i].path;
    return p->part[i].part;
}
