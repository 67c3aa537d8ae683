/* cholesky.c -- IC(0) and its two triangular solves. */
#include "solved/cholesky.h"

#include <math.h>

/* Sum of L_im L_km over the columns m < k that both rows have; row i as far as `end`. */
static double product(const struct cholesky *c, size_t from, size_t end, int k)
{
    size_t q = c->from[k];
    double sum = 0;

    for (size_t p = from; p < end; p++) {
        while (q < c->from[k + 1] && c->column[q] < c->column[p])
            q++;
        if (q == c->from[k + 1])
            break;
        if (c->column[q] == c->column[p])
            sum += c->lower[p] * c->lower[q];
    }
    return sum;
}

int cholesky_factor(struct cholesky *c)
{
    for (int i = 0; i < c->n; i++) {
        double left = c->diagonal[i];
        for (size_t p = c->from[i]; p < c->from[i + 1]; p++) {
            const int k = c->column[p];
            c->lower[p] = (c->lower[p] - product(c, c->from[i], p, k)) * c->diagonal[k];
            left -= c->lower[p] * c->lower[p];
        }
        if (!(left > 0))
            return 1 + i;
        c->diagonal[i] = 1 / sqrt(left);
    }
    return 0;
}

void cholesky_solve(const struct cholesky *c, const double *b, double *x)
{
    for (int i = 0; i < c->n; i++) {
        double sum = b[i];
        for (size_t p = c->from[i]; p < c->from[i + 1]; p++)
            sum -= c->lower[p] * x[c->column[p]];
        x[i] = sum * c->diagonal[i];
    }
    for (int i = c->n - 1; i >= 0; i--) {
        x[i] *= c->diagonal[i];
        for (size_t p = c->from[i]; p < c->from[i + 1]; p++)
            x[c->column[p]] -= c->lower[p] * x[i];
    }
}
