/* rigid-state.h -- the rows of a rigid body in y, and what they say. */
#ifndef BODIES_RIGID_STATE_H
#define BODIES_RIGID_STATE_H

#include "bodies/rigid-make.h"

/* As in struct body_kind.  A body with a joint has its q and the rate of that; one that is
 * driven its own time, which goes with t to rounding. */
int rigid_state_rows(struct body *b, struct layout *l);
void rigid_state_start(const struct body *b, const struct layout *l, double *y);

/* Adds body.NAME.name to y, as layout_add(); its number to *row. */
int rigid_state_row(struct body *b, struct layout *l, int *row, enum layout_class what,
                    const char *name, const char *unit, int n, int components, double scale);

/* Any body: sets x, turn, v, spin and R of w, and with a joint the link. */
void rigid_state_read(const struct body *b, struct body_work *w, const struct layout *l,
                      const double *y);

/* Rates of a body with a joint, by q''. */
void rigid_state_rates(const struct body *b, const struct body_work *w, const struct layout *l,
                       double second, double *ydot);

#endif
