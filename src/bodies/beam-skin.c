/* beam-skin.c -- points that the water meets, carried by a bending beam.
 * Checked in tests/unit/beam*.c. */
#include "bodies/beam-skin.h"

#include "base/status.h"
#include "bodies/element.h"
#include <math.h>
#include <stdlib.h>

static void place(const struct skin_def *d, int i, struct beam_skin_point *p)
{
    const double l = d->length / d->elements;
    double along, eta, slope[4]; /* slope: of no use here */
    int e;

    skin_site(d, i, &along, &eta);
    e = (int)(along / l);
    if (e > d->elements - 1)
        e = d->elements - 1;
    p->first = p->from = 2 * e;
    p->n = 4;
    p->mean = p->shape;
    element_shape(along / l - e, l, p->shape, slope);
    for (int k = 0; k < DIM; k++)
        p->rest[k] = d->at[k] + along * d->along[k] + eta * d->normal[k];
}

/* Adds to mean, from the degrees of freedom of element e, the shapes of its part of
 * [low, high]: two points of Gauss are exact for cubics. */
static void add_element(const struct skin_def *d, int e, double low, double high,
                        double *mean)
{
    const double l = d->length / d->elements, a = fmax(low, e * l), b = fmin(high, (e + 1) * l);
    const double weight = 0.5 * (b - a) / (high - low);

    for (int side = -1; side <= 1 && b > a; side += 2) {
        const double at = 0.5 * (a + b) + side * 0.5 * (b - a) / sqrt(3);
        double shape[4], slope[4]; /* slopes are of no use here */
        element_shape(at / l - e, l, shape, slope);
        for (int k = 0; k < 4; k++)
            mean[k] += weight * shape[k];
    }
}

/* Means over the share of every point: row j of the skin has [j, j + 1] length/rows. */
static int take_means(struct beam_skin *s, int rows)
{
    const struct skin_def *d = &s->def;
    const double share = d->length / rows, l = d->length / d->elements;
    const int most = 2 * ((int)(share / l) + 3);

    s->mean = status_alloc((unsigned long)s->points * most, sizeof *s->mean);
    if (!s->mean)
        return STATUS_FAILED;
    for (int i = 0; i < s->points; i++) {
        const double low = i / d->layers * share, high = low + share;
        const int first = (int)(low / l), last = (int)fmin(high / l, d->elements - 1);
        double *mean = s->mean + (size_t)i * most;
        for (int e = first; e <= last; e++)
            add_element(d, e, low, high, mean + 2 * (e - first));
        s->point[i].from = 2 * first;
        s->point[i].n = 2 * (last - first + 2);
        s->point[i].mean = mean;
    }
    return STATUS_DONE;
}

int beam_skin_create(const struct skin_def *def, struct beam_skin **out)
{
    struct beam_skin *s = status_alloc(1, sizeof *s);
    int rows, status = STATUS_DONE;

    if (!s)
        return STATUS_FAILED;
    s->def = *def;
    s->points = skin_points(def);
    s->point = status_alloc((unsigned long)s->points, sizeof *s->point);
    if (!s->point) {
        beam_skin_free(&s);
        return STATUS_FAILED;
    }
    for (int i = 0; i < s->points; i++)
        place(def, i, &s->point[i]);
    rows = s->points > 0 ? s->points / def->layers : 0;
    if (rows > 0 && def->elements > rows)
        status = take_means(s, rows);
    if (status != STATUS_DONE)
        beam_skin_free(&s);
    *out = s;
    return status;
}

void beam_skin_free(struct beam_skin **s)
{
    if (!*s)
        return;
    free((*s)->mean);
    free((*s)->point);
    free(*s);
    *s = NULL;
}

/* w of a point, or its rate. */
static double across_of(const struct beam_skin_point *p, const double *q)
{
    double sum = 0;

    for (int k = 0; k < p->n; k++)
        sum += p->mean[k] * q[p->from + k];
    return sum;
}

void beam_skin_move(const struct beam_skin *s, const double *q, const double *v,
                    double (*x)[DIM], double (*u)[DIM])
{
    const double *n = s->def.normal;

    for (int i = 0; i < s->points; i++) {
        const struct beam_skin_point *p = &s->point[i];
        const double across = across_of(p, q);
        const double across_rate = across_of(p, v);
        for (int d = 0; d < DIM; d++) {
            x[i][d] = p->rest[d] + across * n[d];
            u[i][d] = across_rate * n[d];
        }
    }
}

void beam_skin_drift(const struct beam_skin *s, const double *v, double (*u)[DIM])
{
    for (int i = 0; i < s->points; i++) {
        const double across = across_of(&s->point[i], v);
        for (int d = 0; d < DIM; d++)
            u[i][d] = across * s->def.normal[d];
    }
}

double beam_skin_load(const struct beam_skin *s, const double (*force)[DIM], double *f)
{
    double axial = 0;

    for (int i = 0; i < s->points; i++) {
        const struct beam_skin_point *p = &s->point[i];
        double across = 0, along = 0;
        for (int d = 0; d < DIM; d++) {
            across += force[i][d] * s->def.normal[d];
            along += force[i][d] * s->def.along[d];
        }
        for (int k = 0; k < p->n; k++)
            f[p->from + k] += across * p->mean[k];
        axial += along;
    }
    return axial;
}
