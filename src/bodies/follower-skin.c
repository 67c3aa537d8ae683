/* follower-skin.c -- points that the water meets, carried by a beam that bends far.
 * Checked in tests/unit/elastica-body.c. */
#include "bodies/follower-skin.h"

#include "base/status.h"
#include "bodies/elastica.h"
#include "bodies/element.h"
#include <math.h>
#include <stdlib.h>

static struct follower_skin_place place(const struct skin_def *d, double s)
{
    const double l = d->length / d->elements;
    struct follower_skin_place p = { .s = fmin(fmax(s, 0), d->length) };
    double slope[4]; /* of no use here */

    p.element = (int)(p.s / l);
    if (p.element > d->elements - 1)
        p.element = d->elements - 1;
    element_shape(p.s / l - p.element, l, p.shape, slope);
    return p;
}

int follower_skin_create(const struct skin_def *def, struct follower_skin **out)
{
    struct follower_skin *s = status_alloc(1, sizeof *s);

    if (!s)
        return STATUS_FAILED;
    s->def = *def;
    s->points = skin_points(def);
    s->point = status_alloc((unsigned long)s->points, sizeof *s->point);
    if (!s->point) {
        follower_skin_free(&s);
        return STATUS_FAILED;
    }
    for (int i = 0; i < s->points; i++) {
        double at, eta;
        skin_site(def, i, &at, &eta);
        s->point[i] = (struct follower_skin_point){
            .here = place(def, at), .back = place(def, at - def->spacing),
            .front = place(def, at + def->spacing), .eta = eta };
    }
    *out = s;
    return STATUS_DONE;
}

void follower_skin_free(struct follower_skin **s)
{
    if (!*s)
        return;
    free((*s)->point);
    free(*s);
    *s = NULL;
}

/* Cubic of the element through q: displacement, or its rate. */
static void carry(const struct follower_skin_place *p, const double *q, double *to)
{
    for (int c = 0; c < 2; c++) {
        to[c] = 0;
        for (int k = 0; k < 4; k++)
            to[c] += p->shape[k] * q[elastica_at(p->element, k, c)];
    }
}

static void take_back(const struct follower_skin_place *p, const double *force, double *f)
{
    for (int c = 0; c < 2; c++)
        for (int k = 0; k < 4; k++)
            f[elastica_at(p->element, k, c)] += p->shape[k] * force[c];
}

/* Chord through a point's neighbourhood; returns its length. */
static double chord(const struct follower_skin_point *p, const double *q, double *c)
{
    double back[2], front[2];

    carry(&p->back, q, back);
    carry(&p->front, q, front);
    c[0] = p->front.s - p->back.s + front[0] - back[0];
    c[1] = front[1] - back[1];
    return hypot(c[0], c[1]);
}

/* With t = c/|c|: n = (-t_y, t_x), and n' = -t (n . c')/|c|. */
static void move_point(const struct follower_skin_point *p, const double *q, const double *v,
                       double *x, double *u)
{
    double c[2], back[2], front[2];
    const double size = chord(p, q, c), t[2] = { c[0] / size, c[1] / size };

    carry(&p->back, v, back);
    carry(&p->front, v, front);
    const double turning = (t[0] * (front[1] - back[1]) - t[1] * (front[0] - back[0])) / size;
    carry(&p->here, q, x);
    carry(&p->here, v, u);
    x[0] += p->here.s - p->eta * t[1];
    x[1] += p->eta * t[0];
    u[0] -= p->eta * turning * t[0];
    u[1] -= p->eta * turning * t[1];
}

void follower_skin_move(const struct follower_skin *s, const double *q, const double *v,
                        double (*x)[DIM], double (*u)[DIM])
{
    const struct skin_def *f = &s->def;

    for (int i = 0; i < s->points; i++) {
        double at[2], rate[2];
        move_point(&s->point[i], q, v, at, rate);
        for (int d = 0; d < DIM; d++)
            x[i][d] = f->at[d] + at[0] * f->along[d] + at[1] * f->normal[d];
        for (int d = 0; u && d < DIM; d++)
            u[i][d] = rate[0] * f->along[d] + rate[1] * f->normal[d];
    }
}

void follower_skin_drift(const struct follower_skin *s, const double *q, const double *v,
                         double (*u)[DIM])
{
    for (int i = 0; i < s->points; i++) {
        double at[2], rate[2];
        move_point(&s->point[i], q, v, at, rate);
        for (int d = 0; d < DIM; d++)
            u[i][d] = rate[0] * s->def.along[d] + rate[1] * s->def.normal[d];
    }
}

/* With t, n, n' = -w t and t' = w n as there, w = (c x c')/|c|^2: of u = r' - eta w t the rest is
 * -eta (w' t + w^2 n), w' = -2 w (c . c')/|c|^2, as c' is constant. */
static void bend_point(const struct follower_skin_point *p, const double *q, const double *v,
                       double *a)
{
    double c[2], back[2], front[2];
    const double size = chord(p, q, c);

    carry(&p->back, v, back);
    carry(&p->front, v, front);
    const double rate[2] = { front[0] - back[0], front[1] - back[1] };
    const double turning = (c[0] * rate[1] - c[1] * rate[0]) / (size * size);
    const double slows = -2 * turning * (c[0] * rate[0] + c[1] * rate[1]) / (size * size);
    a[0] = -p->eta * (slows * c[0] - turning * turning * c[1]) / size;
    a[1] = -p->eta * (slows * c[1] + turning * turning * c[0]) / size;
}

void follower_skin_bend(const struct follower_skin *s, const double *q, const double *v,
                        double (*a)[DIM])
{
    for (int i = 0; i < s->points; i++) {
        double rest[2];
        bend_point(&s->point[i], q, v, rest);
        for (int d = 0; d < DIM; d++)
            a[i][d] += rest[0] * s->def.along[d] + rest[1] * s->def.normal[d];
    }
}

void follower_skin_load(const struct follower_skin *s, const double *q,
                        const double (*force)[DIM], double *f)
{
    for (int i = 0; i < s->points; i++) {
        const struct follower_skin_point *p = &s->point[i];
        double push[2] = { 0, 0 }, c[2];
        const double size = chord(p, q, c);

        for (int d = 0; d < DIM; d++) {
            push[0] += force[i][d] * s->def.along[d];
            push[1] += force[i][d] * s->def.normal[d];
        }
        const double couple = p->eta * (push[0] * c[0] + push[1] * c[1]) / (size * size * size);
        const double front[2] = { couple * c[1], -couple * c[0] };
        const double back[2] = { -front[0], -front[1] };
        take_back(&p->here, push, f);
        take_back(&p->front, front, f);
        take_back(&p->back, back, f);
    }
}

void follower_skin_centre(const struct follower_skin *s, double at, const double *q, double *r)
{
    const struct follower_skin_place p = place(&s->def, at);

    carry(&p, q, r);
    r[0] += p.s;
}
