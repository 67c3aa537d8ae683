/* body-book.h -- for methods that move bodies by other stages than those at which they
 * ask for right-hand sides. */
#ifndef PLAN_BODY_BOOK_H
#define PLAN_BODY_BOOK_H

#include "plan/plan.h"

/* Adds to ydot, the book alone, `share` times what bodies get there at (t, y) under
 * the forces of the last right-hand side: impulse of supports and of prescribed
 * loads, energy that damping takes and loads give.  A right-hand side of the same y
 * has booked the same with share 1. */
void plan_body_book(struct plan *plan, double t, const double *y, double share, double *ydot);

#endif
