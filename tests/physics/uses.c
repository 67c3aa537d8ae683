/* uses.c -- each law is weighed with the kernel of its use, whatever laws and kernels
 * stand beside it: the rates of all are the sum of the rates of each alone. */
#include "tank.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum use { DENSITY, PRESSURE, VISCOSITY, USES };

static const struct {
    const char *text;
    enum use use;
} laws[] = {
    { "pressure = { };", PRESSURE },
    { "pressure-printed = { };", PRESSURE },
    { "artificial-viscosity = { alpha = 0.1; };", VISCOSITY },
    { "laminar-viscosity = { mu = 0.7; };", VISCOSITY },
    { "laplacian-viscosity = { mu = 0.6; };", VISCOSITY },
    { "density-diffusion = { delta = 0.1; };", DENSITY },
};
enum { LAWS = sizeof laws / sizeof laws[0] };

/* Kernels of densities, pressure, viscosity: all different, and two of them the same. */
static const char *const kernels[][USES] = {
    { "poly6", "spiky", "viscosity-log" },
    { "viscosity-log", "spiky", "viscosity-log" },
    { "poly6", "viscosity-log", "viscosity-log" },
    { "poly6", "poly6", "viscosity-log" },
    { "cubic-spline", "wendland-c4", "viscosity-log" },
};
enum { SETS = sizeof kernels / sizeof kernels[0] };

/* Rates in front of the book of these effects beside continuity, all at the same y.
 * A diffusion of nothing makes walls have a density whatever else there is. */
static double *rates(const char *effects, const char *const use[USES], const double *y, long *n)
{
    double *to;
    struct tank t;
    char text[1024];

    snprintf(text, sizeof text, "kernel = { support = 2.52; density = \"%s\"; pressure = \"%s\";"
             " viscosity = \"%s\"; }; walls = \"own-density\"; effects = { continuity = { }; %s %s };",
             use[DENSITY],
             use[PRESSURE], use[VISCOSITY], effects,
             strstr(effects, "diffusion") ? "" : "density-diffusion = { delta = 0.0; };");
    tank_make(&t, tank_bare_water, tank_frame, text, NULL);
    *n = tank_at(&t, "book", NULL);
    if (y)
        memcpy(t.y, y, *n * sizeof *y);
    else
        tank_shake(&t, 3, 0.2, 1, 0.02);
    tank_rates(&t, 0, t.y, t.ydot);
    to = tank_copy(&t, y ? t.ydot : t.y);
    tank_free(&t);
    return to;
}

/* sum += sign (effects with all uses of one kernel) */
static void add(double *sum, double sign, const char *effects, const char *kernel, const double *y)
{
    const char *const same[USES] = { kernel, kernel, kernel };
    long n;
    double *one = rates(effects, same, y, &n);

    for (long i = 0; i < n; i++)
        sum[i] += sign * one[i];
    test_free(one);
}

static void check_set(const char *const use[USES], const char *const *law, const enum use *of,
                      int some)
{
    double *y, *all, *sum, size = 0, off = 0;
    char text[512] = "";
    long n;

    for (int i = 0; i < some; i++)
        strcat(text, law[i]);
    y = rates("", use, NULL, &n);
    all = rates(text, use, y, &n);
    sum = test_calloc(n, sizeof *sum);
    add(sum, 1, "", use[DENSITY], y);
    for (int i = 0; i < some; i++) {
        add(sum, 1, law[i], use[of[i]], y);
        add(sum, -1, "", use[of[i]], y);
    }
    for (long i = 0; i < n; i++) {
        size = fmax(size, fabs(all[i]));
        off = fmax(off, fabs(all[i] - sum[i]));
    }
    check(off <= 1e-12 * size, "%s with %s, %s, %s: all together are off by %g of %g", text,
          use[DENSITY], use[PRESSURE], use[VISCOSITY], off, size);
    test_free(y);
    test_free(all);
    test_free(sum);
}

/* All laws but one or two, so that every law stands beside many others. */
static void laws_have_the_kernel_of_their_use(void **state)
{
    (void)state;
    for (int k = 0; k < SETS; k++)
        for (int left_out = -1; left_out < LAWS; left_out++) {
            const char *law[LAWS];
            enum use of[LAWS];
            int n = 0;
            for (int i = 0; i < LAWS; i++)
                if (i != left_out && i != (left_out + 2) % LAWS
                    && (i != 1 || left_out == 0)) { /* one law of pressure at a time */
                    law[n] = laws[i].text;
                    of[n++] = laws[i].use;
                }
            check_set(kernels[k], law, of, n);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(laws_have_the_kernel_of_their_use),
    };

    return cmocka_run_group_tests_name("uses", tests, NULL, NULL);
}
