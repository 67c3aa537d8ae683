/* base.c -- tests of src/base: what becomes of messages. */
#include "base/status.h"

#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static int clean(void **state)
{
    (void)state;
    status_clear();
    return 0;
}

static void the_first_failure_wins(void **state)
{
    (void)state;
    assert_string_equal(status_message(), "");
    assert_int_equal(status_fail(STATUS_BAD_SCENE, "eos.c0 = %g", 3.5), STATUS_BAD_SCENE);
    assert_int_equal(status_fail(STATUS_IO, "and then another"), STATUS_IO);
    assert_string_equal(status_message(), "eos.c0 = 3.5");
}

static void a_cleared_failure_makes_room_for_the_next(void **state)
{
    (void)state;
    status_fail(STATUS_FAILED, "one");
    status_clear();
    assert_string_equal(status_message(), "");
    status_fail(STATUS_FAILED, "two");
    assert_string_equal(status_message(), "two");
}

static void a_sentence_that_is_too_long_ends_in_dots(void **state)
{
    char *lengthy = calloc(20001, 1);

    (void)state;
    memset(lengthy, 'x', 20000);
    status_fail(STATUS_FAILED, "%s", lengthy);
    assert_true(strlen(status_message()) > 1000);
    assert_string_equal(status_message() + strlen(status_message()) - 4, "x...");
    free(lengthy);
}

static int second(int *calls)
{
    (*calls)++;
    return STATUS_DONE;
}

static int first_fails(int *calls)
{
    TRY(second(calls));
    TRY(status_fail(STATUS_IO, "no"));
    TRY(second(calls));
    return STATUS_DONE;
}

static void try_hands_the_code_up_and_stops(void **state)
{
    int calls = 0;

    (void)state;
    assert_int_equal(first_fails(&calls), STATUS_IO);
    assert_int_equal(calls, 1);
}

static void memory_is_zeroed_and_never_null_for_nothing(void **state)
{
    unsigned char *bytes = status_alloc(100, 8), *none = status_alloc(0, 8);

    (void)state;
    assert_non_null(bytes);
    assert_non_null(none);
    for (int i = 0; i < 800; i++)
        assert_int_equal(bytes[i], 0);
    free(bytes);
    free(none);
}

static void memory_that_cannot_be_had_is_a_failure_with_its_size(void **state)
{
    (void)state;
    assert_null(status_alloc(ULONG_MAX / 2, 16)); /* the product does not fit */
    assert_non_null(strstr(status_message(), "16 bytes"));
}

/* What a call of status_warn() leaves on standard error. */
static void warning(char *line, int room)
{
    FILE *file = tmpfile();
    const int saved = dup(STDERR_FILENO);
    size_t n;

    assert_non_null(file);
    fflush(stderr);
    dup2(fileno(file), STDERR_FILENO);
    status_warn("%d particles left the domain", 3);
    fflush(stderr);
    dup2(saved, STDERR_FILENO);
    close(saved);
    rewind(file);
    n = fread(line, 1, (size_t)room - 1, file);
    line[n] = '\0';
    fclose(file);
}

static void a_warning_names_the_program_and_is_no_failure(void **state)
{
    char line[200];

    (void)state;
    warning(line, sizeof line);
    assert_string_equal(line, "stiffwater: warning: 3 particles left the domain\n");
    assert_string_equal(status_message(), "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(the_first_failure_wins, clean),
        cmocka_unit_test_setup(a_cleared_failure_makes_room_for_the_next, clean),
        cmocka_unit_test_setup(a_sentence_that_is_too_long_ends_in_dots, clean),
        cmocka_unit_test_setup(try_hands_the_code_up_and_stops, clean),
        cmocka_unit_test_setup(memory_is_zeroed_and_never_null_for_nothing, clean),
        cmocka_unit_test_setup(memory_that_cannot_be_had_is_a_failure_with_its_size, clean),
        cmocka_unit_test_setup(a_warning_names_the_program_and_is_no_failure, clean),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
