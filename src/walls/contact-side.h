/* contact-side.h -- the one side of walls = "contact": they press, and never pull.
 *
 *   d+ = (d + sqrt(d^2 + eps^2))/2,  eps = 1e-3
 *   pi = p(rho0 (1 + d+))/(rho0 (1 + d+))^2 dd+/dd,  dd+/dd = d+/sqrt(d^2 + eps^2)      (W6) */
#ifndef WALLS_CONTACT_SIDE_H
#define WALLS_CONTACT_SIDE_H

#include "matter/eos.h"

#define CONTACT_SIDE_EPS 1e-3

/* A chunk of n densities [kg/m^D] rho0 (1 + d) becomes rho0 (1 + d+), and share = dd+/dd. */
static inline void contact_side(double rho0, int n, double *restrict rho, double *restrict share)
{
    const double eps = CONTACT_SIDE_EPS;

    for (int k = 0; k < n; k++) {
        const double d = rho[k] / rho0 - 1, root = __builtin_sqrt(d * d + eps * eps);
        const double wet = (d + root) / 2, dry = eps * eps / (2 * (root - d)); /* all digits */
        const double over = d > 0 ? wet : dry;
        rho[k] = rho0 * (1 + over);
        share[k] = over / root;
    }
}

/* The same with eps = 0, which a pressure that is solved for may have: d+ = max(d, 0). */
static inline void contact_side_sharp(double rho0, int n, double *restrict rho,
                                      double *restrict share)
{
    for (int k = 0; k < n; k++) {
        share[k] = rho[k] > rho0;
        rho[k] = rho[k] > rho0 ? rho[k] : rho0;
    }
}

/* rho0 (1 + d) [kg/m^D] of which pi is p/rho^2 for the density rho of a pressure p: what a solid
 * is to start with, so that it holds just what it is to hold.  Of pressures below
 * 6e-6 rho0 c0^2, which d = -2 eps has, it is that d. */
double contact_side_start(const struct eos *eos, double rho);

#endif
