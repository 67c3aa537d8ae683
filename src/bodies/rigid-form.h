/* rigid-form.h -- the contract of a shape of rigid bodies: one const struct a shape, one line of
 * the table in rigid-figure.c. */
#ifndef BODIES_RIGID_FORM_H
#define BODIES_RIGID_FORM_H

#include "bodies/core.h"
#include "bodies/rigid-def.h"
#include "shapes/points.h"
#include "shapes/surface.h"

/* What follows from a shape.  All of it stands in the body's own frame, that of its centre of mass
 * and its axes of inertia, but for centre and frame. */
struct rigid_figure {
    const struct rigid_form *form;
    double volume, surface;          /* [m^3, 2D: m^2], [m^2, 2D: m]                 */
    double span[DIM], least, reach;  /* sides of a box around it; shortest way through; from the
                                        centre to the farthest place [m]            */
    double gyration[TURNING_SPINS];  /* moments of inertia by mass [m^2]            */
    double centre[DIM];              /* where the scene's frame has the centre [m]  */
    double frame[4];                 /* 3D: how that has its axes, a quaternion     */
    double half[DIM], radius;        /* of a box, cylinder; of disc, sphere, cylinder [m] */
    const struct rigid_form *of;     /* that a clump is made from; NULL: a list      */
    double ball;                     /* radius of each ball of a clump [m]           */
    double together;                 /* balls of a clump that touch at once, at most  */
    struct param_points outline;     /* 2D: of a polygon, anticlockwise [m]          */
    int parts, kernels;
    struct polytope *part;           /* [parts] convex ones that make it             */
    struct polytope *kernel;         /* [kernels] what cores have of them            */
};

struct rigid_form {
    const char *name;
    const char *keys;                /* that it needs, a blank before and behind each */
    const char *may;                 /* that it may have besides; NULL: none          */
    bool faces;                      /* of a box, below which water may press        */
    bool rounds;                     /* it has no edges that a margin could round    */

    /* Refuses (BAD_SCENE) what makes no body; fills in all of *to, which is zeroed, but for form,
     * frame and what polytopes say.  What it takes is freed by rigid_figure_free(). */
    int (*measure)(const struct rigid_def *d, const char *path, struct rigid_figure *to);

    /* Adds places of a skin: layers from half a spacing below its surface on. */
    int (*skin)(const struct rigid_figure *f, double spacing, int layers, struct points *to);

    double (*depth)(const struct rigid_figure *f, const double *own); /* outside below 0 [m] */

    /* Makes the polytopes of its cores, edges rounded by `margin` [m].  NULL: it needs none. */
    int (*kernels)(struct rigid_figure *f, double margin);

    /* What contacts take it for: fills core, which may be NULL, and returns how many. */
    int (*cores)(const struct rigid_figure *f, double margin, struct core *core);

    /* What pictures show of it: adds to *to, in its own frame.  Round ones are polygons whose corners
     * lie on the circle.  NULL: its convex parts, or without them a box of its span. */
    int (*surface)(const struct rigid_figure *f, struct surface *to);
};

extern const struct rigid_form rigid_form_box, rigid_form_round, rigid_form_clump;
extern const struct rigid_form rigid_form_polygon;                   /* in the plane */
extern const struct rigid_form rigid_form_cylinder, rigid_form_hull, rigid_form_compound; /* in space */

#endif
