/* beam-def.h -- a beam as a scene gives it, and what follows from that. */
#ifndef BODIES_BEAM_DEF_H
#define BODIES_BEAM_DEF_H

#include "base/param.h"
#include "bodies/bending.h"
#include "bodies/skin.h"
#include "state/scales.h"

struct beam_def {
    const char *theory;        /* "auto", "linear", "elastica"                */
    double at[3];              /* root                                   [m]  */
    double angle;              /* of the axis, root to tip, from +x      [deg] */
    double length, thickness;  /* [m]                                         */
    double E, nu;              /* [Pa], [1]                                   */
    const char *plane;         /* "none", "stress", "strain"                  */
    double density, mass;      /* [kg/m^3], [kg, 2D: kg/m]; 0: not given      */
    int elements;
    const char *inertia;       /* "consistent", "lumped", "lumped-ends"       */
    const char *root, *tip;    /* "clamped", "pinned", "free"                 */
    double alpha, beta;        /* Rayleigh damping [1/s], [s]                 */
    double damping_ratio;      /* of the first mode, adds to alpha; elastica: to beta */
    double drag;               /* of every node, (45) [N s/m and N m s, 2D: per metre of width] */
    int layers;                /* of the skin; 0: as many as the kernel needs */
    bool slip;
    bool contact;              /* its skin touches solids                     */
    double restitution, friction; /* where it does                            */
    const char *response;      /* "own", "predicted"                          */
    double tip_force;          /* across [N, 2D: N/m]                         */
    double load;               /* across, per length [N/m, 2D: N/m^2]         */
    double load_until;         /* [s]; 0: for ever                            */
    bool follower;             /* tip_force and load turn with the beam       */
    double bent, bent_rate;    /* at t = 0: turn of the tip [deg], [deg/s]    */
};

extern const struct param beam_def_params[];

/* Refuses (BAD_SCENE) what cannot stand; path is "beam.NAME". */
int beam_def_check(const struct beam_def *d, const char *path);

/* Does the scene ask for theory = "elastica"? */
bool beam_def_far(const struct beam_def *d);

/* Does it ask for response = "predicted"? */
bool beam_def_predicted(const struct beam_def *d);

/* EI, mass per length, ends and damping, of a def that passed the check. */
struct bending_def beam_def_bending(const struct beam_def *d);

/* Stiffness against stretch EA [N, 2D: N/m]. */
double beam_def_axial(const struct beam_def *d);

/* Unit vectors along the axis and across it (turned by +90 degrees), exact at
 * multiples of 90 degrees. */
void beam_def_axes(const struct beam_def *d, double *along, double *across);

/* Potential energy of the straight beam, all of whose nodes have mass [kg, 2D: kg/m]
 * together [J, 2D: J/m]: nodes spread evenly have their centre in the middle, whichever
 * mass matrix. */
double beam_def_potential(const struct beam_def *d, const struct scales *s, double mass);

/* Layers cover the kernel's support unless the scene says how many; warns of too few. */
struct skin_def beam_def_skin(const struct beam_def *d, const struct scales *s, const char *path);

#endif
