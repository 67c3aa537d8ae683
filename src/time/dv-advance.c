/* dv-advance.c -- the formulas of a step, see dv.h. */
#include "time/dv.h"

#include "base/status.h"

/* to = y + h f in the entries of one class. */
static void add(const struct dv *x, enum layout_class what, const double *y, double h,
                const double *f, double *to)
{
    const long i = x->from[what];
    const double c[2] = { 1, h };

    vector_combine(2, c, (const double *[]){ y + i, f + i }, x->from[what + 1] - i, to + i);
}

/* Positions of `to` = those of y + h times the velocities in v. */
static void drift(const struct dv *x, const double *y, double h, const double *v, double *to)
{
    add(x, LAYOUT_POSITION, y, h, v + x->from[LAYOUT_VELOCITY], to);
}

/* D.  Densities that follow from positions are up to date: only the book asks then. */
static int flow(struct dv *x, double t, const double *y, double later, double *f)
{
    return plan_half(x->plan, PLAN_DENSITY, t, y, x->flows ? later : 0, f);
}

int dv_begin(struct dv *x)
{
    TRY(flow(x, x->t, x->y, 0, x->d.f[1]));
    TRY(plan_rhs(x->plan, PLAN_VELOCITY, x->t, x->y, x->a.f[1]));
    if (x->ranges > 0)
        vector_copy(x->n, x->a.f[1], x->load_old);
    x->a.t[1] = x->d.t[1] = x->t;
    x->a.known = x->d.known = 1;
    x->ready = true;
    return STATUS_DONE;
}

int dv_advance(struct dv *x, double h)
{
    const long v = x->from[LAYOUT_VELOCITY], rho = x->from[LAYOUT_OTHER];

    x->a.t[0] = x->t_old + h / 2;
    x->d.t[0] = x->t_old + h;
    drift(x, x->y_old, h / 2, x->y_old, x->half);
    vector_copy(rho - v, x->y_old + v, x->half + v);
    add(x, LAYOUT_OTHER, x->y_old, h / 2, x->d.f[1], x->half);
    TRY(dv_bodies_half(x, h / 2));
    TRY(plan_half(x->plan, PLAN_VELOCITY, x->a.t[0], x->half, h / 2, x->a.f[0]));
    add(x, LAYOUT_VELOCITY, x->y_old, h, x->a.f[0], x->y);
    drift(x, x->half, h / 2, x->y, x->y);
    TRY(dv_bodies_step(x, h));
    add(x, LAYOUT_OTHER, x->half, h, x->a.f[0], x->y); /* A's share of quadratures */
    TRY(flow(x, x->d.t[0], x->y, h / 2, x->d.f[0]));
    add(x, LAYOUT_OTHER, x->y, h / 2, x->d.f[0], x->y);
    return STATUS_DONE;
}
