/* float.h -- a body without an implicit side, for tests: a rigid block of three layers of
 * points that goes up and down on a spring. */
#ifndef TESTS_UNIT_FLOAT_H
#define TESTS_UNIT_FLOAT_H

#include "bodies/bodies.h"

struct float_def {
    double at[3];     /* its lower left point at rest        [m]        */
    double length;    /*                                     [m]        */
    double mass;      /*                                     [2D: kg/m] */
    double stiffness; /* of the spring                       [2D: N/m^2] */
    double lift;      /* height above rest at t = 0          [m]        */
};

/* m s'' = F + m g - k s across, held along.  Rows "beam.NAME.s" and "beam.NAME.s_rate". */
extern const struct body_kind float_kind;

#endif
