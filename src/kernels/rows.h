/* rows.h -- smoothing kernels on rows of lanes: the loops of each, and their table. */
#ifndef KERNELS_ROWS_H
#define KERNELS_ROWS_H

#include "base/lanes.h"
#include "kernels/kernel.h"

typedef void kernel_loop(double support, double scale, int n, const lanes *r, const lanes *m,
                         lanes *to);

typedef void kernel_soft_loop(double support, double scale, int n, const lanes *r,
                              const lanes *r2, const lanes *m, lanes *restrict g,
                              lanes *restrict g_r2);

struct kernel_rows {
    /* g[k] = m[k] W'(r)/r [of m, m^-(D+2)], w[k] = m[k] W(r) [of m, m^-D] and
     * l[k] = m[k] lap W(r) in DIM dimensions [of m, m^-(D+2)] for n rows of
     * r [m]; exactly 0 from r = H on, finite at r = 0 (those that divide by r
     * count it as KERNEL_CLOSE H at least).  scale = sigma_D/H^D. */
    kernel_loop *gradient, *value, *laplacian;

    /* g[k] as above and g_r2[k] = g[k]/(r2[k] + kernel_softening(support)), r2 [m^2],
     * in one loop, where the rest hides behind the division; NULL: in two loops. */
    kernel_soft_loop *both;
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

/* The Laplacian of W in DIM dimensions [m^-(D+2)] at r >= 0 [m], that of the rows; 0 from
 * r = H on. */
#define kernel_laplacian LANE_NAME(kernel_laplacian)
double kernel_laplacian(const struct kernel_use *use, double r);

#endif
