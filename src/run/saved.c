/* saved.c -- files of checkpoints: which of them counts, and whether they may go. */
#include "run/saved.h"

#include "base/status.h"
#include "output/archive-file.h"
#include "output/aside.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char newest[] = "checkpoint.h5", previous[] = "checkpoint-before.h5";

enum { MESSAGE = 1024 };

int saved_write(const char *dir, const struct archive *a, const struct pieces *pieces)
{
    char path[ASIDE_PATH], before[ASIDE_PATH];

    TRY(aside_join(path, dir, newest)); /* all ranks alike */
    TRY(aside_join(before, dir, previous));
    return archive_file_write(a, path, before, pieces);
}

/* The one before, because of `why'. */
static int read_previous(const char *dir, bool newer, const char *why, struct archive **out)
{
    char before[ASIDE_PATH];
    bool found;

    TRY(aside_join(before, dir, previous));
    if (archive_file_read(before, &found, out) == STATUS_DONE) {
        status_warn("%s; going on from %s", why, before);
        return STATUS_DONE;
    }
    if (found && !newer)
        return STATUS_IO;
    status_clear();
    if (!newer)
        return status_fail(STATUS_IO, "%s: there is no checkpoint to go on from: a run writes "
                           "some when its scene sets output.checkpoint; run the scene anew", dir);
    return status_fail(STATUS_IO, "%s; %s: run the scene anew", why, found
                       ? "the checkpoint before it is damaged, too" : "there is none before it");
}

int saved_read(const char *dir, struct archive **out)
{
    char path[ASIDE_PATH], why[MESSAGE];
    bool found;

    TRY(aside_join(path, dir, newest));
    if (archive_file_read(path, &found, out) == STATUS_DONE)
        return STATUS_DONE;
    snprintf(why, sizeof why, "%s", status_message());
    status_clear();
    return read_previous(dir, found, why, out);
}

/* Does DIR/run.json say that the run came to an end that no resume would change? */
static bool has_ended(const char *dir)
{
    char path[ASIDE_PATH], line[256];
    bool ended = false;
    FILE *from = NULL;

    if (aside_join(path, dir, "run.json") == STATUS_DONE)
        from = fopen(path, "r");
    while (from && fgets(line, sizeof line, from))
        ended |= strcmp(line, "  \"status\": \"done\",\n") == 0
                 || strcmp(line, "  \"status\": \"failed\",\n") == 0;
    if (from)
        fclose(from);
    return ended;
}

int saved_refuse(const char *dir)
{
    char path[ASIDE_PATH], before[ASIDE_PATH];

    TRY(aside_join(path, dir, newest));
    TRY(aside_join(before, dir, previous));
    if (access(path, F_OK) != 0 && access(before, F_OK) != 0)
        return STATUS_DONE;
    if (has_ended(dir))
        return STATUS_DONE;
    return status_fail(STATUS_IO, "%s: a run was interrupted there and can go on: `stiffwater "
                           "resume %s`; to begin anew, remove %s and %s there, or choose another "
                           "directory (-o)", dir, dir, newest, previous);
}

int saved_scene(const char *dir, char hash[HASH_TEXT])
{
    char path[ASIDE_PATH], piece[4096];
    uint64_t sum = HASH_START;
    FILE *from;
    size_t n;

    TRY(aside_join(path, dir, "scene.used"));
    from = fopen(path, "r");
    if (!from)
        return status_fail(STATUS_IO, "%s: cannot be read: %s", path, strerror(errno));
    while ((n = fread(piece, 1, sizeof piece, from)) > 0)
        sum = hash_bytes(sum, piece, n);
    fclose(from);
    hash_text(sum, hash);
    return STATUS_DONE;
}
