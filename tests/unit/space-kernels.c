/* space-kernels.c -- the kernels keep their definitions, (K1) to (K9), and are what the
 * papers print, or what they should have printed. */
#include "space.h"

#define LANES 2
#include "kernels/rows.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <string.h>

static const double H = 0.3;

static double sphere(double r)
{
    return DIM == 2 ? 2 * M_PI * r : 4 * M_PI * r * r;
}

static double shell(double r, void *use)
{
    return kernel_w(use, r) * sphere(r);
}

static double laplacian_of_shell(double r, void *use)
{
    return kernel_laplacian(use, r) * sphere(r);
}

/* From r to H, between the knots of the splines, to 1e-11 of `size`; a singularity may lie
 * at r. */
static double integral(double (*of)(double, void *), struct kernel_use *use, double r,
                       double size)
{
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(400);
    gsl_function f = { of, use };
    double points[] = { r, H / 3, H / 2, 2 * H / 3, H }, sum, error;

    gsl_integration_qagp(&f, points, 5, 1e-11 * size, 0, 400, work, &sum, &error);
    gsl_integration_workspace_free(work);
    return sum;
}

/* The integral of W over its support is 1: sigma is right. */
void kernel_integrates_to_one(void **state)
{
    (void)state;
    for (int i = 0; kernel_table[i]; i++) {
        struct kernel_use use = kernel_use_make(kernel_table[i], H, DIM);
        const double sum = integral(shell, &use, 0, 1);

        check(fabs(sum - 1) < 1e-10, "%s integrates to %.12g", kernel_table[i]->name, sum);
    }
}

/* Gauss's theorem: what W' carries through the sphere of radius r = H/20 and, where W'
 * jumps, through that of radius H, the Laplacian has between them. */
void kernel_laplacian_integrates(void **state)
{
    const double r = H / 20;

    (void)state;
    for (int i = 0; kernel_table[i]; i++) {
        struct kernel_use use = kernel_use_make(kernel_table[i], H, DIM);
        const double size = use.scale / H * sphere(H) * -use.kernel->dw(0.5);
        const double sum = integral(laplacian_of_shell, &use, r, size);
        const double end = use.scale / H * use.kernel->dw(1);
        const double flux = sphere(H) * end - sphere(r) * kernel_gradient(&use, r);

        check(fabs(sum - flux) < 1e-9 * size, "%s: the Laplacian integrates to %.12g, not %.12g",
              use.kernel->name, sum, flux);
    }
}

/* A derivative by differences of fourth order. */
static double difference(double (*f)(double), double q)
{
    const double e = 1e-3 * fmin(q, 1 - q);

    return (8 * (f(q + e) - f(q - e)) - (f(q + 2 * e) - f(q - 2 * e))) / (12 * e);
}

static bool near_knot(double q)
{
    const double knots[] = { 1.0 / 3, 1.0 / 2, 2.0 / 3 };

    for (int k = 0; k < 3; k++)
        if (fabs(q - knots[k]) < 3e-3 * q)
            return true;
    return false;
}

/* dw and ddw are the derivatives of w, away from the knots of splines; the Laplacian is
 * made of them. */
static void derivatives_at(const struct kernel *k, double q)
{
    const struct kernel_use use = kernel_use_make(k, H, DIM);
    const double dw = k->dw(q), ddw = k->ddw(q), laplacian = kernel_laplacian(&use, q * H);
    const double part = use.scale / (H * H);

    check(near_knot(q) || fabs(difference(k->w, q) - dw) < 1e-7 * (k->w(q) / q + fabs(dw)),
          "%s: w' at q = %g", k->name, q);
    check(near_knot(q) || fabs(difference(k->dw, q) - ddw) < 1e-7 * (fabs(dw) / q + fabs(ddw)),
          "%s: w'' at q = %g", k->name, q);
    check(fabs(kernel_gradient(&use, q * H) - use.scale / H * dw) <= 1e-12 * part * H * fabs(dw),
          "%s: W' at q = %g", k->name, q);
    check(fabs(laplacian - part * (ddw + (DIM - 1) * dw / q))
              <= 1e-12 * part * (k->w(0.1) + fabs(ddw) + fabs(dw) / q),
          "%s: Laplacian at q = %g: %g", k->name, q, laplacian);
}

void kernel_derivatives_agree(void **state)
{
    (void)state;
    for (int i = 0; kernel_table[i]; i++)
        for (double q = 0.005; q < 0.995; q += 0.005)
            derivatives_at(kernel_table[i], q);
}

/* Laplacians of smooth kernels reach D w''(0) at the centre; all are finite there. */
void kernel_laplacian_at_centre(void **state)
{
    (void)state;
    for (int i = 0; kernel_table[i]; i++) {
        const struct kernel *k = kernel_table[i];
        const struct kernel_use use = kernel_use_make(k, H, DIM);
        const double at = kernel_laplacian(&use, 0), part = use.scale / (H * H);

        check(isfinite(at), "%s: Laplacian at 0 is %g", k->name, at);
        if (!k->singular && k->dw(0) == 0)
            check(fabs(at / (part * DIM * k->ddw(0)) - 1) < 1e-12, "%s: Laplacian %g at 0",
                  k->name, at);
    }
}

/* W falls from its centre to 0 without a jump, W' too except that of the cut bell;
 * `singular` and `spreads` say what W and its Laplacian do. */
static void signs(const struct kernel *k)
{
    const struct kernel_use use = kernel_use_make(k, H, DIM);
    const double jump = k == &kernel_gauss ? 9 * exp(-4.5) : 0;
    bool spreads = true;

    for (int n = 1; n < 2000; n++) {
        const double r = n * H / 2000;

        check(kernel_w(&use, r) >= 0, "%s: W(%g) = %g", k->name, r, kernel_w(&use, r));
        check(kernel_gradient(&use, r) <= 0, "%s: W' = %g", k->name, kernel_gradient(&use, r));
        spreads = spreads && kernel_laplacian(&use, r) >= 0;
    }
    check(k->spreads == spreads, "%s %s", k->name, spreads ? "spreads" : "does not spread");
    check(k->singular == !isfinite(k->w(0)), "%s: W(0) is %g", k->name, k->w(0));
    check(fabs(k->w(1)) < 1e-14, "%s: w(1) = %g", k->name, k->w(1));
    check(fabs(k->dw(1) + jump) < 1e-14, "%s: w'(1) = %g", k->name, k->dw(1));
}

void kernel_signs(void **state)
{
    (void)state;
    for (int i = 0; kernel_table[i]; i++)
        signs(kernel_table[i]);
}

/* W(0) H^D as published; splines are given with h = H/2 and h = H/3.  The bell is that of
 * (13), H = 3 hbar, lowered to 0 at its edge and raised again by its new norm, worked out
 * by sums of 2 10^6 terms elsewhere. */
void kernel_as_published(void **state)
{
    const struct { const struct kernel *k; double centre[2]; } table[] = {
        { &kernel_wendland_c2, { 7 / M_PI, 21 / (2 * M_PI) } },
        { &kernel_wendland_c4, { 9 / M_PI, 495 / (32 * M_PI) } },
        { &kernel_wendland_c6, { 78 / (7 * M_PI), 1365 / (64 * M_PI) } },
        { &kernel_cubic_spline, { 4 * 10 / (7 * M_PI), 8 / M_PI } },
        { &kernel_quintic_spline, { 9 * 66 * 7 / (478 * M_PI), 27 * 66 / (120 * M_PI) } },
        { &kernel_gauss, { 1.508660, 1.902812 } },
        { &kernel_poly6, { 4 / M_PI, 315 / (64 * M_PI) } },
        { &kernel_spiky, { 10 / M_PI, 15 / M_PI } },
    };

    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const struct kernel_use use = kernel_use_make(table[i].k, H, DIM);
        const double found = kernel_w(&use, 0) * pow(H, DIM), expected = table[i].centre[DIM - 2];
        const double tolerance = table[i].k == &kernel_gauss ? 1e-6 : 1e-14;

        check(fabs(found / expected - 1) < tolerance, "%s: W(0) = %.15g / H^D, not %.15g",
              table[i].k->name, found, expected);
    }
}

/* What Toth 2012 should have printed in (17), (27), (29) and (31), at h = 0.7, r = 0.31;
 * in 3D the forms of Mueller, Charypar, Gross 2003.  The printed (17) and (27) would
 * give -83.237 and -3.545. */
void kernel_corrections_of_print(void **state)
{
    const double h = 0.7, r = 0.31, d = h - r;
    const struct kernel_use poly6 = kernel_use_make(&kernel_poly6, h, DIM);
    const struct kernel_use spiky = kernel_use_make(&kernel_spiky, h, DIM);
    const struct kernel_use viscosity = kernel_use_make(&kernel_viscosity_log, h, DIM);
    const double found[] = { kernel_laplacian(&poly6, r), kernel_laplacian(&spiky, r),
                             kernel_w(&viscosity, r), kernel_laplacian(&viscosity, r) };
    const double flat[] = { -21.057, 16.440, 40 / (M_PI * pow(h, 5)) * (h * r * r / 4
                            - r * r * r / 9 - h * h * h / 6 * log(r / h) - 5 * h * h * h / 36),
                            40 / (M_PI * pow(h, 5)) * d };
    const double solid[] = { -945 / (32 * M_PI * pow(h, 9)) * (h * h - r * r)
                             * (3 * h * h - 7 * r * r),
                             -90 / (M_PI * pow(h, 6)) / r * d * (h - 2 * r),
                             15 / (2 * M_PI * h * h * h) * (-r * r * r / (2 * h * h * h)
                             + r * r / (h * h) + h / (2 * r) - 1), 45 / (M_PI * pow(h, 6)) * d };
    const double *expected = DIM == 2 ? flat : solid;

    (void)state;
    for (int i = 0; i < 4; i++)
        check(fabs(found[i] - expected[i]) < (DIM == 2 && i < 2 ? 5e-4 : 1e-11),
              "number %d: %.9g, not %.9g", i, found[i], expected[i]);
}

/* The Laplacian of (K9) is linear down to the centre, where W has a sink that balances
 * it: 40/(3 H^2) in 2D, 15/H^2 in 3D. */
void kernel_laplacian_linear(void **state)
{
    struct kernel_use use = kernel_use_make(&kernel_viscosity_log, H, DIM);
    const double total = (DIM == 2 ? 40.0 / 3 : 15) / (H * H), r = 1e-6 * H;
    const double sink = sphere(r) * kernel_gradient(&use, r);

    (void)state;
    for (int n = 0; n <= 10; n++) {
        const double found = kernel_laplacian(&use, n * H / 10);
        const double line = (1 - n / 10.0) * kernel_laplacian(&use, 0);

        check(fabs(found - line) < 1e-12 * kernel_laplacian(&use, 0), "%g, not %g", found, line);
    }
    check(fabs(integral(laplacian_of_shell, &use, 0, total) / total - 1) < 1e-10, "its integral");
    check(fabs(sink / total + 1) < 1e-10, "the sink is %.12g, not %.12g", sink, -total);
}

/* Summed density of a square lattice over the true one, Wendland C2: 2D values
 * by summing (K1) by hand. */
static double lattice(double ratio)
{
    const struct kernel_use use = kernel_use_make(&kernel_wendland_c2, ratio, DIM);
    double sum = 0;

    for (int i = -4; i <= 4; i++)
        for (int j = -4; j <= 4; j++)
            for (int k = DIM == 3 ? -4 : 0; k <= (DIM == 3 ? 4 : 0); k++)
                sum += kernel_w(&use, sqrt(i * i + j * j + k * k));
    return sum;
}

void kernel_density_of_lattice(void **state)
{
    static const double ratio[] = { 2.52, 3.0, 3.5 }, expected[] = { 1.013, 1.005, 1.003 };

    (void)state;
    for (int i = 0; i < 3; i++) {
        const double found = lattice(ratio[i]);

        if (DIM == 2)
            check(fabs(found - expected[i]) < 6e-4, "H/dx = %g: %.5f, not %.3f", ratio[i], found,
                  expected[i]);
        else
            check(fabs(found - 1) < 0.03, "H/dx = %g in 3D: %.5f", ratio[i], found);
    }
}
