/* viscous.h -- a viscosity on the implicit side: its rates, and the solve of a stage
 * for the velocities of fluid and bodies together. */
#ifndef IMPLICIT_VISCOUS_H
#define IMPLICIT_VISCOUS_H

#include "algebra/vector.h"
#include "eval/inside.h"
#include "implicit/operator.h"
#include "plan/couple.h"

enum { VISCOUS_PRODUCTS = 1000, /* of one solve at most */
       VISCOUS_STARTS = 3, VISCOUS_STAGES = 1,
       VISCOUS_VECTORS = 12 + VISCOUS_STARTS + VISCOUS_STAGES }; /* of all velocities */

/* Velocities at a moment, for guesses: those at which a step began, and stages since. */
struct viscous_past {
    double t;
    double *v; /* [unknowns] */
};

/* What a callback of the operator knows: of body i, of the fluid (body: -1). */
struct viscous_block {
    struct moment *moment;
    double gamma;
    int body;
};

/* Velocities come in two orders: that of rows (v: the fluid's block of y, then each
 * body's unknowns) and that of the list's places (all other vectors). */
struct viscous {
    const struct plan_part *part;
    struct couple_job job;
    size_t room;                 /* for so many c                              */
    size_t slots;                /* for so many velocities by place            */
    double tol;                  /* error in units of scales that a step may have */
    double rounding;             /* r . M^-1 r of a residual r that is no more than that */
    int fluid, unknowns;         /* entries of the fluid's velocity; of all    */
    double *velocity;            /* [places][COUPLE_STRIDE]                    */
    double *apart;               /* [particles][DIM] forces by place, of both sides' pass */
    double *stage;               /* [size] y as far as it is known             */
    double *v, *right, *x, *residual; /* [unknowns]                            */
    double *guess, *guess_image; /* [unknowns] w, A w of viscous-directions.c   */
    double *drag[DIM];           /* [unknowns - fluid] bodies' part of A 1     */
    double drag_all;             /* 1 . A 1                                    */
    double *partial;             /* sums of blocks                             */
    struct {
        int starts, stages;
        struct viscous_past start[VISCOUS_STARTS], past[VISCOUS_STAGES]; /* newest first */
    } known;                     /* for guesses                                */
    struct {                     /* A of (BV1), as viscous_assemble() made it   */
        struct operator all;
        struct operator_body *body;  /* [bodies] of it                         */
        struct viscous_block *block; /* [1 + bodies] what its callbacks know    */
        double *diagonal;            /* [fluid/DIM] by slot                     */
    } operator;
    struct operator_solver *solver;
};

static inline struct viscous *viscous_of(const struct moment *m)
{
    return m->solver;
}

/* The slot of point j of a body's skin; -1: it is in no list. */
static inline int viscous_place(const struct moment *m, const struct moment_body *b, int j)
{
    return m->list->slot[particles_row_of(m->particles, m->particles->object[b->object].from + j)];
}

/* viscous.c: members of implicit_viscous; after a rebuild there may be more pairs. */
int viscous_create(struct moment *m, void **out);
void viscous_free(void **self);
int viscous_fit(struct viscous *u);

/* After forces and power in the workspace are those of the implicit law: rates of the book
 * but for what supports give, and forces on bodies. */
void viscous_book(struct moment *m, double *book);

/* viscous-operator.c: the matrix as an operator, and to = A x less gamma times the pull of
 * walls, in one pass over pairs; then, forces of these kinds (bits) at velocities x into
 * work->f; ready for bodies' part of the inverse; unknowns of body i. */
int viscous_assemble(struct moment *m, double gamma, const double *x, double *to);
void viscous_multiply(struct moment *m, unsigned kinds, const double *x, bool walls);
int viscous_join(struct moment *m, double gamma);
int viscous_body(const struct plan *p, int i);

/* viscous-directions.c: "all fluid alike" and the guess, for which a solve is exact.
 * set: they are made of x and guess_image = A x.  clear: takes A times so much of them
 * out of a residual that nothing of it is left along them.  add: x gets so much of them.
 * leave: v without what of A v is along them. */
struct viscous_along {
    double guess, all[DIM];
};
void viscous_directions_set(struct moment *m, double gamma);
struct viscous_along viscous_directions_clear(struct moment *m, double gamma, double *residual);
void viscous_directions_add(const struct viscous *u, const struct viscous_along *along, double *x);
void viscous_directions_leave(struct moment *m, double gamma, double *v);

/* viscous-gradients.c: x, its residual and guess_image = A x come in; x and its residual
 * go out.  STATUS_FAILED: a refusal. */
int viscous_iterate(struct moment *m, double t, double gamma);

/* viscous-solve.c */
int viscous_solve(struct moment *m, double t, double gamma, const double *r, double *z);

/* viscous-guess.c: velocities in the order of rows. */
void viscous_read(struct moment *m, const double *y, double *v);
void viscous_begin(struct moment *m, double t, const double *y); /* a step starts at t   */
void viscous_keep(struct viscous *u, double t, const double *v); /* a stage was solved */
void viscous_guess(struct moment *m, double t, const double *z, double *v);
void viscous_forget(void *self); /* a member of implicit_viscous */
int viscous_rearrange(struct moment *m, const int *from);

#endif
