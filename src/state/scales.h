/* scales.h -- the constants of a scene that every part may read. */
#ifndef STATE_SCALES_H
#define STATE_SCALES_H

#include <stdbool.h>

/* Largest eigenvalues of the particle operators with a smooth kernel, in units
 * of (c0 + v)/hs for waves and 1/hs^2 for the Laplacian.  Measured on finite
 * difference Jacobians of a dam break (Wendland C2, H = 3 dx): waves 1.18 at
 * rest, 1.32 after impact; Laplacian 6.5. */
#define SCALES_WAVE 1.32
#define SCALES_LAPLACE 7.0

struct scales {
    int dimension;
    double dx;              /* spacing of particles at the start     [m]      */
    double support;         /* support radius H of the kernel        [m]      */
    double hs;              /* H/2, only for step limits and eta^2   [m]      */
    double mass;            /* rho0 dx^D                             [kg, 2D: kg/m] */
    double rho0, c0, gamma; /* fluid at rest [kg/m^3], sound [m/s], Tait exponent */
    double speed;           /* U, reference speed                    [m/s]    */
    double density;         /* of evolving densities: what turns into a pressure of
                               about rho0 U^2                        [kg/m^D] */
    double g[3];            /* gravity                               [m/s^2]  */
    double low[3], high[3]; /* domain                                [m]      */
    double period[3];       /* of a direction that repeats the domain's length,
                               else 0                                [m]      */
    bool fluid;             /* there is any                                   */
    bool clamped;           /* pressure is never negative                     */

    /* How the kernels of the scene differ from Wendland C2 of the same support,
     * by their largest eigenvalues on the lattice (1 when they do not differ). */
    double wave;            /* of waves: SCALES_WAVE wave/hs         [1]      */
    double laplace_density, laplace_viscosity; /* of Laplacians made of gradients
                               of these kernels                      [1]      */
    double laplacian;       /* largest eigenvalue of the Laplacian of the
                               viscosity kernel                      [1/m^2]  */
    double centre;          /* density kernel at its centre          [1/m^D]  */
    double nearby;          /* pressure kernel at dx                [1/m^D]  */
};

#endif
