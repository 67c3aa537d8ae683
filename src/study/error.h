/* error.h -- distances between tables of two runs; formulas in study/result.h. */
#ifndef STUDY_ERROR_H
#define STUDY_ERROR_H

#include "output/table.h"

double error_positions(const struct table *run, const struct table *reference); /* [m] */
double error_front(const struct table *run, const struct table *reference);
double error_tip(const struct table *run, const struct table *reference);
double error_body(const struct table *run, const struct table *reference);
double error_impulse(const struct table *run, const struct table *reference);
double error_force(const struct table *run, const struct table *reference);
double error_probe(const struct table *run, const struct table *reference);

#endif
