/* kernels.c -- the table of smoothing kernels, and their Laplacian at one distance. */
#include "kernels/rows.h"

#include <stddef.h>

const struct kernel *const kernel_table[] = {
    &kernel_wendland_c2, &kernel_wendland_c4, &kernel_wendland_c6, &kernel_cubic_spline,
    &kernel_quintic_spline, &kernel_gauss, &kernel_poly6, &kernel_spiky, &kernel_viscosity_log,
    NULL
};

/* A row of one distance: w'' + (D - 1) w'/q would lose all digits near the centre
 * of a singular kernel. */
double kernel_laplacian(const struct kernel_use *use, double r)
{
    const lanes at = lanes_all(r), one = lanes_all(1);
    lanes laplacian;

    use->kernel->rows->laplacian(use->support, use->scale, 1, &at, &one, &laplacian);
    return laplacian[0];
}
