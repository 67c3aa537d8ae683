/* time-tests.h -- what the files of this test share. */
#ifndef TIME_TESTS_H
#define TIME_TESTS_H

#include "time-toy.h"

#include "base/status.h"
#include "time/arkode.h"
#include "time/method.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static inline void near(double got, double want, double tolerance)
{
    if (!(fabs(got - want) <= tolerance))
        fail_msg("%.17g instead of %.17g within %g", got, want, tolerance);
}

/* A method at t = 0 on the exact solution, with steps of length h if not 0: then
 * the toy's wave rate is set so that the stability bound is h, and tol is huge. */
void *toy_method(struct plan *p, const char *name, double tol, double h);
void toy_method_free(void **self);
const struct method *toy_found(void); /* what toy_method() found */

/* Steps to t_end; the failing status if one fails. */
int toy_run(void *self, double t_end, int *steps);

void tables_keep_their_order_conditions(void **state);
void stability_factors_are_those_published(void **state);
void stability_factors_of_sundials_tables(void **state);

void staggered_steps_water_and_bodies_in_turn(void **state);
void staggered_counts_its_substeps(void **state);
void staggered_without_bodies_is_euler(void **state);
void staggered_bodies_alone_set_their_step(void **state);
void staggered_steps_do_not_depend_on_stiffness(void **state);
void staggered_bodies_go_straight_between_the_ends(void **state);
void staggered_halves_the_step_while_refused(void **state);

#endif
