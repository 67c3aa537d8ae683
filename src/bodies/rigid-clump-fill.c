/* rigid-clump-fill.c -- where the balls of a clump are that is made from a shape: their centres lie as
 * deep below its surface as their radius is.
 *
 * Below faces of a box they stand in rows.  All others have layers of points for their skins, half a
 * spacing below the surface; the one of a shape that is larger or smaller by what is missing is
 * that of the balls. */
#include "bodies/rigid-clump-fill.h"

#include "base/status.h"
#include "bodies/rigid-figure.h"
#include "shapes/layers.h"
#include "shapes/layers-polytope.h"

#include <math.h>

int rigid_clump_fill_refuse(const char *path, double n)
{
    return status_fail(STATUS_BAD_SCENE, "%s: %.0f balls make this clump, and at most %d are allowed, as "
                       "each may touch each of another clump; set a larger pitch, or give fewer points",
                       path, n, RIGID_CLUMP_FILL_MOST);
}

static int no_room(const struct rigid_def *d, const char *path, double side)
{
    return status_fail(STATUS_BAD_SCENE, "%s: balls of radius %g m do not fit into a side of %g m; set a "
                       "radius below half of it", path, d->radius, side);
}

/* Rows of balls below the faces of the box. */
static int fill_box(const struct rigid_def *d, const char *path, struct points *to)
{
    int count[DIM];
    double all = 1, within = 1;

    for (int k = 0; k < DIM; k++) {
        const double room = d->size[k] - 2 * d->radius;
        if (!(room > 0))
            return no_room(d, path, d->size[k]);
        count[k] = (int)fmin(RIGID_CLUMP_FILL_MOST, fmax(1, round(room / d->pitch))) + 1;
        all *= count[k];
        within *= count[k] - 2;
    }
    if (all - within > RIGID_CLUMP_FILL_MOST)
        return rigid_clump_fill_refuse(path, all - within);
    for (int i = 0; i < (int)all; i++) {
        double x[DIM];
        bool outer = false;
        for (int k = 0, rest = i; k < DIM; rest /= count[k++]) {
            const int j = rest % count[k];
            outer |= j == 0 || j == count[k] - 1;
            x[k] = ((double)j / (count[k] - 1) - 0.5) * (d->size[k] - 2 * d->radius);
        }
        if (outer)
            TRY(points_add(to, x));
    }
    return STATUS_DONE;
}

/* Its corners, and even steps along its sides. */
static int along_sides(const struct polytope *p, double pitch, struct points *to)
{
    for (int i = 0; i < p->corners; i++) {
        const double *a = p->x[i], *b = p->x[(i + 1) % p->corners];
        double square = 0, x[DIM];
        for (int d = 0; d < DIM; d++)
            square += (b[d] - a[d]) * (b[d] - a[d]);
        const long steps = layers_steps(sqrt(square), pitch);
        for (long k = 0; k < steps; k++) {
            for (int d = 0; d < DIM; d++)
                x[d] = a[d] + (double)k / (double)steps * (b[d] - a[d]);
            TRY(points_add(to, x));
        }
    }
    return STATUS_DONE;
}

/* Of one convex part; layers of points are for space. */
static int fill_part(const struct rigid_def *d, const char *path, const struct polytope *part,
                     struct points *to)
{
    const double deep = DIM == 2 ? d->radius : d->radius - 0.5 * d->pitch;
    struct polytope smaller = { .x = NULL };
    double deepest;
    int code;

    TRY(polytope_deepest(part, &deepest));
    if (!(d->radius < 0.99 * deepest))
        return no_room(d, path, 2 * deepest);
    code = polytope_shrink(part, deep, &smaller);
    if (code == STATUS_DONE)
        code = DIM == 2 ? along_sides(&smaller, d->pitch, to) : layers_polytope(&smaller, d->pitch, 1, to);
    polytope_free(&smaller);
    return code;
}

/* Does a ball of that radius touch the side from corner a to corner b? */
static bool touched(const double *a, const double *b, double radius, const struct points *p)
{
    const double way[2] = { b[0] - a[0], b[1] - a[1] }, length = hypot(way[0], way[1]);
    bool found = false;

    for (int i = 0; !found && i < (int)p->n; i++) {
        const double off[2] = { p->x[i][0] - a[0], p->x[i][1] - a[1] };
        const double along = (off[0] * way[0] + off[1] * way[1]) / length;
        const double away = fabs(off[0] * way[1] - off[1] * way[0]) / length;
        found = along >= 0 && along <= length && away < 1.05 * radius;
    }
    return found;
}

static int side_bare(const struct rigid_def *d, const char *path, const double *a, const double *b)
{
    return status_fail(STATUS_BAD_SCENE, "%s: no ball of radius %g m touches the side of %g m between its corners "
                       "[%g, %g] and [%g, %g] (from the centre of mass), as the polygon is thinner there; set a smaller "
                       "radius", path, d->radius, hypot(b[0] - a[0], b[1] - a[1]), a[0], a[1], b[0], b[1]);
}

/* A row below the outline, dents included.  Other bodies would not feel a side without balls. */
static int fill_dented(const struct rigid_def *d, const char *path, const struct rigid_figure *outer,
                       struct points *to)
{
    const struct param_points *o = &outer->outline;

    TRY(layers_row(o, d->radius, d->pitch, to));
    for (int i = 0; i < o->n; i++) {
        const double *a = o->x[i], *b = o->x[(i + 1) % o->n];
        if (hypot(b[0] - a[0], b[1] - a[1]) > d->pitch && !touched(a, b, d->radius, to))
            return side_bare(d, path, a, b);
    }
    return STATUS_DONE;
}

int rigid_clump_fill(const struct rigid_def *d, const char *path, const struct rigid_figure *outer,
                     struct points *to)
{
    const double off = d->radius - 0.5 * d->pitch;
    const double about = outer->surface / pow(d->pitch, DIM - 1);
    struct rigid_figure other = *outer;

    if (outer->of == &rigid_form_box)
        return fill_box(d, path, to);
    if (about > 4 * RIGID_CLUMP_FILL_MOST)
        return rigid_clump_fill_refuse(path, about);
    if (outer->parts > 1)
        return fill_dented(d, path, outer, to);
    if (outer->parts == 1)
        return fill_part(d, path, outer->part, to);
    if (!(2 * d->radius < outer->least))
        return no_room(d, path, outer->least);
    other.radius -= off;
    for (int k = 0; k < DIM; k++)
        other.half[k] -= off;
    return outer->of->skin(&other, d->pitch, 1, to);
}
