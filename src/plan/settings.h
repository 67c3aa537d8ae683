/* settings.h -- the keys of a scene that belong to no part. */
#ifndef PLAN_SETTINGS_H
#define PLAN_SETTINGS_H

#include "base/param.h"
#include "shapes/shape.h"
#include "state/part.h"
#include <stdbool.h>

struct settings {
    const char *title;
    int dimension;
    double gravity[3];  /* [m/s^2]                                            */
    double until;       /* [s]                                                */
    double spacing;     /* dx [m]                                             */
    double particle_mass; /* [kg, 2D: kg/m]                                   */
    const char *method; /* "" : by whether there is a stiff side              */
    double tol;
    const char *norm;   /* one of vector_norm_words                            */
    double substep;     /* largest one of bodies in staggered and mri [s]     */
    const char *walls;  /* wall model                                         */
    const char *precision; /* of pairs: "double" or "single"                 */
};

struct settings_kernel {
    const char *type;
    const char *use[PART_KERNELS]; /* for densities, pressure, viscosity; "same": type */
    double support; /* H/dx */
    double skin;    /* Verlet margin of the pair list / H */
};

struct settings_domain {
    double from[3], to[3]; /* [m] */
    bool lid;
    unsigned open; /* sides without wall, bits of shape_side() */
    unsigned periodic; /* directions that repeat, bit d for number d */
};

struct settings_reference {
    double speed; /* U [m/s] */
};

struct settings_disturbance {
    double size; /* of the displacement of fluid particles at the start [dx] */
    int seed;
};

struct settings_pcisph { /* of the method pcisph */
    double limit;      /* compression that a step may leave [1]        */
    int least, most;   /* iterations of a step                         */
    double gain;       /* factor on delta [1]                          */
    const char *delta; /* "consistent" or "toth"                       */
};

struct settings_eos { /* beside the keys of the equation of state itself */
    const char *type;
    double lowest, highest; /* density bounds in rho0 */
    double fastest;         /* speed at which a run is given up, in c0 */
};

struct settings_output {
    double interval;  /* between rows of the CSV files [s]          */
    double fields;    /* between output fields [s]                  */
    double profiles;  /* between profiles of probes [s]             */
    double checkpoint;         /* between checkpoints [s], 0: none     */
    double checkpoint_minutes; /* the same by the clock [min]          */
    int snapshots;    /* pictures of the particles, start and end included */
};

struct settings_fluid {
    struct shape shape;
    int dye;
    const char *initial;  /* "hydrostatic", "rest" or "released"     */
    double surface;       /* height of its free surface [m]          */
    double velocity[3];   /* at the start [m/s]                      */
};

struct settings_wall {
    struct shape shape;
    bool slip;
    double surface[3];    /* velocity of its surface beside its motion [m/s] */
    double rim;           /* height at which the sides of a frame end; NaN [m] */
};

struct settings_probe {
    double at[3];
    const char *what;     /* "pressure", "height", "velocity"        */
    double to[3];         /* other end of a segment, other corner of a rectangle; NaN [m] */
    double radius;        /* of a disc around `at`; NaN              [m]      */
    double normal[3];     /* of the disc                             [1]      */
    double window;        /* of its running mean; 0: none            [s]      */
    bool profile;         /* whether its points are written one by one        */
};

struct settings_panel {
    const char *of;       /* name of a wall or beam                           */
    const char *side;     /* of a frame: one of shape_sides; "all"            */
    double from[3], to[3]; /* corners of a box around its particles at t = 0; NaN [m] */
    double about[3];      /* point of its moment                     [m]      */
    double along[3];      /* direction of its drag; 0: none          [1]      */
};

extern const struct param settings_params[], settings_kernel_params[], settings_domain_params[],
    settings_reference_params[], settings_disturbance_params[], settings_pcisph_params[],
    settings_eos_params[], settings_output_params[], settings_fluid_params[], settings_wall_params[],
    settings_probe_params[], settings_panel_params[];

/* Fills in the words that come from tables of other rooms; call first. */
void settings_prepare(const char *const *kernels, const char *const *eos,
                      const char *const *walls);

#endif
