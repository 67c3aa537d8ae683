/* catalogue-rows.h -- rows of parameters, as `explain` prints them. */
#ifndef PLAN_CATALOGUE_ROWS_H
#define PLAN_CATALOGUE_ROWS_H

#include "bodies/group.h"

#include <stdio.h>

void catalogue_row(const struct param *r, FILE *to);
void catalogue_rows(const struct param *rows, FILE *to); /* NULL is welcome */

/* Those of the groups inside of a body, each with the name of its group; NULL is welcome. */
void catalogue_body_rows(const struct body_group *groups, FILE *to);

#endif
