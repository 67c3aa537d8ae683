/* solid-wall.c -- a wall as contacts see it: the figure of a rigid body, where its shape stands. */
#include "bodies/solid-wall.h"

#include "base/status.h"
#include "bodies/rigid-figure.h"
#include "shapes/shape-kind.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int solid_wall_most(const struct shape *s)
{
    enum { ROD_AND_PRISM = 2 };

    if (shape_goes_round(s))
        return 0;
    return s->points.n > ROD_AND_PRISM ? s->points.n : ROD_AND_PRISM;
}

/* The middle of its figure in its own axes; what has points stands where these say. */
static void middle(const struct shape *s, double *own)
{
    for (int d = 0; d < DIM; d++)
        if (s->kind == SHAPE_BOX)
            own[d] = 0.5 * (s->from[d] + s->to[d]);
        else if (s->kind == SHAPE_DISC || s->kind == SHAPE_SPHERE)
            own[d] = s->centre[d];
}

/* The same words name shapes of walls and of bodies. */
static void tell(const struct shape *s, struct rigid_def *d)
{
    *d = (struct rigid_def){ .shape = s->type, .density = 1, .points = s->points,
                             .radius = s->radius, .height = s->height };
    for (int k = 0; k < DIM && s->kind == SHAPE_BOX; k++)
        d->size[k] = s->to[k] - s->from[k];
    middle(s, d->at);
}

/* In space, of the place and the axes that its figure has in the shape's own. */
static void stand(const struct shape *s, const struct rigid_def *d, double least,
                  struct solid_place *to)
{
    const struct shape_kind *kind = shape_kind(s);
    double q[TURNING_NUMBERS];

    memcpy(to->x, d->at, sizeof to->x);
    rigid_def_turned(d, q);
    turning_matrix(q, to->R);
    if (!kind->place)
        return;
    kind->place(s, d->at, to->x);
    for (int k = 0; k < DIM; k++) {
        double own[DIM], at[DIM];
        memcpy(own, d->at, sizeof own);
        own[k] += least;
        kind->place(s, own, at);
        for (int i = 0; i < DIM; i++)
            to->R[i][k] = (at[i] - to->x[i]) / least;
    }
}

static int take_cores(struct solid_wall *w, double margin)
{
    const struct rigid_form *form = w->figure.form;

    if (form->kernels)
        TRY(form->kernels(&w->figure, margin));
    w->cores = form->cores(&w->figure, margin, NULL);
    w->core = status_alloc((size_t)w->cores, sizeof *w->core);
    if (!w->core)
        return STATUS_FAILED;
    form->cores(&w->figure, margin, w->core);
    return STATUS_DONE;
}

int solid_wall_make(const struct shape *s, const char *path, double margin, struct solid_wall *out)
{
    struct rigid_def d;

    *out = (struct solid_wall){ .cores = 0 };
    tell(s, &d);
    TRY(rigid_figure_make(&d, path, &out->figure));
    stand(s, &d, 0.5 * out->figure.least, &out->start);
    return take_cores(out, fmin(margin, 0.5 * out->figure.least));
}

void solid_wall_free(struct solid_wall *w)
{
    rigid_figure_free(&w->figure);
    free(w->core);
    *w = (struct solid_wall){ .cores = 0 };
}

void solid_wall_facts(const struct solid_wall *w, int i, const char *path, struct solid *out)
{
    solid_unmoved(path, out);
    out->core = w->core[i];
    out->start = w->start;
}
