/* movie-set.c -- arrays of HDF5 files. */
#include "output/movie-set.h"

#include "base/status.h"

#include <stdlib.h>

void *movie_set(hid_t file, const char *name, hid_t type, hsize_t n, size_t bytes)
{
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t space = set >= 0 ? H5Dget_space(set) : -1;
    const hssize_t there = space >= 0 ? H5Sget_simple_extent_npoints(space) : -1;
    void *to = there == (hssize_t)n ? status_alloc(n, bytes) : NULL;

    if (to && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) < 0) {
        free(to);
        to = NULL;
    }
    if (space >= 0)
        H5Sclose(space);
    if (set >= 0)
        H5Dclose(set);
    return to;
}
