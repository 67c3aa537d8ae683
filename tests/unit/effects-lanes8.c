/* effects-lanes8.c -- effects with 8 lanes, where the build has them. */
#ifdef STIFFWATER_V4
#define LANES 8
#include "effects-lanes.h"
#endif
