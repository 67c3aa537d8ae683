/* fields-file.h -- one moment of the particles as one HDF5 file. */
#ifndef OUTPUT_FIELDS_FILE_H
#define OUTPUT_FIELDS_FILE_H

#include "output/cloud.h"

/* Writes path whole or not at all (STATUS_IO).  Where the frame is shared all ranks call it, others than
 * the first with path NULL. */
int fields_file_write(const char *path, const struct cloud_frame *frame);

/* The same of the surfaces of its bodies, which it has. */
int fields_bodies_write(const char *path, const struct cloud_frame *frame);

#endif
