/* inside.h -- a plan as the rooms that evaluate it see it. */
#ifndef PLAN_INSIDE_H
#define PLAN_INSIDE_H

#include "bodies/contacts.h"
#include "plan/engine.h"
#include "plan/facts.h"
#include "plan/input.h"
#include "plan/passes.h"
#include "plan/plan.h"
#include "plan/survey.h"

enum { PLAN_PARTS = 32, PLAN_FIELDS = 4, PLAN_PASSES = 32 };

struct pairs_table;
struct kernel_use;

struct plan_part {
    const struct part *part;
    void *self;
    char path[80]; /* "effects.continuity", "eos"                             */
    int slot;      /* column of power it is booked in, -1: none               */
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
    struct motion motion;
    bool moves;
    int object;
};

/* Rows of the layout. */
struct plan_rows {
    int x, u;                /* of the fluid, -1: none                        */
    int density[KINDS];      /* -1: none                                      */
};

/* A part of a solid whose force is told apart. */
struct plan_panel {
    const char *name;        /* of the scene's; lent                          */
    int n, *id;              /* [n] its particles, ids of all kinds, ascending */
    double about[3];         /* of its moment                        [m]      */
    double along[3];         /* direction of its drag, of length 1; 0: none   */
};

/* Where the quadratures of the book stand in its row of y, and of which parts of solids it
 * keeps impulses. */
struct plan_book {
    int row;      /* of the layout                                            */
    int work;     /* [columns] energy each pair part gave                     */
    int walls;    /* energy that driven walls gave                            */
    int damping;  /* [bodies] energy that damping took (negative)             */
    int driven;   /* [bodies] energy that prescribed loads gave               */
    int impulse;  /* [objects + panels][DIM] on solids and parts of them      */
    int support;  /* [bodies][DIM] impulse of supports                        */
    int applied;  /* [bodies][DIM] impulse of prescribed loads                */
    int pull;     /* [DIM] impulse of body forces beside the weight           */
    int contacts; /* [columns] energy that contacts between bodies gave       */
    int dissipated; /* [0 or 1] energy that a pressure that looks ahead took   */
    int solved;   /* [solved_works] energy that corrections of the method gave,
                     plan/solver.h                                            */
    int solved_works;
    int n;
    int panels;
    struct plan_panel *panel; /* [panels]                                     */
};

/* A density that is summed before there are forces. */
struct plan_field {
    const struct plan_part *part;
    unsigned meets[KINDS]; /* partner kinds by owner kind                     */
};

/* What an evaluation is made of. */
struct plan_passes {
    int fields;
    struct plan_field field[PLAN_FIELDS]; /* in the order of their parts       */
    const struct plan_part *press;        /* the wall model, if solids press by more than
                                             their density; NULL               */
    bool filters;                         /* a part replaces densities at times */
    int n;
    struct plan_pass pass[PLAN_PASSES];   /* in the order in which they run    */
};

/* Contacts between bodies. */
struct plan_contacts {
    const struct body_contacts *kind; /* NULL: none                            */
    struct contacts *self;
    int columns;                      /* of the book; without contacts 0       */
};

/* What a viscosity does at the faces of solids, eval/face.h. */
struct plan_face {
    const struct plan_part *part; /* the viscosity                              */
    bool mirrored;                /* sticks at faces; else only some slide      */
    bool turns;                   /* some wall does                             */
    unsigned acts[KINDS];         /* the fluid and what it sticks to            */
};

/* Laws between kinds, [KINDS][KINDS] each; NULL: no such question can be asked. */
struct plan_tables {
    struct pairs_table *all;
    struct pairs_table *densities, *velocities; /* one half of the explicit side each */
    struct pairs_table *explicit, *implicit;    /* one side each; explicit is `all` where
                                                   all laws are                    */
    struct pairs_table *without_pressure;
    bool mixed;                /* a law belongs to both halves             */
    struct kernel_use *kernel[PART_KERNELS]; /* in the precision of pairs; or the plan's */
    double mass;               /* of all particles [kg, 2D: kg/m]; 0: they differ */
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
    bool moving_walls;
    struct plan_passes passes;
    int bodies, walls;
    struct plan_body *body;
    struct plan_wall *wall;
    struct plan_contacts contacts;
    struct particles *particles;       /* at t = 0                            */
    struct layout layout;              /* likewise                            */
    struct plan_rows row;
    struct plan_book book;
    struct plan_tables table;
    struct plan_face *face;            /* where the fluid sticks; NULL: where solids'
                                          particles are                       */
    struct list_def list_def;
    const struct plan_solver *solver;  /* of the implicit viscosity; NULL: none */
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

/* scales.c: p->scales from what was read; the kernels' share comes later. */
int plan_scales_make(struct plan *p, struct scene *scene);
void plan_scales_density(struct plan *p); /* after parts are prepared */

/* objects.c: bodies; then all particles; then which objects walls and
 * skins are, and the dye of fluids. */
int plan_bodies_make(struct plan *p);
int plan_objects_fill(struct plan *p);
/* Counts them by their shapes instead, for a survey. */
int plan_objects_count(struct plan *p, struct plan_survey *to);
int plan_objects_name(struct plan *p);

/* contacts.c: of a plan whose bodies are made. */
int plan_contacts_make(struct plan *p);

/* survey.c: of a plan whose bodies are made. */
int plan_survey_take(struct plan *p, struct plan_survey *s);

/* panels.c: which particles the panels have; after all particles. */
int plan_panels_make(struct plan *p);
void plan_panels_free(struct plan *p);

/* agree.c: refuses parts that do not go together. */
int plan_agree(const struct plan *p, const struct scene *scene);

/* ahead.c: the time that the pressure looks ahead [s], 0: not at all; refuses what a pressure
 * that does so cannot go with. */
double plan_ahead(const struct plan *p);
int plan_ahead_agree(const struct plan *p, const struct scene *scene);

/* list.c: list_def, of a plan whose tables are made. */
void plan_list_make(struct plan *p);

/* tables.c: tables of laws, by lane-free arithmetic on pointers; summed densities. */
int plan_tables_make(struct plan *p);
void plan_fields_make(struct plan *p);

/* book-rows.c: where the book stands in y. */
int plan_book_rows(struct plan *p);

/* sticking.c: p->face, when the scene asks for it and has solids to stick to. */
int plan_face_make(struct plan *p, const struct scene *scene);

/* Is the viscosity at faces the one that is implicit? */
bool plan_face_implicit(const struct plan *p);

/* press.c: passes.press, and what that wall model keeps of the places of solids, which all ranks measure
 * together where all make this plan. */
int plan_press_make(struct plan *p, bool together);
void plan_press_free(struct plan *p);

/* start.c: densities at t = 0; pressure that a solid's particle at x starts with [Pa];
 * densities of solids in y, those of their pressures, become what their wall model has then. */
void plan_start_density(const struct plan *p, double *y);
double plan_start_pressure(const struct plan *p, const double *x);
void plan_start_press(const struct plan *p, double *y);

/* memory.c: bytes that a particle of the fluid, or of a solid, will need. */
double plan_memory_each(const struct plan *p, bool fluid);

#endif
