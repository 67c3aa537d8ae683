/* output.c -- unit tests of the room output: files that are whole, also when
 * the disk is full or the run is killed.
 *
 *     output              the tests
 *     output sample DIR   only writes the series that tests/fields-open.sh looks at */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/status.h"
#include "output/cloud.h"
#include "output/fields.h"
#include "output/figures.h"
#include "output/hash.h"
#include "output/json.h"
#include "output/progress.h"
#include "output/series.h"
#include "output/snapshot.h"

#include <hdf5.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static char dir[64]; /* of this test, removed after it */

static int make_dir(void **state)
{
    (void)state;
    snprintf(dir, sizeof dir, "/tmp/stiffwater-output-XXXXXX");
    status_clear();
    return mkdtemp(dir) ? 0 : -1;
}

static int remove_dir(void **state)
{
    char command[96];

    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", dir);
    return system(command);
}

/* "DIR/NAME", good until the fourth call after this one. */
static const char *in_dir(const char *name)
{
    static char path[4][256];
    static int turn;

    turn = (turn + 1) % 4;
    snprintf(path[turn], sizeof path[turn], "%s/%s", dir, name);
    return path[turn];
}

/* Everything in a file; "" when there is none. */
static const char *contents(const char *name)
{
    static char text[1 << 20];
    FILE *in = fopen(in_dir(name), "r");
    size_t n = 0;

    if (in) {
        n = fread(text, 1, sizeof text - 1, in);
        fclose(in);
    }
    text[n] = '\0';
    return text;
}

static void put(const char *name, const char *text)
{
    FILE *to = fopen(in_dir(name), "w");

    assert_non_null(to);
    fputs(text, to);
    assert_int_equal(fclose(to), 0);
}

static int exists(const char *name)
{
    return access(in_dir(name), F_OK) == 0;
}

/* --- series ------------------------------------------------------------------------ */

static const char *const names[] = { "t", "x", "where" };
static const char *const units[] = { "s", "m", "" };

static void test_series_reads_back(void **state)
{
    const double row[][3] = { { 0.123456789012, -1.2345678901, 0 }, { 1e-300, INFINITY, -NAN } };
    double t, x;
    struct series *s;

    (void)state;
    assert_int_equal(series_open(&s, in_dir("a.csv"), 3, names, units), STATUS_DONE);
    assert_int_equal(series_text_row(s, row[0], (const char *[]){ NULL, NULL, "a, \"b\"" }), 0);
    assert_int_equal(series_row(s, row[1]), STATUS_DONE);
    assert_int_equal(series_close(&s), STATUS_DONE);
    assert_null(s);
    assert_string_equal(contents("a.csv"), "# units: s,m,\nt,x,where\n"
                        "0.123456789012,-1.23456789,\"a, \"\"b\"\"\"\n1e-300,inf,nan\n");
    assert_int_equal(sscanf(strstr(contents("a.csv"), "0.12"), "%lf,%lf", &t, &x), 2);
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
    assert_int_equal(series_open(&s, in_dir("no/where.csv"), 3, names, units), STATUS_IO);
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
        || series_open(&s, in_dir("full.csv"), 3, names, units) != STATUS_DONE)
        return 99;
    for (int i = 0; i < 1000 && code == STATUS_DONE; i++)
        code = series_row(s, row);
    return code == STATUS_IO && series_close(&s) == STATUS_IO ? 0 : 98;
}

static int child_of(int (*work)(void))
{
    int ended;
    const pid_t child = fork();

    if (child == 0)
        _exit(work());
    assert_int_equal(waitpid(child, &ended, 0), child);
    return WIFSIGNALED(ended) ? 1000 + WTERMSIG(ended) : WEXITSTATUS(ended);
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
    assert_int_equal(child_of(fill_up), 0);
    assert_whole_lines(contents("full.csv"), "\n0.333333333333,0.6666666667,0\n");
    assert_true(strlen(contents("full.csv")) > 9000);
}

static int die_while_writing(void)
{
    const double row[] = { 1.0 / 3, 2.0 / 3, 0 };
    struct series *s;

    if (series_open(&s, in_dir("killed.csv"), 3, names, units) != STATUS_DONE)
        return 99;
    for (int i = 0; i < 1000; i++)
        series_row(s, row);
    return raise(SIGKILL);
}

static void test_series_leaves_whole_lines_when_killed(void **state)
{
    (void)state;
    assert_int_equal(child_of(die_while_writing), 1000 + SIGKILL);
    assert_whole_lines(contents("killed.csv"), "\n0.333333333333,0.6666666667,0\n");
    assert_true(strlen(contents("killed.csv")) > 20 * 1000); /* of 30 * 1000: 4 kB held back */
}

static void test_series_is_not_older_than_a_second(void **state)
{
    const double row[] = { 1, 2, 3 };
    struct series *s;

    (void)state;
    assert_int_equal(series_open(&s, in_dir("slow.csv"), 3, names, units), STATUS_DONE);
    usleep(1050000);
    assert_int_equal(series_row(s, row), STATUS_DONE);
    assert_whole_lines(contents("slow.csv"), "\n1,2,3\n");
    assert_int_equal(series_close(&s), STATUS_DONE);
}

/* --- json, hash -------------------------------------------------------------------- */

static void test_json(void **state)
{
    struct json *j;

    (void)state;
    assert_int_equal(json_open(&j, in_dir("a.json")), STATUS_DONE);
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
    assert_false(exists("a.json")); /* not before it is whole */
    assert_int_equal(json_close(&j), STATUS_DONE);
    assert_null(j);
    assert_false(exists("a.json.part"));
    assert_string_equal(contents("a.json"),
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
    if (setrlimit(RLIMIT_FSIZE, &most) != 0 || json_open(&j, in_dir("b.json")) != STATUS_DONE)
        return 99;
    for (int i = 0; i < 100; i++)
        json_integer(j, "n", i);
    return json_close(&j) == STATUS_IO && strstr(status_message(), "b.json") ? 0 : 98;
}

static void test_json_keeps_the_old_file_on_a_full_disk(void **state)
{
    (void)state;
    put("b.json", "{}\n");
    assert_int_equal(child_of(json_fill_up), 0);
    assert_string_equal(contents("b.json"), "{}\n");
    assert_false(exists("b.json.part"));
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

/* --- particles --------------------------------------------------------------------- */

enum { N = 30, MOMENTS = 3 };

/* Particle i at moment k: pressure 10 i + k, dye i % 2, kind i % 5. */
static struct cloud_frame sample(int dim, int k)
{
    static double x[3 * N], u[3 * N], rho[N], p[N];
    static unsigned char dye[N], kind[N];

    for (int i = 0; i < N; i++) {
        for (int d = 0; d < dim; d++) {
            x[dim * i + d] = i + 100 * d + 0.5 * k;
            u[dim * i + d] = i * d + k;
        }
        rho[i] = 1000 + i;
        p[i] = 10 * i + k;
        dye[i] = (unsigned char)(i % 2);
        kind[i] = (unsigned char)(i % 5);
    }
    return (struct cloud_frame){ 0.1 * k + 0.01 * k * k, N, dim, x, u, rho, p, dye, kind, NULL };
}

static int write_sample(const char *where, int dim)
{
    struct fields *f;

    TRY(fields_open(&f, where));
    for (int k = 0; k < MOMENTS; k++) {
        const struct cloud_frame frame = sample(dim, k);
        TRY(fields_write(f, &frame));
    }
    fields_close(&f);
    return STATUS_DONE;
}

static void read_array(const char *name, const char *array, hid_t type, int rank, hsize_t columns,
                       void *to)
{
    const hid_t file = H5Fopen(in_dir(name), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t set = H5Dopen2(file, array, H5P_DEFAULT), space = H5Dget_space(set);
    hsize_t size[2] = { 0, 1 };

    assert_true(file >= 0 && set >= 0);
    assert_int_equal(H5Sget_simple_extent_ndims(space), rank);
    H5Sget_simple_extent_dims(space, size, NULL);
    assert_int_equal(size[0], N);
    assert_int_equal(size[1], columns);
    assert_true(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) >= 0);
    H5Sclose(space);
    H5Dclose(set);
    H5Fclose(file);
}

static void check_fields(int dim)
{
    static double x[N][3], p[N];
    static int id[N], kind[N];
    const struct cloud_frame frame = sample(dim, 2);

    assert_int_equal(write_sample(dir, dim), STATUS_DONE);
    read_array("fields/000002.vtkhdf", "/VTKHDF/Points", H5T_NATIVE_DOUBLE, 2, 3, x);
    read_array("fields/000002.vtkhdf", "/VTKHDF/PointData/pressure", H5T_NATIVE_DOUBLE, 1, 1, p);
    read_array("fields/000002.vtkhdf", "/VTKHDF/PointData/id", H5T_NATIVE_INT, 1, 1, id);
    read_array("fields/000002.vtkhdf", "/VTKHDF/PointData/kind", H5T_NATIVE_INT, 1, 1, kind);
    for (int i = 0; i < N; i++) {
        for (int d = 0; d < 3; d++)
            assert_true(x[i][d] == (d < dim ? frame.x[dim * i + d] : 0));
        assert_true(p[i] == frame.p[i] && id[i] == i && kind[i] == i % 5);
    }
    read_array("fields/000001.vtkhdf", "/VTKHDF/PointData/velocity", H5T_NATIVE_DOUBLE, 2, 3, x);
    assert_true(x[7][0] == 1 && x[7][1] == 8 && x[7][2] == (dim == 3 ? 15 : 0));
}

static void test_fields_read_back(void **state)
{
    (void)state;
    check_fields(2);
    check_fields(3);
}

static int count(const char *text, const char *what)
{
    int n = 0;

    for (const char *s = text; (s = strstr(s, what)); s++)
        n++;
    return n;
}

/* Whatever the index names is there, with the shape it says. */
static void test_index_is_consistent(void **state)
{
    static double u[N][3];
    const char *index;

    (void)state;
    assert_int_equal(write_sample(dir, 2), STATUS_DONE);
    index = contents("fields.xdmf");
    assert_int_equal(count(index, "<Time Value="), MOMENTS);
    assert_int_equal(count(index, "<Topology "), MOMENTS);
    assert_int_equal(count(index, "NumberOfElements=\"30\""), MOMENTS);
    assert_int_equal(count(index, "<DataItem Dimensions=\"30 3\""), 2 * MOMENTS);
    assert_int_equal(count(index, "<DataItem Dimensions=\"30\""), 6 * MOMENTS);
    assert_non_null(strstr(index, "<Time Value=\"0.24"));
    assert_int_equal(count(index, "</Xdmf>"), 1);
    for (const char *s = index; (s = strstr(s, "Format=\"HDF\">")); s++) {
        char name[64], array[64];
        assert_int_equal(sscanf(s, "Format=\"HDF\">%63[^:]:%63[^<]", name, array), 2);
        read_array(name, array, H5T_NATIVE_DOUBLE, strstr(array, "Points")
                   || strstr(array, "velocity") ? 2 : 1,
                   strstr(array, "Points") || strstr(array, "velocity") ? 3 : 1, u);
    }
    assert_false(exists("fields.xdmf.part"));
}

/* A disk that fills up: STATUS_IO with path and reason, index and files stay whole. */
static int fields_fill_up(void)
{
    struct cloud_frame frame = sample(2, 0);
    struct rlimit most = { 1 << 20, 1 << 20 };
    struct fields *f;

    signal(SIGXFSZ, SIG_IGN);
    if (fields_open(&f, dir) != STATUS_DONE || fields_write(f, &frame) != STATUS_DONE)
        return 99;
    most.rlim_cur = most.rlim_max = 5000;
    if (setrlimit(RLIMIT_FSIZE, &most) != 0)
        return 98;
    frame.t = 1;
    if (fields_write(f, &frame) != STATUS_IO)
        return 97;
    fields_close(&f);
    return strstr(status_message(), "000001.vtkhdf") && strstr(status_message(), "File too large")
           ? 0 : 96;
}

static void test_fields_tell_of_a_full_disk(void **state)
{
    (void)state;
    assert_int_equal(child_of(fields_fill_up), 0);
    assert_int_equal(count(contents("fields.xdmf"), "<Time Value="), 1);
    assert_true(exists("fields/000000.vtkhdf"));
    assert_false(exists("fields/000001.vtkhdf"));
    assert_false(exists("fields/000001.vtkhdf.part"));
}

static void test_snapshots(void **state)
{
    const struct cloud_frame frame[2] = { sample(2, 1), sample(3, 1) };
    struct snapshot *s;

    (void)state;
    for (int i = 0; i < 2; i++) {
        assert_int_equal(snapshot_open(&s, dir), STATUS_DONE);
        struct cloud_frame now = sample(i + 2, 1);
        assert_int_equal(snapshot_write(s, &now), STATUS_DONE);
        assert_string_equal(contents("snapshots.csv"),
                            "# units: s,\nt,file\n0.11,snapshots/0000.csv\n");
        now.t = frame[i].t + 1;
        assert_int_equal(snapshot_write(s, &now), STATUS_DONE);
        assert_int_equal(snapshot_close(&s), STATUS_DONE);
        assert_non_null(strstr(contents("snapshots.csv"), "\n1.11,snapshots/0001.csv\n"));
        assert_int_equal(count(contents("snapshots/0001.csv"), "\n"), N + 3);
        assert_non_null(strstr(contents("snapshots/0000.csv"),
                               i == 0 ? "x,y,ux,uy,rho,p,dye,kind\n0.5,100.5,1,1,1000,1,0,0\n"
                                      : "x,y,z,ux,uy,uz,rho,p,dye,kind\n"
                                        "0.5,100.5,200.5,1,1,1,1000,1,0,0\n1.5,101.5,201.5,1,2,3"));
    }
}

/* --- progress, figures ------------------------------------------------------------- */

static void test_progress_into_a_file(void **state)
{
    struct progress p;
    FILE *to = fopen(in_dir("log"), "w");

    (void)state;
    progress_start(&p, to, 0, 2, false);
    for (int i = 1; i <= 1000; i++)
        progress_step(&p, 0.001 * i, 1e-3, "stability");
    progress_end(&p, 1);
    fclose(to);
    assert_int_equal(count(contents("log"), "\n"), 2); /* the first and the last */
    assert_non_null(strstr(contents("log"), "t = 0.001 of 2 s  step 1.00e-03 s (stability)"));
    assert_non_null(strstr(contents("log"), " 50.0 %  t = 1 of 2 s"));
    assert_null(strchr(contents("log"), '\r'));
}

static void test_quiet_progress(void **state)
{
    struct progress p;
    FILE *to = fopen(in_dir("log"), "w");

    (void)state;
    progress_start(&p, to, 0, 2, true);
    progress_step(&p, 1, 1e-3, "error");
    progress_end(&p, 2);
    fclose(to);
    assert_string_equal(contents("log"), "");
}

/* Scripts and a run for them: `good` applies, the needs of the others are missing. */
static void make_scripts(void)
{
    mkdir(in_dir("plots"), 0777);
    mkdir(in_dir("reference"), 0777);
    mkdir(in_dir("run it's"), 0777);
    put("plots/helper.gp", "# helper.gp -- nothing to draw\nseen = 1\n");
    put("plots/good.gp", "# good.gp\n# needs: a.csv\n# reference: r.csv\nload 'helper.gp'\n"
        "set print 'good.png'; print seen; print system('cat r.csv')\n");
    put("plots/norows.gp", "# needs: a.csv empty.csv\nset print 'norows.png'; print 1\n");
    put("plots/nofile.gp", "# needs: none.csv\nset print 'nofile.png'; print 1\n");
    put("reference/r.csv", "T,Z\n");
    put("run it's/a.csv", "# units: s\nt\n1\n");
    put("run it's/empty.csv", "# units: s\nt\n");
}

static void test_figures(void **state)
{
    char run[256], plots[256];
    const char *path = getenv("PATH");

    (void)state;
    make_scripts();
    snprintf(run, sizeof run, "%s", in_dir("run it's"));
    snprintf(plots, sizeof plots, "%s", in_dir("plots"));
    if (system("gnuplot --version >/dev/null 2>&1") == 0) {
        assert_int_equal(figures_draw(run, plots, in_dir("reference")), STATUS_DONE);
        assert_string_equal(contents("run it's/figures/good.png"), "1\nT,Z\n");
        assert_true(exists("run it's/figures/good.gp") && exists("run it's/figures/r.csv"));
        assert_false(exists("run it's/figures/norows.png"));
        assert_false(exists("run it's/figures/nofile.png"));
        assert_false(exists("run it's/figures/good.gp.log"));
        put("plots/bad.gp", "# needs: a.csv\nplot nonsense(\n");
        remove(in_dir("run it's/figures/good.png"));
        assert_int_equal(figures_draw(run, plots, in_dir("reference")), STATUS_IO);
        assert_non_null(strstr(status_message(), "bad.gp"));
        assert_true(exists("run it's/figures/good.png")); /* drawn all the same */
        assert_true(exists("run it's/figures/bad.gp.log"));
        status_clear();
    }
    setenv("PATH", "/nowhere", 1);
    assert_int_equal(figures_draw(run, plots, in_dir("reference")), STATUS_IO);
    setenv("PATH", path, 1);
    assert_non_null(strstr(status_message(), "gnuplot-nox"));
}

static void test_constants(void **state)
{
    const struct figures_constants c = { .title = "Tóth's \"dam\"\n", .dim = 2, .a = NAN,
                                         .g = 9.81, .high = { 0.5, 0.25 } };

    (void)state;
    assert_int_equal(figures_constants(dir, &c), STATUS_DONE);
    assert_non_null(strstr(contents("figures/constants.gp"), "title = 'Tóth''s \"dam\" '\n"));
    assert_non_null(strstr(contents("figures/constants.gp"), "\na = NaN\n"));
    assert_non_null(strstr(contents("figures/constants.gp"), "\nhigh_y = 0.25\n"));
    assert_null(strstr(contents("figures/constants.gp"), "high_z"));
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, make_dir, remove_dir)

int main(int words, char **word)
{
    const struct CMUnitTest tests[] = {
        TEST(test_series_reads_back),
        TEST(test_series_tells_of_a_full_disk),
        TEST(test_series_leaves_whole_lines_on_a_full_disk),
        TEST(test_series_leaves_whole_lines_when_killed),
        TEST(test_series_is_not_older_than_a_second),
        TEST(test_json),
        TEST(test_json_keeps_the_old_file_on_a_full_disk),
        TEST(test_hash),
        TEST(test_fields_read_back),
        TEST(test_index_is_consistent),
        TEST(test_fields_tell_of_a_full_disk),
        TEST(test_snapshots),
        TEST(test_progress_into_a_file),
        TEST(test_quiet_progress),
        TEST(test_figures),
        TEST(test_constants),
    };

    if (words == 3 && !strcmp(word[1], "sample"))
        return write_sample(word[2], 2);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
