/* fields-grid.h -- arrays of a particle file, in groups that VTK 9.1 reads. */
#ifndef OUTPUT_FIELDS_GRID_H
#define OUTPUT_FIELDS_GRID_H

#include <hdf5.h>
#include <stddef.h>

/* Where one array of the file comes from. */
struct fields_grid_array {
    const char *name;
    hid_t type;
    hsize_t rows, columns; /* columns 0: a list, not a table                  */
    const void *data;
    int regular; /* a pattern: worth compressing                    */
};

/* A group of all of array, which ends with one without a name; "VTKHDF" itself is a grid at the
 * time t [s].  Not 0: it is there. */
int fields_grid_write(hid_t file, const char *name, const struct fields_grid_array *array, double t);

/* A file as it is, put in place when it is whole; image NULL: HDF5 had no memory for it. */
int fields_grid_keep(const char *path, const void *image, size_t size);

#endif
