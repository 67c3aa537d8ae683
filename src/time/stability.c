/* stability.c -- stability factors of explicit Runge-Kutta tables.
 *
 * Their R(z) = 1 + sum_k z^k b A^(k-1) 1 is a polynomial; a ray is followed
 * outwards in small steps until |R| first exceeds 1.001.  Hairer, Wanner,
 * Solving Ordinary Differential Equations II, section IV.2. */
#include "time/stability.h"

#include <complex.h>
#include <math.h>

/* r[k] = coefficient of z^k. */
static void polynomial(const struct tableau *t, double r[TABLEAU_STAGES + 1])
{
    double v[TABLEAU_STAGES], next[TABLEAU_STAGES];

    r[0] = 1;
    for (int i = 0; i < t->stages; i++)
        v[i] = 1;
    for (int k = 1; k <= t->stages; k++) {
        r[k] = 0;
        for (int i = 0; i < t->stages; i++) {
            r[k] += t->b[i] * v[i];
            next[i] = 0;
            for (int j = 0; j < i; j++)
                next[i] += t->a[i][j] * v[j];
        }
        for (int i = 0; i < t->stages; i++)
            v[i] = next[i];
    }
}

static double growth(int degree, const double *r, double complex z)
{
    double complex sum = 0;

    for (int k = degree; k >= 0; k--)
        sum = sum * z + r[k];
    return cabs(sum);
}

double stability_growth(const struct tableau *t, double re, double im)
{
    double r[TABLEAU_STAGES + 1];

    polynomial(t, r);
    return growth(t->stages, r, re + im * I);
}

static double along(const struct tableau *t, double complex direction)
{
    const double step = 1e-3, farthest = 100;
    double r[TABLEAU_STAGES + 1], c = 0;

    polynomial(t, r);
    while (c < farthest && growth(t->stages, r, (c + step) * direction) <= 1.001)
        c += step;
    return c;
}

double stability_wave(const struct tableau *t, double damping)
{
    return along(t, I - damping);
}

double stability_decay(const struct tableau *t)
{
    return along(t, -1);
}

/* |R(i x)|, stage by stage. */
static double ringing(const struct tableau *t, double x)
{
    double complex k[TABLEAU_STAGES], sum = 1;

    for (int i = 0; i < t->stages; i++) {
        double complex z = 1;
        for (int j = 0; j < i; j++)
            z += I * x * t->a[i][j] * k[j];
        k[i] = z / (1 - I * x * t->a[i][i]);
        sum += I * x * t->b[i] * k[i];
    }
    return cabs(sum);
}

double stability_swing(const struct tableau *t, double loss)
{
    const double step = 1e-3, farthest = 2 * M_PI / 12, periods = 10;
    double c = step;

    while (c < farthest
           && fabs(pow(ringing(t, c + step), periods * 2 * M_PI / (c + step)) - 1) <= loss)
        c += step;
    return c;
}
