/* mri.h -- what the files of the method "mri" share.
 *
 * SUNDIALS' MRIStep takes the steps of the water, with the explicit side as its slow
 * right-hand side; the bodies are its fast one and go through each of its stages in
 * steps of their own (mri-bodies.c), which touch nothing but their entries.  In 6.4.1
 * MRIStep has no error estimate, so the frame of fixed.h gives the length of a step,
 * halves it where f has no answer, and shows the state in between. */
#ifndef TIME_MRI_H
#define TIME_MRI_H

#include "algebra/vector.h"
#include "time/control.h"
#include "time/fixed.h"
#include "time/tableau.h"

struct mri;
struct mri_forcing;

/* What the fast side is, and how its stages are found. */
struct mri_side {
    const char *table;           /* of SUNDIALS                                */
    bool implicit;               /* in its diagonal                            */
    const struct control_row *control;

    /* Entries that it moves; returns how many ranges. */
    int (*ranges)(const struct moment *moment, int most, long (*range)[2]);

    /* Rate of stage i of a step h from t. */
    int (*stage)(struct mri *m, const struct mri_forcing *f, double t, double h, int i);

    /* Longest stable step at the bodies' y [s]; NULL: any is stable. */
    double (*longest)(struct mri *m, double t);

    /* Takes from the rates of all at y what the side has itself. */
    int (*less)(struct mri *m, double t, const double *y, double *ydot);

    /* Bounds of the steps of the water. */
    void (*limit)(struct moment *moment, double t, const double *y, struct limit limit[2]);

    void (*between)(const struct fixed *x, double t, double *y); /* entries of bodies there */
};

/* The bodies' own integrator.  Vectors hold the entries of all ranges, one after the
 * other. */
struct mri_bodies {
    struct tableau table;
    double stable[2];            /* of explicit ones: times rates of waves, decay */
    struct control control;
    double longest;              /* that the next step may be [s]              */
    long entries;
    double *weight;              /* of error tests                             */
    double *y, *sum, *load;      /* state; of a stage; M^-1 F of the water     */
    double *rest;                /* [n] all 0: a y in which they are at rest   */
    double *rate[TABLEAU_STAGES];
};

struct mri {
    struct fixed_kind kind;      /* first, and of the frame: functions of the
                                    kind find the rest so                      */
    const struct mri_side *side;
    struct fixed *frame;
    char table[96];
    SUNContext context;
    void *steps;                 /* MRIStep                                    */
    MRIStepInnerStepper inner;
    N_Vector start, end;         /* of a step                                  */
    double h;                    /* of it [s]                                  */
    struct mri_bodies bodies;
};

struct mri_method {
    struct fixed_kind kind;      /* first: create() finds the rest so          */
    const struct mri_side *side;
};

extern const struct mri_method mri_method, mri_rigid_method;

extern const struct mri_side mri_beams_side; /* mri-beams.c: implicit            */
extern const struct mri_side mri_rigid_side;  /* mri-rigid.c: explicit            */

/* mri-bodies.c */
int mri_bodies_create(struct mri *m, const struct method_def *def);
void mri_bodies_restart(struct mri *m, const struct method_pace *pace);
void mri_bodies_free(struct mri *m);
void mri_bodies_pick(const struct fixed *x, const double *y, double *to);
void mri_bodies_put(const struct fixed *x, const double *from, double *y);
/* To load: the water's push at t.  To sum: y + h sum_(j<stages) c_j k_j. */
void mri_bodies_load(const struct mri *m, const struct mri_forcing *f, double t);
void mri_bodies_add_up(const struct mri_bodies *b, const double *c, int stages, double h, double *sum);
int mri_bodies_evolve(MRIStepInnerStepper inner, sunrealtype t, sunrealtype t_end, N_Vector y);

#endif
