/* kernel-fourier.c -- the signs of the kernels' Fourier transforms in two dimensions, which
 * decide whether particles pair under pressure: the table of doc/seed-000.md.
 *
 *   F(k) = 2 pi int_0^H W(r) J0(k r) r dr,   here F(k)/F(0) against kH
 *
 * Dehnen, Aly, Mon. Not. R. Astron. Soc. 425 (2012) 1068-1082, section 2.3. */
#include "space.h"

#define LANES 2
#include "kernels/rows.h"

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 32 }; /* of Gauss in each piece; waves up to kH = 60 fit in well */

static const double FARTHEST = 60, STEP = 0.01; /* of kH */

/* Where it is least, over F(0), and the first zero [1/H]; without one, 0. */
struct transform {
    double least, zero;
};

/* int_0^1 w(q) J0(x q) q dq, between the knots of the splines. */
static double hankel(const struct kernel *kernel, const gsl_integration_glfixed_table *rule,
                     double x)
{
    static const double knot[] = { 0, 1.0 / 3, 1.0 / 2, 2.0 / 3, 1 };
    double sum = 0;

    for (int piece = 0; piece < 4; piece++)
        for (size_t i = 0; i < POINTS; i++) {
            double q, weight;
            gsl_integration_glfixed_point(knot[piece], knot[piece + 1], i, &q, &weight, rule);
            sum += weight * kernel->w(q) * gsl_sf_bessel_J0(x * q) * q;
        }
    return sum;
}

static struct transform transform(const struct kernel *kernel)
{
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(POINTS);
    struct transform t = { 1, 0 };
    const double whole = hankel(kernel, rule, 0);
    double before = 1;

    for (double x = STEP; x < FARTHEST; x += STEP) {
        const double now = hankel(kernel, rule, x) / whole;
        if (before > 0 && now < -1e-12 && t.zero == 0)
            t.zero = x - STEP * now / (now - before);
        if (now < t.least)
            t.least = now;
        before = now;
    }
    gsl_integration_glfixed_table_free(rule);
    return t;
}

/* The cells of the page's row on a kernel, as texts from the first after its name on. */
static bool row_of(const char *name, char *cell[8], char *line, int size)
{
    char path[4096], wanted[64];
    const char *top = getenv("top_srcdir");
    FILE *page;
    bool found = false;

    snprintf(path, sizeof path, "%s/doc/seed-000.md", top ? top : ".");
    snprintf(wanted, sizeof wanted, "| `%s` | ", name);
    page = fopen(path, "r");
    check(page, "%s cannot be read; top_srcdir says where doc/ is", path);
    while (!found && fgets(line, size, page))
        found = strncmp(line, wanted, strlen(wanted)) == 0 && strstr(line, "%") != NULL;
    fclose(page);
    for (int i = 0; found && i < 8; i++)
        cell[i] = strtok(i ? NULL : line, "|\n");
    return found;
}

/* As the page writes it: half a unit of its last digit. */
static void printed(const char *name, const char *what, const char *text, double found)
{
    const char *point = strchr(text, '.'), *power = strchr(text, 'e');
    const char *end = power ? power : text + strcspn(text + 1, " ") + 1;
    const double wanted = atof(text), exponent = power ? atof(power + 1) : 0;
    const double half = 0.5 * pow(10, exponent - (point ? (double)(end - point - 1) : 0));

    check(fabs(found - wanted) <= 1.0001 * half, "%s: %s is %.5g, the page says %s", name, what,
          found, text);
}

static void page_has_the_negative_ones(void **state)
{
    static const struct kernel *const negative[] = { &kernel_poly6, &kernel_cubic_spline,
                                                     &kernel_gauss, &kernel_quintic_spline };

    (void)state;
    for (int i = 0; i < 4; i++) {
        const char *name = negative[i]->name;
        const struct transform t = transform(negative[i]);
        char line[512], *cell[8] = { NULL };

        check(row_of(name, cell, line, sizeof line) && cell[7], "no row on %s", name);
        printed(name, "the least value", cell[5], t.least);
        printed(name, "its first zero, kH", cell[6], t.zero);
        printed(name, "H/dx from there", cell[7], t.zero / (M_PI * sqrt(2)));
    }
}

/* Wendland's because he made them so, spiky as it happens. */
static void others_are_positive(void **state)
{
    static const struct kernel *const positive[] = { &kernel_wendland_c2, &kernel_wendland_c4,
                                                     &kernel_wendland_c6, &kernel_spiky };

    (void)state;
    for (int i = 0; i < 4; i++) {
        const struct transform t = transform(positive[i]);

        check(t.zero == 0 && t.least > -1e-12, "%s: least %g, zero at %g", positive[i]->name,
              t.least, t.zero);
    }
}

/* The full bell is its own transform: what makes (13) pair is that it is cut. */
static double full_bell(double q)
{
    return exp(-36 * q * q);
}

static void bell_that_ends_in_zero_is_positive(void **state)
{
    const struct kernel bell = { .name = "full bell", .w = full_bell };
    gsl_integration_glfixed_table *rule = gsl_integration_glfixed_table_alloc(POINTS);
    const double whole = hankel(&bell, rule, 0);

    (void)state;
    for (double x = 0; x < FARTHEST; x += 1) {
        const double found = hankel(&bell, rule, x) / whole, wanted = exp(-x * x / 144);
        check(fabs(found - wanted) < 1e-13, "kH = %g: %.15g, not %.15g", x, found, wanted);
    }
    gsl_integration_glfixed_table_free(rule);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(page_has_the_negative_ones),
        cmocka_unit_test(others_are_positive),
        cmocka_unit_test(bell_that_ends_in_zero_is_positive),
    };

    return cmocka_run_group_tests_name("kernels' Fourier transforms", tests, NULL, NULL);
}
