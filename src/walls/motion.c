/* motion.c -- prescribed motion of a wall. */
#include "walls/walls.h"

#include <math.h>

const struct param walls_motion_params[] = {
    { .key = "velocity", .unit = "m/s", .type = PARAM_VECTOR,
      .offset = offsetof(struct walls_motion, velocity), .min = -1e4, .max = 1e4,
      .about = "constant velocity of the wall" },
    { .key = "amplitude", .unit = "m", .type = PARAM_VECTOR,
      .offset = offsetof(struct walls_motion, amplitude), .min = -1e3, .max = 1e3,
      .about = "amplitude of a sine motion added to it" },
    { .key = "frequency", .unit = "Hz", .offset = offsetof(struct walls_motion, frequency),
      .max = 1e4, .about = "frequency of the sine motion" },
    { 0 },
};

bool walls_motion_any(const struct walls_motion *m)
{
    for (int d = 0; d < DIM; d++)
        if (m->velocity[d] != 0 || (m->amplitude[d] != 0 && m->frequency > 0))
            return true;
    return false;
}

void walls_motion_at(const struct walls_motion *m, double t, double *shift, double *u, double *a)
{
    const double omega = 2 * M_PI * m->frequency;

    for (int d = 0; d < DIM; d++) {
        shift[d] = m->velocity[d] * t + m->amplitude[d] * sin(omega * t);
        u[d] = m->velocity[d] + m->amplitude[d] * omega * cos(omega * t);
        a[d] = -m->amplitude[d] * omega * omega * sin(omega * t);
    }
}
