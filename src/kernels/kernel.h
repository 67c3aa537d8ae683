/* kernel.h -- smoothing kernels, described by their support radius H:
 *
 *     W(r) = sigma_D / H^D  w(q),   q = r/H in [0, 1],   0 beyond.
 *
 * One file, one const struct, one line in kernels/kernels.c.  Their loops over rows of
 * lanes are in kernels/rows.h; this header knows no lanes. */
#ifndef KERNELS_KERNEL_H
#define KERNELS_KERNEL_H

#include <stdbool.h>

struct kernel {
    const char *name, *about, *source;
    double sigma[4]; /* [D] normalisation in 2D and 3D, 0 where undefined    */
    bool singular;   /* W grows without bound at the centre: no kernel for sums
                        that count the particle itself                        */
    bool spreads;    /* the Laplacian of W is nowhere negative, as a viscosity
                        made of it needs                                      */

    /* The shape and its first two derivatives by q [1], for q in [0, 1]. */
    double (*w)(double q);
    double (*dw)(double q);
    double (*ddw)(double q);

    const struct kernel_rows *rows; /* of the compiled width: kernels/rows.h  */
};

/* 0.01 hs^2, hs half the support [m^2]. */
static inline double kernel_softening(double support)
{
    return 0.01 * (support / 2) * (support / 2);
}

#define KERNEL_CLOSE 1e-9

/* A kernel as a scene uses it. */
struct kernel_use {
    const struct kernel *kernel;
    double support; /* H [m]                                                 */
    double scale;   /* sigma_D / H^D [m^-D]                                  */
    double inverse; /* 1/H [1/m]                                             */
};

/* A kernel with its scale worked out; it must have a sigma in that dimension. */
struct kernel_use kernel_use_make(const struct kernel *kernel, double support, int dimension);

/* W [m^-D] and W' [m^-(D+1)] at r >= 0 [m]; 0 from r = H on, infinite at the centre of a
 * singular kernel. */
double kernel_w(const struct kernel_use *use, double r);
double kernel_gradient(const struct kernel_use *use, double r);

#endif
