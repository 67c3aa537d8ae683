/* base.c -- tests of src/base: what becomes of messages. */
#include "base/pages.h"
#include "base/status.h"
#include "base/waiting.h"

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
    status_forgive();
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

static void advice_is_kept_apart_and_printed_behind(void **state)
{
    (void)state;
    assert_false(status_has_cause() || status_has_remedy());
    assert_int_equal(status_fail_with(STATUS_FAILED, (struct status_advice){ .remedy = "take 2" },
                                      "c0 = %d m/s", 1), STATUS_FAILED);
    assert_false(status_has_cause());
    assert_true(status_has_remedy());
    assert_string_equal(status_message(), "c0 = 1 m/s; take 2");
    status_advise((struct status_advice){ "It is slow", "or 3" });
    assert_true(status_has_cause() && status_has_remedy());
    assert_string_equal(status_message(), "c0 = 1 m/s. It is slow; take 2; or 3");
}

static void words_are_no_advice(void **state)
{
    (void)state;
    status_fail(STATUS_FAILED, "the constant step; try another, or take a rest. Try it");
    assert_false(status_has_cause() || status_has_remedy());
}

static void advice_of_a_failure_that_is_not_kept_is_dropped(void **state)
{
    (void)state;
    status_advise((struct status_advice){ "why", "what" });
    assert_string_equal(status_message(), "");
    status_fail(STATUS_FAILED, "one");
    assert_int_equal(status_fail_with(STATUS_IO, (struct status_advice){ "a", "b" }, "two"),
                     STATUS_IO);
    assert_string_equal(status_message(), "one");
    assert_false(status_has_cause() || status_has_remedy());
    status_advise((struct status_advice){ "why", "Take it" });
    assert_string_equal(status_message(), "one; why. Take it");
    status_clear();
    assert_false(status_has_cause() || status_has_remedy());
    assert_string_equal(status_message(), "");
}

static void advice_that_is_too_long_ends_in_dots(void **state)
{
    char lengthy[3001];

    (void)state;
    memset(lengthy, 'x', 3000);
    lengthy[3000] = '\0';
    status_fail_with(STATUS_FAILED, (struct status_advice){ lengthy, "do" }, "one");
    assert_true(strlen(status_message()) > 500);
    assert_string_equal(status_message() + strlen(status_message()) - 8, "x...; do");
    for (int i = 0; i < 4; i++)
        status_advise((struct status_advice){ .remedy = lengthy });
    assert_string_equal(status_message() + strlen(status_message()) - 4, "x...");
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
    assert_true(status_has_remedy());
}

static void want_of_memory_is_forgiven_but_not_cleared(void **state)
{
    (void)state;
    assert_int_equal(status_starved("%d rows cannot be kept", 7), STATUS_FAILED);
    assert_true(status_is_starved());
    status_clear();
    assert_true(status_is_starved());
    assert_non_null(strstr(status_message(), "out of memory: 7 rows cannot be kept; use fewer"));
    status_forgive();
    assert_false(status_is_starved());
    assert_string_equal(status_message(), "");
    status_fail(STATUS_IO, "a disk");
    status_starved("too late");
    assert_false(status_is_starved());
    assert_string_equal(status_message(), "a disk");
}

static void a_reserve_is_had_or_told(void **state)
{
    (void)state;
    assert_int_equal(status_reserve(1000, "a file"), STATUS_DONE);
    assert_int_equal(status_reserve(ULONG_MAX / 2, "a file"), STATUS_FAILED);
    assert_non_null(strstr(status_message(), "bytes for a file"));
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

static void threads_spin_only_on_cores_of_their_own(void **state)
{
    (void)state;
    assert_true(waiting_spins(2, 2, 2, 0) > 0);
    assert_true(waiting_spins(4, 8, 8, 4) > 0);
    assert_int_equal(waiting_spins(4, 8, 8, 5), 0);   /* others need them          */
    assert_int_equal(waiting_spins(3, 2, 64, 0), 0);  /* it may not use more       */
    assert_true(waiting_spins(2, 2, 64, 60) > 0);
    assert_int_equal(waiting_spins(2, 64, 64, -1), 0); /* who knows                */
    assert_int_equal(waiting_spins(1, 8, 8, 0), 0);   /* waits for nobody          */
}

static void what_the_user_says_of_waiting_stays(void **state)
{
    (void)state;
    unsetenv("GOMP_SPINCOUNT");
    setenv("OMP_WAIT_POLICY", "active", 1);
    waiting_choose(2);
    waiting_sleep();
    assert_string_equal(getenv("OMP_WAIT_POLICY"), "active");
    assert_null(getenv("GOMP_SPINCOUNT"));
    unsetenv("OMP_WAIT_POLICY");
    setenv("GOMP_SPINCOUNT", "7", 1);
    waiting_choose(2);
    assert_string_equal(getenv("GOMP_SPINCOUNT"), "7");
}

static void more_threads_than_processors_sleep(void **state)
{
    (void)state;
    unsetenv("OMP_WAIT_POLICY");
    unsetenv("GOMP_SPINCOUNT");
    waiting_choose(100000);
    assert_string_equal(getenv("OMP_WAIT_POLICY"), "passive");
    assert_null(getenv("GOMP_SPINCOUNT"));
    setenv("OMP_NUM_THREADS", "100000", 1);
    waiting_choose(0);
    assert_null(getenv("GOMP_SPINCOUNT"));
}

static void short_loops_have_threads_where_these_spin(void **state)
{
    (void)state;
    assert_in_range(waiting_worth(NULL), 5000, 50000); /* some microseconds: as long as waking takes */
    assert_int_equal(waiting_worth("0"), waiting_worth(NULL));
    assert_in_range(waiting_worth("1000"), 500, 5000);
    unsetenv("GOMP_SPINCOUNT");
    assert_false(waiting_repays(waiting_worth(NULL)));
    assert_true(waiting_repays(waiting_worth(NULL) + 1));
}

/* Entries of 24 bytes: 170 and 2/3 a page of 4 kB. */
static void pages_are_those_that_entries_stand_in(void **state)
{
    const double page = (double)sysconf(_SC_PAGESIZE);
    const int per_page = (int)(page / 24), across[] = { per_page }, far[] = { 1, 9 * per_page, 9 * per_page + 1 };

    (void)state;
    assert_true(pages_bytes(0, 0, NULL, 24) == 0);
    assert_true(pages_bytes(1, 0, NULL, 24) == page);
    assert_true(pages_bytes(per_page, 0, NULL, 24) == page);
    assert_true(pages_bytes(per_page + 1, 0, NULL, 24) == 2 * page);
    assert_true(pages_bytes(0, 1, across, 24) == 2 * page); /* the entry has a part of two */
    assert_true(pages_bytes(0, 3, far, 24) == 2 * page);
    assert_true(pages_bytes(2 * per_page, 3, far, 24) == 3 * page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(the_first_failure_wins, clean),
        cmocka_unit_test_setup(a_cleared_failure_makes_room_for_the_next, clean),
        cmocka_unit_test_setup(a_sentence_that_is_too_long_ends_in_dots, clean),
        cmocka_unit_test_setup(advice_is_kept_apart_and_printed_behind, clean),
        cmocka_unit_test_setup(words_are_no_advice, clean),
        cmocka_unit_test_setup(advice_of_a_failure_that_is_not_kept_is_dropped, clean),
        cmocka_unit_test_setup(advice_that_is_too_long_ends_in_dots, clean),
        cmocka_unit_test_setup(try_hands_the_code_up_and_stops, clean),
        cmocka_unit_test_setup(memory_is_zeroed_and_never_null_for_nothing, clean),
        cmocka_unit_test_setup(memory_that_cannot_be_had_is_a_failure_with_its_size, clean),
        cmocka_unit_test_setup(want_of_memory_is_forgiven_but_not_cleared, clean),
        cmocka_unit_test_setup(a_reserve_is_had_or_told, clean),
        cmocka_unit_test_setup(a_warning_names_the_program_and_is_no_failure, clean),
        cmocka_unit_test(threads_spin_only_on_cores_of_their_own),
        cmocka_unit_test(what_the_user_says_of_waiting_stays),
        cmocka_unit_test(more_threads_than_processors_sleep),
        cmocka_unit_test(short_loops_have_threads_where_these_spin),
        cmocka_unit_test(pages_are_those_that_entries_stand_in),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
