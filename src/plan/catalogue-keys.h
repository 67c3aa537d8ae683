/* catalogue-keys.h -- `explain` of a single key. */
#ifndef PLAN_CATALOGUE_KEYS_H
#define PLAN_CATALOGUE_KEYS_H

#include <stdbool.h>
#include <stdio.h>

/* Every row that KEY, GROUP.KEY, GROUP.NAME.KEY or effects.EFFECT.KEY can mean, and whose it is;
 * else every row that can have this word as its value; false: there is none. */
bool catalogue_explain_key(const char *name, FILE *to);

#endif
