/* shape-kind.h -- the contract of a kind of shape: one const struct a kind, one line of the
 * table in shape.c.  Nobody else asks what kind a shape has. */
#ifndef SHAPES_SHAPE_KIND_H
#define SHAPES_SHAPE_KIND_H

#include "shapes/points.h"
#include "shapes/shape-rows.h"
#include "shapes/shape.h"

struct shape_kind {
    const char *name;
    const char *keys; /* that not all kinds take, a blank before and behind each */
    bool domain;      /* goes round the domain, whose lattice it continues       */
    int (*check)(struct shape *s, const char *path, const char *where);
    bool (*contains)(const struct shape *s, const double *x); /* half-open      */
    double (*depth)(const struct shape *s, const double *x);  /* of a point inside [m] */
    void (*bounds)(const struct shape *s, double *low, double *high); /* [DIM] [m] */
    double (*volume)(const struct shape *s); /* [m^3, 2D: m^2]                 */
    /* The lattice that fills it along its own axis d. */
    struct shape_rows (*rows)(const struct shape *s, int d, double dx);
    /* From its own axes, in which its lattice stands, to space and back; may be one place.
     * NULL: they are those of space. */
    void (*place)(const struct shape *s, const double *own, double *x);
    void (*own)(const struct shape *s, const double *x, double *own);
    /* Its length between two flat faces across its own axis d [m]; NULL: it has none. */
    double (*side)(const struct shape *s, int d);
    /* Points in layers along its outline (layers.h), and how large that is [m^2, 2D: m];
     * NULL: its lattice follows its sides already. */
    int (*layers)(const struct shape *s, double dx, long layers, struct points *to);
    double (*surface)(const struct shape *s);
    /* A corner list whose edges its layers may leave bare; NULL: none. */
    const struct param_points *(*edges)(const struct shape *s);
};

const struct shape_kind *shape_kind(const struct shape *s);

/* For their files. */
void shape_axis(const struct shape *s, double *axis); /* [3] of length 1 */
int shape_check_axis(const struct shape *s, const char *path, const char *where);
bool shape_is_place(const double *x); /* given, and no further than SHAPE_REACH */
bool shape_between(const double *low, const double *high, const double *x); /* half-open */
double shape_to_faces(const double *low, const double *high, const double *x); /* from inside [m] */

extern const struct shape_kind shape_box, shape_corners, shape_disc, shape_sphere, shape_frame,
    shape_cylinder, shape_hull;

#endif
