/* rearrange.h -- particles change rows while a run goes on.
 *
 *     rows = moment_rows(moment, from, row);
 *     TRY(method->rearrange(self, rows, row));      y and all that a method keeps
 *     TRY(moment_rearrange(moment, from));          all that a moment keeps
 *
 * Between two steps, and both or none.  No bit of what follows depends on it: pair lists
 * are in order of places, sums and outputs in that of places or ids. */
#ifndef EVAL_REARRANGE_H
#define EVAL_REARRANGE_H

#include "algebra/vector.h"
#include "eval/moment.h"
#include "space/kinds.h"

enum { MOMENT_ROWS = KINDS + 2 }; /* blocks of y that hold particles */

/* Row i of kind k becomes what row from[k][i] was (NULL: this kind stands as before). */
int moment_rearrange(struct moment *moment, const int *const from[KINDS]);

/* The same in words of y; returns how many blocks. */
int moment_rows(const struct moment *moment, const int *const from[KINDS],
                struct vector_rows row[MOMENT_ROWS]);

/* The same of rows that go to other ranks, by kind; NULL: none of them does. */
int moment_travels(const struct moment *moment, const struct vector_travel *const travel[KINDS],
                   struct vector_rows row[MOMENT_ROWS]);

/* The kind whose particles a row of the layout holds, KINDS: none. */
int moment_kind(const struct moment *moment, int row);

/* Where the particle with that id, of its kind, stands in a row of the layout; of what is no
 * particle, the number itself. */
int moment_row(const struct moment *moment, int row, int id);

#endif
