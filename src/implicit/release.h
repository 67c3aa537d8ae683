/* release.h -- the start: y at t = 0, with the pressure of fluid that is let go then.
 *
 *     TRY(release_start(moment, y));
 *
 * Where a fluid says initial = "released", all densities are those of pressures at which the
 * divergence of velocities has no rate, so that no sound follows:
 *
 *     S^T D a = 0,  m a = f - G P,  P = p/rho^2                                   (R1)
 *
 * with D and G of space/nabla.h and f the forces of all but the pressure.  Walls are
 * accelerated as they are driven; bodies with a struct body_coupled yield, others are held.
 * P of solids is the hydrostatic one, plus S times what P of the fluid differs from its own:
 * means over the fluid around them.  doc/equations.md, Start, says how and why. */
#ifndef IMPLICIT_RELEASE_H
#define IMPLICIT_RELEASE_H

struct moment;
struct plan;

/* y [moment_size()] at t = 0 of a fresh moment, which is as fresh afterwards, but for its
 * counters.  All ranks together, and on all STATUS_FAILED: no memory, or no such pressure is
 * found. */
int release_start(struct moment *m, double *y);

/* Bytes that it works in, beside the moment and y; 0: no fluid is let go. */
double release_memory(const struct plan *p);

#endif
