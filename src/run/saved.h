/* saved.h -- the checkpoints of a run's directory: DIR/checkpoint.h5 and the one before it,
 * DIR/checkpoint-before.h5. */
#ifndef RUN_SAVED_H
#define RUN_SAVED_H

#include "base/archive.h"
#include "output/hash.h"
#include "output/pieces.h"

/* Replaces the checkpoint; the one there was is now the one before.  Pieces, and ranks: as in
 * output/archive-file.h. */
int saved_write(const char *dir, const struct archive *a, const struct pieces *pieces);

/* The checkpoint; when it is damaged or missing, the one before, with a warning.  STATUS_IO:
 * there is none to go on from. */
int saved_read(const char *dir, struct archive **out);

/* For a run that begins: refuses a directory with the checkpoint of a run that did not come to
 * its end. */
int saved_refuse(const char *dir);

/* Hash of DIR/scene.used. */
int saved_scene(const char *dir, char hash[HASH_TEXT]);

#endif
