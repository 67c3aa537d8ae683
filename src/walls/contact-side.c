/* contact-side.c -- the one side of walls = "contact": they press, and never pull. */
#include "walls/contact-side.h"

/* pi of rho0 (1 + d). */
static double push(const struct eos *eos, double d)
{
    double rho = eos->rho0 * (1 + d), share;

    contact_side(eos->rho0, 1, &rho, &share);
    return eos_pressure(eos, rho) / (rho * rho) * share;
}

double contact_side_start(const struct eos *eos, double rho)
{
    const double wanted = eos_pressure(eos, rho) / (rho * rho);
    double low = -2 * CONTACT_SIDE_EPS, high = rho / eos->rho0 - 1;

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
