/* layout.c -- tests of src/state/layout.c: which numbers of y mean what. */
#include "base/status.h"
#include "state/layout.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

static void assert_near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.17g is not %.17g to %g", value, expected, tolerance);
}

static struct layout three_blocks(void)
{
    struct layout l = { 0 };

    assert_int_equal(layout_add(&l, LAYOUT_OTHER, "fluid.rho", "kg/m^3", 4, 1, 2.5), 0);
    assert_int_equal(layout_add(&l, LAYOUT_VELOCITY, "fluid.u", "m/s", 4, 2, 0.5), 1);
    assert_int_equal(layout_add(&l, LAYOUT_POSITION, "fluid.x", "m", 4, 2, 0.01), 2);
    assert_int_equal(layout_add(&l, LAYOUT_OTHER, "book", "J", 3, 1, 0), 3);
    assert_int_equal(layout_add(&l, LAYOUT_POSITION, "beam.q", "m", 5, 1, 0.1), 4);
    assert_int_equal(layout_add(&l, LAYOUT_OTHER, "nothing.rho", "kg/m^3", 0, 1, 1), 5);
    layout_done(&l);
    return l;
}

static void blocks_stand_class_by_class(void **state)
{
    const struct layout l = three_blocks();
    const long offset[] = { 21, 13, 0, 25, 8, 28 }, from[] = { 0, 13, 21, 28 };

    (void)state;
    assert_int_equal(layout_size(&l), 28);
    assert_memory_equal(l.from, from, sizeof from);
    for (int r = 0; r < l.rows; r++)
        assert_int_equal(layout_at(&l, r), offset[r]);
}

static void a_layout_is_remade_from_its_rows(void **state)
{
    struct layout l = three_blocks();

    (void)state;
    l.row[2].n = 3;
    layout_done(&l);
    assert_int_equal(layout_at(&l, 4), 6);
    assert_int_equal(layout_size(&l), 26);
}

static void weights_are_one_over_tol_times_scale(void **state)
{
    const struct layout l = three_blocks();
    double weight[28];

    (void)state;
    layout_weights(&l, 1e-3, NULL, weight);
    assert_near(weight[0], 1e5, 1e-9);
    assert_near(weight[7], 1e5, 1e-9);
    assert_near(weight[8], 1e4, 1e-9);
    assert_near(weight[13], 2000, 1e-9);
    assert_near(weight[24], 400, 1e-9);
    assert_true(weight[25] == 1e-12 && weight[27] == 1e-12);
}

static void entries_are_found(void **state)
{
    const struct layout l = three_blocks();
    int which = -1;

    (void)state;
    assert_string_equal(layout_find(&l, 0, &which)->name, "fluid.x");
    assert_int_equal(which, 0);
    assert_string_equal(layout_find(&l, 7, &which)->name, "fluid.x");
    assert_int_equal(which, 3);
    assert_string_equal(layout_find(&l, 12, &which)->name, "beam.q");
    assert_int_equal(which, 4);
    assert_string_equal(layout_find(&l, 18, &which)->name, "fluid.u");
    assert_int_equal(which, 2);
    assert_string_equal(layout_find(&l, 27, &which)->name, "book");
    assert_int_equal(which, 2);
    assert_null(layout_find(&l, 28, &which));
    assert_null(layout_find(&l, -1, &which));
}

static void assert_row_refused(struct layout *l, const char *name, int n, double scale,
                               const char *text)
{
    const int rows = l->rows;

    status_clear();
    assert_int_equal(layout_add(l, LAYOUT_OTHER, name, "", n, 1, scale), -1);
    assert_non_null(strstr(status_message(), text));
    assert_int_equal(l->rows, rows);
    status_clear();
}

static void rows_that_make_no_sense_are_refused(void **state)
{
    struct layout l = { 0 };

    (void)state;
    assert_row_refused(&l, "a-name-of-more-than-forty-seven-characters-is-too-long", 1, 1,
                       "too long");
    assert_row_refused(&l, "a", -1, 1, "negative");
    assert_row_refused(&l, "a", 1, NAN, "not a number");
    assert_row_refused(&l, "a", 1, -1, "negative");
    for (int r = 0; r < LAYOUT_ROWS; r++)
        assert_int_equal(layout_add(&l, LAYOUT_OTHER, "a", "", 1, 1, 1), r);
    assert_row_refused(&l, "last", 1, 1, "\"last\"");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_stand_class_by_class),
        cmocka_unit_test(a_layout_is_remade_from_its_rows),
        cmocka_unit_test(weights_are_one_over_tol_times_scale),
        cmocka_unit_test(entries_are_found),
        cmocka_unit_test(rows_that_make_no_sense_are_refused),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
