/* bodies.h -- things that move by themselves and carry a skin of particles.
 *
 * A kind of body is a const struct in the table of this room.  The state of a
 * body lives in y, in blocks that it adds to the layout; its skin is a range of
 * particles of kind KIND_SKIN or KIND_SKIN_SLIP, moved by move() and pressed
 * by the fluid through load(), its exact transpose.
 *
 * A contract in layers: every kind has the core, struct body_kind.  A kind whose rates
 * are too fast for explicit steps has an implicit side besides; one that moves with an
 * implicit viscosity in one solve has a part in that, too, and so has one in the solve of a
 * pressure that looks ahead.  Pointers to layers that a kind does not have are NULL.
 *
 * A body is const as soon as its blocks are known.  What its members work in during a run
 * is a struct body_work that the caller brings: two works of one body may be in use at
 * the same time.  What a work keeps saves time and changes no result by a bit, but for
 * join(), whose matrix joined() solves with. */
#ifndef BODIES_BODIES_H
#define BODIES_BODIES_H

#include "bodies/group.h"
#include "state/part.h"

struct surface;

struct solid;
struct solid_place;
struct body;      /* one body of a kind                                        */
struct body_work; /* what members of that kind work in: scratch and caches     */

struct body_load { /* what load() reports, all [N, 2D: N/m], [N m] */
    double damping;      /* power taken by damping [W], never positive; of what moves by (E4)
                            all that it takes from the body's own energy      */
    double driven;       /* power put in by prescribed loads [W]               */
    double support[DIM]; /* force of the supports on the body [N]              */
    double applied[DIM]; /* force of prescribed loads [N]                      */
};

struct body_view { /* for output: displacements of chosen points */
    double tip[DIM], mid[DIM]; /* displacement [m]                             */
    double tip_angle;          /* [rad]                                        */
    double root_force;         /* shear force at the root [N, 2D: N/m]         */
    double root_moment;        /* bending moment at the root [N m, 2D: N]      */
    double section;            /* height of a rectangular section there, for the stress
                                  6 M/h^2 (of 1 m of width); 0: it has none [m] */
};

/* Where a rigid body is, how it moves and what pushes it; space's axes but for the spin. */
struct body_pose {
    double x[DIM], v[DIM];  /* of its centre [m], [m/s]                          */
    double turn[4];         /* 2D: its angle [rad]; 3D: a quaternion of length 1, w first */
    double spin[3];         /* 2D: the first [rad/s]; 3D: in the frame of the body */
    double force[DIM];      /* of the fluid [N, 2D: N/m]                         */
    double moment[3];       /* of that about the centre, 2D: the last [N m, 2D: N] */
    double contact[DIM];    /* force of what it touches [N, 2D: N/m]             */
    double support[DIM];    /* of what holds or drives it, and of its springs    */
};

struct body_kind;

struct body_identity { /* for scenes and for readers */
    const char *name, *about, *equation, *source;
    const char *group;          /* scene group: "beam", "body"                 */
    size_t size;                /* of its parameter struct                     */
    const struct param *params;
    const struct body_group *groups; /* of keys inside of it; NULL: none           */

    /* Another kind with the same parameters that these ask for; NULL: never another. */
    const struct body_kind *(*choose)(const void *params);
};

struct body_making { /* free and work_free: a pointer to NULL is welcome */
    /* Refuses (BAD_SCENE) what cannot stand; `path` is "beam.NAME". */
    int (*create)(const void *params, const struct scales *s, const char *name,
                  const char *path, struct body **out);
    void (*free)(struct body **body);

    /* All the memory that members will ever need. */
    int (*work)(const struct body *b, struct body_work **out);
    void (*work_free)(struct body_work **work);
};

/* Rates that explicit steps follow at a price only: f_I, beside what load() gives. */
struct body_implicit {
    /* q' = v, v' = -M^-1 (K q + D v), ADDED to its blocks of ydot. */
    void (*stiff)(const struct body *b, struct body_work *w, const struct layout *l, double t,
                  const double *y, double *ydot);

    /* Finds z with z - gamma f_I(t, z) = r in its own blocks; others untouched.  A guess
     * comes in through z; STATUS_FAILED when none is found from there. */
    int (*solve)(const struct body *b, struct body_work *w, const struct layout *l, double t,
                 double gamma, const double *r, double *z);

    /* The fastest rate of f_I, for methods that take it explicitly. */
    void (*limit)(const struct body *b, struct limit *out);

    /* Frequency of its slowest vibration, which lasts [rad/s]; 0, or NULL: there is none. */
    double (*swing)(const struct body *b);
};

/* The same where the fluid's viscosity is implicit, too, and pulls at the skin by
 * forces that are linear in velocities.  A solver of the whole (implicit/viscous.h) has
 * the body's part of it by v [unknowns], the velocities of its blocks:
 *   B v - gamma S^T (forces on the skin) = right,  positions = r + gamma v */
struct body_coupled {
    int (*unknowns)(const struct body *b);
    void (*read)(const struct body *b, const struct layout *l, const double *y, double *v);
    void (*write)(const struct body *b, const struct layout *l, double gamma, const double *r,
                  const double *v, double *z);
    void (*right)(const struct body *b, struct body_work *w, const struct layout *l,
                  double gamma, const double *r, double *to);
    void (*inertia)(const struct body *b, struct body_work *w, double gamma, const double *v,
                    double *to);                                          /* B v */
    void (*drift)(const struct body *b, const double *v, double (*u)[DIM]); /* S v */
    void (*pull)(const struct body *b, struct body_work *w, const double (*force)[DIM],
                 double c, double *to);                    /* adds c S^T force   */

    /* Ready to solve B + gamma S^T (c of each point) S, in place, by this work. */
    int (*join)(const struct body *b, struct body_work *w, double gamma, const double *c);
    void (*joined)(const struct body *b, const struct body_work *w, double *v);
    double (*fastest)(const struct body *b, const double *v); /* of its points [m/s] */

    /* Rates by forces on the skin alone: adds M^-1 S^T force to its blocks of ydot, and
     * what the support gives against them [N, 2D: N/m] to `support`. */
    void (*yield)(const struct body *b, struct body_work *w, const struct layout *l,
                  const double (*force)[DIM], double *ydot, double support[DIM]);

    /* The same support after a solve: with the acceleration that (z - r)/gamma has
     * beyond that of stiff(), so that momentum closes however inexact the solve. */
    void (*settle)(const struct body *b, struct body_work *w, const struct layout *l,
                   double gamma, const double *r, const double *z, const double (*force)[DIM],
                   double support[DIM]);
};

/* What a skin is where it touches solids. */
struct body_surface {
    bool touches;
    double restitution, friction; /* as keys of a rigid body                      */
    int across;                   /* points of a row of it; rows one after the other */
};

/* What a run asks between its steps, and contacts at the start. */
struct body_watch {
    /* Next time after t at which f jumps (a load ends), HUGE_VAL: never [s].  NULL: never. */
    double (*event)(const struct body *b, double t);

    /* Is its theory still good at y?  STATUS_FAILED, with advice: no run should go on from
     * here; else `doubt` is what readers should hear, or "".  NULL: it is good for all y. */
    int (*judge)(const struct body *b, const struct layout *l, double t, const double *y,
                 char *doubt, size_t room);

    /* How far it would bend if water at the reference speed hit it, in parts of what its theory
     * allows; 0: not at all, or it may.  NULL: it is good for all y. */
    double (*foresee)(const struct body *b, const struct scales *s);

    /* Is point i of its skin beside a support, where it may turn into what holds the body?
     * NULL: none is. */
    bool (*held)(const struct body *b, int i);

    /* Of a body that is no solid: how does its skin touch solids?  NULL: never. */
    const struct body_surface *(*surface)(const struct body *b);

    /* Is x inside of it as it stands at the start?  NULL: it is no wider than its points. */
    bool (*holds)(const struct body *b, const double *x);

    /* For output; force as in show().  NULL: it is no rigid body. */
    void (*pose)(const struct body *b, struct body_work *w, const struct layout *l,
                 const double *y, const double (*force)[DIM], struct body_pose *out);

    /* Of a rigid body: what pictures show of it, in its own frame; adds to *to.  How that stands:
     * role.solid. */
    int (*look)(const struct body *b, struct surface *to);

    /* Of a rigid body: do joints, a motion or springs give it forces?  NULL: none is rigid. */
    bool (*tied)(const struct body *b);
};

/* What it is to a pressure that looks ahead by tau, (E3), which predicts a body as it does
 * the water: by one step of backward Euler,
 *   (M + tau D + tau^2 K) a = S^T force + loads - K (q + tau v) - D v              (E4)
 * with the matrices of q as it is now.  The other two go by the last set(). */
struct body_ahead {
    bool moves; /* load() has its rates by (E4), too: no other pressure goes with it */

    /* Ready at (t, y).  STATUS_FAILED, without a failure kept: the matrix is not finite. */
    int (*set)(const struct body *b, struct body_work *w, const struct layout *l, double t,
               double tau, const double *y);

    /* Accelerations of its points a [skin][DIM] [m/s^2] by force [skin][DIM] and all else,
     * with what they have at constant v. */
    void (*drive)(const struct body *b, struct body_work *w, const double (*force)[DIM],
                  double (*a)[DIM]);

    /* By force alone: linear in it, symmetric, positive semidefinite. */
    void (*yield)(const struct body *b, struct body_work *w, const double (*force)[DIM],
                  double (*a)[DIM]);
};

/* Forces of contacts on a solid: load() adds them to those of the fluid. */
struct body_push {
    double force[DIM];   /* [N, 2D: N/m]                                         */
    double moment[3];    /* about the centre, in its own frame; 2D: the first [N m, 2D: N] */
    double by_walls[DIM]; /* the part of the force that walls give               */
};

/* What contacts ask of a body that keeps its shape. */
struct body_solid {
    int (*solids)(const struct body *b); /* that it is for them, fixed to each other */
    void (*facts)(const struct body *b, int i, struct solid *out); /* of one of these */
    double (*depth)(const struct body *b, const double *own); /* of a place in its frame below
                                                         its surface; outside below 0 [m] */
    void (*stand)(const struct body *b, const struct layout *l, const double *y,
                  struct solid_place *out);
    void (*push)(struct body_work *w, const struct body_push *push); /* until the next one */
};

struct body_role { /* what others may take it for */
    const struct body_coupled *coupled; /* NULL: in no solve with implicit viscosity */
    const struct body_ahead *ahead;     /* NULL: no pressure may look ahead          */
    const struct body_solid *solid;     /* NULL: contacts do not know its shape      */
};

struct body_kind {
    struct body_identity identity;
    struct body_making make;

    /* The number of its points; x [skin][DIM] at rest and their kind, NULL: not asked. */
    int (*skin)(const struct body *b, double (*x)[DIM], enum kind *kind);

    /* Adds its blocks; the last that changes a body.  As many velocities as positions, in
     * the same order: methods like "dv" step positions by velocities alone. */
    int (*rows)(struct body *b, struct layout *l);
    void (*start)(const struct body *b, const struct layout *l, double *y); /* y at t = 0 */

    /* Skin at this state: x, u [skin][DIM]. */
    void (*move)(const struct body *b, struct body_work *w, const struct layout *l, double t,
                 const double *y, double (*x)[DIM], double (*u)[DIM]);

    /* Explicit rates, all blocks of ydot set: of velocities M^-1 (N^T force + weight +
     * prescribed loads), of positions q' = v, or, with an implicit side, 0: there it is
     * stiff() that adds v.  force [skin][DIM]. */
    void (*load)(const struct body *b, struct body_work *w, const struct layout *l, double t,
                 const double *y, const double (*force)[DIM], double *ydot,
                 struct body_load *out);

    /* The fastest rate of load(), which every method takes explicitly.  NULL: it never
     * limits a step. */
    void (*limit)(const struct body *b, struct limit *out);

    void (*energy)(const struct body *b, struct body_work *w, const struct layout *l,
                   const double *y, struct energies *to); /* adds to it */
    void (*momentum)(const struct body *b, struct body_work *w, const struct layout *l,
                     const double *y, double *p);         /* adds to p [DIM] */
    double (*weight)(const struct body *b);               /* its mass [kg, 2D: kg/m] */

    /* force [skin][DIM] as in load(); y and t of the same moment. */
    void (*show)(const struct body *b, struct body_work *w, const struct layout *l, double t,
                 const double *y, const double (*force)[DIM], struct body_view *out);

    const struct body_implicit *implicit; /* NULL: it makes no plan stiff          */
    struct body_role role;
    const struct body_watch *watch;       /* NULL: f never jumps, all is allowed   */
};

extern const struct body_kind *const bodies_table[]; /* NULL-ended */
extern const struct body_kind bodies_beam;           /* src/bodies/beam.c, DIM 2 only */
extern const struct body_kind bodies_beam_predicted; /* the same, chosen by response  */
extern const struct body_kind bodies_elastica;       /* elastica-body.c, chosen by theory */
extern const struct body_kind bodies_elastica_predicted; /* by theory and response       */
extern const struct body_kind bodies_rigid;           /* rigid.c                      */

#endif
