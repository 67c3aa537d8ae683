/* beam3.c -- in three dimensions a beam is refused, and says so. */
#include "base/status.h"
#include "bodies/bodies.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

static void a_beam_in_three_dimensions_is_refused(void **state)
{
    const struct scales scales = { .dimension = 3 };
    void *params = calloc(1, bodies_beam.identity.size);
    struct body *body = NULL;

    (void)state;
    assert_non_null(params);
    assert_int_equal(bodies_beam.make.create(params, &scales, "it", "beam.it", &body),
                     STATUS_BAD_SCENE);
    assert_null(body);
    assert_non_null(strstr(status_message(), "beam.it: a beam in three dimensions is not there"));
    free(params);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_beam_in_three_dimensions_is_refused),
    };

    return cmocka_run_group_tests_name("beam3", tests, NULL, NULL);
}
