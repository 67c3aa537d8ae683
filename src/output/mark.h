/* mark.h -- whose a directory of results is: DIR/.stiffwater says so, with version and scene.
 *
 * A run, comparison, sweep or spread writes into a directory that is new, empty, or one of its
 * own kind.  Symbolic links are never followed. */
#ifndef OUTPUT_MARK_H
#define OUTPUT_MARK_H

#include <stdbool.h>

struct mark_owner {
    const char *name;            /* "run": of the kind, in the mark and in messages    */
    const char *const *files;    /* NULL-ended: what it writes                         */
    const char *const *folders;  /* NULL-ended: of these, directories                  */
    const char *const *before;   /* NULL-ended: what may be there before it, NULL: none */
};

/* Marks the directory, which exists, for a scene (its path).  STATUS_IO, and nothing has
 * changed: there are files and no mark, or that of another kind, or links with names of the
 * owner's files.  force: only links are refused. */
int mark_claim(const struct mark_owner *o, const char *dir, const char *scene, bool force);

/* The last of these alone, where the mark is there already. */
int mark_refuse_links(const struct mark_owner *o, const char *dir);

/* STATUS_IO when DIR/NAME is a link. */
int mark_refuse_link(const struct mark_owner *o, const char *dir, const char *name);

/* Is name, of these n characters, in the list, NULL-ended? */
bool mark_is_in(const char *const *list, const char *name, unsigned long n);

#endif
