/* element.h -- the plane beam element with four degrees of freedom: deflection w
 * and rotation theta = dw/ds at its two ends, in the order w1, theta1, w2, theta2.
 *
 * Per metre of width in 2D: EI [N m], mass per length mu [kg/m^2]. */
#ifndef BODIES_ELEMENT_H
#define BODIES_ELEMENT_H

/* (43) of Toth (2012): forces and moments of the bent element are k (w1 .. theta2). */
void element_stiffness(double EI, double l, double k[4][4]);

/* Consistent mass: kinetic energy of the element is 1/2 v . m v. */
void element_mass(double mu, double l, double m[4][4]);

/* Lumped mass: half of the element's m = mu l at each end, and m l^2/24 for its turns. */
void element_lumped(double mu, double l, double m[4][4]);

/* Deflection at s = xi l is the sum of shape[i] dof[i], rotation that of
 * slope[i] dof[i]; xi from 0 to 1.  slope[] in 1/m and 1. */
void element_shape(double xi, double l, double shape[4], double slope[4]);

/* Nodal forces and moments of a uniform transverse load q [N/m^2]. */
void element_uniform(double q, double l, double f[4]);

#endif
