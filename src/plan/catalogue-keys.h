/* catalogue-keys.h -- `explain` of a single key. */
#ifndef PLAN_CATALOGUE_KEYS_H
#define PLAN_CATALOGUE_KEYS_H

#include <stdbool.h>
#include <stdio.h>

/* Every row that KEY, GROUP.KEY, GROUP.NAME.KEY or effects.EFFECT.KEY can mean, and whose it is;
 * else every row that can have this word as its value; false: there is none. */
bool catalogue_explain_key(const char *name, FILE *to);

/* All rows of the table when GROUP.NAME has the name of an object, as contact.NAME; false: there is no
 * such table, or NAME is nearly a key of it, which then stands in *near, else NULL. */
bool catalogue_explain_named(const char *name, FILE *to, const char **near);

/* The unit of the key, written as in a scene: "Pa" for "beam.plate.E" or "beam.E"; "" where it has
 * none, is unknown, or can mean keys with different units. */
const char *catalogue_unit(const char *name);

#endif
