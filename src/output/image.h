/* image.h -- an HDF5 file that is made in memory and written by us.
 *
 * HDF5 never writes to a disk here: after a write that failed it can neither close its file
 * nor end the program in peace (1.10: a crash at exit). */
#ifndef OUTPUT_IMAGE_H
#define OUTPUT_IMAGE_H

#include <hdf5.h>
#include <stdbool.h>

/* A new file for about so many bytes, below 0 when there is none: memory is asked for before,
 * because HDF5 may crash without it.  HDF5 prints nothing from now on. */
hid_t image_open(size_t bytes);

/* Closes it.  The file as bytes [*size], NULL when it is not fine or cannot be had; free() it. */
void *image_close(hid_t file, bool fine, size_t *size);

/* An image that image_close() did not give: STATUS_FAILED, with the reason. */
int image_refused(const char *path);

/* Opens bytes [size] to be read, below 0 when HDF5 cannot; the bytes stay the caller's. */
hid_t image_read(const void *bytes, size_t size);

#endif
