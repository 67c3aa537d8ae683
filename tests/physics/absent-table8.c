/* absent-table8.c -- one effect more, 8 lanes, where the build has them. */
#ifdef STIFFWATER_V4
#define LANES 8
#include "absent-table.h"
#endif
