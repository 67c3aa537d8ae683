/* absent-table2.c -- one effect more, 2 lanes. */
#define LANES 2
#include "absent-table.h"
