/* scales.c -- the rates that step limits are made of, against the fastest motion that
 * a block of water alone in the world is capable of. */
#include "tank.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#if DIM == 2
#define BLOCK "dimension = 2; until = 1.0; spacing = 0.01; eos = { c0 = 10.0; };"        \
              "domain = { from = [0.0, 0.0]; to = [0.2, 0.2]; };"                        \
              "fluid = { a = { type = \"box\"; from = [0.0, 0.0]; to = [0.2, 0.2]; }; };"
#else
#define BLOCK "dimension = 3; until = 1.0; spacing = 0.01; eos = { c0 = 10.0; };"        \
              "domain = { from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.1]; };"              \
              "fluid = { a = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.1]; }; };"
#endif

/* Of the power iteration, which approaches from below. */
enum { ROUNDS = DIM == 2 ? 80 : 40 };

#define SMALL 1e-3 /* m/s, kg/m^3 */

static double length(const double *v, long n)
{
    double sum = 0;

    for (long i = 0; i < n; i++)
        sum += v[i] * v[i];
    return sqrt(sum);
}

/* to = d(rate of row `out`)/d(row `in`) v, by a central difference of size h. */
static void derive(struct tank *t, const char *in, const char *out, double h, const double *v,
                   double *to)
{
    const struct layout_row *ri, *ro;
    const long at = tank_at(t, in, &ri), from = tank_at(t, out, &ro);
    const long n = (long)ri->n * ri->components, m = (long)ro->n * ro->components;

    memset(to, 0, m * sizeof *to);
    for (int side = -1; side <= 1; side += 2) {
        double *y = tank_copy(t, t->y);
        for (long i = 0; i < n; i++)
            y[at + i] += side * h * v[i];
        tank_rates(t, 0, y, t->ydot);
        for (long i = 0; i < m; i++)
            to[i] += side * t->ydot[from + i] / (2 * h);
        test_free(y);
    }
}

/* Largest eigenvalue in size of row `in` -> rate of `in`, or of `in` -> rate of
 * `between` -> rate of `in` when that is given. */
static double fastest(struct tank *t, const char *in, const char *between)
{
    const struct layout_row *r, *q;
    double *v, *w, size = 0;
    unsigned seed = 1;
    long n;

    tank_at(t, in, &r);
    tank_at(t, between ? between : in, &q);
    n = (long)r->n * r->components;
    v = test_malloc(n * sizeof *v);
    w = test_malloc((long)q->n * q->components * sizeof *w);
    for (long i = 0; i < n; i++)
        v[i] = tank_random(&seed);
    for (int k = 0; k <= ROUNDS; k++) {
        size = length(v, n);
        for (long i = 0; i < n; i++)
            v[i] /= size;
        derive(t, in, between ? between : in, SMALL, v, w);
        if (between)
            derive(t, between, in, SMALL, w, v);
        else
            memcpy(v, w, n * sizeof *v);
    }
    size = length(v, n);
    test_free(v);
    test_free(w);
    return size;
}

static const char *const kernels[] = {
    "", "type = \"wendland-c4\";", "type = \"cubic-spline\";", "type = \"gauss\";",
    "type = \"poly6\";", "type = \"spiky\";", "type = \"viscosity-log\";",
    "density = \"poly6\"; pressure = \"spiky\"; viscosity = \"viscosity-log\";",
    "density = \"gauss\"; pressure = \"wendland-c6\";",
    "density = \"wendland-c6\"; pressure = \"gauss\";",
};
enum { SOME = sizeof kernels / sizeof kernels[0], FOR_DECAY = SOME - 2 };

static void make(struct tank *t, const char *kernel, double support, const char *rest)
{
    char keys[256];

    snprintf(keys, sizeof keys, "kernel = { support = %g; %s };", support, kernel);
    tank_make(t, BLOCK, keys, rest, NULL);
}

/* The limit of the plan over the rate that was found: 1 at least, not much more. */
static double check_limit(struct tank *t, bool decay, double rate, double most,
                          const char *kernel, const char *what)
{
    struct limit limit[2];
    double ratio;

    moment_limit(t->moment, 0, t->y, false, limit);
    ratio = limit[decay].rate / rate;
    check(ratio >= 1 && ratio <= most, "%s, H = %g m, %s: the limit is %g 1/s, the fastest rate %g",
          kernel, plan_scales(t->plan)->support, what, limit[decay].rate, rate);
    return ratio;
}

static void for_all(const char *effects, bool decay, const char *in, const char *between,
                    double most)
{
    const int every = tank_brief() && !strstr(effects, "laplacian") ? 3 : 1; /* of the kernels */
    double low = HUGE_VAL, high = 0;

    for (int i = 0; i < (decay ? FOR_DECAY : SOME); i += every)
        for (int wide = 0; wide < (DIM == 2 ? 2 : 1); wide++) {
            struct tank t;
            double rate, ratio;
            if (strstr(effects, "laplacian") && !strstr(kernels[i], "viscosity-log"))
                continue;
            make(&t, kernels[i], wide ? 3 : 2.52, effects);
            rate = fastest(&t, in, between);
            ratio = check_limit(&t, decay, decay ? rate : sqrt(rate), most, kernels[i], effects);
            low = fmin(low, ratio);
            high = fmax(high, ratio);
            tank_free(&t);
        }
    print_message("# %s limits are %.3f to %.3f times the fastest rate\n", effects, low, high);
}

/* Water at rest; in the plane motion leaves more of the limit unused than in space. */
static void limit_of_waves_is_just_above_the_fastest(void **state)
{
    (void)state;
    for_all("effects = { continuity = { }; pressure = { }; };", false, "velocity of fluid",
            "density of fluid", 1.18);
}

static void limits_of_decay_are_just_above_the_fastest(void **state)
{
    (void)state;
    for_all("effects = { continuity = { }; laminar-viscosity = { mu = 1000.0; }; };", true,
            "velocity of fluid", NULL, 1.2);
    for_all("effects = { continuity = { }; laplacian-viscosity = { mu = 1000.0; }; };", true,
            "velocity of fluid", NULL, 1.05);
    for_all("effects = { continuity = { }; artificial-viscosity = { alpha = 1.0; }; };", true,
            "velocity of fluid", NULL, 1.5);
    for_all("effects = { continuity = { }; stress-viscosity = { mu = 1000.0; }; };", true,
            "velocity of fluid", NULL, 1.5);
    for_all("effects = { continuity = { }; density-diffusion = { delta = 1.0; }; };", true,
            "density of fluid", NULL, 1.9);
}

/* The default kernel is the measure of the others, exactly. */
static void default_kernel_has_scale_one(void **state)
{
    static const char *const same[] = { "", "type = \"wendland-c2\"; pressure = \"wendland-c2\";" };
    const double support[] = { 2, 2.52, 3.7 };

    (void)state;
    for (int i = 0; i < 6; i++) {
        const double H = support[i / 2] * 0.01, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);
        const struct scales *s;
        struct tank t;
        make(&t, same[i % 2], support[i / 2], "effects = { continuity = { }; };");
        s = plan_scales(t.plan);
        check(s->wave == 1 && s->laplace_density == 1 && s->laplace_viscosity == 1,
              "wave %.17g, Laplacians %.17g, %.17g", s->wave, s->laplace_density,
              s->laplace_viscosity);
        check(fabs(s->centre / (sigma * pow(H, -DIM)) - 1) < 1e-14, "centre %.17g", s->centre);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limit_of_waves_is_just_above_the_fastest),
        cmocka_unit_test(limits_of_decay_are_just_above_the_fastest),
        cmocka_unit_test(default_kernel_has_scale_one),
    };

#ifdef _OPENMP
    omp_set_num_threads(1); /* thousands of small sums */
#endif
    return cmocka_run_group_tests_name("scales", tests, NULL, NULL);
}
