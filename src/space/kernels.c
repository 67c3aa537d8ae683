/* kernels.c -- the table of smoothing kernels, and a kernel at one distance. */
#include "space/kernel.h"

#include <math.h>
#include <stddef.h>

const struct kernel *const kernel_table[] = {
    &kernel_wendland_c2, &kernel_cubic_spline, NULL
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

/* W'' + (D - 1) W'/r; W'/r tends to W''(0) at the centre. */
double kernel_laplacian(const struct kernel_use *use, double r, int dimension)
{
    const double q = r / use->support;

    if (!(q < 1))
        return 0;
    const double curvature = use->kernel->ddw(q);
    const double slope = q > 0 ? use->kernel->dw(q) / q : curvature;
    return use->scale / (use->support * use->support) * (curvature + (dimension - 1) * slope);
}
