/* time-tests.h -- what the files of this test share. */
#ifndef TIME_TESTS_H
#define TIME_TESTS_H

#include "time-toy.h"

#include "base/status.h"
#include "time/arkode.h"
#include "time/dv.h"
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
void *toy_method(struct moment *p, const char *name, double tol, double h);
void toy_method_free(void **self);
const struct method *toy_found(void); /* what toy_method() found */

/* Steps to t_end; the failing status if one fails. */
int toy_run(void *self, double t_end, int *steps);

void tables_keep_their_order_conditions(void **state);
void stability_factors_are_those_published(void **state);
void stability_factors_of_sundials_tables(void **state);
void halves_of_a_pair_go_together(void **state);
void implicit_tables_are_l_stable(void **state);
void steps_that_follow_a_vibration(void **state);

void staggered_steps_water_and_bodies_in_turn(void **state);
void staggered_counts_its_substeps(void **state);
void staggered_without_bodies_is_euler(void **state);
void staggered_bodies_alone_set_their_step(void **state);
void staggered_steps_do_not_depend_on_stiffness(void **state);
void staggered_bodies_go_straight_between_the_ends(void **state);
void staggered_halves_the_step_while_refused(void **state);

struct dv *toy_dv(struct moment *p, double tol, double h);
void toy_dv_free(struct dv *x);
void dv_is_of_order_two_without_dissipation(void **state);
void dv_books_the_work_of_a_kick(void **state);
void dv_is_symmetric_in_time(void **state);
void dv_estimates_its_error(void **state);
void dv_starts_carefully(void **state);
void dv_keeps_waves_and_decay_stable(void **state);
void dv_is_not_disturbed_by_a_short_step(void **state);
void dv_shortens_steps_without_an_answer(void **state);
void dv_steps_do_not_depend_on_stiffness(void **state);
void dv_resolves_vibrations_of_bodies(void **state);
void dv_shows_bodies_under_the_last_load(void **state);
void dv_estimates_the_error_of_bodies(void **state);
void dv_needs_halves(void **state);

void mri_is_of_order_three(void **state);
void mri_keeps_to_substep(void **state);
void mri_resolves_vibrations_of_bodies(void **state);
void mri_passes_over_stiff_bodies(void **state);
void mri_shortens_steps_without_an_answer(void **state);
void mri_says_what_it_cannot_serve(void **state);

#endif
