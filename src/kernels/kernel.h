/* kernel.h -- smoothing kernels, described by their support radius H:
 *
 *     W(r) = sigma_D / H^D  w(q),   q = r/H in [0, 1],   0 beyond.
 *
 * One file, one const struct, one line in kernels/kernels.c. */
#ifndef KERNELS_KERNEL_H
#define KERNELS_KERNEL_H

#include "base/lanes.h"
#include <stdbool.h>

typedef void kernel_rows(double support, double scale, int n, const lanes *r, const lanes *m,
                         lanes *to);

typedef void kernel_soft_rows(double support, double scale, int n, const lanes *r,
                              const lanes *r2, const lanes *m, lanes *restrict g,
                              lanes *restrict g_r2);

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

    /* g[k] = m[k] W'(r)/r [of m, m^-(D+2)], w[k] = m[k] W(r) [of m, m^-D] and
     * l[k] = m[k] lap W(r) in DIM dimensions [of m, m^-(D+2)] for n rows of
     * r [m]; exactly 0 from r = H on, finite at r = 0 (those that divide by r
     * count it as KERNEL_CLOSE H at least).  scale = sigma_D/H^D. */
    kernel_rows *gradient, *value, *laplacian;

    /* g[k] as above and g_r2[k] = g[k]/(r2[k] + kernel_softening(support)), r2 [m^2],
     * in one loop, where the rest hides behind the division; NULL: in two loops. */
    kernel_soft_rows *both;
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
};

#define kernel_wendland_c2 LANE_NAME(kernel_wendland_c2)
#define kernel_wendland_c4 LANE_NAME(kernel_wendland_c4)
#define kernel_wendland_c6 LANE_NAME(kernel_wendland_c6)
#define kernel_cubic_spline LANE_NAME(kernel_cubic_spline)
#define kernel_quintic_spline LANE_NAME(kernel_quintic_spline)
#define kernel_gauss LANE_NAME(kernel_gauss)
#define kernel_poly6 LANE_NAME(kernel_poly6)
#define kernel_spiky LANE_NAME(kernel_spiky)
#define kernel_viscosity_log LANE_NAME(kernel_viscosity_log)
extern const struct kernel kernel_wendland_c2, kernel_wendland_c4, kernel_wendland_c6,
    kernel_cubic_spline, kernel_quintic_spline, kernel_gauss, kernel_poly6, kernel_spiky,
    kernel_viscosity_log;

/* NULL-ended; the compiled width's own functions. */
#define kernel_table LANE_NAME(kernel_table)
extern const struct kernel *const kernel_table[];

/* A kernel with its scale worked out; it must have a sigma in that dimension. */
#define kernel_use_make LANE_NAME(kernel_use_make)
struct kernel_use kernel_use_make(const struct kernel *kernel, double support, int dimension);

/* W [m^-D], W' [m^-(D+1)] and the Laplacian of W in DIM dimensions [m^-(D+2)] at
 * r >= 0 [m]; 0 from r = H on.  The Laplacian is that of the rows; W and W' of a
 * singular kernel are infinite at the centre. */
#define kernel_w LANE_NAME(kernel_w)
#define kernel_gradient LANE_NAME(kernel_gradient)
#define kernel_laplacian LANE_NAME(kernel_laplacian)
double kernel_w(const struct kernel_use *use, double r);
double kernel_gradient(const struct kernel_use *use, double r);
double kernel_laplacian(const struct kernel_use *use, double r);

#endif
