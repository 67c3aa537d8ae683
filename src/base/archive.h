/* archive.h -- named arrays on their way to a checkpoint and back.
 *
 * A room that keeps something from one step to the next says so in one function, which both
 * saves and loads, so that the two cannot differ:
 *
 *     int tally_keep(struct tally *t, struct archive *a)
 *     {
 *         TRY(archive_integers(a, "tally.steps", &t->steps, 1));
 *         return archive_numbers(a, "tally.t", &t->t, 1);
 *     }
 *
 * An archive that has been created takes copies of what it is handed; after archive_turn() it
 * fills what it is handed.  It refuses names that it does not have and arrays of another
 * length, with STATUS_IO. */
#ifndef BASE_ARCHIVE_H
#define BASE_ARCHIVE_H

#include <stdbool.h>
#include <stddef.h>

enum archive_type { ARCHIVE_NUMBERS, ARCHIVE_INTEGERS, ARCHIVE_TEXT };
enum { ARCHIVE_NAME = 64 };

struct archive_entry {
    char name[ARCHIVE_NAME];
    enum archive_type type;
    long n;          /* numbers, integers, or letters of a text without its end */
    void *data;      /* [n] double, long or char; owned by the archive; NULL: elsewhere */
    bool taken;      /* has been handed out                                     */
};

struct archive;

int archive_create(struct archive **out);
void archive_free(struct archive **archive); /* NULL is welcome */

/* From now on it fills what it is handed. */
void archive_turn(struct archive *a);
bool archive_fills(const struct archive *a);

/* Between archive_try(a, true) and archive_try(a, false) it fills to see whether all of it can
 * be had: whoever would change a file by it leaves that for the second time. */
void archive_try(struct archive *a, bool tries);
bool archive_tries(const struct archive *a);

int archive_numbers(struct archive *a, const char *name, double *value, long n);
/* The same, but no copy is taken: who writes the file has the numbers. */
int archive_numbers_elsewhere(struct archive *a, const char *name, double *value, long n);
int archive_integers(struct archive *a, const char *name, long *value, long n);
int archive_integer(struct archive *a, const char *name, int *value);
int archive_flag(struct archive *a, const char *name, bool *value);
int archive_text(struct archive *a, const char *name, char *text, size_t room);

/* STATUS_IO when something in it has not been asked for: whoever saved it meant it to be
 * loaded. */
int archive_spent(const struct archive *a);

/* For writers and readers of files.  archive_add() copies data [n], unless that is NULL; archive_entry() lends
 * number i of archive_entries(). */
int archive_add(struct archive *a, const char *name, enum archive_type type, long n,
                const void *data);
int archive_entries(const struct archive *a);
const struct archive_entry *archive_entry(const struct archive *a, int i);
size_t archive_bytes(const struct archive_entry *entry);

#endif
