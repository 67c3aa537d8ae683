/* space-laws2.c -- the tests' laws for 2 lanes. */
#define LANES 2
#include "space-laws.h"
