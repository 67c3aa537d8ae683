/* eos.c -- the Tait and the linear equation of state and what follows from them.
 *
 * Everything is written in d = (rho - rho0)/rho0, which a double holds exactly
 * near rho0: weakly compressible water lives at |d| of 1e-6 to 1e-2, where
 * (rho/rho0)^gamma - 1 would lose most of its digits. */
#include "matter/eos.h"

#include <math.h>

static double stiffness(const struct eos *e) /* B [Pa] */
{
    return e->rho0 * e->c0 * e->c0 / e->gamma;
}

static double strain(const struct eos *e, double rho) /* d [1] */
{
    return (rho - e->rho0) / e->rho0;
}

/* s^7 - 1 = (s - 1)(1 + s + ... + s^6) at s = 1 + d. */
static inline double seventh(double d)
{
    const double s = 1 + d, s2 = s * s;

    return d * (1 + (s + s2) * (1 + s2 * (1 + s2)));
}

/* (exp(z) - 1 - z)/z^2, to rounding for every z. */
static double second_remainder(double z)
{
    double sum = 0;

    if (fabs(z) > 1)
        return (expm1(z) - z) / (z * z);
    for (int k = 19; k >= 2; k--)
        sum = (sum * z + 1) / k;
    return sum;
}

/* (E2) p = B ((rho/rho0)^gamma - 1).  Monaghan, J. Comput. Phys. 110 (1994)
 * 399-406, takes gamma = 7 for water; gamma = 1 is (E1), p = c0^2 (rho - rho0),
 * (19) of Toth (2012) with k = c0^2. */
double eos_pressure(const struct eos *e, double rho)
{
    const double d = strain(e, rho);

    if (e->clamped && d < 0)
        return 0;
    if (e->gamma == 7)
        return stiffness(e) * seventh(d);
    if (e->gamma == 1)
        return stiffness(e) * d;
    return stiffness(e) * expm1(e->gamma * log1p(d));
}

double eos_density(const struct eos *e, double p)
{
    if (e->clamped && p < 0)
        return e->rho0;
    return e->rho0 * (1 + expm1(log1p(p / stiffness(e)) / e->gamma));
}

/* c = c0 (rho/rho0)^((gamma - 1)/2), from dp/drho of (E2). */
static inline double third_power(double c0, double s)
{
    return c0 * s * s * s;
}

double eos_sound(const struct eos *e, double rho)
{
    const double s = rho / e->rho0;

    return e->gamma == 7 ? third_power(e->c0, s) : e->c0 * pow(s, 0.5 * (e->gamma - 1));
}

/* With s = rho/rho0 and L = ln s the integral of (E2) is
 *
 *   e = B/rho0 [ (s^(gamma-1) - 1)/(gamma - 1) + 1/s - 1 ]
 *     = B/rho0 L^2 [ (gamma - 1) R((gamma - 1) L) + R(-L) ],  R = second_remainder,
 *
 * the second line without the cancellation of the first, and good for gamma = 1.
 * With gamma = 7 and s = 1 + d the bracket is a polynomial and 1/(1 + d), both
 * of which begin with d^2 once d and -d have gone. */
static inline double seventh_energy(double d)
{
    return d * d * (1 / (1 + d) + 2.5 + d * (10. / 3 + d * (2.5 + d * (1 + d / 6))));
}

double eos_energy(const struct eos *e, double rho)
{
    if (e->clamped && rho < e->rho0)
        return 0;
    if (e->gamma == 7)
        return stiffness(e) / e->rho0 * seventh_energy(strain(e, rho));
    const double a = e->gamma - 1, log_s = log1p(strain(e, rho));
    const double sum = a * second_remainder(a * log_s) + second_remainder(-log_s);

    return stiffness(e) / e->rho0 * log_s * log_s * sum;
}

/* Loops that take several at once: a limit of strains (-INFINITY: none) instead of a question,
 * as a branch on the sign of a strain is often mispredicted.  Copied into each width. */
static inline __attribute__((always_inline)) void loops(const struct eos *e, int n,
                                                        const double *restrict rho,
                                                        double *restrict p)
{
    const double b = stiffness(e), rho0 = e->rho0, least = e->clamped ? 0 : -INFINITY;

    if (e->gamma == 7) {
#pragma omp simd
        for (int i = 0; i < n; i++) {
            const double given = (rho[i] - rho0) / rho0, d = least > given ? least : given;
            p[i] = b * seventh(d);
        }
        return;
    }
#pragma omp simd
    for (int i = 0; i < n; i++) {
        const double given = (rho[i] - rho0) / rho0;
        p[i] = b * (least > given ? least : given);
    }
}

static inline __attribute__((always_inline)) void sound_loop(const struct eos *e, int n,
                                                             const double *restrict rho,
                                                             double *restrict c)
{
    const double rho0 = e->rho0, c0 = e->c0;

#pragma omp simd
    for (int i = 0; i < n; i++)
        c[i] = third_power(c0, rho[i] / rho0);
}

typedef void eos_loops(const struct eos *e, int n, const double *rho, double *to);

static void narrow(const struct eos *e, int n, const double *rho, double *p)
{
    loops(e, n, rho, p);
}

static void narrow_sounds(const struct eos *e, int n, const double *rho, double *c)
{
    sound_loop(e, n, rho, c);
}

#if defined __x86_64__ && defined __GNUC__
static __attribute__((target("avx2"))) void wide(const struct eos *e, int n, const double *rho,
                                                 double *p)
{
    loops(e, n, rho, p);
}

static __attribute__((target("avx2"))) void wide_sounds(const struct eos *e, int n,
                                                        const double *rho, double *c)
{
    sound_loop(e, n, rho, c);
}

static bool is_wide(void)
{
    return __builtin_cpu_supports("avx2");
}
#else
#define wide narrow
#define wide_sounds narrow_sounds

static bool is_wide(void)
{
    return false;
}
#endif

void eos_pressures(const struct eos *e, int n, const double *rho, double *p)
{
    if (e->gamma == 7 || e->gamma == 1)
        (is_wide() ? wide : narrow)(e, n, rho, p);
    else
        for (int i = 0; i < n; i++)
            p[i] = eos_pressure(e, rho[i]);
}

void eos_sounds(const struct eos *e, int n, const double *rho, double *c)
{
    if (e->gamma == 7)
        (is_wide() ? wide_sounds : narrow_sounds)(e, n, rho, c);
    else
        for (int i = 0; i < n; i++)
            c[i] = eos_sound(e, rho[i]);
}

/* rho dp/drho = gamma (p + B), of (E2). */
void eos_moduli(const struct eos *e, int n, const double *restrict p, double *restrict modulus)
{
    const double gamma = e->gamma, stiff = e->rho0 * e->c0 * e->c0;

    for (int i = 0; i < n; i++)
        modulus[i] = gamma * p[i] + stiff;
    for (int i = 0; i < n && e->clamped; i++)
        if (!(p[i] > 0))
            modulus[i] = 0;
}
