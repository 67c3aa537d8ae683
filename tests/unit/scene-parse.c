/* scene-parse.c -- tests of how src/scene reads the notation: which nodes with which lines come
 * of which bytes, to the last digit, and that no bytes take long. */
#include "base/status.h"
#include "scene/tree.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

/* --- a scene and what it is read as --------------------------------------------------- */

static char path[64];

static struct scene *read_bytes(const char *bytes, size_t n, int expected)
{
    struct scene *scene = NULL;
    FILE *file = fopen(path, "w");
    int status;

    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, n, file), n);
    fclose(file);
    status_clear();
    status = scene_read(path, &scene);
    if (status != expected)
        fail_msg("code %d for \"%.100s\": %s", status, bytes, status_message());
    return scene;
}

static void show(const struct scene_node *node, FILE *to)
{
    fprintf(to, "%s@%d=", node->name, node->at.line);
    if (node->kind != SCENE_GROUP && node->kind != SCENE_LIST) {
        scene_write_node(node, to);
        return;
    }
    fputc(node->kind == SCENE_GROUP ? '{' : '[', to);
    for (int i = 0; i < node->n; i++) {
        fputs(i > 0 ? " " : "", to);
        show(node->child[i], to);
    }
    fputc(node->kind == SCENE_GROUP ? '}' : ']', to);
}

/* Asserts what the scene is read as: NAME@LINE=VALUE, a list in [ ], a group in { }. */
static void reads(const char *bytes, const char *expected)
{
    struct scene *scene = read_bytes(bytes, strlen(bytes), STATUS_DONE);
    char *text = NULL;
    size_t n = 0;
    FILE *stream = open_memstream(&text, &n);

    show(scene_root(scene), stream);
    fclose(stream);
    assert_string_equal(text, expected);
    free(text);
    scene_free(&scene);
}

static void refused(const char *bytes, const char *words)
{
    assert_null(read_bytes(bytes, strlen(bytes), STATUS_BAD_SCENE));
    if (!strstr(status_message(), words))
        fail_msg("\"%s\" is not in \"%s\"", words, status_message());
}

/* --- structure -------------------------------------------------------------------------- */

static void settings_are_parted_by_anything_or_nothing(void **state)
{
    (void)state;
    reads("a = 1; b = 2, c = 3\nd = 4 e = { } f = [ ] g = ( )", "@0={a@1=1 b@1=2 c@1=3 d@2=4 "
          "e@2={} f@2=[] g@2=[]}");
    reads("a : { b : 1; }; *x-1_* = TRUE; y = false", "@0={a@1={b@1=1} *x-1_*@1=true y@1=false}");
    refused("a=1b=2", "1b is not a number");
}

static void lists_hold_values_of_any_kind(void **state)
{
    (void)state;
    reads("a = [1, -2.5, \"x\", true, [2], (), { b = 3; c = 4 }]",
          "@0={a@1=[@1=1 @1=-2.5 @1=\"x\" @1=true @1=[@1=2] @1=[] @1={b@1=3 c@1=4}]}");
}

static void groups_in_a_list_may_have_the_same_names(void **state)
{
    (void)state;
    reads("a = ({ b = 1 }, { b = 2 }); b = 3",
          "@0={a@1=[@1={b@1=1} @1={b@1=2}] b@1=3}");
    refused("a = ({ b = 1; b = 2 })", ":1: a.b is given twice");
    refused("a = { a = 1 }; a = 2", ":1: a is given twice");
}

static void a_node_has_the_line_of_its_first_token(void **state)
{
    (void)state;
    reads("a =\n3;\nb = /* \n */ {\n c\t=\n [1,\n2\n,\"x\"\n,\n\"y\"\n\"z\"\n] }",
          "@0={a@1=3 b@3={c@5=[@6=1 @7=2 @8=\"x\" @10=\"yz\"]}}");
    refused("a = [\"x\"\n,\n;", ":3: values in a list");
}

static void brackets_may_be_64_deep(void **state)
{
    char bytes[200] = "a = ";
    struct scene *scene;

    (void)state;
    memset(bytes + 4, '[', 65);
    memset(bytes + 69, ']', 65);
    refused(bytes, "more than 64 brackets");
    memmove(bytes + 4, bytes + 5, 128);
    scene = read_bytes(bytes, 132, STATUS_DONE);
    scene_free(&scene);
}

static void a_group_may_have_10000_settings(void **state)
{
    char *bytes = malloc(10001 * 9 + 1);
    struct scene *scene;

    (void)state;
    for (int i = 0; i <= 10000; i++)
        sprintf(bytes + 9 * i, "a%05d=1;", i);
    scene = read_bytes(bytes, 9 * 10000, STATUS_DONE);
    assert_int_equal(scene_count(scene_root(scene)), 10000);
    scene_free(&scene);
    refused(bytes, "more than 10000 settings in one group");
    free(bytes);
}

/* --- texts -------------------------------------------------------------------------------- */

static const char *only_text(struct scene **scene, const char *bytes)
{
    *scene = read_bytes(bytes, strlen(bytes), STATUS_DONE);
    return scene_at(scene_root(*scene), 0)->text;
}

static void escapes_of_texts_are_those_of_libconfig(void **state)
{
    static const char *const pairs[][2] = {
        { "\"\\n\\r\\t\\f\\\\\\\"\"", "\n\r\t\f\\\"" },
        { "\"\\x41\\X42\\xe9\\xFF\"", "AB\xe9\xff" },
        { "\"\\a\\b\\v\\q\\0\\'\"", "\\a\\b\\v\\q\\0\\'" },
        { "\"\\x4\\x4g\\xg4\"", "\\x4\\x4g\\xg4" },
        { "\"a\\x00b\" \"c\"", "abc" },
        { "\"\"", "" },
        { "\"\" \"\"\n\"a\" /* and */ \"b\"", "ab" },
        { "\"\xc3\xa9\ttab // # /* no comment\"", "\xc3\xa9\ttab // # /* no comment" },
        { "\"\\\\\" \"n\"", "\\n" },
    };

    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        struct scene *scene;
        char bytes[100];

        snprintf(bytes, sizeof bytes, "a = %s;", pairs[i][0]);
        assert_string_equal(only_text(&scene, bytes), pairs[i][1]);
        scene_free(&scene);
    }
    refused("a = \"x\\\"", "no closing quote");
    refused("a = \"x\" 3", "3 stands where a name is expected");
    refused("a = [\"x\" 3]", "a comma is missing before 3");
    refused("a = 3 \"x\"", "\"x\" stands where a name is expected");
}

static void a_text_is_written_and_read_again(void **state)
{
    char text[256] = "", *written = NULL;
    struct scene *scene;
    size_t n = 0;
    FILE *stream = open_memstream(&written, &n);

    (void)state;
    for (int c = 1; c < 256; c++)
        text[c - 1] = (char)c;
    fputs("a = ", stream);
    scene_write_text(text, stream);
    fclose(stream);
    assert_string_equal(only_text(&scene, written), text);
    scene_free(&scene);
    free(written);
}

/* --- numbers ------------------------------------------------------------------------------ */

static void every_double_is_read_to_its_last_bit(void **state)
{
    unsigned long bits = 1;

    (void)state;
    for (int i = 0; i < 2000; i++) {
        char bytes[60];
        double x, y;
        struct scene *scene;

        bits = bits * 6364136223846793005UL + 1442695040888963407UL;
        memcpy(&x, &bits, sizeof x);
        if (!(x - x == 0))
            continue;
        snprintf(bytes, sizeof bytes, i % 2 ? "a = %.17g" : "a = %.16e", x);
        scene = read_bytes(bytes, strlen(bytes), STATUS_DONE);
        y = scene_at(scene_root(scene), 0)->number;
        assert_memory_equal(&x, &y, sizeof x);
        scene_free(&scene);
    }
}

static void numbers_are_written_as_in_c(void **state)
{
    (void)state;
    reads("a = [1, +1, -0, .5, 5., 0x10, 010, 5L, 5LL, 1E3, 1e+3, 3000000000, -1e999]",
          "@0={a@1=[@1=1 @1=1 @1=-0 @1=0.5 @1=5 @1=16 @1=10 @1=5 @1=5 @1=1000 @1=1000 @1=3e+09 "
          "@1=-inf]}");
    refused("a = 1.2.3", "1.2.3 is not a number");
    refused("a = 1e", "1e is not a number");
    refused("a = 1-2", "1-2 is not a number");
    refused("a = nan", "nan has no quotes");
    refused("a = -inf", "a number must follow - at once");
}

/* --- bytes that might take long -------------------------------------------------------- */

enum { MOST = 8 << 20 }; /* bytes that a scene may have */

/* Reads head, as many units as fit, and tail; answers the scene, in less than a minute. */
static struct scene *much(const char *head, const char *unit, const char *tail)
{
    const size_t n = strlen(unit), room = MOST - strlen(head) - strlen(tail) - 1;
    char *bytes = malloc(MOST + 1), *end = bytes + sprintf(bytes, "%s", head);
    struct scene *scene;
    clock_t start;

    for (size_t i = 0; i < room / n; i++, end += n)
        memcpy(end, unit, n);
    end += sprintf(end, "%s", tail);
    start = clock();
    scene = read_bytes(bytes, (size_t)(end - bytes), STATUS_DONE);
    assert_true(clock() - start < 60 * CLOCKS_PER_SEC);
    free(bytes);
    return scene;
}

static void long_scenes_are_read_in_seconds(void **state)
{
    static const char *const units[] = { "/**/\n", "\n", "#\n", "// x\n", " " };
    struct scene *scene = much("a = ", "\"b\" ", ";");

    (void)state;
    assert_int_equal(strlen(scene_at(scene_root(scene), 0)->text), (MOST - 6) / 4);
    scene_free(&scene);
    scene = much("a = \"", "\\x41", "\";");
    assert_int_equal(strlen(scene_at(scene_root(scene), 0)->text), (MOST - 8) / 4);
    scene_free(&scene);
    scene = much("a = [", "1.25e3, ", "1];");
    assert_int_equal(scene_count(scene_at(scene_root(scene), 0)), (MOST - 9) / 8 + 1);
    scene_free(&scene);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        scene = much("a = 1", units[i], "b = 2");
        assert_int_equal(scene_count(scene_root(scene)), 2);
        scene_free(&scene);
    }
}

/* --- all of them -------------------------------------------------------------------------- */

static int make_file(void **state)
{
    const char *above = getenv("TMPDIR");
    int file;

    (void)state;
    snprintf(path, sizeof path, "%.40s/scene-XXXXXX", above ? above : P_tmpdir);
    file = mkstemp(path);
    return file < 0 ? -1 : close(file);
}

static int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(settings_are_parted_by_anything_or_nothing),
        cmocka_unit_test(lists_hold_values_of_any_kind),
        cmocka_unit_test(groups_in_a_list_may_have_the_same_names),
        cmocka_unit_test(a_node_has_the_line_of_its_first_token),
        cmocka_unit_test(brackets_may_be_64_deep),
        cmocka_unit_test(a_group_may_have_10000_settings),
        cmocka_unit_test(escapes_of_texts_are_those_of_libconfig),
        cmocka_unit_test(a_text_is_written_and_read_again),
        cmocka_unit_test(every_double_is_read_to_its_last_bit),
        cmocka_unit_test(numbers_are_written_as_in_c),
        cmocka_unit_test(long_scenes_are_read_in_seconds),
    };

    return cmocka_run_group_tests(tests, make_file, remove_file);
}
