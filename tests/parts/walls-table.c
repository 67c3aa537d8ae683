/* walls-table.c -- the table of wall models with that of doc/adding-a-part.md at its end. */
#include "base/lanes.h"
#include "walls/walls.h"

extern const struct part LANE_NAME(walls_hydrostatic);

/* The library's own text: its end becomes a line more and the end. */
#undef NULL
#define NULL &LANE_NAME(walls_hydrostatic), (const struct part *)0
#include "walls/walls.c"
