/* space-laws8.c -- the tests' laws for 8 lanes. */
#define LANES 8
#include "space-laws.h"
