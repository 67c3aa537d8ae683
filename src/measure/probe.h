/* probe.h -- what a gauge at one point would read. */
#ifndef MEASURE_PROBE_H
#define MEASURE_PROBE_H

#include "algebra/exact-sum.h"
#include "measure/crowd.h"

/* Pressure at x [Pa]: mean of the fluid within the support H, weighted by
 * w(q) = (1-q)^4 (1+4q), q = r/H (Shepard's interpolation).  p [count of fluid].
 * 0 when no fluid is near, as in a wall or in the air.  Exact for a linear field
 * where particles lie around x evenly; on the face of a wall it reads the fluid
 * some 0.3 H before it.
 *
 * Where the weights add up to less than a sixteenth of those of a full
 * surrounding, the rest counts as air without pressure: a drop that flies by is
 * no impact. */
double probe_pressure(const struct crowd *c, const double *p, const double *x);

/* Velocity at x, u [DIM] [m/s], by the same mean, of however little fluid. */
void probe_velocity(const struct crowd *c, const double *x, double *u);

/* The same step by step, for many points and where the crowd has some rows of the fluid alone: sums over
 * these, which have no order; then all ranks together make them sums over all; then what they are of.
 * At most PROBE_SHARED points are shared at a time. */
enum { PROBE_SHARED = 16 };
struct probe_sums {
    int components;
    struct exact_sum weight, sum[DIM]; /* of w, of w times each component */
};
void probe_sum_pressure(const struct crowd *c, const double *p, const double *x, struct probe_sums *to);
void probe_sum_velocity(const struct crowd *c, const double *x, struct probe_sums *to);
void probe_share(int n, struct probe_sums *of);
double probe_mean_pressure(const struct crowd *c, const struct probe_sums *s);
void probe_mean_velocity(const struct probe_sums *s, double *u);

/* Level of the water above the domain's lowest point [m]: its surface lies half a spacing
 * above its highest particle, as the floor lies half a spacing below the lowest one.  Of those
 * particles whose horizontal distance from x is within the support, counting only the first
 * `axes` coordinates (1: a gauge across the whole depth of a 3D tank; DIM - 1: a column).
 * 0: it is dry.  Of the rows that the crowd has: of all it is the largest of all ranks. */
double probe_height(const struct crowd *c, const double *x, int axes);

#endif
