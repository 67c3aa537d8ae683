/* pcisph-table.c -- how much of an error one iteration of PCISPH corrects on a 2D lattice.
 *
 * A pressure that is a plane wave, P = cos(k.x), changes rho* by
 *
 *   -2 h^2 m^2 B lambda(k) P,  lambda = s_d . s_f / (2 B),  s = sum gradW(r) sin(k.r)  (PC7)
 *
 * over the sites r of a square lattice, so that an iteration leaves 1 - g lambda of an error,
 * g the gain of doc/equations.md: one that grows where g > 2/max(lambda), or lambda < 0.
 *
 * `pcisph-table` writes CSV to stdout: density and pressure kernel, H/dx, the gain that
 * delta of the density's kernel has, least and largest lambda, 2/max(lambda). */
#define LANES 2
#include "kernels/rows.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WAVES = 40 }; /* from 0 to the shortest, in each direction */

static const struct kernel *find(const char *name)
{
    for (int i = 0; kernel_table[i]; i++)
        if (strcmp(kernel_table[i]->name, name) == 0)
            return kernel_table[i];
    return NULL;
}

/* s of (PC7) by W'; the spacing is 1. */
static void slope(const struct kernel_use *use, double kx, double ky, double s[2])
{
    const int reach = (int)use->support + 1;

    s[0] = s[1] = 0;
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            const double r = hypot(i, j);
            const double w = r > 0 ? kernel_gradient(use, r) / r * sin(kx * i + ky * j) : 0;
            s[0] += w * i;
            s[1] += w * j;
        }
}

static double response(const struct kernel_use *d, const struct kernel_use *f)
{
    const int reach = (int)d->support + 1;
    double sum = 0;

    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++)
            if (i != 0 || j != 0)
                sum += kernel_gradient(d, hypot(i, j)) * kernel_gradient(f, hypot(i, j));
    return sum;
}

static void row(const char *density, const char *pressure, double support)
{
    const struct kernel_use d = kernel_use_make(find(density), support, 2);
    const struct kernel_use f = kernel_use_make(find(pressure), support, 2);
    const double B = response(&d, &f);
    double least = 0, most = 0;

    for (int j = 0; j <= WAVES; j++)
        for (int i = 0; i <= j; i++) {
            double a[2], b[2];
            slope(&d, M_PI * i / WAVES, M_PI * j / WAVES, a);
            slope(&f, M_PI * i / WAVES, M_PI * j / WAVES, b);
            const double lambda = (a[0] * b[0] + a[1] * b[1]) / (2 * B);
            least = fmin(least, lambda);
            most = fmax(most, lambda);
        }
    printf("%s,%s,%.4g,%.6g,%.6g,%.6g,%.6g\n", density, pressure, support, B / response(&d, &d),
           least, most, 2 / most);
}

int main(void)
{
    printf("density,pressure,support,gain,least,most,bound\n");
    for (double support = 2.2; support < 5.01; support += 0.02) {
        row("poly6", "spiky", support);
        row("wendland-c2", "wendland-c2", support);
    }
    return fflush(stdout) == 0 ? 0 : 1;
}
