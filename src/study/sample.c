/* sample.c -- what a few numbers that differ by chance say. */
#include "study/sample.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

/* Equal numbers have exactly their mean: sums of differences from the first. */
static double mean_of(int n, const double *value, int *count)
{
    double first = NAN, sum = 0;

    *count = 0;
    for (int i = 0; i < n; i++) {
        if (!isfinite(value[i]))
            continue;
        if ((*count)++ == 0)
            first = value[i];
        sum += value[i] - first;
    }
    return first + sum / *count;
}

double sample_mean(int n, const double *value)
{
    int count;

    return mean_of(n, value, &count);
}

void sample_make(struct sample *s, int n, const double *value)
{
    double sum = 0;

    *s = (struct sample){ .low = NAN, .high = NAN, .sd = NAN, .half = NAN };
    s->mean = mean_of(n, value, &s->n);
    for (int i = 0; i < n; i++) {
        if (!isfinite(value[i]))
            continue;
        s->low = fmin(s->low, value[i]);
        s->high = fmax(s->high, value[i]);
        sum += (value[i] - s->mean) * (value[i] - s->mean);
    }
    if (s->n < 2)
        return;
    s->sd = sqrt(sum / (s->n - 1));
    s->half = gsl_cdf_tdist_Pinv(0.975, s->n - 1) * s->sd / sqrt(s->n);
}

double sample_inside(int n)
{
    return (n - 1.0) / (n + 1.0);
}

double sample_doubt(int n)
{
    return n > 1 ? 1 / sqrt(2 * (n - 1.0)) : NAN;
}
