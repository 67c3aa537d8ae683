/* elastica-theory.c -- tests of src/bodies/elastica*: beams that bend far, against theory
 * and published numbers. */
#include "elastica.h"

#include <stdio.h>

enum { ROWS = 40 };

/* The first four numbers of each line of data/reference/NAME; how many lines. */
static int read_table(const char *name, double (*row)[4])
{
    char path[1024], line[512];
    FILE *file;
    int n = 0;

    snprintf(path, sizeof path, "%s/data/reference/%s",
             getenv("top_srcdir") ? getenv("top_srcdir") : ".", name);
    file = fopen(path, "r");
    if (!file)
        fail_msg("%s is not there", path);
    while (n < ROWS && fgets(line, sizeof line, file))
        n += sscanf(line, "%lf,%lf,%lf,%lf", &row[n][0], &row[n][1], &row[n][2], &row[n][3]) == 4;
    fclose(file);
    assert_true(n > 10);
    return n;
}

/* Lying cantilever of 20 elements, so thin that it does not stretch. */
static void lie(struct bench *b)
{
    bench_defaults(b);
    b->def.angle = 0;
    b->def.thickness = 1e-3;
    b->def.E = 1e9;
    b->def.elements = 20;
}

static double stiffness(const struct bench *b)
{
    return b->def.E * pow(b->def.thickness, 3) / 12;
}

/* Tip of a beam at rest against a row: deflection, shortening over the length, angle.  The
 * mark is 0.5 %; 20 elements are off by 2e-5. */
static void check_row(struct bench *b, const double *row)
{
    struct body_view view;

    bench_settle(b, 0);
    bench_show(b, 0, &view);
    const double L = b->def.length, found[3] = { fabs(view.tip[1]) / L, -view.tip[0] / L,
                                                 fabs(view.tip_angle) * 180 / M_PI };
    for (int i = 0; i < 3; i++)
        if (!(fabs(found[i] - row[1 + i]) <= 1e-4 * row[1 + i] + (row[0] == 0) * 1e-7))
            fail_msg("load %g: column %d is %.8g, not %.8g", row[0], i + 1, found[i], row[1 + i]);
}

static void elastica_under_a_tip_force(void **state)
{
    double row[ROWS][4];
    const int n = read_table("A09a_elastica_tip_load.csv", row);
    struct bench b;

    (void)state;
    for (int i = 0; i < n; i++) {
        lie(&b);
        b.def.tip_force = -row[i][0] * stiffness(&b) / (b.def.length * b.def.length);
        bench_make(&b);
        check_row(&b, row[i]);
        bench_free(&b);
    }
}

static void elastica_under_its_weight(void **state)
{
    double row[ROWS][4];
    const int n = read_table("A09b_elastica_uniform_load.csv", row);
    struct bench b;

    (void)state;
    for (int i = 0; i < n; i++) {
        lie(&b);
        b.scales.g[1] = -row[i][0] * stiffness(&b)
                      / (b.def.density * b.def.thickness * pow(b.def.length, 3));
        bench_make(&b);
        check_row(&b, row[i]);
        bench_free(&b);
    }
}

/* CSM1 and CSM2 of Turek and Hron 2006, data/reference/A11a_turek_hron_reference.csv: a bar
 * in plane strain under its weight.  A thin beam is 0.7 to 1.2 % below their solid. */
static void bar_of_turek_and_hron(void **state)
{
    static const double bar[][3] = { { 1.4e6, -7.187e-3, -66.10e-3 },
                                     { 5.6e6, -0.469e-3, -16.9739e-3 } };
    struct body_view view;
    struct bench b;

    (void)state;
    for (int i = 0; i < 2; i++) {
        bench_defaults(&b);
        b.def.angle = 0;
        b.def.length = 0.35;
        b.def.thickness = 0.02;
        b.def.density = 1000;
        b.def.E = bar[i][0];
        b.def.nu = 0.4;
        b.def.plane = "strain";
        b.def.elements = 20;
        b.scales.g[1] = -2;
        bench_make(&b);
        bench_settle(&b, 0);
        bench_show(&b, 0, &view);
        check_close(view.tip[0] / bar[i][1], 1, 0.015, "u_x");
        check_close(view.tip[1] / bar[i][2], 1, 0.015, "u_y");
        bench_free(&b);
    }
}

/* A step of the implicit midpoint rule; loads are constant. */
static void step(struct bench *b, double h)
{
    double before[BENCH_Y];

    memcpy(before, b->y, sizeof before);
    if (bench_step(b, 0, h / 2) != STATUS_DONE)
        fail_msg("%s", status_message());
    for (int i = 0; i < BENCH_Y; i++)
        b->y[i] = 2 * b->y[i] - before[i];
}

/* Swings down from `angle` over the lowest point; a quarter of the period. */
static double quarter_of_pendulum(double angle, int elements)
{
    struct body_view view;
    struct bench b;
    double t = 0, last = 0;
    const double h = 1e-3;

    bench_defaults(&b);
    b.def.root = "pinned";
    b.def.angle = -90 + angle;
    b.def.E = 1e8;
    b.def.elements = elements;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    const double energy = bench_energy(&b, b.y);
    for (double swung = 0; swung > -angle * M_PI / 180; t += h) {
        last = swung;
        step(&b, h);
        bench_show(&b, 0, &view);
        swung = view.tip_angle;
        check_close(bench_energy(&b, b.y), energy, 1e-3, "energy");
        assert_true(t < 2);
    }
    const double part = (-angle * M_PI / 180 - last) / (view.tip_angle - last);
    bench_free(&b);
    return t - h + part * h;
}

/* Arithmetic-geometric mean. */
static double agm(double a, double b)
{
    for (int i = 0; i < 30; i++) {
        const double mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return a;
}

/* A stiff rod on a hinge: T = 2 pi sqrt(2 L/(3 g))/agm(1, cos(angle/2)). */
static void rods_swing_as_pendulums(void **state)
{
    (void)state;
    for (int elements = 1; elements <= 5; elements += 4)
        for (double angle = 20; angle < 180; angle += 50) {
            const double T = 2 * M_PI * sqrt(2 * 0.2 / (3 * 9.81))
                           / agm(1, cos(angle * M_PI / 360));
            check_close(4 * quarter_of_pendulum(angle, elements) / T, 1, 1e-3, "period");
        }
}

/* Bent by a thousandth of its length: F L^3/(3 EI), F L^2/(2 EI), q L^4/(8 EI). */
static void small_deflections_are_linear(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    for (int n = 1; n <= 40; n += 13) {
        const double EI = 2e6 * 1e-6 / 12, L = 0.2, F = 3e-3 * EI / (L * L);
        bench_defaults(&b);
        b.def.elements = n;
        b.def.tip_force = F;
        bench_make(&b);
        bench_settle(&b, 0);
        bench_show(&b, 0, &view);
        check_close(-view.tip[0] / (F * L * L * L / (3 * EI)), 1, 5e-6, "F L^3/(3 EI)");
        check_close(view.tip_angle / (F * L * L / (2 * EI)), 1, 5e-6, "F L^2/(2 EI)");
        check_close(view.root_moment / (F * L), 1, 5e-6, "moment");
        bench_free(&b);
    }
    bench_defaults(&b);
    b.def.load = 0.01;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(-view.tip[0] / (0.01 * pow(0.2, 4) / (8 * 2e6 * 1e-6 / 12)), 1, 5e-6,
                "q L^4/(8 EI)");
    bench_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elastica_under_a_tip_force),
        cmocka_unit_test(elastica_under_its_weight),
        cmocka_unit_test(small_deflections_are_linear),
        cmocka_unit_test(bar_of_turek_and_hron),
        cmocka_unit_test(rods_swing_as_pendulums),
    };

    return cmocka_run_group_tests_name("elastica-theory", tests, NULL, NULL);
}
