/* eos.h -- equations of state: pressure, and the energy stored by it. */
#ifndef MATTER_EOS_H
#define MATTER_EOS_H

#include <stdbool.h>

/* Tait (E2): p = B ((rho/rho0)^gamma - 1), B = rho0 c0^2 / gamma; with gamma = 1
 * the linear one (E1), p = c0^2 (rho - rho0).  One that is clamped knows no
 * tension: below rho0 its pressure and its energy are 0. */
struct eos {
    double rho0, c0, gamma; /* [kg/m^D], [m/s], [1] */
    bool clamped;
};

double eos_pressure(const struct eos *e, double rho);  /* [Pa] */
double eos_density(const struct eos *e, double p);     /* inverse [kg/m^D]; NaN below -B,
                                                          rho0 for p < 0 when clamped */
double eos_sound(const struct eos *e, double rho);     /* sqrt(dp/drho) [m/s] */

/* Specific internal energy [J/kg], integral of p/rho^2 from rho0 to rho; keeps
 * all its digits near rho0, where it is c0^2/2 ((rho - rho0)/rho0)^2. */
double eos_energy(const struct eos *e, double rho);

/* p[i] = eos_pressure(rho[i]), n of them; without pow() when gamma is 7. */
void eos_pressures(const struct eos *e, int n, const double *rho, double *p);

/* c[i] = eos_sound(rho[i]), n of them. */
void eos_sounds(const struct eos *e, int n, const double *rho, double *c);

/* modulus[i] = rho dp/drho [Pa] at the pressure p[i], n of them; 0 for p <= 0 when clamped. */
void eos_moduli(const struct eos *e, int n, const double *p, double *modulus);

#endif
