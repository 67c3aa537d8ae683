/* patience.c -- what takes too long or too much memory is stopped, and told from what ends by
 * itself. */
#include "run/patience.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static double peak_of_children(void) /* [bytes] */
{
    struct rusage u;

    getrusage(RUSAGE_CHILDREN, &u);
    return 1024.0 * (double)u.ru_maxrss;
}

static void test_end(void **state)
{
    const int ended = patience_try(10);

    (void)state;
    if (ended == PATIENCE_BEGIN) {
        patience_done();
        _exit(7);
    }
    assert_int_equal(ended, 7);
}

static void test_done(void **state)
{
    const int ended = patience_try(10);

    (void)state;
    if (ended == PATIENCE_BEGIN) {
        patience_is_all();
        patience_done();
        _exit(7);
    }
    assert_int_equal(ended, 0);
}

static void test_time(void **state)
{
    const int ended = patience_try(0.1);
    volatile bool goes = true;

    (void)state;
    if (ended == PATIENCE_BEGIN)
        while (goes)
            ;
    assert_int_equal(ended, PATIENCE_OVER);
}

/* In pieces of 1 MB, 3 GB of them: far more than is allowed, and no harm to a machine where nothing
 * stops it. */
static void test_memory(void **state)
{
    const int ended = patience_try(60);
    enum { PIECE = 1 << 20, PIECES = 3000 };
    static char *volatile kept[PIECES];

    (void)state;
    if (ended == PATIENCE_BEGIN) {
        for (int i = 0; i < PIECES; i++) {
            char *piece = malloc(PIECE);
            if (!piece)
                break;
            memset(piece, 1 + i % 7, PIECE);
            kept[i] = piece;
        }
        patience_done();
        _exit(7);
    }
    assert_int_equal(ended, PATIENCE_OVER);
    assert_true(peak_of_children() < 1e9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_end),
        cmocka_unit_test(test_done),
        cmocka_unit_test(test_time),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
