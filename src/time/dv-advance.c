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
    return moment_eval(x->frame.moment, ASK_HALF(ASK_DENSITIES, x->flows ? later : 0), t, y, f);
}

int dv_begin(struct paced *frame)
{
    struct dv *x = (struct dv *)frame;

    TRY(flow(x, x->frame.t, x->frame.y, 0, x->d.f[1]));
    TRY(moment_eval(x->frame.moment, ASK_HALF(ASK_VELOCITIES, 0), x->frame.t, x->frame.y,
                    x->a.f[1]));
    if (x->ranges > 0)
        vector_copy(x->frame.n, x->a.f[1], x->load_old);
    x->a.t[1] = x->d.t[1] = x->frame.t;
    x->a.known = x->d.known = 1;
    return STATUS_DONE;
}

int dv_advance(struct paced *frame, double h)
{
    struct dv *x = (struct dv *)frame;
    const long v = x->from[LAYOUT_VELOCITY], rho = x->from[LAYOUT_OTHER];

    x->a.t[0] = frame->t_old + h / 2;
    x->d.t[0] = frame->t_old + h;
    drift(x, frame->y_old, h / 2, frame->y_old, x->half);
    vector_copy(rho - v, frame->y_old + v, x->half + v);
    add(x, LAYOUT_OTHER, frame->y_old, h / 2, x->d.f[1], x->half);
    TRY(dv_bodies_half(x, h / 2));
    TRY(moment_eval(frame->moment, ASK_HALF(ASK_VELOCITIES, h / 2), x->a.t[0], x->half,
                    x->a.f[0]));
    add(x, LAYOUT_VELOCITY, frame->y_old, h, x->a.f[0], frame->y);
    drift(x, x->half, h / 2, frame->y, frame->y);
    TRY(dv_bodies_step(x, h));
    add(x, LAYOUT_OTHER, x->half, h, x->a.f[0], frame->y); /* A's share of quadratures */
    TRY(flow(x, x->d.t[0], frame->y, h / 2, x->d.f[0]));
    add(x, LAYOUT_OTHER, frame->y, h / 2, x->d.f[0], frame->y);
    return STATUS_DONE;
}

static void swap(double **a, double **b)
{
    double *c = *a;

    *a = *b;
    *b = c;
}

/* The newest rates become past. */
static void push(struct dv_past *p, bool replace)
{
    p->begun = p->f[1];
    swap(&p->f[0], &p->f[1]);
    if (!replace) {
        swap(&p->f[0], &p->f[2]);
        p->t[2] = p->t[1];
        p->known = 2;
    }
    p->t[1] = p->t[0];
}

/* There are none to replace after a first step. */
void dv_remember(struct paced *frame, bool replace)
{
    struct dv *x = (struct dv *)frame;
    const bool over = replace && x->a.known > 1;

    swap(&x->load, &x->load_old);
    push(&x->a, over);
    push(&x->d, over);
}
