/* solid-rows.h -- rows of y for densities that solids have of their own. */
#ifndef WALLS_SOLID_ROWS_H
#define WALLS_SOLID_ROWS_H

#include "state/part.h"

/* The member blocks() of wall models: one row for each kind of solids that there is. */
int solid_rows_add(const void *self, const struct scales *s, const struct particles *p,
                   struct layout *l, int density_row[KINDS]);

#endif
