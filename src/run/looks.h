/* looks.h -- the surfaces of rigid bodies, where they are. */
#ifndef RUN_LOOKS_H
#define RUN_LOOKS_H

#include "eval/observe.h"
#include "output/cloud.h"

struct looks;

/* What pictures take for a spacing [m]: that of particles; where there are none a 200th of the domain's
 * longest side. */
double looks_grain(const struct plan *plan);

/* *out stays NULL when the plan has no rigid bodies. */
int looks_open(struct looks **out, const struct plan *plan);

/* Their names and faces; NULL for NULL. */
const struct cloud_looks *looks_known(const struct looks *l);

/* Area of their faces [m^2 in space, else 0]. */
double looks_area(const struct looks *l);

/* As they stand at y; lent until the next call. */
const struct cloud_looks *looks_at(struct looks *l, const struct moment *moment, const double *y);

void looks_close(struct looks **looks); /* frees; NULL is welcome */

#endif
