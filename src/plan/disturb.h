/* disturb.h -- a start that differs by next to nothing. */
#ifndef PLAN_DISTURB_H
#define PLAN_DISTURB_H

#include "plan/settings.h"

/* Shifts x[0..n)[DIM], positions of the fluid's particles in the order of their ids [m], along
 * each axis by a number between -s->size dx and s->size dx, every one as likely.  It follows
 * from seed, particle and axis alone, so that it is the same on any machine.  Nothing at
 * size 0. */
void disturb_positions(const struct settings_disturbance *s, double dx, double *x, int n);

#endif
