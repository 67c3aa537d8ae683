/* given.h -- what a step whose pressure was solved for gave to solids.
 *
 *     TRY(given_make(moment));              once, by what solves
 *     given_start(moment);                  forces of the last evaluation, in each step
 *     given_add(moment, h, push, book);     and impulses that no evaluation knows
 *
 * An equation of state says of the densities in y what it likes; observe_force() and
 * observe_panel() (observe.h) then tell of the last step instead. */
#ifndef EVAL_GIVEN_H
#define EVAL_GIVEN_H

#include "eval/inside.h"

struct moment_given {
    bool known;            /* has there been a step since the moment was made or restarted? */
    double (*force)[DIM];  /* [objects + panels][DIM] momentum given in that step, by its
                              length                                     [N]      */
    double (*turn)[3];     /* [panels][3] moments of those; 2D: the last [N m]    */
};

/* Memory in moment->given, which moment_free() gives back; nothing is known yet. */
int given_make(struct moment *m);
void given_free(struct moment_given **given); /* NULL is welcome */

void given_start(struct moment *m);

/* Adds impulses push [particles][DIM] by id, those of fluid are not read [N s], of a step h;
 * to the book [n], too. */
void given_add(struct moment *m, double h, const double (*push)[DIM], double *book);

#endif
