/* time-toy.c -- a plan with a known solution. */
#include "time-toy.h"

#include "base/status.h"
#include "plan/solver.h"
#include "state/limit.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static long at(const struct moment *p, int row)
{
    return layout_at(&p->layout, row);
}

void toy_make(struct moment *p, double stiffness, double damping)
{
    struct layout *l = &p->layout;

    *p = (struct moment){ .stiffness = stiffness, .damping = damping, .wave = 1 };
    p->row_x = layout_add(l, LAYOUT_POSITION, "position of fluid", "m", TOY_PARTICLES, 1, 1);
    if (stiffness > 0)
        p->row_q = layout_add(l, LAYOUT_POSITION, "beam.b.w", "m", 1, 1, 1);
    p->row_u = layout_add(l, LAYOUT_VELOCITY, "velocity of fluid", "m/s", TOY_PARTICLES, 1, 1);
    if (stiffness > 0)
        p->row_v = layout_add(l, LAYOUT_VELOCITY, "beam.b.w_rate", "m/s", 1, 1, 1);
    p->row_rho = layout_add(l, LAYOUT_OTHER, "density of fluid", "kg/m^3", TOY_PARTICLES, 1, 1);
    p->row_book = layout_add(l, LAYOUT_OTHER, "book", "J", 1, 1, 0);
    layout_done(l);
}

/* The beam's answer to cos t that neither grows nor decays, and its rate. */
static void exact_beam(const struct moment *p, double t, double *q, double *v)
{
    const double s = p->stiffness - 1, d = p->damping, n = s * s + d * d;
    const double a = s / n, b = d / n;

    *q = a * cos(t) + b * sin(t);
    *v = -a * sin(t) + b * cos(t);
}

void toy_exact(const struct moment *p, double t, double *y)
{
    for (int i = 0; i < TOY_PARTICLES; i++) {
        y[at(p, p->row_x) + i] = sin(t + i);
        y[at(p, p->row_u) + i] = cos(t + i);
        y[at(p, p->row_rho) + i] = 1 + 0.1 * cos(t + i);
    }
    if (p->stiffness > 0)
        exact_beam(p, t, &y[at(p, p->row_q)], &y[at(p, p->row_v)]);
    y[at(p, p->row_book)] = sin(t) * sin(t) / 2;
}

double toy_error(const struct moment *p, double t, const double *y)
{
    double exact[64], most = 0;

    toy_exact(p, t, exact);
    for (long i = 0; i < at(p, p->row_book); i++)
        most = fmax(most, fabs(y[i] - exact[i]));
    return most;
}

static bool refused(struct moment *p, double t, const double *y)
{
    const double off = fabs(y[at(p, p->row_rho)] - 1 - 0.1 * cos(t));
    const bool no = (p->off > 0 && !(off <= p->off))
                 || (p->refuse_after > 0 && t > p->refuse_after);

    p->counts.refused += no;
    return no;
}

static void particle_rates(struct moment *p, double t, const double *y, double *f)
{
    double q = 0, v = 0;

    if (p->stiffness > 0)
        exact_beam(p, t, &q, &v);
    for (int i = 0; i < TOY_PARTICLES; i++) {
        const double x = y[at(p, p->row_x) + i], u = y[at(p, p->row_u) + i],
                     rho = y[at(p, p->row_rho) + i];
        const double s = sin(t + i), c = cos(t + i), r = 1 + 0.1 * c;
        f[at(p, p->row_x) + i] = u;
        f[at(p, p->row_u) + i] = -s - (x * x * x * rho - s * s * s * r) - p->drag * (u - c);
        if (p->stiffness > 0)
            f[at(p, p->row_u) + i] += y[at(p, p->row_q)] - q;
        f[at(p, p->row_rho) + i] = -0.1 * s - (p->plain ? u - c : rho * u - r * c);
        if (p->stiffness > 0)
            f[at(p, p->row_rho) + i] += y[at(p, p->row_v)] - v;
    }
}

/* Of a half, rates of the other one and of positions are 0; the book is the
 * velocities' business. */
static void halve(const struct moment *p, unsigned rates, double *f)
{
    const long *from = p->layout.from;

    memset(f, 0, (size_t)from[LAYOUT_VELOCITY] * sizeof *f);
    if (rates == ASK_VELOCITIES)
        memset(f + from[LAYOUT_OTHER], 0, TOY_PARTICLES * sizeof *f);
    else
        memset(f + from[LAYOUT_VELOCITY], 0,
               (size_t)(from[LAYOUT_OTHER] - from[LAYOUT_VELOCITY]) * sizeof *f);
    if (rates == ASK_DENSITIES)
        f[at(p, p->row_book)] = 0;
}

static void explicit_side(struct moment *p, const struct ask *ask, double t, const double *y,
                          double *f)
{
    const double x = y[at(p, p->row_x)], u = y[at(p, p->row_u)];

    particle_rates(p, t, y, f);
    if (fabs(x - p->listed) > 0.05) {
        p->listed = x;
        p->counts.rebuilds++;
    }
    f[at(p, p->row_u)] += 1e-14 * p->listed;
    f[at(p, p->row_book)] = x * (u + ask->ahead * f[at(p, p->row_u)]);
    if (p->stiffness > 0)
        f[at(p, p->row_v)] = cos(t) + x - sin(t);
    if (ask->rates)
        halve(p, ask->rates, f);
}

int moment_eval(struct moment *p, struct ask ask, double t, const double *y, double *f)
{
    if (ask.apart) {
        TRY(moment_eval(p, ASK_EXPLICIT_SIDE, t, y, f));
        return moment_eval(p, ASK_IMPLICIT_SIDE, t, y, ask.apart);
    }
    p->counts.rhs_explicit += (ask.sides & ASK_EXPLICIT) && ask.rates != ASK_DENSITIES;
    p->counts.rhs_implicit += ask.sides == ASK_IMPLICIT;
    memset(f, 0, (size_t)moment_size(p) * sizeof *f);
    if (ask.sides & ASK_EXPLICIT) {
        if (refused(p, t, y))
            return STATUS_FAILED;
        explicit_side(p, &ask, t, y, f);
    }
    if ((ask.sides & ASK_IMPLICIT) && p->stiffness > 0) {
        f[at(p, p->row_q)] += y[at(p, p->row_v)];
        f[at(p, p->row_v)] -= p->stiffness * y[at(p, p->row_q)] + p->damping * y[at(p, p->row_v)];
    }
    if (p->poison_after > 0 && t > p->poison_after)
        f[at(p, p->row_book)] = INFINITY;
    return STATUS_DONE;
}

const char *plan_drifts(const struct plan *p)
{
    (void)p;
    return NULL;
}

const char *plan_halves(const struct plan *p)
{
    return p->moment.whole;
}

/* It has no pressure. */
const struct plan_solved *plan_solved(const char *method)
{
    (void)method;
    return NULL;
}

/* q = rq + g v, v = rv - g (S q + d v). */
int moment_solve(struct moment *p, double t, double g, const double *r, double *z)
{
    const double rq = r[at(p, p->row_q)], rv = r[at(p, p->row_v)];
    const double v = (rv - g * p->stiffness * rq) / (1 + g * p->damping + g * g * p->stiffness);

    (void)t;
    p->counts.solves++;
    if (p->solvable > 0 && g > p->solvable)
        return status_fail(STATUS_FAILED, "gamma is %g", g);
    z[at(p, p->row_v)] = v;
    z[at(p, p->row_q)] = rq + g * v;
    return STATUS_DONE;
}

/* The beam has no place in the book. */
void moment_body_book(struct moment *p, double t, const double *y, double share, double *f)
{
    (void)p, (void)t, (void)y, (void)share, (void)f;
}

/* It has no rigid bodies. */
const char *moment_rigid_lacks(const struct plan *p)
{
    (void)p;
    return "this scene has no rigid body";
}

int moment_rigid_ranges(const struct moment *p, int most, long (*range)[2])
{
    (void)p, (void)most, (void)range;
    return 0;
}

int moment_rigid(struct moment *p, double t, const double *y, double *ydot)
{
    (void)p, (void)t, (void)y, (void)ydot;
    return STATUS_FAILED;
}

void moment_rigid_limit(struct moment *p, double t, const double *y, struct limit limit[2])
{
    moment_limit(p, t, y, false, limit);
}

void moment_fluid_limit(struct moment *p, double t, const double *y, struct limit limit[2])
{
    moment_limit(p, t, y, false, limit);
}

void moment_contact_limit(struct moment *p, double t, const double *y, struct limit *out)
{
    (void)t, (void)y;
    *out = (struct limit){ .rate = p->touch, .where = -1, .part = "contact" };
}

/* One rank has all. */
const double *moment_whole(struct moment *p, const double *y)
{
    (void)p;
    return y;
}

const char *moment_refusal(const struct moment *p)
{
    return p->counts.refused > 0 ? "the density of particle 0 is off" : "";
}

/* Alone it has all of y. */
struct vector_own moment_own(const struct moment *p)
{
    (void)p;
    return (struct vector_own){ 0 };
}

void moment_take(const struct moment *p, const double *y, double *to)
{
    memcpy(to, y, (size_t)moment_size(p) * sizeof *to);
}

void moment_combine(const struct moment *p, int terms, const double *c, const double *const *x,
                    double *to)
{
    vector_combine(terms, c, x, moment_size(p), to);
}

const struct plan *moment_plan(const struct moment *p)
{
    return (const struct plan *)p;
}

long moment_size(const struct moment *p)
{
    return layout_size(&p->layout);
}

const struct layout *moment_layout(const struct moment *p)
{
    return &p->layout;
}

long plan_size(const struct plan *p)
{
    return moment_size(&p->moment);
}

const struct layout *plan_layout(const struct plan *p)
{
    return &p->moment.layout;
}

double plan_length(const struct plan *p)
{
    (void)p;
    return 1;
}

const char *plan_viscous(const struct plan *p)
{
    (void)p;
    return NULL;
}

void moment_solve_tolerance(struct moment *p, double tol)
{
    (void)p, (void)tol;
}

bool plan_stiff(const struct plan *p)
{
    return p->moment.stiffness > 0;
}

int plan_stiff_ranges(const struct plan *p, const struct layout *l, int most, long (*range)[2])
{
    const int rows[2] = { p->moment.row_q, p->moment.row_v };

    for (int k = 0; k < 2 && k < most && plan_stiff(p); k++) {
        range[k][0] = layout_at(l, rows[k]);
        range[k][1] = range[k][0] + 1;
    }
    return plan_stiff(p) ? 2 : 0;
}

int moment_stiff_ranges(const struct moment *p, int most, long (*range)[2])
{
    return plan_stiff_ranges(moment_plan(p), &p->layout, most, range);
}

void moment_limit(struct moment *p, double t, const double *y, bool stiff, struct limit limit[2])
{
    (void)t, (void)y;
    limit[0] = (struct limit){ .rate = p->wave, .where = 1, .part = "pressure" };
    limit[1] = (struct limit){ .rate = p->decay, .decay = true, .where = -1, .part = "viscosity" };
    if (stiff && sqrt(p->stiffness) > p->wave)
        limit[0] = (struct limit){ .rate = sqrt(p->stiffness), .where = 0, .part = "beam.b" };
}

/* Its beam is there for stiffness, not to be followed. */
void moment_swing(const struct moment *p, double most, struct limit *out)
{
    (void)p, (void)most;
    *out = (struct limit){ .where = -1 };
}

void moment_weights(const struct moment *p, double tol, double *weight)
{
    layout_weights(&p->layout, tol, NULL, weight);
}

int moment_id(const struct moment *p, int row, int which)
{
    (void)p, (void)row;
    return which;
}

const char *moment_entry(const struct moment *p, long i)
{
    static char text[96];
    int which = 0;
    const struct layout_row *row = layout_find(&p->layout, i, &which);

    snprintf(text, sizeof text, "%s, number %d", row ? row->name : "nothing", which);
    return text;
}

const struct moment_counts *moment_counts(const struct moment *p)
{
    return &p->counts;
}
