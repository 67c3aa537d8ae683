/* pcisph-lattice.c -- a full neighbourhood: a particle in a square or cubic lattice.
 *
 *   rho_L = m sum W(|r|)                                                      (PC3)
 *   B = sum gradW_d . gradW_f                                                 (PC4)
 *
 * over all sites r, the particle's own among them; W_d is the kernel of densities, W_f that
 * of the pressure.  The other term of delta, S_d . S_f with S = sum gradW, is 0 there. */
#include "solved/pcisph-inside.h"

#include <math.h>

/* What a neighbour at distance r [m] adds. */
typedef double term(const struct kernel_use *first, const struct kernel_use *second, double r);

static double weight(const struct kernel_use *first, const struct kernel_use *second, double r)
{
    (void)second;
    return kernel_w(first, r);
}

static double slopes(const struct kernel_use *first, const struct kernel_use *second, double r)
{
    return r > 0 ? kernel_gradient(first, r) * kernel_gradient(second, r) : 0;
}

static double lattice_sum(const struct kernel_use *first, const struct kernel_use *second,
                          double dx, term *of)
{
    const int reach = (int)(first->support / dx) + 1, deep = DIM == 3 ? reach : 0;
    double sum = 0;

    for (int k = -deep; k <= deep; k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++)
                sum += of(first, second, dx * sqrt((double)(i * i + j * j + k * k)));
    return sum;
}

double pcisph_lattice_density(const struct kernel_use *kernel, double m, double dx)
{
    return m * lattice_sum(kernel, kernel, dx, weight);
}

double pcisph_lattice_response(const struct kernel_use *density, const struct kernel_use *force,
                               double dx)
{
    return lattice_sum(density, force, dx, slopes);
}
