/* growth.c -- how fast a tiny disturbance grows. */
#include "study/growth.h"

#include <gsl/gsl_fit.h>
#include <math.h>

void growth_fit(struct growth *out, int n, const double *t, const double *d, double eps, double g,
                double dx)
{
    double at[1024], gain[1024], c0, slope, cov00, cov01, cov11, sum;
    int k = 0;

    *out = (struct growth){ NAN, NAN };
    for (int i = 0; i < n && k < 1024 && d[i] < dx / 10; i++) {
        const double ratio = d[i] / (eps * g * t[i] * t[i] / 2);
        if (!(ratio > 0) || !isfinite(ratio))
            continue;
        if (ratio <= GROWTH_LOST && k == i)
            out->until = t[i];
        at[k] = t[i];
        gain[k++] = log(ratio);
    }
    if (k < 3)
        return;
    gsl_fit_linear(at, 1, gain, 1, k, &c0, &slope, &cov00, &cov01, &cov11, &sum);
    out->rate = slope;
}
