/* rigid-box.c -- a rigid body that is a box. */
#include "bodies/rigid-form.h"

#include "base/status.h"

#include <math.h>

static int measure(const struct rigid_def *d, const char *path, struct rigid_figure *to)
{
    double square = 0;

    to->volume = 1;
    to->least = HUGE_VAL;
    for (int i = 0; i < DIM; i++) {
        to->span[i] = d->size[i];
        to->half[i] = 0.5 * d->size[i];
        to->least = fmin(to->least, d->size[i]);
        to->volume *= d->size[i];
        square += 0.25 * d->size[i] * d->size[i];
    }
    if (!(to->least > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: a side of %g m makes no box; set size, %d numbers "
                           "above 0 (m)", path, to->least, DIM);
    to->reach = sqrt(square);
    for (int i = 0; i < DIM; i++)
        to->surface += 2 * to->volume / d->size[i];
    for (int i = 0; i < TURNING_SPINS; i++) {
        const double a = d->size[(i + 1) % DIM], b = d->size[DIM == 2 ? 0 : (i + 2) % DIM];
        to->gyration[i] = (a * a + b * b) / 12;
    }
    return STATUS_DONE;
}

/* Rows that its sides are whole numbers of. */
static int skin(const struct rigid_figure *f, double spacing, int layers, struct points *to)
{
    int count[DIM], all = 1;

    for (int k = 0; k < DIM; k++) {
        count[k] = (int)fmax(1, round(f->span[k] / spacing));
        all *= count[k];
    }
    for (int i = 0; i < all; i++) {
        double x[DIM];
        bool shallow = false;
        for (int k = 0, rest = i; k < DIM; rest /= count[k++]) {
            const int j = rest % count[k];
            shallow |= j < layers || count[k] - 1 - j < layers;
            x[k] = ((j + 0.5) / count[k] - 0.5) * f->span[k];
        }
        if (shallow)
            TRY(points_add(to, x));
    }
    return STATUS_DONE;
}

static double depth(const struct rigid_figure *f, const double *own)
{
    double least = HUGE_VAL;

    for (int d = 0; d < DIM; d++)
        least = fmin(least, f->half[d] - fabs(own[d]));
    return least;
}

static int cores(const struct rigid_figure *f, double margin, struct core *core)
{
    if (core)
        *core = (struct core){ .ball = margin };
    for (int d = 0; core && d < DIM; d++)
        core->half[d] = f->half[d] - margin;
    return 1;
}

const struct rigid_form rigid_form_box = { .name = "box", .keys = " size ", .faces = true,
                                           .measure = measure, .skin = skin, .depth = depth,
                                           .cores = cores };
