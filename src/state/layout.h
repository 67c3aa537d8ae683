/* layout.h -- which numbers of y mean what.
 *
 * y = all positions, all velocities, everything else.  The layout is made of
 * blocks, a struct layout_row each; offsets are asked for each time, so
 * that the layout may be remade. */
#ifndef STATE_LAYOUT_H
#define STATE_LAYOUT_H

enum layout_class { LAYOUT_POSITION, LAYOUT_VELOCITY, LAYOUT_OTHER, LAYOUT_CLASSES };

struct layout_row {
    char name[48];
    const char *unit;
    enum layout_class what;
    int n, components;   /* y holds [n][components], by row                  */
    double scale;        /* error of size tol * scale is an error of size 1;
                            0: a quadrature, which no error test sees        */
    long offset;         /* set by layout_done()                             */
};

enum { LAYOUT_ROWS = 2048 };

struct layout {
    int rows;
    struct layout_row row[LAYOUT_ROWS];
    long from[LAYOUT_CLASSES + 1]; /* class c: y[from[c]] .. y[from[c+1]-1]  */
};

/* Adds a block and returns its number; -1 (a failure is kept) when full, when the
 * name is too long or a number makes no sense.  Start from a zeroed layout. */
int layout_add(struct layout *l, enum layout_class what, const char *name, const char *unit,
               int n, int components, double scale);

/* Gives all blocks their offsets. */
void layout_done(struct layout *l);

long layout_size(const struct layout *l);
long layout_at(const struct layout *l, int row); /* offset of a block */

/* Weight 1/(tol*scale) of every entry; quadratures get 1e-12.  rows [l->rows]: of the first so many
 * things of each block; NULL: of all. */
void layout_weights(const struct layout *l, double tol, const int *rows, double *weight);

/* Block that holds y[i], and which of its n things that is; NULL beyond y. */
const struct layout_row *layout_find(const struct layout *l, long i, int *which);

#endif
