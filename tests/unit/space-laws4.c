/* space-laws4.c -- the tests' laws for 4 lanes. */
#define LANES 4
#include "space-laws.h"
