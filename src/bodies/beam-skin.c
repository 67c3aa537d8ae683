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
    p->first = 2 * e;
    element_shape(along / l - e, l, p->shape, slope);
    for (int k = 0; k < DIM; k++)
        p->rest[k] = d->at[k] + along * d->along[k] + eta * d->normal[k];
}

int beam_skin_create(const struct skin_def *def, struct beam_skin **out)
{
    struct beam_skin *s = status_alloc(1, sizeof *s);

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
    *out = s;
    return STATUS_DONE;
}

void beam_skin_free(struct beam_skin **s)
{
    if (!*s)
        return;
    free((*s)->point);
    free(*s);
    *s = NULL;
}

static double dot4(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

void beam_skin_move(const struct beam_skin *s, const double *q, const double *v,
                    double (*x)[DIM], double (*u)[DIM])
{
    const double *n = s->def.normal;

    for (int i = 0; i < s->points; i++) {
        const struct beam_skin_point *p = &s->point[i];
        const double across = dot4(p->shape, q + p->first);
        const double across_rate = dot4(p->shape, v + p->first);
        for (int d = 0; d < DIM; d++) {
            x[i][d] = p->rest[d] + across * n[d];
            u[i][d] = across_rate * n[d];
        }
    }
}

void beam_skin_drift(const struct beam_skin *s, const double *v, double (*u)[DIM])
{
    for (int i = 0; i < s->points; i++) {
        const double across = dot4(s->point[i].shape, v + s->point[i].first);
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
        for (int k = 0; k < 4; k++)
            f[p->first + k] += across * p->shape[k];
        axial += along;
    }
    return axial;
}
