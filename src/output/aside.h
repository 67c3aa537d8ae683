/* aside.h -- small files that are whole at every moment: written under a
 * temporary name beside the old one and then renamed over it. */
#ifndef OUTPUT_ASIDE_H
#define OUTPUT_ASIDE_H

#include <stdio.h>

enum { ASIDE_PATH = 4096 };

struct aside {
    FILE *to; /* write here                                                  */
    char path[ASIDE_PATH], temporary[ASIDE_PATH];
};

/* Where a file is and is written, opened by nobody; STATUS_IO where the path is too long. */
int aside_name(struct aside *a, const char *path);

/* Opens "PATH.part" for writing. */
int aside_open(struct aside *a, const char *path);

/* Renames it to PATH.  When any write failed (full disk, quota) it is taken
 * away instead, the old file stays, and STATUS_IO comes back. */
int aside_close(struct aside *a);

/* The same for a file that has to outlive a loss of power: it is on the disk before it takes
 * the place of the old one, which stays beside it as `before` (in the same directory). */
int aside_close_safely(struct aside *a, const char *before);

/* Waits until a file, or the names in a directory, are on the disk. */
int aside_sync(const char *path);

/* Takes what was written away; the old file stays. */
void aside_drop(struct aside *a);

/* "DIR/NAME" into to [ASIDE_PATH]; STATUS_IO when that is too long. */
int aside_join(char *to, const char *dir, const char *name);

/* Makes the directory and its parents; those that exist already are welcome. */
int aside_directory(const char *path);

#endif
