/* face.h -- what a viscosity does at solids beside its law between particles: the fluid
 * sticks at their faces, not where their particles are, and faces may slide. */
#ifndef EVAL_FACE_H
#define EVAL_FACE_H

#include "plan/couple.h"
#include "eval/inside.h"

enum { FACE_BLOCK = 512 }; /* places, their powers are added first */

/* Of a moment: all vectors are by place. */
struct face {
    const struct plan_face *of;
    struct couple_job job;        /* pairs of the fluid and what it sticks to   */
    size_t room, slots;           /* for so many c; for so many velocities      */
    double *velocity;             /* [places][COUPLE_STRIDE] of all      [m/s]  */
    double *slip;                 /* the same: u_w - v_w of solids, others 0    */
    double *law;                  /* [n][DIM] the law's forces on solids [N]    */
    double *f;                    /* [n][DIM] those beside them [N]; of the fluid
                                     with the sign turned                       */
    double *arm;                  /* [n][DIM] of solids: sum of c_wf (x_f - x_w); NULL:
                                     nothing turns                              */
    double *partial;              /* sums of blocks                             */
    double power;                 /* of the fluid on faces that slide [W]       */
};

/* m->face, where the plan has one. */
int face_create(struct moment *m);
void face_free(struct face **face); /* NULL is welcome */

/* After a rebuild there may be more places, and more pairs. */
int face_fit_slots(struct face *o, const struct list *l);
int face_fit_pairs(struct face *o, const struct list *l);

/* Is its viscosity among these laws? */
bool face_among(const struct plan *p, const struct pairs_table *table);

/* Around the sums over pairs: find forces, and add them to push [fluid][DIM], if that is
 * there; then to the forces that the job is for, and their power to that of the law. */
int face_find(struct moment *m);
void face_push(const struct moment *m, double (*push)[DIM]);
void face_add(struct moment *m, const struct rates_job *job);

/* Of a solve.  law: the coefficients of all pairs, to be made ready after each assembly;
 * f: its forces on all that sticks and, by kinds (bits), on the fluid, to be completed;
 * `walls` as viscous_multiply(); power of the forces of a moment on faces that slide. */
int face_ready(struct moment *m, const struct couple_job *law);
void face_complete(struct moment *m, const struct couple_job *law, unsigned kinds, bool walls,
                   double *f);
double face_power(struct moment *m);

#endif
