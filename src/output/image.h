/* image.h -- an HDF5 file that is made in memory and written by us.
 *
 * HDF5 never writes to a disk here: after a write that failed it can neither close its file
 * nor end the program in peace (1.10: a crash at exit).  What it makes has room for large arrays,
 * of which it never has the numbers: these are written to the disk where they belong
 * (output/pieces.h), and take no memory here.
 *
 *     if (image_begin(&m, bytes))   m.file is open
 *         fine = ... H5Dcreate2(m.file, ..., image_room()), image_leave(&m, set) ...
 *     if (image_end(&m, fine))      it is whole
 *         image_put(&m, to);
 *     image_free(&m); */
#ifndef OUTPUT_IMAGE_H
#define OUTPUT_IMAGE_H

#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { IMAGE_ARRAYS = 8 };

struct image {
    hid_t file;  /* of HDF5, below 0: closed                                      */
    int memory;  /* descriptor of what HDF5 has written, below 0: none            */
    int error;   /* why there is none (errno), 0: memory                          */
    int arrays;
    struct image_array {
        long at, bytes;
    } array[IMAGE_ARRAYS]; /* left out, in the order of image_leave()              */
};

/* A new file of at most so many bytes, with what is left out.  HDF5 may crash without memory, and so it does
 * when it may write no more: both are asked for before, false where there is none.  HDF5 prints nothing
 * from now on. */
bool image_begin(struct image *m, size_t bytes);

/* Makes a contiguous array one that is left out, before it is created (as H5Pset_...()). */
bool image_room(hid_t making);

/* The numbers of this array, which has any, are written by others. */
bool image_leave(struct image *m, hid_t set);

/* Closes the file; false: it is not fine. */
bool image_end(struct image *m, bool fine);

/* What image_end() has closed, arrays that are left out skipped, to a file that can be moved in;
 * false: it cannot be read.  Errors in writing show as ever. */
bool image_put(const struct image *m, FILE *to);

void image_free(struct image *m);

/* An image that is not there: STATUS_FAILED or STATUS_IO, with the reason. */
int image_refused(const struct image *m, const char *path);

/* Opens bytes [size] to be read, below 0 when HDF5 cannot; the bytes stay the caller's. */
hid_t image_read(const void *bytes, size_t size);

#endif
