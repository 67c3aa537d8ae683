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

/* The bodies' own integrator.  Vectors hold the entries of all ranges, one after the
 * other. */
struct mri_bodies {
    struct tableau table;        /* implicit in each stage                     */
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
    struct fixed *frame;
    char table[96];
    SUNContext context;
    void *steps;                 /* MRIStep                                    */
    MRIStepInnerStepper inner;
    N_Vector start, end;         /* of a step                                  */
    double h;                    /* of it [s]                                  */
    struct mri_bodies bodies;
};

extern const struct fixed_kind mri_kind;

/* mri-bodies.c */
extern const char mri_fast_table[];
int mri_bodies_create(struct mri *m, const struct method_def *def);
void mri_bodies_restart(struct mri *m);
void mri_bodies_free(struct mri *m);
/* Adds `share` times what bodies at y book by their own motion. */
void mri_bodies_book(struct mri *m, double t, const double *y, double share, double *ydot);
int mri_bodies_evolve(MRIStepInnerStepper inner, sunrealtype t, sunrealtype t_end, N_Vector y);

#endif
