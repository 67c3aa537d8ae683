/* contact-side.c -- the one side of walls = "contact": they press, and never pull. */
#include "walls/contact-side.h"

#include <math.h>

#define EPS 1e-3

void contact_side(const struct eos *eos, int n, double *rho, double *share)
{
    for (int k = 0; k < n; k++) {
        const double d = rho[k] / eos->rho0 - 1, root = sqrt(d * d + EPS * EPS);
        const double over = d > 0 ? (d + root) / 2 : EPS * EPS / (2 * (root - d)); /* all digits */
        rho[k] = eos->rho0 * (1 + over);
        share[k] = over / root;
    }
}

/* pi of rho0 (1 + d). */
static double push(const struct eos *eos, double d)
{
    double rho = eos->rho0 * (1 + d), share;

    contact_side(eos, 1, &rho, &share);
    return eos_pressure(eos, rho) / (rho * rho) * share;
}

double contact_side_start(const struct eos *eos, double rho)
{
    const double wanted = eos_pressure(eos, rho) / (rho * rho);
    double low = -2 * EPS, high = rho / eos->rho0 - 1;

    if (high < low || push(eos, low) >= wanted)
        return eos->rho0 * (1 + low);
    for (int i = 0; i < 60 && low < high; i++) {
        const double d = (low + high) / 2;
        if (push(eos, d) < wanted)
            low = d;
        else
            high = d;
    }
    return eos->rho0 * (1 + (low + high) / 2);
}
