/* catalogue.h -- joins the tables of all rooms: what there is, and its rows. */
#ifndef PLAN_CATALOGUE_H
#define PLAN_CATALOGUE_H

#include "plan/engine.h"
#include <stdbool.h>
#include <stdio.h>

struct param;

enum { CATALOGUE_ROWS = 3 };

/* Group i of keys of a scene: its name, NULL behind the last, and its rows [CATALOGUE_ROWS], sets of
 * rows that end with NULL where there are fewer. */
const char *catalogue_group(int i, const struct param *const **rows);

/* Groups that a scene may have at its top level, NULL-ended. */
extern const char *const catalogue_groups[];

/* Hands the names of kernels, equations of state and wall models to the rows
 * that refer to them; call before any row is read. */
void catalogue_prepare(const struct engine *engine);

/* The part of that name, NULL if the table has none. */
const struct part *catalogue_part(const struct part *const *table, const char *name);

/* Is the effect called for by a key at the top level instead of a group? */
bool catalogue_implied(const struct part *part);

/* `list WHAT`: a line each; BAD_SCENE for a word that is no table. */
int catalogue_list(const char *what, FILE *to);

/* `explain NAME`: equation, source, parameters with units and defaults of a
 * part, a body kind, a kernel or a group of keys; BAD_SCENE with the nearest
 * name when there is no such thing. */
int catalogue_explain(const char *name, FILE *to);

/* The same of a group of keys alone, as some methods have one; false: there is none. */
bool catalogue_explain_group(const char *name, FILE *to);

#endif
