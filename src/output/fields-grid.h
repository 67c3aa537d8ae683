/* fields-grid.h -- arrays of a particle file, in groups that VTK 9.1 reads. */
#ifndef OUTPUT_FIELDS_GRID_H
#define OUTPUT_FIELDS_GRID_H

#include "output/image.h"

/* Where one array of the file comes from: from `data`, row by row from `fill`, or from all ranks
 * (output/pieces.h) where both are NULL. */
struct fields_grid_array {
    const char *name;
    hid_t type;
    hsize_t rows, columns; /* columns 0: a list, not a table                  */
    const void *data;
    int regular; /* a pattern: worth compressing                    */
    void (*fill)(const void *self, long first, long n, void *to); /* a list: rows first .. */
    const void *self;
};

/* A group of all of array, which ends with one without a name; "VTKHDF" itself is a grid at the
 * time t [s].  Not 0: it is there. */
int fields_grid_write(struct image *to, const char *name, const struct fields_grid_array *array,
                      double t);

/* A file of which nothing is left out, put in place when it is whole; fine: image_end() was. */
int fields_grid_keep(const char *path, const struct image *image, bool fine);

#endif
