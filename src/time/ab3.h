/* ab3.h -- Adams-Bashforth with error control; for the table of methods. */
#ifndef TIME_AB3_H
#define TIME_AB3_H

#include "time/paced.h"

extern const struct paced_kind ab3_kind;

#endif
