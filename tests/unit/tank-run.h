/* tank-run.h -- a tank that runs for a while. */
#ifndef TESTS_UNIT_TANK_RUN_H
#define TESTS_UNIT_TANK_RUN_H

#include "../physics/tank.h"

/* Steps from t = 0 to `until` [s]; y there into t->y.  Fails the test when a step does. */
void tank_run(struct tank *t, const char *name, double tol, double until);

#endif
