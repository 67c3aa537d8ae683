/* archive.c -- what goes to a checkpoint comes back, all of it, or is refused. */
#include "../physics/tank.h"
#include "scratch.h"

#include "base/archive.h"
#include "base/status.h"
#include "output/archive-file.h"
#include "run/past.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- structs ------------------------------------------------------------------------ */

/* Every member has a value that zeroing or another byte would not leave. */
static void fill_past(struct run_past *p)
{
    memset(p, 0x3f, sizeof *p);
    p->balance.begun = true;
    p->balance.sunk.solid = NULL;
    p->balance.sunk.place[PLAN_PLACE - 1] = '\0';
    p->means = NULL;
}

/* Bytes of two structs that differ. */
static size_t differ(const void *one, const void *other, size_t size)
{
    const unsigned char *a = one, *b = other;
    size_t n = 0;

    for (size_t i = 0; i < size; i++)
        n += a[i] != b[i];
    return n;
}

/* Bytes of struct run_past that no checkpoint holds: gaps behind members, and pointers. */
#define GAP(TYPE, MEMBER, NEXT) \
    (offsetof(struct TYPE, NEXT) - offsetof(struct TYPE, MEMBER) - sizeof(((struct TYPE *)0)->MEMBER))
static size_t not_kept(void)
{
    return GAP(run_balance, begun, defect_max) + 2 * GAP(book_sheet, works, work)
         + GAP(observe_sunk, n, t) + GAP(observe_sunk, particle, solid) + 2 * sizeof(void *);
}

/* Into two structs with different bytes: where these still differ nothing was loaded. */
static void test_past(void **state)
{
    struct run_past from, one, other;
    struct archive *a;
    struct tank t;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    fill_past(&from);
    assert_int_equal(archive_create(&a), STATUS_DONE);
    assert_int_equal(run_past_keep(&from, t.plan, a), STATUS_DONE);
    archive_turn(a);
    memset(&one, 0, sizeof one);
    memset(&other, 0x7e, sizeof other);
    assert_int_equal(run_past_keep(&one, t.plan, a), STATUS_DONE);
    assert_int_equal(run_past_keep(&other, t.plan, a), STATUS_DONE);
    assert_int_equal(archive_spent(a), STATUS_DONE);
    assert_int_equal(differ(&one, &other, sizeof one), not_kept());
    assert_true(differ(&from, &one, sizeof one) <= not_kept());
    archive_free(&a);
    tank_free(&t);
}

static void test_counts(void **state)
{
    struct moment_counts from, *counts;
    struct moment *moment;
    struct archive *a;
    struct tank t;

    (void)state;
    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    assert_int_equal(moment_create(t.plan, &moment), STATUS_DONE);
    counts = (struct moment_counts *)moment_counts(moment);
    memset(counts, 0x3f, sizeof *counts);
    from = *counts;
    assert_int_equal(archive_create(&a), STATUS_DONE);
    assert_int_equal(moment_keep(moment, a), STATUS_DONE);
    archive_turn(a);
    memset(counts, 0, sizeof *counts);
    assert_int_equal(moment_keep(moment, a), STATUS_DONE);
    assert_memory_equal(counts, &from, sizeof from);
    archive_free(&a);
    moment_free(&moment);
    tank_free(&t);
}

static struct running *readings(int n)
{
    const double window[] = { 0.1, 1 };
    struct running *r;

    assert_int_equal(running_create(2, window, &r), STATUS_DONE);
    for (int i = 0; i < n; i++)
        assert_int_equal(running_add(r, 0.01 * i, (double[]){ i * i, 1.0 / (i + 1) }), STATUS_DONE);
    return r;
}

static void test_means(void **state)
{
    struct running *from = readings(700), *to = readings(3);
    struct archive *a;

    (void)state;
    assert_int_equal(archive_create(&a), STATUS_DONE);
    assert_int_equal(running_keep(from, a), STATUS_DONE);
    archive_turn(a);
    assert_int_equal(running_keep(to, a), STATUS_DONE);
    for (int i = 0; i < 2; i++) {
        const double wanted = running_mean(from, i, 6.985), seen = running_mean(to, i, 6.985);
        assert_memory_equal(&seen, &wanted, sizeof seen);
    }
    assert_int_equal(running_add(to, 7, (double[]){ 1, 2 }), STATUS_DONE);
    archive_free(&a);
    running_free(&from);
    running_free(&to);
}

/* --- refusals ------------------------------------------------------------------------ */

/* Three numbers, an integer, a text, nothing. */
static int keep_sample(struct archive *a, double *x, long *n, char text[32])
{
    TRY(archive_numbers(a, "x", x, 3));
    TRY(archive_integers(a, "n", n, 1));
    TRY(archive_text(a, "text", text, 32));
    return archive_numbers(a, "nothing", NULL, 0);
}

static struct archive *sample(void)
{
    double x[3] = { 1, -0.0, 5e-324 };
    char text[32] = "two\nlines";
    long n = -7;
    struct archive *a;

    assert_int_equal(archive_create(&a), STATUS_DONE);
    assert_int_equal(keep_sample(a, x, &n, text), STATUS_DONE);
    return a;
}

static void refused(int status, const char *words)
{
    assert_int_equal(status, STATUS_IO);
    assert_non_null(strstr(status_message(), words));
    status_clear();
}

static void test_refusals(void **state)
{
    struct archive *a = sample();
    double x[4];
    char text[4];

    (void)state;
    archive_turn(a);
    refused(archive_numbers(a, "y", x, 3), "no y");
    refused(archive_numbers(a, "x", x, 4), "3 values");
    refused(archive_numbers(a, "n", x, 1), "n of the checkpoint");
    refused(archive_text(a, "text", text, sizeof text), "9 letters");
    refused(archive_spent(a), "has x");
    archive_free(&a);
}

/* --- files ---------------------------------------------------------------------------- */

static const char *path_of(int which, const char *name)
{
    static char path[2][128];

    snprintf(path[which], sizeof path[which], "%s/%s", scratch, name);
    return path[which];
}

static int read_sample(const char *path)
{
    const double wanted[3] = { 1, -0.0, 5e-324 };
    struct archive *a;
    double x[3];
    char text[32];
    bool found;
    long n;

    TRY(archive_file_read(path, &found, &a));
    assert_int_equal(keep_sample(a, x, &n, text), STATUS_DONE);
    assert_int_equal(archive_spent(a), STATUS_DONE);
    assert_memory_equal(x, wanted, sizeof x);
    assert_int_equal(n, -7);
    assert_string_equal(text, "two\nlines");
    archive_free(&a);
    return STATUS_DONE;
}

static char *contents(const char *path, size_t *size)
{
    FILE *from = fopen(path, "rb");
    char *bytes = malloc(1 << 20);

    assert_non_null(from);
    assert_non_null(bytes);
    *size = fread(bytes, 1, 1 << 20, from);
    fclose(from);
    return bytes;
}

static void put(const char *path, const char *bytes, size_t size)
{
    FILE *to = fopen(path, "wb");

    assert_non_null(to);
    assert_int_equal(fwrite(bytes, 1, size, to), size);
    fclose(to);
}

/* Each byte of the header and of the beginning, and others all over it, changed in one bit. */
static void flip(const char *path, char *bytes, size_t size)
{
    for (size_t i = 0; i < size; i += i < 700 ? 1 : 97) {
        bytes[i] ^= (char)(1 << i % 8);
        put(path, bytes, size);
        if (read_sample(path) != STATUS_IO)
            fail_msg("byte %zu of %zu is another one and nobody sees it", i, size);
        status_clear();
        bytes[i] ^= (char)(1 << i % 8);
    }
}

static void test_damage(void **state)
{
    const char *path = path_of(0, "one.h5"), *before = path_of(1, "before.h5");
    struct archive *a = sample();
    char *bytes;
    size_t size;

    (void)state;
    assert_int_equal(archive_file_write(a, path, before, NULL), STATUS_DONE);
    assert_int_equal(read_sample(path), STATUS_DONE);
    bytes = contents(path, &size);
    flip(path, bytes, size);
    for (size_t n = 0; n < size; n += 1 + n / 4) {
        put(path, bytes, n);
        refused(read_sample(path), "damaged");
    }
    put(path, bytes, size);
    assert_int_equal(read_sample(path), STATUS_DONE);
    free(bytes);
    archive_free(&a);
}

static void test_before(void **state)
{
    const char *path = path_of(0, "two.h5"), *before = path_of(1, "two-before.h5");
    struct archive *a = sample(), *other;
    bool found = true;

    (void)state;
    assert_int_equal(archive_file_read(path, &found, &other), STATUS_IO);
    assert_false(found);
    status_clear();
    assert_int_equal(archive_file_write(a, path, before, NULL), STATUS_DONE);
    assert_int_equal(read_sample(before), STATUS_IO);
    status_clear();
    assert_int_equal(archive_create(&other), STATUS_DONE);
    assert_int_equal(archive_file_write(other, path, before, NULL), STATUS_DONE);
    assert_int_equal(read_sample(before), STATUS_DONE);
    refused(archive_file_write(a, "/dev/full/x.h5", before, NULL), "/dev/full");
    assert_int_equal(read_sample(before), STATUS_DONE);
    archive_free(&other);
    archive_free(&a);
}

/* Numbers that the archive does not have come from pieces, in whatever order. */
static void test_elsewhere(void **state)
{
    enum { MANY = 40000 };
    const char *path = path_of(0, "three.h5"), *before = path_of(1, "three-before.h5");
    double *y = malloc(MANY * sizeof *y), *read = malloc(MANY * sizeof *read);
    struct archive *a = sample(), *back;
    const struct piece piece[] = {
        { .from = 30000, .n = 10000, .bytes = sizeof *y, .fill = pieces_numbers, .self = y + 30000 },
        { .from = 0, .n = 30000, .bytes = sizeof *y, .fill = pieces_numbers, .self = y },
    };
    const struct pieces all = { .n = 2, .piece = piece };
    bool found;

    (void)state;
    for (int i = 0; i < MANY; i++)
        y[i] = 1.0 / (i + 1);
    assert_int_equal(archive_numbers_elsewhere(a, "long", NULL, MANY), STATUS_DONE);
    assert_int_equal(archive_add(a, "last", ARCHIVE_NUMBERS, 3, y), STATUS_DONE);
    assert_int_equal(archive_file_write(a, path, before, &all), STATUS_DONE);
    assert_int_equal(archive_file_read(path, &found, &back), STATUS_DONE);
    assert_int_equal(archive_numbers_elsewhere(back, "long", read, MANY), STATUS_DONE);
    assert_memory_equal(read, y, MANY * sizeof *y);
    assert_int_equal(archive_numbers(back, "last", read, 3), STATUS_DONE);
    assert_memory_equal(read, y, 3 * sizeof *y);
    archive_free(&back);
    archive_free(&a);
    free(read);
    free(y);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_past),
        cmocka_unit_test(test_counts),
        cmocka_unit_test(test_means),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_damage),
        cmocka_unit_test(test_before),
        cmocka_unit_test(test_elsewhere),
    };

    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
