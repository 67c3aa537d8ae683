/* home.c -- a run takes its directory: what in it is a run's, and may be taken away. */
#include "run/home.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/figures-room.h"
#include "output/mark.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a run writes, but for series; doc/output.md. */
static const char *const files[] = {
    "run.json", "scene.used", "book.csv", "front.csv", "forces.csv", "beam.csv", "bodies.csv",
    "panels.csv", "report.html", "movie.webm", "movie.gif",
    "probes.csv", "profiles.csv", "pairing.csv", "steps.csv", "checkpoints.csv", "checkpoint.h5",
    "checkpoint-before.h5", "fields.xdmf", "snapshots.csv", NULL,
};
static const char *const folders[] = { "fields", "snapshots", "figures", NULL };

/* Orders of runs in comparisons (study/member.h) are there before the run. */
static const char *const of_studies[] = { "order", "said", NULL };

static const struct mark_owner owner = { "run", files, folders, of_studies };

/* --- names --------------------------------------------------------------------------- */

/* Without the end of a file that is being written. */
static size_t length_of(const char *name)
{
    const size_t n = strlen(name), k = strlen(".part");

    return n > k && strcmp(name + n - k, ".part") == 0 ? n - k : n;
}

static bool is_ours(const char *name)
{
    return mark_is_in(files, name, length_of(name));
}

/* "000012.vtkhdf", "000012-bodies.vtkhdf", "0003.csv", ... */
static bool is_of_series(const char *name)
{
    static const char *const ends[] = { ".vtkhdf", "-bodies.vtkhdf", ".csv", "-bodies.csv",
                                        "-surface.csv", "-cut.csv" };
    const size_t n = length_of(name);
    size_t digits = 0;

    while (isdigit((unsigned char)name[digits]))
        digits++;
    for (size_t i = 0; digits >= 4 && i < sizeof ends / sizeof *ends; i++)
        if (n == digits + strlen(ends[i]) && strncmp(name + digits, ends[i], strlen(ends[i])) == 0)
            return true;
    return false;
}

/* --- what is taken away -------------------------------------------------------------- */

static int take_away(const char *dir, const char *name)
{
    char path[ASIDE_PATH];

    TRY(aside_join(path, dir, name));
    if (unlink(path) == 0 || errno == ENOENT || errno == EISDIR || errno == EPERM)
        return STATUS_DONE;
    return status_fail(STATUS_IO, "%s: this file of an earlier run cannot be removed: %s", path,
                       strerror(errno));
}

/* All files of dir/folder, "": of dir, that are ours. */
static int clear(const char *dir, const char *folder, bool (*ours)(const char *name))
{
    char path[ASIDE_PATH];
    struct dirent **entry;
    int n, status = STATUS_DONE;

    TRY(aside_join(path, dir, folder));
    n = scandir(path, &entry, NULL, NULL);
    if (n < 0)
        return STATUS_DONE; /* no such folder */
    for (int i = 0; i < n; i++) {
        if (status == STATUS_DONE && ours(entry[i]->d_name))
            status = take_away(path, entry[i]->d_name);
        free(entry[i]);
    }
    free(entry);
    if (*folder)
        rmdir(path); /* if nothing else is in it */
    return status;
}

int home_take(const struct home *h)
{
    if (h->again)
        return mark_refuse_links(&owner, h->dir);
    TRY(mark_claim(&owner, h->dir, h->scene, h->force));
    TRY(clear(h->dir, "", is_ours));
    TRY(clear(h->dir, "fields", is_of_series));
    TRY(clear(h->dir, "snapshots", is_of_series));
    figures_room_clear(h->dir);
    return STATUS_DONE;
}
