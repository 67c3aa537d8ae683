/* kernel-table.c -- one kernel in 2D with support H = 1 m, from the centre to a little
 * beyond its end: r/H, W, W', Laplacian.
 *
 * `kernel-table NAME` writes CSV to stdout; plots/figures-kernels.sh draws it.  Values
 * without end are written nan. */
#define LANES 2
#include "kernels/rows.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { STEPS = 400, LAST = 420 };

static const struct kernel *find(const char *name)
{
    for (int i = 0; kernel_table[i]; i++)
        if (strcmp(kernel_table[i]->name, name) == 0)
            return kernel_table[i];
    return NULL;
}

static void number(double value, const char *end)
{
    if (isfinite(value))
        printf("%.10g%s", value + 0.0, end); /* no -0 */
    else
        printf("nan%s", end);
}

static void rows(const struct kernel_use *use)
{
    printf("# units: 1,1/m^2,1/m^3,1/m^4\nr_over_H,W,dW,lapW\n");
    for (int i = 0; i <= LAST; i++) {
        const double r = (double)i / STEPS;

        number(r, ",");
        number(kernel_w(use, r), ",");
        number(kernel_gradient(use, r), ",");
        number(kernel_laplacian(use, r), "\n");
    }
}

int main(int argc, char **argv)
{
    const struct kernel *kernel = argc == 2 ? find(argv[1]) : NULL;

    if (!kernel) {
        fprintf(stderr, "usage: kernel-table NAME, one of");
        for (int i = 0; kernel_table[i]; i++)
            fprintf(stderr, " %s", kernel_table[i]->name);
        fprintf(stderr, "\n");
        return 1;
    }
    const struct kernel_use use = kernel_use_make(kernel, 1, DIM);
    rows(&use);
    return fflush(stdout) == 0 ? 0 : 1;
}
