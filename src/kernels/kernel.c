/* kernel.c -- a kernel at one distance. */
#include "kernels/kernel.h"

#include <math.h>

struct kernel_use kernel_use_make(const struct kernel *kernel, double support, int dimension)
{
    return (struct kernel_use){
        .kernel = kernel,
        .support = support,
        .scale = kernel->sigma[dimension] / pow(support, dimension),
        .inverse = 1 / support,
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
