/* rigid-clump.c -- a rigid body that contacts see as discs or balls of one radius, held together:
 * those of a list, or those below the surface of a box, as seed 003 makes its bodies.
 *
 * Mass and inertia are those of the volume: of the box, or of the union of the balls, where what
 * lies in several counts once.  Every ball touches every ball of another clump. */
#include "bodies/rigid-form.h"

#include "base/status.h"
#include "bodies/rigid-axes.h"
#include "shapes/ball-union.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BALLS = 2000 };

static bool is_box(const struct rigid_figure *f)
{
    return f->half[0] > 0;
}

static int take_ball(struct rigid_figure *to, const double *x)
{
    TRY(polytope_line(x, x, &to->kernel[to->kernels]));
    to->kernels++;
    return STATUS_DONE;
}

static int too_many(const char *path, double n)
{
    return status_fail(STATUS_BAD_SCENE, "%s: %.0f balls make this clump, and at most %d are allowed, as "
                       "each may touch each of another clump; set a larger pitch, or give fewer points",
                       path, n, MOST_BALLS);
}

/* Rows of balls below the faces of the box, which they touch from inside. */
static int fill(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    int count[DIM];
    double all = 1, within = 1;

    for (int k = 0; k < DIM; k++) {
        const double room = d->size[k] - 2 * d->radius;
        if (!(room > 0))
            return status_fail(STATUS_BAD_SCENE, "%s: balls of radius %g m do not fit into a side of %g m; "
                               "set a radius below half of it", path, d->radius, d->size[k]);
        count[k] = (int)fmin(MOST_BALLS, fmax(1, round(room / d->pitch))) + 1;
        all *= count[k];
        within *= count[k] - 2;
    }
    if (all - within > MOST_BALLS)
        return too_many(path, all - within);
    to->kernel = status_alloc((size_t)(all - within), sizeof *to->kernel);
    if (!to->kernel)
        return STATUS_FAILED;
    for (int i = 0; i < (int)all; i++) {
        double x[DIM];
        bool outer = false;
        for (int k = 0, rest = i; k < DIM; rest /= count[k++]) {
            const int j = rest % count[k];
            outer |= j == 0 || j == count[k] - 1;
            x[k] = ((double)j / (count[k] - 1) - 0.5) * (d->size[k] - 2 * d->radius);
        }
        if (outer)
            TRY(take_ball(to, x));
    }
    return STATUS_DONE;
}

/* Told from its centre of mass and along its axes of inertia. */
static int join(const double (*x)[DIM], int n, struct rigid_figure *to)
{
    struct polytope_moments m;
    double R[DIM][DIM];

    TRY(ball_union_moments(x, n, to->radius, &m));
    TRY(ball_union_surface(x, n, to->radius, &to->surface));
    to->volume = m.volume;
    memcpy(to->centre, m.centre, sizeof to->centre);
    TRY(rigid_axes(&m, to->gyration, to->frame, R));
    for (int i = 0; i < n; i++) {
        TRY(take_ball(to, x[i]));
        polytope_tell(&to->kernel[i], m.centre, R);
    }
    to->least = 2 * to->radius;
    return STATUS_DONE;
}

static int list(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    const int n = d->points.n;
    double (*x)[DIM];
    int code = STATUS_FAILED;

    if (n > MOST_BALLS)
        return too_many(path, n);
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
            low[k] = fmin(low[k], f->kernel[i].x[0][k] - f->radius);
            high[k] = fmax(high[k], f->kernel[i].x[0][k] + f->radius);
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
            below += f->kernel[i].x[0][k] - f->radius <= low[k] + 0.01 * f->radius;
            above += f->kernel[i].x[0][k] + f->radius >= high[k] - 0.01 * f->radius;
        }
        most = (int)fmax(most, fmax(below, above));
    }
    return most * (1 << (DIM - 1));
}

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    const bool listed = d->points.n > 0;
    double low[DIM], high[DIM];

    if (listed == (d->size[0] > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: a clump has either points, the centres of its balls, or "
                           "size, a box whose surface balls cover; give one of them", path);
    if (listed == (d->pitch > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: pitch, how far apart centres of balls are (m), belongs to "
                           "a clump with size, and there it is needed", path);
    if (!listed)
        TRY(rigid_form_box.measure(d, path, to));
    to->radius = d->radius;
    TRY((listed ? list : fill)(d, path, to));
    bounds(to, low, high);
    for (int i = 0; i < to->kernels; i++)
        to->reach = fmax(to->reach, polytope_reach(&to->kernel[i]) + to->radius);
    for (int k = 0; k < DIM; k++)
        to->span[k] = high[k] - low[k];
    to->together = most_together(to, low, high);
    return STATUS_DONE;
}

static double depth(const struct rigid_figure *f, const double *own)
{
    double most = -HUGE_VAL;

    if (is_box(f))
        return rigid_form_box.depth(f, own);
    for (int i = 0; i < f->kernels; i++) {
        double square = 0;
        for (int d = 0; d < DIM; d++)
            square += (own[d] - f->kernel[i].x[0][d]) * (own[d] - f->kernel[i].x[0][d]);
        most = fmax(most, f->radius - sqrt(square));
    }
    return most;
}

/* Water meets the box as it is; of a list, sites of a lattice near the surface of the balls. */
static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    double low[DIM], high[DIM], all = 1;
    int count[DIM];

    if (is_box(f))
        return rigid_form_box.skin(f, spacing, layers, to);
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
        core[i] = (struct core){ .ball = f->radius, .hull = &f->kernel[i] };
    return f->kernels;
}

/* Ball by ball: what of one lies in another is not seen. */
static int surface(const struct rigid_figure *f, struct surface *to)
{
    for (int i = 0; i < f->kernels; i++) {
        const int from = to->corners;
        TRY(rigid_form_round.surface(f, to));
        for (int k = from; k < to->corners; k++)
            for (int d = 0; d < DIM; d++)
                to->x[k][d] += f->kernel[i].x[0][d];
    }
    return STATUS_DONE;
}

const struct rigid_form rigid_form_clump = { .name = "clump", .keys = " radius ",
                                             .may = " points size pitch ", .rounds = true,
                                             .measure = measure, .skin = skin, .depth = depth,
                                             .cores = cores, .surface = surface };
