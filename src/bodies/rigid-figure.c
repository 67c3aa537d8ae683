/* rigid-figure.c -- what follows from the shape of a rigid body: size, inertia, cores. */
#include "bodies/rigid-figure.h"

#include "base/status.h"
#include "bodies/rigid-axes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct rigid_form *const forms[] = {
    &rigid_form_box, &rigid_form_round, &rigid_form_clump,
#if DIM == 2
    &rigid_form_polygon,
#else
    &rigid_form_cylinder, &rigid_form_hull, &rigid_form_compound,
#endif
};

enum { FORMS = sizeof forms / sizeof *forms };

const struct rigid_form *rigid_figure_form(const char *name)
{
    for (int i = 0; i < FORMS; i++)
        if (strcmp(forms[i]->name, name) == 0)
            return forms[i];
    return forms[0];
}

/* Keys that only some shapes take: is each where it belongs? */
int rigid_figure_keys(const struct rigid_form *form, const struct rigid_def *d, const char *path)
{
    double size = 0;

    for (int i = 0; i < DIM; i++)
        size = fmax(size, d->size[i]);
    const struct {
        const char *word, *name, *wanted;
        bool given;
    } key[] = {
        { " size ", "size", DIM == 2 ? "two sides (m)" : "three sides (m)", size > 0 },
        { " radius ", "radius", "a number above 0 (m)", d->radius > 0 },
        { " height ", "height", "a length along its axis (m)", d->height > 0 },
        { " points ", "points", "its corners (m)", d->points.n > 0 },
        { " corners ", "corners", "how many points make a part", d->corners > RIGID_DEF_CORNERS },
        { " pitch ", "pitch", "a distance of balls (m)", d->pitch > 0 },
        { " of ", "of", "a shape", d->of && strcmp(d->of, "box") != 0 },
        { " body_radius ", "body_radius", "that of what it is made from (m)", d->body_radius > 0 },
    };
    for (int i = 0; i < (int)(sizeof key / sizeof *key); i++) {
        const bool takes = strstr(form->keys, key[i].word) != NULL;
        if (takes && !key[i].given)
            return status_fail(STATUS_BAD_SCENE, "%s: without %s it is no %s; set %s, %s", path,
                               key[i].name, form->name, key[i].name, key[i].wanted);
        const bool may = form->may && strstr(form->may, key[i].word);
        if (!takes && !may && key[i].given)
            return status_fail(STATUS_BAD_SCENE, "%s: a %s has no %s; leave it out, or choose another "
                               "shape", path, form->name, key[i].name);
    }
    if (d->uplift && !form->faces)
        return status_fail(STATUS_BAD_SCENE, "%s: uplift is for the flat faces of a box, and this is "
                           "a %s; leave it out", path, form->name);
    return STATUS_DONE;
}

/* To the centre of mass and the axes of inertia. */
static void retell(const struct rigid_figure *f, struct rigid_def *d)
{
    double q[TURNING_NUMBERS], R[DIM][DIM];

    rigid_def_turned(d, q);
    turning_matrix(q, R);
    for (int i = 0; i < DIM; i++)
        for (int k = 0; k < DIM; k++)
            d->at[i] += R[i][k] * f->centre[k];
    memcpy(d->frame, f->frame, sizeof d->frame);
#if DIM == 3
    double spin[3] = { 0 };
    if (!turning_known(f->frame))
        return;
    turning_matrix(f->frame, R);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            spin[k] += R[i][k] * d->spin[i];
    memcpy(d->spin, spin, sizeof spin);
#endif
}

int rigid_figure_make(struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    int code;

    *to = (struct rigid_figure){ .form = rigid_figure_form(d->shape) };
    code = rigid_figure_keys(to->form, d, path);
    if (code == STATUS_DONE)
        code = to->form->measure(d, path, to);
    if (code == STATUS_DONE)
        code = rigid_def_check(d, to->volume, path);
    if (code == STATUS_DONE)
        retell(to, d);
    else
        rigid_figure_free(to);
    return code;
}

void rigid_figure_free(struct rigid_figure *f)
{
    for (int i = 0; i < f->parts; i++)
        polytope_free(&f->part[i]);
    for (int i = 0; i < f->kernels; i++)
        polytope_free(&f->kernel[i]);
    free(f->part);
    free(f->kernel);
    free(f->outline.x);
    f->part = f->kernel = NULL;
    f->outline = (struct param_points){ .n = 0 };
    f->parts = f->kernels = 0;
}

double rigid_figure_mass(const struct rigid_figure *f, const struct rigid_def *d)
{
    return d->mass > 0 ? d->mass : d->density * f->volume;
}

void rigid_figure_inertia(const struct rigid_figure *f, double mass, double *to)
{
    for (int i = 0; i < TURNING_SPINS; i++)
        to[i] = mass * f->gyration[i];
}

bool rigid_figure_holds(const struct rigid_figure *f, const struct rigid_def *d, const double *x)
{
    double q[TURNING_NUMBERS], R[DIM][DIM], own[DIM] = { 0 };

    rigid_def_turned(d, q);
    turning_matrix(q, R);
    for (int k = 0; k < DIM; k++)
        for (int i = 0; i < DIM; i++)
            own[k] += R[i][k] * (x[i] - d->at[i]);
    return f->form->depth(f, own) >= 0;
}

/* Volume, centre and second moments of all parts together. */
static void sum_parts(const struct rigid_figure *f, struct polytope_moments *all)
{
    struct polytope_moments m;

    *all = (struct polytope_moments){ .volume = 0 };
    for (int i = 0; i < f->parts; i++) {
        polytope_moments(&f->part[i], &m);
        all->volume += m.volume;
        for (int d = 0; d < DIM; d++)
            all->centre[d] += m.volume * m.centre[d];
    }
    for (int d = 0; d < DIM; d++)
        all->centre[d] /= all->volume;
    for (int i = 0; i < f->parts; i++) {
        polytope_moments(&f->part[i], &m);
        for (int d = 0; d < DIM; d++)
            for (int k = 0; k < DIM; k++)
                all->second[d][k] += m.second[d][k] + m.volume * (m.centre[d] - all->centre[d])
                                                               * (m.centre[k] - all->centre[k]);
    }
}

static void tell_outline(struct rigid_figure *f)
{
    for (int i = 0; i < f->outline.n; i++)
        for (int d = 0; d < DIM; d++)
            f->outline.x[i][d] -= f->centre[d];
}

static void span_corners(struct rigid_figure *f)
{
    double low[DIM], high[DIM];

    for (int d = 0; d < DIM; d++) {
        low[d] = HUGE_VAL;
        high[d] = -HUGE_VAL;
    }
    for (int i = 0; i < f->parts; i++)
        for (int k = 0; k < f->part[i].corners; k++)
            for (int d = 0; d < DIM; d++) {
                low[d] = fmin(low[d], f->part[i].x[k][d]);
                high[d] = fmax(high[d], f->part[i].x[k][d]);
            }
    for (int d = 0; d < DIM; d++)
        f->span[d] = high[d] - low[d];
}

int rigid_figure_measure(struct rigid_figure *f)
{
    struct polytope_moments all;
    double R[DIM][DIM], deepest;

    sum_parts(f, &all);
    f->volume = all.volume;
    memcpy(f->centre, all.centre, sizeof f->centre);
    TRY(rigid_axes(&all, f->gyration, f->frame, R));
    for (int i = 0; i < f->parts; i++) {
        polytope_tell(&f->part[i], all.centre, R);
        f->reach = fmax(f->reach, polytope_reach(&f->part[i]));
        TRY(polytope_deepest(&f->part[i], &deepest));
        f->least = fmax(f->least, 2 * deepest);
    }
    tell_outline(f);
    span_corners(f);
    return STATUS_DONE;
}

int rigid_figure_kernels(struct rigid_figure *f, double margin)
{
    f->kernel = status_alloc((size_t)f->parts + 1, sizeof *f->kernel);
    if (!f->kernel)
        return STATUS_FAILED;
    for (int i = 0; i < f->parts; i++) {
        double deepest;
        TRY(polytope_deepest(&f->part[i], &deepest));
        TRY(polytope_shrink(&f->part[i], fmin(margin, 0.5 * deepest), &f->kernel[i]));
        f->kernels++;
    }
    return STATUS_DONE;
}

int rigid_figure_surface(const struct rigid_figure *f, struct surface *to)
{
    double half[DIM];

    if (f->form->surface)
        return f->form->surface(f, to);
    for (int i = 0; i < f->parts; i++)
        TRY(surface_polytope(to, &f->part[i]));
    for (int d = 0; d < DIM; d++)
        half[d] = 0.5 * f->span[d];
    return f->parts > 0 ? STATUS_DONE : surface_box(to, half);
}

/* Its ball reaches from the face of the kernel to that of the part. */
static struct core core_of(const struct rigid_figure *f, int i, double margin)
{
    const struct polytope *k = &f->kernel[i];
    double ball = k->faces > 0 ? HUGE_VAL : margin;

    for (int c = 0; c < k->corners && k->faces > 0; c++)
        ball = fmin(ball, polytope_depth(&f->part[i], k->x[c]));
    return (struct core){ .ball = ball, .hull = k };
}

int rigid_figure_cores(const struct rigid_figure *f, double margin, struct core *core)
{
    for (int i = 0; core && i < f->parts; i++)
        core[i] = core_of(f, i, margin);
    return f->parts;
}
