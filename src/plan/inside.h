/* inside.h -- the plan as the files of this room see it. */
#ifndef PLAN_INSIDE_H
#define PLAN_INSIDE_H

#include "plan/engine.h"
#include "plan/input.h"
#include "plan/observe.h"
#include "plan/plan.h"

enum { PLAN_PARTS = 32, PLAN_FIELDS = 4 };

struct pairs_table;
struct viscous; /* plan/viscous.h */
struct face;    /* plan/face.h */
struct kernel_use;

struct plan_part {
    const struct part *part;
    void *self;
    char path[80]; /* "effects.continuity", "eos"                             */
    int slot;      /* row of power it is booked in, -1: none                  */
};

struct plan_body {
    const struct body_kind *kind;
    struct body *body;
    char name[64], path[80];
    int object;              /* its skin in particles->object, -1: no skin   */
    int skin;                /* points                                        */
    double (*force)[DIM];    /* [skin][DIM] of the last right-hand side [N]   */
    double (*seen)[DIM];     /* the same of the last look from outside        */
    struct body_load load;   /* of the last right-hand side                   */
};

struct plan_wall {
    struct walls_motion motion;
    bool moves;
    int object;
};

/* Where the quadratures of the book stand in its row of y. */
struct plan_book {
    int row;      /* of the layout                                            */
    int work;     /* [slots] energy each pair part gave                       */
    int walls;    /* energy that driven walls gave                            */
    int damping;  /* [bodies] energy that damping took (negative)             */
    int driven;   /* [bodies] energy that prescribed loads gave               */
    int impulse;  /* [objects][DIM] on solids                                 */
    int support;  /* [bodies][DIM] impulse of supports                        */
    int applied;  /* [bodies][DIM] impulse of prescribed loads                */
    int pull;     /* [DIM] impulse of fields beside the weight                */
    int n;
};

/* A density that is summed before there are forces. */
struct plan_field {
    const struct plan_part *part;
    unsigned meets[KINDS]; /* partner kinds by owner kind                     */
};

/* What one evaluation of the pair sums works in.  The observer has a list of its
 * own; the rest it shares with the run, as one evaluation is over before the next. */
struct plan_workspace {
    struct list *list;
    double *record;  /* [slots][RECORD], 64-byte aligned                      */
    size_t slots;    /* room for so many; with images it may grow             */
    double *f;       /* [n][DIM] by slot; of the fluid only what struct sum_rates
                        leaves there                                          */
    double *drho;    /* [n] likewise                                          */
    double *power;   /* [slots]                                               */
    double *apart;   /* [n][DIM] lent while one pass is for both sides: f of the
                        implicit law by slot; else NULL                       */
    double power_apart; /* of that law                                        */
    double *rho;     /* [n] densities that fields give, creation order; NULL  */
    double (*sum)[PART_SUMS]; /* [n] of a field, by slot; NULL without fields */
    struct sum_scratch scratch;
};

/* Whom refusals, and looks for runaways, named last. */
enum plan_complaint { PLAN_TOO_FAST, PLAN_DENSITY_OUT, PLAN_PLACE_LOST, PLAN_COMPLAINTS };
struct plan_culprit {
    bool known;
    int who;   /* creation index                                             */
    double t;  /* [s]                                                        */
};

struct plan {
    struct input in;
    struct scales scales;
    const struct engine *engine;
    struct kernel_use *kernel[PART_KERNELS]; /* one may serve several uses   */
    int parts, slots;
    struct plan_part part[PLAN_PARTS];
    const struct plan_part *pressure;  /* NULL: none                          */
    bool walls_as_fluid;               /* solids get their density as the fluid */
    const struct plan_part *drifter;   /* whose carry() gives drift; NULL: none */
    double (*drift)[DIM];              /* [fluid][DIM] [m/s]                  */
    int fields;
    struct plan_field field[PLAN_FIELDS]; /* in the order in which they are summed */
    int bodies, walls;
    struct plan_body *body;
    struct plan_wall *wall;
    struct particles *particles;
    struct layout layout;
    int row_x, row_u;                  /* of the fluid, -1: none              */
    int density_row[KINDS];            /* -1: none                            */
    struct plan_book book;
    struct pairs_table *table;         /* [KINDS][KINDS] all laws             */
    struct pairs_table *rates, *forces; /* those of one half of the explicit side */
    struct pairs_table *explicit, *implicit; /* those of one side; explicit is table
                                          where all laws are                  */
    const struct plan_part *stiff;     /* the viscosity that is implicit, NULL: none */
    struct viscous *viscous;           /* its solver                          */
    struct face *face;                 /* where the fluid sticks; NULL: where solids'
                                          particles are                       */
    bool mixed;                        /* a law belongs to both halves        */
    struct list_def list_def;
    struct plan_workspace main, observer; /* observer made at the first look  */
    double (*force)[DIM];              /* [objects][DIM] on solids [N]        */
    double *scratch;                   /* [size] rates for the observer       */
    double later;                      /* of the half that is asked for, see
                                          plan_half()                         */
    double wall_power;                 /* v . f of moving walls [W]           */
    double pull[DIM];                  /* of fields beside the weight [N]     */
    bool moving_walls;
    char refusal[400];
    struct plan_culprit culprit[PLAN_COMPLAINTS];
    struct plan_counts counts;
};

/* scales.c: p->scales from what was read; the kernels' share comes later. */
int plan_scales_make(struct plan *p, struct scene *scene);

/* objects.c: bodies with their forces; then all particles; then which objects walls and
 * skins are, and the dye of fluids. */
int plan_bodies_make(struct plan *p);
int plan_objects_fill(struct plan *p);
int plan_objects_name(struct plan *p);

/* agree.c: refuses parts that do not go together. */
int plan_agree(const struct plan *p, const struct scene *scene);

/* tables.c: tables of laws, by lane-free arithmetic on pointers; fields. */
int plan_tables_make(struct plan *p);
void plan_fields_make(struct plan *p);

/* workspace.c: zeroed numbers on cache lines; the memory of an evaluation. */
double *plan_lines(size_t numbers);
int plan_workspace_make(struct plan *p, struct plan_workspace *w);
void plan_workspace_free(struct plan *p, struct plan_workspace *w);
int plan_workspace_fit(struct plan *p, struct plan_workspace *w); /* after a rebuild */
int plan_observer_make(struct plan *p);
void plan_observer_free(struct plan *p);

/* memory.c: bytes that a particle of the fluid, or of a solid, will need. */
double plan_memory_each(const struct plan *p, bool fluid);

/* pack.c: records of these kinds (bits) in list order.  STATUS_FAILED: refused. */
int plan_pack(struct plan *p, struct plan_workspace *w, const struct view *v, unsigned kinds);

/* fields.c: list and records of this moment, and the densities in v that are
 * summed.  STATUS_FAILED: refused. */
int plan_fields(struct plan *p, struct plan_workspace *w, struct view *v);

/* rates.c: sums over pairs by these laws; force of the fluid on each solid, and the
 * power of driven walls; forces on the points of one skin.  push: see struct sum_job; it
 * is added to. */
int plan_sum(struct plan *p, struct plan_workspace *w, const struct pairs_table *table,
             double (*push)[DIM], struct sum_rates to);
void plan_solids_sum(struct plan *p, const struct plan_workspace *w);
void plan_skin_force(const struct plan *p, const struct plan_workspace *w, struct plan_body *b);

/* The explicit side, one half of it or (PLAN_ALL) all but the stiff side of bodies
 * into ydot, with this workspace. */
int plan_rates(struct plan *p, struct plan_workspace *w, enum plan_which which, double t,
               const double *y, double *ydot);

/* view.c: moves solids to (t, y) and says where everything is, but for densities
 * that are summed. */
void plan_view_make(struct plan *p, double t, const double *y, struct view *v);

/* Where particle c (creation index) is in the domain: "(x, y)" in metres. */
void plan_place(const struct plan *p, const struct view *v, int c, char text[PLAN_PLACE]);

/* book.c */
int plan_book_rows(struct plan *p);
void plan_book_rates(const struct plan *p, const struct plan_workspace *w, double *ydot);

/* start.c */
void plan_start_density(const struct plan *p, double *y);
double plan_start_speed(const struct plan *p); /* largest of the fluid at t = 0 [m/s] */

#endif
