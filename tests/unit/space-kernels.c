/* space-kernels.c -- the kernels keep their definitions: (K1), (K2). */
#include "space.h"

#define LANES 2
#include "space/kernel.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <string.h>

static const double H = 0.3;

static double shell(double r, void *use)
{
    return kernel_w(use, r) * (DIM == 2 ? 2 * M_PI * r : 4 * M_PI * r * r);
}

/* The integral of W over its support is 1: sigma is right. */
void kernel_integrates_to_one(void **state)
{
    gsl_integration_workspace *work = gsl_integration_workspace_alloc(200);

    (void)state;
    for (int i = 0; kernel_table[i]; i++) {
        struct kernel_use use = kernel_use_make(kernel_table[i], H, DIM);
        gsl_function f = { shell, &use };
        double inner, outer, error;

        gsl_integration_qag(&f, 0, H / 2, 0, 1e-12, 200, GSL_INTEG_GAUSS31, work, &inner, &error);
        gsl_integration_qag(&f, H / 2, H, 0, 1e-12, 200, GSL_INTEG_GAUSS31, work, &outer, &error);
        check(fabs(inner + outer - 1) < 1e-10, "%s integrates to %.12g",
              kernel_table[i]->name, inner + outer);
    }
    gsl_integration_workspace_free(work);
}

/* dw and ddw are the derivatives of w, away from the knot of the spline. */
void kernel_derivatives_agree(void **state)
{
    (void)state;
    for (int i = 0; kernel_table[i]; i++) {
        const struct kernel *k = kernel_table[i];
        const struct kernel_use use = kernel_use_make(k, H, DIM);

        for (double q = 0.015; q < 0.99; q += 0.01) {
            const double e = 1e-5, r = q * H;
            const double slope = (k->w(q + e) - k->w(q - e)) / (2 * e);
            const double curvature = (k->dw(q + e) - k->dw(q - e)) / (2 * e);
            const double w1 = use.scale / H * k->dw(q), w2 = use.scale / (H * H) * k->ddw(q);
            const double laplacian = w2 + (DIM - 1) * w1 / r;

            check(fabs(slope - k->dw(q)) < 1e-7, "%s: w' at q = %g", k->name, q);
            check(fabs(curvature - k->ddw(q)) < 1e-7, "%s: w'' at q = %g", k->name, q);
            check(fabs(kernel_gradient(&use, r) - w1) <= 1e-12 * fabs(w1), "%s: W'", k->name);
            check(fabs(kernel_laplacian(&use, r, DIM) - laplacian)
                      <= 1e-10 * (fabs(w2) + fabs(w1 / r)), "%s: Laplacian at q = %g", k->name, q);
        }
        const double near = kernel_laplacian(&use, 1e-9 * H, DIM);
        check(fabs(kernel_laplacian(&use, 0, DIM) / near - 1) < 1e-6, "%s: Laplacian at 0",
              k->name);
    }
}

/* Rows of r give W and W'/r of single distances; r = 0 is finite. */
void kernel_rows_agree(void **state)
{
    enum { ROWS = 50 };
    lanes rows[ROWS], m[ROWS], g[ROWS], v[ROWS];

    (void)state;
    for (int k = 0; k < ROWS; k++)
        for (int l = 0; l < LANES; l++) {
            rows[k][l] = H * (k + 0.5 * l) / (ROWS - 5);
            m[k][l] = 2 + k;
        }
    for (int i = 0; kernel_table[i]; i++) {
        const struct kernel_use use = kernel_use_make(kernel_table[i], H, DIM);

        use.kernel->gradient(H, use.scale, ROWS, rows, m, g);
        use.kernel->value(H, use.scale, ROWS, rows, m, v);
        for (int k = 0; k < ROWS; k++)
            for (int l = 0; l < LANES; l++) {
                const double r = rows[k][l], w = m[k][l] * kernel_w(&use, r);
                const double slope = m[k][l] * (r > 0 ? kernel_gradient(&use, r) / r
                                                : use.scale / (H * H) * use.kernel->ddw(0));

                check(fabs(v[k][l] - w) <= 1e-13 * m[k][l] * use.scale, "%s: W(%g) = %g, not %g",
                      use.kernel->name, r, v[k][l], w);
                check(fabs(g[k][l] - slope) <= 1e-12 * m[k][l] * use.scale / (H * H),
                      "%s: W'(r)/r at %g = %g, not %g", use.kernel->name, r, g[k][l], slope);
            }
    }
}

/* Exactly 0 from the support on, also at the dummy's distance. */
void kernel_ends_at_support(void **state)
{
    const double far[] = { 1, 1 + 1e-15, 1.5, 1e30 };
    lanes r[2], m[2], g[2], v[2];

    (void)state;
    for (int k = 0; k < 4; k++)
        r[k / LANES][k % LANES] = far[k];
    m[0] = m[1] = lanes_all(1);
    for (int i = 0; kernel_table[i]; i++) {
        const struct kernel_use use = kernel_use_make(kernel_table[i], 1, DIM);

        use.kernel->gradient(1, use.scale, 2, r, m, g);
        use.kernel->value(1, use.scale, 2, r, m, v);
        for (int k = 0; k < 4; k++) {
            check(g[k / LANES][k % LANES] == 0 && v[k / LANES][k % LANES] == 0,
                  "%s is not 0 at %g H", use.kernel->name, far[k]);
            check(kernel_w(&use, far[k]) == 0 && kernel_gradient(&use, far[k]) == 0
                  && kernel_laplacian(&use, far[k], DIM) == 0, "%s at %g", use.kernel->name,
                  far[k]);
        }
    }
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
