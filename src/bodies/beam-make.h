/* beam-make.h -- what one beam holds, and how it is made. */
#ifndef BODIES_BEAM_MAKE_H
#define BODIES_BEAM_MAKE_H

#include "bodies/beam-def.h"
#include "bodies/beam-skin.h"
#include "bodies/bodies.h"

enum { BEAM_ROW_W, BEAM_ROW_THETA, BEAM_ROW_W_RATE, BEAM_ROW_THETA_RATE, BEAM_ROWS };

struct body {
    char path[64];
    double along[DIM], normal[DIM];
    double mass;               /* of all nodes                 [kg, 2D: kg/m]   */
    double gravity_along;      /* weight along the axis        [N, 2D: N/m]     */
    double rest_potential;     /* of the straight beam         [J, 2D: J/m]     */
    double thickness, speed;   /* scales of deflection and its rate [m], [m/s]  */
    double load_until;         /* [s], HUGE_VAL: never ends                     */
    bool trusted;              /* the scene itself says theory = "linear"       */
    enum kind skin_kind;
    struct body_surface surface;
    struct bending *bending;
    struct beam_skin *skin;
    int row[BEAM_ROWS];        /* of the layout                                 */
    double *weight, *pushed;   /* [dofs] loads: gravity across, prescribed      */
    double *memory;            /* of both                                       */
};

/* Vectors [dofs], entries (w, theta) node by node. */
struct body_work {
    double *q, *v;             /* [m], [rad] and rates                          */
    double *force, *resist;    /* F, K q + D v                                  */
    double *given, *rate;      /* M^-1 F, all of v'                             */
    double *inertia;           /* M v'                                          */
    double *predicted;         /* forces that (E4) goes by, but for the water's */
    double ahead;              /* its tau [s]                                   */
    double *memory;            /* of all of them                                */
    struct bending_work *bending;
};

/* Members of bodies_beam: see bodies.h. */
int beam_make(const void *params, const struct scales *s, const char *name, const char *path,
              struct body **out);
void beam_make_free(struct body **body);
int beam_make_work(const struct body *b, struct body_work **out);
void beam_make_work_free(struct body_work **work);

#endif
