/* elastica-make.h -- what one beam that bends far holds, and how it is made. */
#ifndef BODIES_ELASTICA_MAKE_H
#define BODIES_ELASTICA_MAKE_H

#include "bodies/beam-def.h"
#include "bodies/bodies.h"
#include "bodies/elastica.h"
#include "bodies/follower-skin.h"

struct body { /* of this kind */
    char path[64];
    double along[DIM], normal[DIM];
    double mass;               /* of all nodes                 [kg, 2D: kg/m]   */
    double rest_potential;     /* of the straight beam         [J, 2D: J/m]     */
    double turning_load;       /* that turns with the beam     [N/m, 2D: N/m^2] */
    double turning_force;      /* at the tip, likewise         [N, 2D: N/m]     */
    double load_until;         /* [s], HUGE_VAL: never ends                     */
    enum kind skin_kind;
    struct body_surface surface;
    struct elastica *beam;
    struct follower_skin *skin;
    int row[2 * ELASTICA_NODE]; /* of the layout: positions, then rates         */
    double *start, *start_rate; /* [dofs] q and v at t = 0                      */
    double *weight, *pushed;   /* [dofs] loads that keep their direction        */
    double *memory;            /* of all four                                   */
};

/* Vectors [dofs], in the order of elastica.h. */
struct body_work { /* of this kind */
    double *q, *v;             /* [m], [1] and rates                            */
    double *given;             /* prescribed loads here and now                 */
    double *force, *resist;    /* F, dE/dq + D v                                */
    double *load, *rate;       /* M^-1 F, all of v'                             */
    double *inertia;           /* M v'                                          */
    double *predicted;         /* forces that (E4) goes by, but for the water's */
    double ahead;              /* its tau [s]                                   */
    double *memory;            /* of all of them                                */
    struct elastica_work *beam;
};

/* Members of bodies_elastica: see bodies.h. */
int elastica_make(const void *params, const struct scales *s, const char *name, const char *path,
                  struct body **out);
void elastica_make_free(struct body **body);
int elastica_make_work(const struct body *b, struct body_work **out);
void elastica_make_work_free(struct body_work **work);

extern const struct body_watch elastica_make_watch;

#endif
