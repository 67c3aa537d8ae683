/* shots.c -- which particles a picture shows: those in front, of each moment that is chosen. */
#include "scratch.h"

#include "base/status.h"
#include "output/canvas.h"
#include "output/shots.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>

/* Of discs behind each other the near one is seen, whatever comes first; one that looks out is, too. */
static void the_near_one_is_seen(void **state)
{
    unsigned char seen[4] = { 0 };
    struct canvas c;

    (void)state;
    assert_int_equal(canvas_make(&c, 0, 10, 0, 10, 0.5), STATUS_DONE);
    canvas_disc(&c, 5, 5, 2, 3, 0);
    canvas_disc(&c, 5, 5, 1, 1, 1); /* behind disc 0 */
    canvas_disc(&c, 6, 5, 2, 2, 2); /* behind it, but looks out on the right */
    canvas_disc(&c, 50, 5, 2, 9, 3); /* beside the picture */
    canvas_mark(&c, seen);
    canvas_free(&c);
    assert_int_equal(seen[0], 1);
    assert_int_equal(seen[1], 0);
    assert_int_equal(seen[2], 1);
    assert_int_equal(seen[3], 0);
}

/* Below the directory of this test. */
static const char *below(const char *name)
{
    static char path[200];

    snprintf(path, sizeof path, "%s/%s", scratch, name);
    return path;
}

/* --- a run of made-up snapshots ------------------------------------------------------------ */

static FILE *open_in(const char *dir, const char *name)
{
    char path[900];

    snprintf(path, sizeof path, "%s/%s", dir, name);
    return fopen(path, "w");
}

/* A cube of n^3 particles in a tank, whose pressure tells the moment, in k. */
static void write_run(const char *run, int moments, int n)
{
    char name[400];
    FILE *list;

    snprintf(name, sizeof name, "%s/snapshots", run);
    mkdir(name, 0777);
    FILE *constants = open_in(run, "constants.gp");
    fputs("dim = 3\ndx = 0.1\nwalls_move = 0\nlow_x = 0.0\nlow_y = 0.0\nlow_z = 0.0\n"
          "high_x = 4.0\nhigh_y = 2.0\nhigh_z = 2.0\n", constants);
    fclose(constants);
    list = open_in(run, "snapshots.csv");
    fputs("# units: s,\nt,file\n", list);
    for (int k = 0; k < moments; k++) {
        snprintf(name, sizeof name, "snapshots/%04d.csv", k);
        fprintf(list, "%d,%s\n", k, name);
        FILE *to = open_in(run, name);
        fprintf(to, "# t = %d s\n# units: m\nx,y,z,ux,uy,uz,rho,p,dye,kind\n", k);
        for (int i = 0; i < n * n * n; i++)
            fprintf(to, "%g,%g,%g,3,0,4,1000,%d,0,0\n", 0.05 + 0.1 * (i % n),
                    0.05 + 0.1 * (i / n % n), 0.05 + 0.1 * (i / n / n), k);
        fclose(to);
    }
    fclose(list);
}

/* Rows of a table below its lines of head; the last numbers of one, by column, in row. */
static int read_rows(const char *run, const char *name, int head, double *row)
{
    char path[900], line[400];
    int n = -head;

    snprintf(path, sizeof path, "%s/%s", run, name);
    FILE *in = fopen(path, "r");
    assert_non_null(in);
    while (fgets(line, sizeof line, in))
        if (++n > 0)
            for (char *at = line; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL)
                row[at == line ? 0 : 1] = atof(at);
    fclose(in);
    return n;
}

/* From the side and above a cube shows three faces and no more than the layer behind. */
static void what_is_inside_is_left_out(void **state)
{
    enum { N = 20 };
    const char *run = below("cube");
    double row[2];

    (void)state;
    mkdir(run, 0777);
    write_run(run, 8, N);
    assert_int_equal(shots_prepare(run, run), STATUS_DONE);
    const int seen = read_rows(run, "view-1.csv", 3, row);
    assert_true(seen >= 3 * N * N - 3 * N && seen < 2 * 3 * N * N);
    assert_true(row[1] == 5); /* speed */
    /* a cut is two particles thick, along the floor three layers */
    assert_int_equal(read_rows(run, "cut-1.csv", 3, row) <= 2 * N * N, 1);
    assert_int_equal(read_rows(run, "floor-6.csv", 3, row) <= 3 * N * N, 1);
}

/* Six of eight: the first, the last, and 1, 3, 4, 6 between. */
static void moments_are_spread(void **state)
{
    static const double t[] = { 0, 1, 3, 4, 6, 7 };
    const char *run = below("cube");
    char line[400], path[900];
    FILE *in;
    int n = -2;

    (void)state;
    snprintf(path, sizeof path, "%s/shots.csv", run);
    in = fopen(path, "r");
    assert_non_null(in);
    for (; fgets(line, sizeof line, in); n++) {
        double at, low, high;
        if (n < 0)
            continue;
        assert_int_equal(sscanf(line, "%lf,../snapshots/%*d,%lf,%lf", &at, &low, &high), 3);
        assert_true(at == t[n] && low == t[n] && high == t[n]); /* pressure tells the moment */
    }
    assert_int_equal(n, 6);
    fclose(in);
}

static void a_torn_row_is_told(void **state)
{
    const char *run = below("torn");
    FILE *to;

    (void)state;
    mkdir(run, 0777);
    write_run(run, 1, 2);
    to = open_in(run, "snapshots/0000.csv");
    fputs("# t = 0 s\n# units: m\nx,y,z,ux,uy,uz,rho,p,dye,kind\n1,2,3,0,0\n", to);
    fclose(to);
    assert_int_equal(shots_prepare(run, run), STATUS_IO);
    assert_non_null(strstr(status_message(), "0000.csv:4"));
    status_clear();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_near_one_is_seen),
        cmocka_unit_test(what_is_inside_is_left_out),
        cmocka_unit_test(moments_are_spread),
        cmocka_unit_test(a_torn_row_is_told),
    };

    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
