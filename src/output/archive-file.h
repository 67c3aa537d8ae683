/* archive-file.h -- an archive as a file that says itself whether it is whole.
 *
 * The first 512 bytes hold the number of bytes behind them and their hash (output/hash.h), the
 * rest is HDF5, one data set an entry: h5dump and h5py read it as it is. */
#ifndef OUTPUT_ARCHIVE_FILE_H
#define OUTPUT_ARCHIVE_FILE_H

#include "base/archive.h"
#include "output/pieces.h"

/* Writes path whole or not at all, to the disk, and keeps what was there as `before`.  Numbers that are
 * elsewhere come from `pieces`, whose arrays are these entries in their order; NULL: there are none.  Where they
 * are shared all ranks call it, others than the first with a, path and before NULL.
 * STATUS_IO, STATUS_FAILED: nothing has changed. */
int archive_file_write(const struct archive *a, const char *path, const char *before,
                       const struct pieces *pieces);

/* A new archive that fills, with all that the file has.  STATUS_IO: there is none (*found is
 * false), or it is damaged. */
int archive_file_read(const char *path, bool *found, struct archive **out);

#endif
