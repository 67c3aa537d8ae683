/* kernels.c -- the table of smoothing kernels, and a kernel at one distance. */
#include "kernels/kernel.h"

#include <math.h>
#include <stddef.h>

const struct kernel *const kernel_table[] = {
    &kernel_wendland_c2, &kernel_wendland_c4, &kernel_wendland_c6, &kernel_cubic_spline,
    &kernel_quintic_spline, &kernel_gauss, &kernel_poly6, &kernel_spiky, &kernel_viscosity_log,
    NULL
};

struct kernel_use kernel_use_make(const struct kernel *kernel, double support, int dimension)
{
    return (struct kernel_use){
        .kernel = kernel,
        .support = support,
        .scale = kernel->sigma[dimension] / pow(support, dimension),
    };
}

double kernel_w(const struct kernel_use *use, double r)
{
    const double q = r / use->support;

    return q < 1 ? use->scale * use->kernel->w(q) : 0;
}

double kernel_gradient(const struct kernel_use *use, double r)
{
    const double q = r / use->support;

    return q < 1 ? use->scale / use->support * use->kernel->dw(q) : 0;
}

/* A row of one distance: w'' + (D - 1) w'/q would lose all digits near the centre
 * of a singular kernel. */
double kernel_laplacian(const struct kernel_use *use, double r)
{
    const lanes at = lanes_all(r), one = lanes_all(1);
    lanes laplacian;

    use->kernel->laplacian(use->support, use->scale, 1, &at, &one, &laplacian);
    return laplacian[0];
}
