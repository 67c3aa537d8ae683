/* tableau.h -- Runge-Kutta methods as tables of numbers.
 *
 *   z_i = y + h sum_j a_ij f(t + c_j h, z_j),  y_new = y + h sum_i b_i f(..., z_i),
 *   error = h sum_i (b_i - d_i) f(..., z_i). */
#ifndef TIME_TABLEAU_H
#define TIME_TABLEAU_H

#include <stdbool.h>

enum { TABLEAU_STAGES = 16 };

struct tableau {
    const char *name;
    int stages, order, embedded; /* orders of b and of d                      */
    double a[TABLEAU_STAGES][TABLEAU_STAGES]; /* explicit: below the diagonal;
                                                 implicit: on it as well */
    double b[TABLEAU_STAGES];
    double d[TABLEAU_STAGES];    /* the embedded method's b                   */
};

/* Tables that SUNDIALS 6.4.1 does not have; NULL-ended. */
extern const struct tableau *const tableau_own[];
extern const struct tableau tableau_cks43, tableau_opt53, tableau_opt64, tableau_bs54,
    tableau_ark2_erk, tableau_ark2_dirk;

/* c_i = sum_j a_ij. */
double tableau_node(const struct tableau *t, int i);

/* Its last stage stands where the step ends: f there is the next step's first. */
bool tableau_first_same_as_last(const struct tableau *t);

#endif
