/* mps-source.c -- number densities, who is at a surface, and the source of the Poisson
 * equation.
 *
 *     n_i = sum w(r_ij)                                                          (M2)
 *     Dn_i/Dt = -sum re/r^3 r_ij . u_ij,  r_ij = r_j - r_i, u_ij = u_j - u_i      (M9)
 *
 * Sources b = -lap p, times dt^2/rho0, s being what the explicit part left:
 *
 *     gamma (n^s - n0)/n0                                                         (M6)
 *     stable for gamma kappa < 4/3                                                (M18)
 *     dt (Dn/Dt)^s/(K n0) + drift (n^s - n0)/n0                                    (M10)
 *     dt (Dn/Dt)^s/(K n0) + a dt (Dn/Dt)^k/(K n0) + |dt (Dn/Dt)^k/n0| a' (M11),
 *     a' = (n^k - n0)/n0, a = |a'|
 *
 * K is 1, as published, or kappa, with which Dn/Dt/(K n0) is -div u on the lattice.  (M10):
 * Khayyer and Gotoh 2009, drift: Tanaka and Masunaga 2010; (M11): Khayyer and Gotoh 2011. */
#include "solved/mps-inside.h"

#include <math.h>
#include <string.h>

void mps_number(const struct mps *s, double *number)
{
    const struct near *at = &s->near;

#pragma omp parallel for schedule(static)
    for (int i = 0; i < at->n; i++) {
        double sum = 0, step[DIM];
        for (size_t k = at->from[i]; k < at->from[i + 1]; k++)
            sum += weights_w(&s->density, sqrt(near_step(at, i, at->place[k], step)));
        number[i] = sum;
    }
}

void mps_rate(const struct mps *s, double *rate)
{
    const struct near *at = &s->near;

#pragma omp parallel for schedule(static)
    for (int i = 0; i < at->n; i++) {
        double sum = 0, step[DIM];
        for (size_t k = at->from[i]; k < at->from[i + 1]; k++) {
            const double r2 = near_step(at, i, at->place[k], step), r = sqrt(r2);
            const int j = at->origin[at->place[k]];
            if (!(r > 0 && r < s->density.re))
                continue;
            for (int d = 0; d < DIM; d++)
                sum -= s->density.re / (r2 * r) * step[d] * (at->u[j][d] - at->u[i][d]);
        }
        rate[i] = sum;
    }
}

/* --- roles ----------------------------------------------------------------------- */

/* Of a solid: only a first layer with fluid near it has a pressure.  Where solids alone have n0,
 * as under the tip of a wedge on a floor, another wall covers it: no flow could ever take that
 * number density back, and its source would push for ever. */
static bool presses(const struct mps *s, int i)
{
    const struct near *at = &s->near;
    double step[DIM], solids = 0;
    bool wet = false;

    if (i < at->fluid)
        return true;
    if (!s->face[mps_id(s, i)])
        return false;
    for (size_t k = at->from[i]; k < at->from[i + 1]; k++) {
        const double r2 = near_step(at, i, at->place[k], step);
        if (at->origin[at->place[k]] >= at->fluid)
            solids += weights_w(&s->density, sqrt(r2));
        else
            wet |= r2 < s->laplacian.re * s->laplacian.re;
    }
    return wet && solids < s->density.n0;
}

void mps_roles(struct mps *s)
{
#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->near.n; i++) {
        if (!presses(s, i))
            s->role[i] = POISSON_DUMMY;
        else
            s->role[i] = s->number[i] < s->key->beta * s->density.n0 ? POISSON_SURFACE
                                                                     : POISSON_UNKNOWN;
    }
}

/* --- the source ------------------------------------------------------------------ */

/* (M6), (M10) or (M11) of one particle. */
static double source_of(const struct mps *s, int i)
{
    const struct settings_mps *key = s->key;
    const double n0 = s->density.n0, strain = (s->number[i] - n0) / n0;
    const double K = mps_is(key->hs_constant, "published") ? 1 : s->density.kappa;
    double rate;

    if (mps_is(key->source, "number-density"))
        return key->gamma * strain;
    rate = s->h * s->rate[i] / (K * n0);
    if (mps_is(key->source, "hs"))
        return rate + key->drift * strain;
    const int id = mps_id(s, i);
    const double strain_before = (s->before[id] - n0) / n0;
    const double rate_before = s->h * s->rate_before[id] / n0;
    return rate + fabs(strain_before) * rate_before / K + fabs(rate_before) * strain_before;
}

void mps_source(struct mps *s)
{
    const double scale = s->moment->plan->scales.rho0 / (s->h * s->h);

#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->near.n; i++)
        s->source[i] = s->role[i] == POISSON_UNKNOWN ? scale * source_of(s, i) : 0;
}

/* --- the Laplacian of the pressure ----------------------------------------------- */

/* (M4) */
static double standard(const void *self, double r)
{
    const struct mps *s = self;

    return 2 * DIM / (s->laplacian.lambda * s->laplacian.n0) * weights_w(&s->laplacian, r);
}

/* (M12), exact for quadratic p on the lattice. */
static double higher(const void *self, double r)
{
    const struct mps *s = self;

    return r < s->laplacian.re ? 2 * DIM / s->laplacian.inverse * s->laplacian.re / (r * r * r) : 0;
}

/* (M12) as published, Khayyer and Gotoh 2010 (2D), 2012 (3D). */
static double higher_published(const void *self, double r)
{
    const struct mps *s = self;

    return r < s->laplacian.re ? (5 - DIM) / s->laplacian.n0 * s->laplacian.re / (r * r * r) : 0;
}

poisson_weight *mps_laplacian(const struct mps *s)
{
    if (mps_is(s->key->laplacian, "standard"))
        return standard;
    return mps_is(s->key->hl_constant, "published") ? higher_published : higher;
}
