/* output.c -- unit tests of the room output: files that are whole, also when
 * the disk is full or the run is killed.
 *
 *     output              the tests
 *     output sample DIR   only writes the series that tests/fields-open.sh looks at */
#include "output.h"

#include "base/status.h"
#include "output/hash.h"
#include "output/json.h"
#include "output/progress.h"
#include "output/series.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

char output_dir[64];

int output_make_dir(void **state)
{
    (void)state;
    snprintf(output_dir, sizeof output_dir, P_tmpdir "/stiffwater-output-XXXXXX");
    status_clear();
    return mkdtemp(output_dir) ? 0 : -1;
}

int output_remove_dir(void **state)
{
    char command[96];

    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", output_dir);
    return system(command);
}

const char *output_path(const char *name)
{
    static char path[4][256];
    static int turn;

    turn = (turn + 1) % 4;
    snprintf(path[turn], sizeof path[turn], "%s/%s", output_dir, name);
    return path[turn];
}

const char *output_contents(const char *name)
{
    static char text[1 << 20];
    FILE *in = fopen(output_path(name), "r");
    size_t n = 0;

    if (in) {
        n = fread(text, 1, sizeof text - 1, in);
        fclose(in);
    }
    text[n] = '\0';
    return text;
}

void output_put(const char *name, const char *text)
{
    FILE *to = fopen(output_path(name), "w");

    assert_non_null(to);
    fputs(text, to);
    assert_int_equal(fclose(to), 0);
}

int output_exists(const char *name)
{
    return access(output_path(name), F_OK) == 0;
}

int output_child(int (*work)(void))
{
    int ended;
    const pid_t child = fork();

    if (child == 0)
        _exit(work());
    assert_int_equal(waitpid(child, &ended, 0), child);
    return WIFSIGNALED(ended) ? 1000 + WTERMSIG(ended) : WEXITSTATUS(ended);
}

int output_count(const char *text, const char *what)
{
    int n = 0;

    for (const char *s = text; (s = strstr(s, what)); s++)
        n++;
    return n;
}

/* --- series ------------------------------------------------------------------------ */

static const char *const names[] = { "t", "x", "where" };
static const char *const units[] = { "s", "m", "" };

static void test_series_reads_back(void **state)
{
    const double row[][3] = { { 0.123456789012, -1.2345678901, 0 }, { -0.0, INFINITY, -NAN } };
    double t, x;
    struct series *s;

    (void)state;
    assert_int_equal(series_open(&s, output_path("a.csv"), 3, names, units), STATUS_DONE);
    assert_int_equal(series_text_row(s, row[0], (const char *[]){ NULL, NULL, "a, \"b\"" }), 0);
    assert_int_equal(series_row(s, row[1]), STATUS_DONE);
    assert_int_equal(series_close(&s), STATUS_DONE);
    assert_null(s);
    assert_string_equal(output_contents("a.csv"),
                        "# units: s,m,\nt,x,where\n"
                        "0.123456789012,-1.23456789,\"a, \"\"b\"\"\"\n0,inf,nan\n");
    assert_int_equal(sscanf(strstr(output_contents("a.csv"), "0.12"), "%lf,%lf", &t, &x), 2);
    assert_true(t == row[0][0] && fabs(x - row[0][1]) < 1e-9);
}

static void test_series_tells_of_a_full_disk(void **state)
{
    struct series *s;

    (void)state;
    assert_int_equal(series_open(&s, "/dev/full", 3, names, units), STATUS_IO);
    assert_null(s);
    assert_non_null(strstr(status_message(), "/dev/full"));
    assert_non_null(strstr(status_message(), "No space left"));
    status_clear();
    assert_int_equal(series_open(&s, output_path("no/where.csv"), 3, names, units), STATUS_IO);
    assert_non_null(strstr(status_message(), "No such file"));
}

/* In a child, because the limit on the size of files cannot be taken back: the
 * file ends with a whole line, and all later rows fail too. */
static int fill_up(void)
{
    const struct rlimit most = { 10000, 10000 };
    const double row[] = { 1.0 / 3, 2.0 / 3, 0 };
    int code = STATUS_DONE;
    struct series *s;

    signal(SIGXFSZ, SIG_IGN);
    if (setrlimit(RLIMIT_FSIZE, &most) != 0
        || series_open(&s, output_path("full.csv"), 3, names, units) != STATUS_DONE)
        return 99;
    for (int i = 0; i < 1000 && code == STATUS_DONE; i++)
        code = series_row(s, row);
    return code == STATUS_IO && series_close(&s) == STATUS_IO ? 0 : 98;
}

static void assert_whole_lines(const char *text, const char *last)
{
    const size_t n = strlen(text), m = strlen(last);

    assert_true(n > m);
    assert_string_equal(text + n - m, last);
}

static void test_series_leaves_whole_lines_on_a_full_disk(void **state)
{
    (void)state;
    assert_int_equal(output_child(fill_up), 0);
    assert_whole_lines(output_contents("full.csv"), "\n0.333333333333,0.6666666667,0\n");
    assert_true(strlen(output_contents("full.csv")) > 9000);
}

static int die_while_writing(void)
{
    const double row[] = { 1.0 / 3, 2.0 / 3, 0 };
    struct series *s;

    if (series_open(&s, output_path("killed.csv"), 3, names, units) != STATUS_DONE)
        return 99;
    for (int i = 0; i < 1000; i++)
        series_row(s, row);
    return raise(SIGKILL);
}

static void test_series_leaves_whole_lines_when_killed(void **state)
{
    (void)state;
    assert_int_equal(output_child(die_while_writing), 1000 + SIGKILL);
    assert_whole_lines(output_contents("killed.csv"), "\n0.333333333333,0.6666666667,0\n");
    assert_true(strlen(output_contents("killed.csv"))
                > 20 * 1000); /* of 30 * 1000: 4 kB held back */
}

static void test_series_is_not_older_than_a_second(void **state)
{
    const double row[] = { 1, 2, 3 };
    struct series *s;

    (void)state;
    assert_int_equal(series_open(&s, output_path("slow.csv"), 3, names, units), STATUS_DONE);
    usleep(1050000);
    assert_int_equal(series_row(s, row), STATUS_DONE);
    assert_whole_lines(output_contents("slow.csv"), "\n1,2,3\n");
    assert_int_equal(series_close(&s), STATUS_DONE);
}

/* --- json, hash -------------------------------------------------------------------- */

static void test_json(void **state)
{
    struct json *j;

    (void)state;
    assert_int_equal(json_open(&j, output_path("a.json")), STATUS_DONE);
    json_text(j, "te\"xt", "\\ \n \x01 \xc3\xa1 \xff.");
    json_text(j, "none", NULL);
    json_number(j, "third", 1.0 / 3);
    json_number(j, "nan", NAN);
    json_number(j, "inf", -INFINITY);
    json_object(j, "empty");
    json_end(j);
    json_object(j, "inside");
    json_integer(j, "n", -9007199254740993);
    json_flag(j, "yes", true);
    assert_false(output_exists("a.json")); /* not before it is whole */
    assert_int_equal(json_close(&j), STATUS_DONE);
    assert_null(j);
    assert_false(output_exists("a.json.part"));
    assert_string_equal(output_contents("a.json"),
                        "{\n  \"te\\\"xt\": \"\\\\ \\u000a \\u0001 \xc3\xa1 \\ufffd.\",\n"
                        "  \"none\": null,\n  \"third\": 0.33333333333333331,\n"
                        "  \"nan\": null,\n  \"inf\": null,\n  \"empty\": {},\n"
                        "  \"inside\": {\n    \"n\": -9007199254740993,\n    \"yes\": true\n"
                        "  }\n}\n");
}

static int json_fill_up(void)
{
    const struct rlimit most = { 100, 100 };
    struct json *j;

    signal(SIGXFSZ, SIG_IGN);
    if (setrlimit(RLIMIT_FSIZE, &most) != 0 || json_open(&j, output_path("b.json")) != STATUS_DONE)
        return 99;
    for (int i = 0; i < 100; i++)
        json_integer(j, "n", i);
    return json_close(&j) == STATUS_IO && strstr(status_message(), "b.json") ? 0 : 98;
}

static void test_json_keeps_the_old_file_on_a_full_disk(void **state)
{
    (void)state;
    output_put("b.json", "{}\n");
    assert_int_equal(output_child(json_fill_up), 0);
    assert_string_equal(output_contents("b.json"), "{}\n");
    assert_false(output_exists("b.json.part"));
}

/* Values of the test suite in draft-eastlake-fnv. */
static void test_hash(void **state)
{
    char text[HASH_TEXT];

    (void)state;
    assert_string_equal(hash_text(hash_bytes(HASH_START, "", 0), text), "cbf29ce484222325");
    assert_string_equal(hash_text(hash_bytes(HASH_START, "a", 1), text), "af63dc4c8601ec8c");
    assert_string_equal(hash_text(hash_bytes(HASH_START, "foobar", 6), text), "85944171f73967e8");
    assert_true(hash_bytes(hash_bytes(HASH_START, "foo", 3), "bar", 3)
                == hash_bytes(HASH_START, "foobar", 6));
    assert_string_equal(hash_text(0x1f, text), "000000000000001f");
}

/* --- progress ---------------------------------------------------------------------- */

static void test_progress_into_a_file(void **state)
{
    struct progress p;
    FILE *to = fopen(output_path("log"), "w");

    (void)state;
    progress_start(&p, to, 0, 2, false);
    for (int i = 1; i <= 1000; i++)
        progress_step(&p, 0.001 * i, 1e-3, "stability");
    progress_end(&p, 1);
    fclose(to);
    assert_int_equal(output_count(output_contents("log"), "\n"), 2); /* the first and the last */
    assert_non_null(
        strstr(output_contents("log"), "t = 0.001 of 2 s  step 1.00e-03 s (stability)"));
    assert_non_null(strstr(output_contents("log"), " 50.0 %  t = 1 of 2 s"));
    assert_null(strchr(output_contents("log"), '\r'));
}

static void test_quiet_progress(void **state)
{
    struct progress p;
    FILE *to = fopen(output_path("log"), "w");

    (void)state;
    progress_start(&p, to, 0, 2, true);
    progress_step(&p, 1, 1e-3, "error");
    progress_end(&p, 2);
    fclose(to);
    assert_string_equal(output_contents("log"), "");
}

int main(int words, char **word)
{
    const struct CMUnitTest tests[] = {
        OUTPUT_TEST(test_series_reads_back),
        OUTPUT_TEST(test_series_tells_of_a_full_disk),
        OUTPUT_TEST(test_series_leaves_whole_lines_on_a_full_disk),
        OUTPUT_TEST(test_series_leaves_whole_lines_when_killed),
        OUTPUT_TEST(test_series_is_not_older_than_a_second),
        OUTPUT_TEST(test_json),
        OUTPUT_TEST(test_json_keeps_the_old_file_on_a_full_disk),
        OUTPUT_TEST(test_hash),
        OUTPUT_TEST(test_progress_into_a_file),
        OUTPUT_TEST(test_quiet_progress),
        OUTPUT_TEST(test_fields_read_back),
        OUTPUT_TEST(test_index_is_consistent),
        OUTPUT_TEST(test_fields_tell_of_a_full_disk),
        OUTPUT_TEST(test_snapshots),
        OUTPUT_TEST(test_figures),
        OUTPUT_TEST(test_figures_of_users),
        OUTPUT_TEST(test_constants_of_strangers),
        OUTPUT_TEST(test_constants),
    };

    if (words == 3 && !strcmp(word[1], "sample"))
        return output_write_sample(word[2], 2);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
