/* beam-theory.c -- tests of src/bodies/beam: deflections and periods of beam theory. */
#include "beam.h"

/* F L^3/(3 EI), root force F and moment F L, for 1 to 100 elements. */
static void tip_force_bends_as_theory_says(void **state)
{
    (void)state;
    for (int n = 1; n <= 100; n++) {
        const double EI = 2e6 * 1e-6 / 12, F = 0.3, L = 0.2;
        struct body_view view;
        struct bench b;
        bench_defaults(&b);
        b.def.elements = n;
        b.def.tip_force = F;
        bench_make(&b);
        bench_settle(&b, 0);
        bench_show(&b, 0, &view);
        check_close(view.tip[0] / (-F * L * L * L / (3 * EI)), 1, 1e-8, "F L^3/(3 EI)");
        check_close(view.mid[0] / (-F * L * L * L * 5 / (48 * EI)), 1, 1e-8, "5 F L^3/(48 EI)");
        check_close(view.tip_angle / (F * L * L / (2 * EI)), 1, 1e-8, "F L^2/(2 EI)");
        check_close(view.root_force / F, 1, 1e-6, "root force");
        check_close(view.root_moment / (F * L), 1, 1e-6, "root moment");
        bench_free(&b);
    }
}

/* q L^4/(8 EI) lying down, by weight and, for the catalogue's A08c, by a load;
 * a plate between clamped ends q L^4/(384 D). */
static void uniform_loads_bend_as_theory_says(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.angle = 0;
    b.scales.g[1] = -9.81;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(view.tip[1] / (-1200 * 0.01 * 9.81 * pow(0.2, 4) / (8 * 2e6 * 1e-6 / 12)), 1, 1e-8,
                "own weight");
    check_close(view.root_force / (-2.4 * 9.81), 1, 1e-6, "the root carries the weight");
    check_close(view.root_moment / (-2.4 * 9.81 * 0.1), 1, 1e-6, "and its moment");
    bench_free(&b);

    bench_defaults(&b);
    b.def.length = 0.079;
    b.def.thickness = 0.005;
    b.def.E = 12e6;
    b.def.nu = 0.4;
    b.def.plane = "strain";
    b.def.load = 686.7;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(-view.tip[0], 0.022467497, 1e-8, "A08c, antoci_gate");
    bench_free(&b);

    bench_defaults(&b);
    b.def.root = b.def.tip = "clamped";
    b.def.load = 100;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(-view.mid[0] / (100 * pow(0.2, 4) / (384 * 2e6 * 1e-6 / 12)), 1, 1e-8,
                "both ends clamped");
    bench_free(&b);
}

static void pinned_root_feels_no_moment(void **state)
{
    struct body_view view;
    struct bench b;

    (void)state;
    bench_defaults(&b);
    b.def.root = b.def.tip = "pinned";
    b.def.load = 100;
    bench_make(&b);
    bench_settle(&b, 0);
    bench_show(&b, 0, &view);
    check_close(view.root_moment, 0, 0, "moment");
    check_close(view.root_force / 10, 1, 1e-6, "half the load");
    check_close(-view.mid[0] / (5 * 100 * pow(0.2, 4) / (384 * 2e6 * 1e-6 / 12)), 1, 1e-8, "mid");
    bench_free(&b);
}

/* Shape of the first mode of a cantilever and its slope, at x from 0 to 1. */
static void first_mode(double x, double *w, double *slope)
{
    const double k = 1.875104068711961, r = 0.7340955137589128; /* (cosh + cos)/(sinh + sin) ^-1 */

    *w = cosh(k * x) - cos(k * x) - r * (sinh(k * x) - sin(k * x));
    *slope = k * (sinh(k * x) + sin(k * x) - r * (cosh(k * x) - cos(k * x)));
}

/* Swings by the implicit midpoint rule through solve(); returns the time of the
 * first passage through rest, a quarter of the period. */
static double quarter_period(struct bench *b, double h)
{
    const double before = bench_energy(b, b->y);
    double t = 0, last = b->y[bench_at(b, bench_dofs(b) - 2, false)];

    for (;;) {
        double middle[BENCH_Y] = {0};
        assert_int_equal(bench_solve(b, t, h / 2, b->y, middle), 0);
        for (int i = 0; i < bench_dofs(b); i++)
            for (int rate = 0; rate < 2; rate++) {
                const long at = bench_at(b, i, rate);
                b->y[at] = 2 * middle[at] - b->y[at];
            }
        const double tip = b->y[bench_at(b, bench_dofs(b) - 2, false)];
        check_close(bench_energy(b, b->y) / before, 1, 1e-9, "midpoint rule keeps energy");
        if (tip <= 0 || t > 10)
            return t + h * last / (last - tip);
        last = tip;
        t += h;
    }
}

/* Gray's plate, A08b: period in plane strain within the catalogue's 0.5 %. */
static void free_plate_swings_with_the_published_period(void **state)
{
    static const double plate[][2] = { { 0.22, 0.27006105 }, { 0.3975, 0.25403243 } };
    struct bench b;

    (void)state;
    for (int k = 0; k < 2; k++) {
        bench_defaults(&b);
        b.def.length = 0.2;
        b.def.thickness = 0.02;
        b.def.E = 2e6;
        b.def.density = 1000;
        b.def.nu = plate[k][0];
        b.def.plane = "strain";
        b.def.elements = 10;
        bench_make(&b);
        for (int i = 0; i <= 10; i++) {
            double w, slope;
            first_mode(i / 10.0, &w, &slope);
            b.y[bench_at(&b, 2 * i, false)] = 0.001 * w;
            b.y[bench_at(&b, 2 * i + 1, false)] = 0.001 * slope / 0.2;
        }
        check_close(4 * quarter_period(&b, 1e-4) / plate[k][1], 1, 1e-3, "period");
        bench_free(&b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tip_force_bends_as_theory_says),
        cmocka_unit_test(uniform_loads_bend_as_theory_says),
        cmocka_unit_test(pinned_root_feels_no_moment),
        cmocka_unit_test(free_plate_swings_with_the_published_period),
    };

    return cmocka_run_group_tests_name("beam-theory", tests, NULL, NULL);
}
