/* effects-lanes2.c -- effects with 2 lanes. */
#define LANES 2
#include "effects-lanes.h"
