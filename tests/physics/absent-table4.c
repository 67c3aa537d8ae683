/* absent-table4.c -- one effect more, 4 lanes, where the build has them. */
#ifdef STIFFWATER_V3
#define LANES 4
#include "absent-table.h"
#endif
