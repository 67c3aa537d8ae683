/* effects-pair.h -- one particle and its neighbours, put to an effect. */
#ifndef TESTS_UNIT_EFFECTS_PAIR_H
#define TESTS_UNIT_EFFECTS_PAIR_H

#include "state/part.h"

struct pair_particle {
    double x[DIM], v[DIM]; /* [m], [m/s]                                     */
    double rho, p2, m;     /* density [kg/m^D], p/rho^2, mass [kg, 2D: kg/m] */
};

struct pair_answer {
    double f[DIM]; /* force on a                                  [N, 2D: N/m] */
    double drho;   /* its mass times its rate of density                       */
};

/* An effect with parameters of its own. */
struct pair_law {
    const struct part *part;
    void *self; /* part->size bytes */
};

enum { PAIR_MOST = 24 };

/* What n <= PAIR_MOST particles b do to a by the law, gathered as in a run;
 * `padding` rows without a particle follow.  Rows that the part did not ask for are
 * NaN.  One function a lane width. */
typedef void pair_ask(const struct pair_law *law, const struct pair_particle *a, int n,
                      const struct pair_particle *b, int padding, struct pair_answer *to);
extern pair_ask effects_ask_lanes2, effects_ask_lanes4, effects_ask_lanes8;
extern const struct part *const effects_table_lanes2[], *const effects_table_lanes4[];
extern const struct part *const effects_table_lanes8[];

/* The world of these tests; the kernel is Wendland's C2, but for laws made of a
 * Laplacian that of viscosity, (K9). */
extern const struct scales effects_scales;

/* The same law by its formula, written plainly for one neighbour. */
typedef void pair_formula(const struct pair_particle *a, const struct pair_particle *b,
                          struct pair_answer *to);
pair_formula *effects_formula(const char *name); /* NULL: not known here */

/* Parameters that the formulas and the laws share. */
#define EFFECTS_ALPHA 0.37
#define EFFECTS_MU 1.9
#define EFFECTS_DELTA 0.13
#define EFFECTS_STRENGTH 0.23
#define EFFECTS_POWER 5

#endif
