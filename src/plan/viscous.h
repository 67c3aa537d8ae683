/* viscous.h -- a viscosity on the implicit side: its rates, and the solve of a stage
 * for the velocities of fluid and bodies together. */
#ifndef PLAN_VISCOUS_H
#define PLAN_VISCOUS_H

#include "plan/couple.h"
#include "plan/inside.h"

enum { VISCOUS_STARTS = 3, VISCOUS_STAGES = 2,
       VISCOUS_VECTORS = 10 + VISCOUS_STARTS + VISCOUS_STAGES }; /* of all velocities */

/* Velocities at a moment, for guesses: those at which a step began, and stages since. */
struct viscous_past {
    double t;
    double *v; /* [unknowns] */
};

/* Velocities come in two orders: that of creation (v: the fluid's row of y, then each
 * body's unknowns) and that of the list's slots (all other vectors). */
struct viscous {
    const struct plan_part *part;
    struct pairs_table *table;   /* [KINDS][KINDS] its law alone               */
    struct couple_job job;
    size_t room;                 /* for so many c                              */
    size_t slots;                /* for so many velocities by slot             */
    double tol;                  /* error in units of scales that a step may have */
    int fluid, unknowns;         /* entries of the fluid's velocity; of all    */
    double *velocity;            /* [slots][COUPLE_STRIDE]                     */
    double *stage;               /* [size] y as far as it is known             */
    double *v, *right, *x, *residual, *near, *search, *image; /* [unknowns]     */
    double *guess, *guess_image; /* [unknowns] w, A w of viscous-gradients.c    */
    double *drag[DIM];           /* [unknowns - fluid] bodies' part of A 1     */
    double drag_all;             /* 1 . A 1                                    */
    double *partial;             /* sums of blocks                             */
    int starts, stages;
    struct viscous_past start[VISCOUS_STARTS], past[VISCOUS_STAGES]; /* newest first */
};

/* viscous.c: p->viscous, when the scene asks for one. */
int viscous_make(struct plan *p);
void viscous_free(struct plan *p);
int viscous_fit(struct viscous *u); /* after a rebuild */
bool viscous_faces(const struct plan *p); /* does it act at the faces of solids?      */
int viscous_rates(struct plan *p, double t, const double *y, double *ydot);

/* After w->f and w->power are those of the implicit law: rates of the book but for
 * what supports give, and p->body[].force. */
void viscous_book(struct plan *p, struct plan_workspace *w, double *book);

/* viscous-operator.c: forces of these kinds (bits) at velocities x, into main.f; to =
 * A x, or with `walls` what A x less gamma times the pull of walls comes to; ready for
 * bodies' part of the inverse; near = about A^-1 residual, returns its largest speed in
 * units of scales; unknowns of body i. */
void viscous_multiply(struct plan *p, unsigned kinds, const double *x, bool walls);
void viscous_apply(struct plan *p, double gamma, const double *x, bool walls, double *to);
int viscous_join(struct plan *p, double gamma);
double viscous_precondition(struct plan *p, double gamma);
int viscous_body(const struct plan *p, int i);

/* viscous-gradients.c: x, its residual and image = A x come in; x and its residual go
 * out.  STATUS_FAILED: a refusal. */
int viscous_iterate(struct plan *p, double t, double gamma);

/* viscous-solve.c */
int viscous_solve(struct plan *p, double t, double gamma, const double *r, double *z);

/* viscous-guess.c: velocities in the order of creation. */
void viscous_read(struct plan *p, const double *y, double *v);
void viscous_begin(struct plan *p, double t, const double *y); /* a step starts at t   */
void viscous_keep(struct viscous *u, double t, const double *v); /* a stage was solved */
void viscous_guess(struct plan *p, double t, const double *z, double *v);

#endif
