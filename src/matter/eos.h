/* eos.h -- equations of state: pressure, and the energy stored by it. */
#ifndef MATTER_EOS_H
#define MATTER_EOS_H

/* Tait (E2): p = B ((rho/rho0)^gamma - 1), B = rho0 c0^2 / gamma. */
struct eos {
    double rho0, c0, gamma; /* [kg/m^D], [m/s], [1] */
};

double eos_pressure(const struct eos *e, double rho);  /* [Pa] */
double eos_density(const struct eos *e, double p);     /* inverse [kg/m^D]; NaN below -B */
double eos_sound(const struct eos *e, double rho);     /* sqrt(dp/drho) [m/s] */

/* Specific internal energy [J/kg], integral of p/rho^2 from rho0 to rho; keeps
 * all its digits near rho0, where it is c0^2/2 ((rho - rho0)/rho0)^2. */
double eos_energy(const struct eos *e, double rho);

/* p[i] = eos_pressure(rho[i]), n of them; without pow() when gamma is 7. */
void eos_pressures(const struct eos *e, int n, const double *rho, double *p);

#endif
