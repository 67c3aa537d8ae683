/* added.h -- what every part that doc/adding-a-part.md adds must do, beside its physics. */
#ifndef TESTS_PARTS_ADDED_H
#define TESTS_PARTS_ADDED_H

#include "../physics/tank.h"

enum added_table { ADDED_EFFECTS, ADDED_WALLS };

/* It stands in the tables of all widths that the build has; `list` has its line, `explain` its
 * equation, source and keys. */
void added_is_told(enum added_table table, const char *name);

/* A plan of water in a tank that does not name it has none of it: no part, no law, no field,
 * no row of y. */
void added_costs_nothing(const char *name);

/* A periodic box without walls, filled with fluid at rest on its lattice, one wavelength
 * `added_wave` [m] long; goes before effects. */
extern const char *const added_lattice;
extern const double added_wave;

/* Runs `check` with each width that this machine has. */
void added_at_all_widths(void (*check)(void));

#endif
