/* rigid-clump.c -- a rigid body that contacts see as discs or balls of one radius, held together:
 * those of a list, or those below the surface of another shape, as seed 003 makes its bodies.
 *
 * Mass and inertia are those of the volume: of that shape, or of the union of the balls, where what
 * lies in several counts once.  Every ball touches every ball of another clump. */
#include "bodies/rigid-figure.h"

#include "base/status.h"
#include "bodies/rigid-axes.h"
#include "bodies/rigid-clump-fill.h"
#include "shapes/ball-union.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int take_ball(struct rigid_figure *to, const double *x)
{
    TRY(polytope_line(x, x, &to->kernel[to->kernels]));
    to->kernels++;
    return STATUS_DONE;
}

/* Below the surface of a shape. */
static int fill(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    struct points centre = { .n = 0 };
    int code = rigid_clump_fill(d, path, to, &centre);

    if (code == STATUS_DONE && centre.n > RIGID_CLUMP_FILL_MOST)
        code = rigid_clump_fill_refuse(path, (double)centre.n);
    if (code == STATUS_DONE) {
        to->kernel = status_alloc((size_t)centre.n + 1, sizeof *to->kernel);
        code = to->kernel ? STATUS_DONE : STATUS_FAILED;
    }
    for (long i = 0; code == STATUS_DONE && i < (long)centre.n; i++)
        code = take_ball(to, centre.x[i]);
    free(centre.x);
    return code;
}

/* Told from its centre of mass and along its axes of inertia. */
static int join(const double (*x)[DIM], int n, struct rigid_figure *to)
{
    struct polytope_moments m;
    double R[DIM][DIM];

    TRY(ball_union_moments(x, n, to->ball, &m));
    TRY(ball_union_surface(x, n, to->ball, &to->surface));
    to->volume = m.volume;
    memcpy(to->centre, m.centre, sizeof to->centre);
    TRY(rigid_axes(&m, to->gyration, to->frame, R));
    for (int i = 0; i < n; i++) {
        TRY(take_ball(to, x[i]));
        polytope_tell(&to->kernel[i], m.centre, R);
    }
    to->least = 2 * to->ball;
    return STATUS_DONE;
}

static int list(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    const int n = d->points.n;
    double (*x)[DIM];
    int code = STATUS_FAILED;

    if (n > RIGID_CLUMP_FILL_MOST)
        return rigid_clump_fill_refuse(path, n);
    x = status_alloc((size_t)n, sizeof *x);
    to->kernel = status_alloc((size_t)n, sizeof *to->kernel);
    for (int i = 0; x && i < n; i++)
        memcpy(x[i], d->points.x[i], sizeof *x);
    if (x && to->kernel)
        code = join((const double (*)[DIM])x, n, to);
    free(x);
    return code;
}

/* Of the box around the balls. */
static void bounds(const struct rigid_figure *f, double *low, double *high)
{
    for (int k = 0; k < DIM; k++) {
        low[k] = HUGE_VAL;
        high[k] = -HUGE_VAL;
        for (int i = 0; i < f->kernels; i++) {
            low[k] = fmin(low[k], f->kernel[i].x[0][k] - f->ball);
            high[k] = fmax(high[k], f->kernel[i].x[0][k] + f->ball);
        }
    }
}

/* Balls that a plane touches at once along one of its axes, at most; each of them is held by as
 * many as surround a pocket, where two clumps meet. */
static double most_together(const struct rigid_figure *f, const double *low, const double *high)
{
    int most = 1;

    for (int k = 0; k < DIM; k++) {
        int below = 0, above = 0;
        for (int i = 0; i < f->kernels; i++) {
            below += f->kernel[i].x[0][k] - f->ball <= low[k] + 0.01 * f->ball;
            above += f->kernel[i].x[0][k] + f->ball >= high[k] - 0.01 * f->ball;
        }
        most = (int)fmax(most, fmax(below, above));
    }
    return most * (1 << (DIM - 1));
}

/* A clump is either a list of balls, or made from a shape, whose keys it has then. */
static int check(const struct rigid_def *d, const char *path, const struct rigid_form *of, bool listed)
{
    const bool round = strstr(of->keys, " radius ") != NULL;

    if (of == &rigid_form_box && listed == (d->size[0] > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: a clump has either points, the centres of its balls, or "
                           "size, a box whose surface balls cover, or `of`, another shape; give one of them",
                           path);
    if (round != (d->body_radius > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: body_radius, of what a clump is made from (m), belongs to a "
                           "clump of a disc, sphere or cylinder, and there it is needed", path);
    if (listed == (d->pitch > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: pitch, how far apart centres of balls are (m), belongs to "
                           "a clump that is made from a shape, and there it is needed", path);
    return STATUS_DONE;
}

/* The shape it is made from, which calls its radius by that name. */
static int measure_outer(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    struct rigid_def outer = *d;
    char name[100];

    outer.radius = d->body_radius;
    outer.pitch = outer.body_radius = 0;
    outer.of = NULL;
    snprintf(name, sizeof name, "%s (of = \"%s\")", path, d->of);
    TRY(rigid_figure_keys(to->of, &outer, name));
    return to->of->measure(&outer, path, to);
}

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    const struct rigid_form *of = rigid_figure_form(d->of);
    const bool listed = d->points.n > 0 && of == &rigid_form_box;
    double low[DIM], high[DIM];

    TRY(check(d, path, of, listed));
    to->of = listed ? NULL : of;
    if (!listed)
        TRY(measure_outer(d, path, to));
    to->ball = d->radius;
    TRY((listed ? list : fill)(d, path, to));
    bounds(to, low, high);
    for (int i = 0; i < to->kernels; i++)
        to->reach = fmax(to->reach, polytope_reach(&to->kernel[i]) + to->ball);
    for (int k = 0; k < DIM; k++)
        to->span[k] = high[k] - low[k];
    to->together = most_together(to, low, high);
    return STATUS_DONE;
}

static double depth(const struct rigid_figure *f, const double *own)
{
    double most = -HUGE_VAL;

    if (f->of)
        return f->of->depth(f, own);
    for (int i = 0; i < f->kernels; i++) {
        double square = 0;
        for (int d = 0; d < DIM; d++)
            square += (own[d] - f->kernel[i].x[0][d]) * (own[d] - f->kernel[i].x[0][d]);
        most = fmax(most, f->ball - sqrt(square));
    }
    return most;
}

/* Water meets the shape as it is; of a list, sites of a lattice near the surface of the balls. */
static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    double low[DIM], high[DIM], all = 1;
    int count[DIM];

    if (f->of)
        return f->of->skin(f, spacing, layers, to);
    bounds(f, low, high);
    for (int k = 0; k < DIM; k++) {
        count[k] = (int)fmax(1, round(f->span[k] / spacing));
        all *= count[k];
    }
    for (int i = 0; i < (int)all; i++) {
        double x[DIM], deep;
        for (int k = 0, rest = i; k < DIM; rest /= count[k++])
            x[k] = low[k] + (rest % count[k] + 0.5) / count[k] * f->span[k];
        deep = depth(f, x);
        if (deep > 0 && deep < layers * spacing)
            TRY(points_add(to, x));
    }
    return STATUS_DONE;
}

/* Balls, without edges: a margin rounds nothing. */
static int cores(const struct rigid_figure *f, double margin, struct core *core)
{
    (void)margin;
    for (int i = 0; core && i < f->kernels; i++)
        core[i] = (struct core){ .ball = f->ball, .hull = &f->kernel[i] };
    return f->kernels;
}

/* Ball by ball: what of one lies in another is not seen. */
static int surface(const struct rigid_figure *f, struct surface *to)
{
    const struct rigid_figure ball = { .radius = f->ball };

    for (int i = 0; i < f->kernels; i++) {
        const int from = to->corners;
        TRY(rigid_form_round.surface(&ball, to));
        for (int k = from; k < to->corners; k++)
            for (int d = 0; d < DIM; d++)
                to->x[k][d] += f->kernel[i].x[0][d];
    }
    return STATUS_DONE;
}

const struct rigid_form rigid_form_clump = { .name = "clump", .keys = " radius ",
                                             .may = " points size pitch body_radius height of ", .rounds = true,
                                             .measure = measure, .skin = skin, .depth = depth,
                                             .cores = cores, .surface = surface };
