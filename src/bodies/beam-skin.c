/* beam-skin.c -- points that the water meets, carried by a bending beam.
 * Checked in tests/unit/beam*.c. */
#include "bodies/beam-skin.h"

#include "base/status.h"
#include "bodies/element.h"
#include <math.h>
#include <stdlib.h>

static void place(const struct beam_skin_def *d, double along, double eta,
                  struct beam_skin_point *p)
{
    const double l = d->length / d->elements;
    double slope[4]; /* of no use here */
    int e = (int)(along / l);

    if (e > d->elements - 1)
        e = d->elements - 1;
    p->first = 2 * e;
    element_shape(along / l - e, l, p->shape, slope);
    for (int i = 0; i < DIM; i++)
        p->rest[i] = d->at[i] + along * d->along[i] + eta * d->normal[i];
}

int beam_skin_create(const struct beam_skin_def *def, struct beam_skin **out)
{
    const int rows = def->spacing > 0 ? (int)fmax(1, round(def->length / def->spacing)) : 0;
    struct beam_skin *s = status_alloc(1, sizeof *s);
    int n = 0;

    if (!s)
        return STATUS_FAILED;
    s->def = *def;
    s->points = rows * def->layers;
    s->point = status_alloc((unsigned long)s->points, sizeof *s->point);
    if (!s->point) {
        beam_skin_free(&s);
        return STATUS_FAILED;
    }
    for (int j = 0; j < rows; j++)
        for (int k = 0; k < def->layers; k++)
            place(def, (j + 0.5) * def->length / rows,
                  (k - (def->layers - 1) / 2.0) * def->spacing, &s->point[n++]);
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
