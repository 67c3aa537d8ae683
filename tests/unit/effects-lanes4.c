/* effects-lanes4.c -- effects with 4 lanes, where the build has them. */
#ifdef STIFFWATER_V3
#define LANES 4
#include "effects-lanes.h"
#endif
