/* hull.c -- `stiffwater hull': the points of a convex hull, of the surface in an STL file. */
#include "cli/cli.h"

#include "base/status.h"
#include "shapes/polytope.h"
#include "shapes/stl.h"

#if DIM == 3

enum { FACES = 1000 }; /* as many as a scene takes, shape_hull_make() */

/* Leaves out those that are nearer than `merge` to one before. */
static void thin_out(struct polytope *p, double merge)
{
    int kept = 0;

    for (int i = 0; i < p->corners; i++) {
        bool is_new = true;
        for (int k = 0; k < kept && is_new; k++) {
            double square = 0;
            for (int d = 0; d < DIM; d++)
                square += (p->x[i][d] - p->x[k][d]) * (p->x[i][d] - p->x[k][d]);
            is_new = !(square < merge * merge);
        }
        for (int d = 0; d < DIM && is_new; d++)
            p->x[kept][d] = p->x[i][d];
        kept += is_new;
    }
    p->corners = kept;
}

static int hull_of(const char *path, const double (*x)[DIM], int n, struct polytope *to)
{
    TRY(polytope_hull(x, n, to));
    if (to->corners == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: its corners lie in one plane, or nearly so, and have no "
                           "hull; is --merge too large?", path);
    return STATUS_DONE;
}

static void print(const char *path, const struct polytope *p, long triangles)
{
    struct polytope_moments m;

    polytope_moments(p, &m);
    printf("// Convex hull of %s: %ld triangles; %d corners and %d faces here, %.6g m^3, %.6g m^2.\n", path,
           triangles, p->corners, p->faces, m.volume, polytope_surface(p));
    printf("// Its centre is (%.6g, %.6g, %.6g).\n", m.centre[0], m.centre[1], m.centre[2]);
    printf("points = (\n");
    for (int i = 0; i < p->corners; i++)
        printf("    [%.9g, %.9g, %.9g]%s\n", p->x[i][0], p->x[i][1], p->x[i][2],
               i < p->corners - 1 ? "," : "");
    printf(");\n");
}

static int make(const struct cli *c, struct points *all, struct polytope *first, struct polytope *last)
{
    TRY(stl_read(c->subject, all));
    for (long i = 0; i < all->n; i++)
        for (int d = 0; d < DIM; d++)
            all->x[i][d] *= c->hull.scale;
    TRY(hull_of(c->subject, (const double (*)[DIM])all->x, (int)all->n, first));
    thin_out(first, c->hull.merge);
    TRY(hull_of(c->subject, (const double (*)[DIM])first->x, first->corners, last));
    if (last->faces > FACES)
        return status_fail(STATUS_BAD_SCENE, "%s: its hull has %d faces, and a scene takes at most %d; make "
                           "one of corners that are further apart: --merge LENGTH (m)", c->subject,
                           last->faces, FACES);
    return STATUS_DONE;
}

int cli_hull(const struct cli *c)
{
    struct points all = { .n = 0 };
    struct polytope first = { .x = NULL }, last = { .x = NULL };
    const int code = make(c, &all, &first, &last);

    if (code == STATUS_DONE)
        print(c->subject, &last, all.n / 3);
    points_free(&all);
    polytope_free(&first);
    polytope_free(&last);
    return code;
}

#else

int cli_hull(const struct cli *c)
{
    return status_fail(STATUS_BAD_SCENE, "%s: hulls are shapes in three dimensions, which `stiffwater hull` "
                       "knows; this is the program for two", c->subject);
}

#endif
