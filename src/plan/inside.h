/* inside.h -- plan and moment as the files of this room see them. */
#ifndef PLAN_INSIDE_H
#define PLAN_INSIDE_H

#include "plan/engine.h"
#include "plan/input.h"
#include "plan/moment.h"
#include "plan/observe.h"
#include "plan/plan.h"

enum { PLAN_PARTS = 32, PLAN_FIELDS = 4 };

struct pairs_table;
struct viscous; /* plan/viscous.h */
struct face;    /* plan/face.h */
struct face_plan;
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
    int points;              /* that its skin would have                      */
    int skin;                /* points in the tank: without water none        */
};

struct plan_wall {
    struct walls_motion motion;
    bool moves;
    int object;
};

/* Rows of the layout. */
struct plan_rows {
    int x, u;                /* of the fluid, -1: none                        */
    int density[KINDS];      /* -1: none                                      */
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

/* Laws between kinds, [KINDS][KINDS] each; NULL: no such question can be asked. */
struct plan_tables {
    struct pairs_table *all;
    struct pairs_table *densities, *velocities; /* one half of the explicit side each */
    struct pairs_table *explicit, *implicit;    /* one side each; explicit is `all` where
                                                   all laws are                    */
    struct pairs_table *without_pressure;
};

struct plan {
    struct input in;
    struct scales scales;
    const struct engine *engine;
    struct kernel_use *kernel[PART_KERNELS]; /* one may serve several uses   */
    int parts, slots;
    struct plan_part part[PLAN_PARTS];
    const struct plan_part *pressure;  /* NULL: none                          */
    const struct plan_part *drifter;   /* whose carry() gives drift; NULL: none */
    const struct plan_part *stiff;     /* the viscosity that is implicit; NULL: none */
    bool walls_as_fluid;               /* solids get their density as the fluid */
    bool mixed;                        /* a law belongs to both halves        */
    bool moving_walls;
    int fields;
    struct plan_field field[PLAN_FIELDS]; /* in the order in which they are summed */
    int bodies, walls;
    struct plan_body *body;
    struct plan_wall *wall;
    struct particles *particles;       /* at t = 0                            */
    struct layout layout;              /* likewise                            */
    struct plan_rows row;
    struct plan_book book;
    struct plan_tables table;
    struct face_plan *face;            /* where the fluid sticks; NULL: where solids'
                                          particles are                       */
    struct list_def list_def;
};

/* A body at a moment. */
struct moment_body {
    const struct body_kind *kind;
    const struct body *body;
    struct body_work *work;
    int object, skin;        /* as in struct plan_body                        */
    double (*force)[DIM];    /* [points][DIM] of the last evaluation [N]      */
    struct body_load load;   /* likewise                                      */
};

/* What an evaluation works in: read while it lasts.  A moment made beside another shares
 * that one's, as one evaluation is over before the next. */
struct workspace {
    double *record;  /* [slots][RECORD], 64-byte aligned                      */
    size_t slots;    /* room for so many; with images it may grow             */
    double *f;       /* [n][DIM] by slot; of the fluid only what struct sum_rates
                        leaves there                                          */
    double *drho;    /* [n] likewise                                          */
    double *power;   /* [slots]                                               */
    double *rho;     /* [n] densities that fields give, creation order; NULL  */
    double (*sum)[PART_SUMS]; /* [n] of a field, by slot; NULL without fields */
    double (*drift)[DIM];     /* [fluid][DIM] beside velocities [m/s]; NULL   */
    double (*points)[DIM];    /* [points of any body][DIM] scratch            */
    double *rates;   /* [size] of an evaluation that is only looked at        */
    struct sum_scratch scratch;
};

/* What refusals, and looks for runaways, named last. */
enum moment_complaint { MOMENT_TOO_FAST, MOMENT_DENSITY_OUT, MOMENT_PLACE_LOST,
                        MOMENT_COMPLAINTS };
struct moment_culprit {
    bool known;
    int who;   /* creation index                                             */
    double t;  /* [s]                                                        */
};

struct moment {
    const struct plan *plan;
    struct moment *beside;             /* the run's, whose work it shares; NULL: its own */
    struct moment *observer;           /* made at the first look              */
    struct layout layout;
    struct particles *particles;       /* solids stand where they are now     */
    struct list *list, *own;           /* of the evaluation; its own          */
    struct workspace *work;
    struct moment_body *body;          /* [bodies]                            */
    double (*force)[DIM];              /* [objects][DIM] on solids [N]        */
    double wall_power;                 /* v . f of moving walls [W]           */
    double pull[DIM];                  /* of fields beside the weight [N]     */
    double density_low, density_high;  /* bounds, beyond them it refuses      */
    struct viscous *viscous;           /* of the run's                        */
    struct face *face;
    char refusal[400];
    struct moment_culprit culprit[MOMENT_COMPLAINTS];
    struct moment_counts counts;
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

/* book.c: its rows. */
int plan_book_rows(struct plan *p);

/* start.c */
void plan_start_density(const struct plan *p, double *y);
double plan_start_speed(const struct plan *p); /* largest of the fluid at t = 0 [m/s] */

/* memory.c: bytes that a particle of the fluid, or of a solid, will need. */
double plan_memory_each(const struct plan *p, bool fluid);

/* workspace.c: zeroed numbers on cache lines; the memory of an evaluation; after a rebuild
 * there may be more images. */
double *workspace_lines(size_t numbers);
int workspace_create(const struct plan *p, struct workspace **out);
void workspace_free(struct workspace **w);
int workspace_fit(struct workspace *w, const struct list *l);

/* moment.c: another moment of the run's plan, for looking. */
int moment_create_beside(struct moment *run, struct moment **out);

/* view.c: moves solids to (t, y) and says where everything is, but for densities
 * that are summed. */
void moment_view(struct moment *m, double t, const double *y, struct view *v);

/* Where particle c (creation index) is in the domain: "(x, y)" in metres. */
void moment_place(const struct moment *m, const struct view *v, int c, char text[PLAN_PLACE]);

/* pack.c: records of these kinds (bits) in list order.  STATUS_FAILED: refused. */
int moment_pack(struct moment *m, const struct view *v, unsigned kinds);

/* fields.c: list and records of this moment, and the densities in v that are
 * summed.  STATUS_FAILED: refused. */
int moment_fields(struct moment *m, struct view *v);

/* rates.c: sums over pairs by these laws; force of the fluid on each solid, and the
 * power of driven walls; forces on the points of one skin.  push: see struct sum_job; it
 * is added to.  apart: see struct ask; forces of the implicit law by slot. */
struct rates_job {
    const struct pairs_table *table;
    double ahead;         /* see struct ask */
    double (*push)[DIM];
    struct sum_rates to;
    double *apart;
};
int rates_sum(struct moment *m, const struct rates_job *job);
void rates_of_solids(struct moment *m);
void rates_of_skin(const struct moment *m, struct moment_body *b);

/* The explicit side, or what of it was asked for; of the implicit side, laws of pairs but
 * not the stiff side of bodies.  apart: forces of the implicit law by slot, with their
 * power in *power; NULL. */
int rates_eval(struct moment *m, const struct ask *ask, double t, const double *y, double *ydot,
               double *apart, double *power);

/* book.c */
void book_rates(const struct moment *m, double *ydot);

#endif
