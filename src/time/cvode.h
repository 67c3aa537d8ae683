/* cvode.h -- what the files of the CVODE methods share.
 *
 * SUNDIALS' CVODE takes the steps and chooses their length and order; ours are the
 * weights, the norm and the whole right-hand side.  It knows no bound of stability:
 * a step that is too long is seen by its error, or by a solve that does not converge.
 * Contacts are the exception: a step past one is seen by nothing, so they bound steps. */
#ifndef TIME_CVODE_H
#define TIME_CVODE_H

#include "algebra/vector.h"
#include "time/method.h"
#include "time/rates.h"
#include <cvode/cvode.h>

/* One method: `method` comes first, so that its create() finds the row. */
struct cvode_row {
    struct method method;
    int family;         /* CV_ADAMS or CV_BDF                                  */
    int order[2];       /* the highest; [1]: with a stiff side                 */
    bool newton;        /* Newton-Krylov, else fixed-point iteration           */
    const char *table[2];
};

/* Each is listed in method.c. */
extern const struct cvode_row cvode_adams, cvode_bdf;

struct cvode {
    const struct cvode_row *row;
    struct method_def def;
    struct rates rates;
    long n;                     /* entries of y                                */

    SUNContext context;
    void *cvode;
    SUNNonlinearSolver solver;
    SUNLinearSolver linear;     /* NULL without Newton                         */

    N_Vector y, weight;
    N_Vector spare;             /* errors of a step; dense output              */
    double t, h;                /* reached [s]; length of the last step, 0: none */
    bool launched, floored;     /* started at t; has its shortest step         */
    long rejected;              /* before the latest start                     */
};

/* cvode-create.c */
int cvode_create(const struct method *m, const struct method_def *def, struct moment *moment,
                 double t, const double *y, void **out);
void cvode_free(void **self);
int cvode_vectors(const struct method *m, const struct plan *plan);

/* cvode.c */
int cvode_refuse(const struct cvode *c, const char *what); /* what SUNDIALS does not like */
int cvode_step(void *self, double t_stop, struct method_step *out);
int cvode_at(void *self, double t, double *y);
int cvode_restart(void *self, double t, const double *y, const struct method_pace *pace);
int cvode_rearrange(void *self, int blocks, const struct vector_rows *block);

#endif
