/* check-look.h -- the two looks of `check`, without limits: they end with patience_done(), print,
 * and return a status. */
#ifndef RUN_CHECK_LOOK_H
#define RUN_CHECK_LOOK_H

#include "run/run.h"

/* program: bytes that it holds before there is a scene.  Of many ranks, which call it together. */
int check_look(const struct run_order *order, double program);

/* Counts what would take too long to make, on one rank. */
int check_count(const struct run_order *order, double program);

#endif
