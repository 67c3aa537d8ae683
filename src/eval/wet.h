/* wet.h -- solids that something meets in the list of pairs, and the forces on solids. */
#ifndef EVAL_WET_H
#define EVAL_WET_H

#include "space/kinds.h"
#include <stdbool.h>

struct list;
struct moment;
struct plan;

/* Of a workspace.  [solids] counts from the first solid, by row or by id. */
struct wet_solids {
    const struct list *list; /* of which it is, when that had been made so often  */
    long builds;
    bool named;              /* `of` and `row` are there                           */
    bool *met;               /* [solids] by id: fluid is a neighbour, of a pair that this rank sums */
    bool *has;               /* [solids] by id: it has neighbours, on any rank      */
    int *row, *of;           /* those of object i: row[of[i]] .. row[of[i + 1] - 1], in order
                                of ids, [solids], [objects + 1]; counted over all kinds */
    double (*f)[DIM];        /* [solids] by row: forces on them [N]                */
    int others, *other;      /* [solids] rows that solids press, likewise counted  */
    bool *seen;              /* [slots] of the workspace, by place: scratch        */
};

int wet_create(const struct plan *p, struct wet_solids *wet);
void wet_free(struct wet_solids *wet);

/* Makes it that of the moment's list, where it is not: members met and has, for what this rank
 * sums; all but f and other. */
void wet_mark(struct moment *m);
void wet_find(struct moment *m);

/* Has the solid in this row a neighbour in the list, after wet_mark()?  So where kinds that meet act on
 * each other. */
bool wet_is_near(const struct moment *m, int row);

/* The list, or the rows that it names, become others without a rebuild that is counted. */
void wet_forget(struct moment *m);

/* Forces of pairs, from places to rows; what solids press is added afterwards. */
void wet_take(struct moment *m);

/* Was a solid in the domain when the list was made?  Others have no force at all. */
bool wet_counts(const struct moment *m, int row);

/* Rows of an object on which there may be a force; row k of them. */
int wet_rows(const struct moment *m, int object);
int wet_row(const struct moment *m, int object, int k);

#endif
