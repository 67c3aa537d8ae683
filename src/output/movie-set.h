/* movie-set.h -- arrays of HDF5 files. */
#ifndef OUTPUT_MOVIE_SET_H
#define OUTPUT_MOVIE_SET_H

#include <hdf5.h>

/* All n numbers of a data set, `bytes` each in memory; NULL when it has another size or cannot be
 * read.  free() it. */
void *movie_set(hid_t file, const char *name, hid_t type, hsize_t n, size_t bytes);

#endif
