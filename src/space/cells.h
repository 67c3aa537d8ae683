/* cells.h -- a grid for each kind, and all particles sorted by kind, cell and
 * id.  A grid covers its own kind's listed particles, no more; its
 * cells are narrow in x, and rows of cells run to and fro (like a plough), so
 * that places in turn are near each other and a row's stretch of x is one run
 * of places. */
#ifndef SPACE_CELLS_H
#define SPACE_CELLS_H

#include "space/kinds.h"
#include <stdbool.h>
#include <stddef.h>

struct list;

struct cells {
    double low[DIM];      /* least coordinates of the kind        [m]        */
    double per_metre[DIM]; /* cells                               [1/m]      */
    int n[DIM];           /* cells; all 0: no particles                      */
    int *start;           /* [cells+1] first place of a cell                 */
    size_t room;          /* entries allocated in start                      */
    double farthest;      /* from 0, of a coordinate              [m]        */
};

/* A box of cells. */
struct cells_window {
    int low[DIM], high[DIM]; /* first and last cell, both in it              */
};

/* Sets start, order, slot, the grids and the positions in list order from those
 * given, in the domain where it repeats. 0 or STATUS_FAILED (no memory). */
int cells_sort(struct list *list, const struct cloud *cloud);

/* For sorting others in the same way: a grid from c->low to high for n of them, with
 * all start at 0 (0 or STATUS_FAILED); its shape alone, and how many cells it has; the number of the cell that holds x; the
 * counts in start[cell + 2] become, in start[cell + 1], first places from `first` on;
 * the position of a place. */
int cells_grid(struct list *list, struct cells *c, const double *high, double n);
size_t cells_shape(const struct list *list, struct cells *c, const double *high, double n);
int cells_rank(const struct cells *c, const double *x);
void cells_add_up(struct cells *c, int first);
void cells_note(struct list *list, int slot, const double *x);

/* The cells that the box low..high [m] touches; false when there are none. */
static inline bool cells_window(const struct cells *c, const double *low, const double *high,
                                struct cells_window *w)
{
    for (int d = 0; d < DIM; d++) {
        const double from = (low[d] - c->low[d]) * c->per_metre[d];
        const double to = (high[d] - c->low[d]) * c->per_metre[d];

        if (!(to >= 0 && from < c->n[d]))
            return false;
        w->low[d] = from > 0 ? (int)from : 0;
        w->high[d] = to < c->n[d] ? (int)to : c->n[d] - 1;
    }
    return true;
}

/* First cell of line number `row` in a window, as counted in start; the last
 * one is w->high[0] - w->low[0] further on. */
static inline size_t cells_first(const struct cells *c, const struct cells_window *w, int row)
{
    const int x = row % 2 ? c->n[0] - 1 - w->high[0] : w->low[0];

    return (size_t)row * (size_t)c->n[0] + (size_t)x;
}

#endif
