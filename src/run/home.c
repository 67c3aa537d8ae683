/* home.c -- whose a run's directory is, and what in it a run may take away. */
#include "run/home.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/figures-room.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

static const char mark[] = ".stiffwater";

/* What a run writes, but for series; doc/output.md. */
static const char *const files[] = {
    "run.json", "scene.used", "book.csv", "front.csv", "forces.csv", "beam.csv", "bodies.csv",
    "panels.csv", "report.html", "movie.webm", "movie.gif",
    "probes.csv", "profiles.csv", "pairing.csv", "steps.csv", "checkpoints.csv", "checkpoint.h5",
    "checkpoint-before.h5", "fields.xdmf", "snapshots.csv",
};
static const char *const folders[] = { "fields", "snapshots", "figures" };

enum { FILES = sizeof files / sizeof files[0], FOLDERS = sizeof folders / sizeof folders[0] };

/* Orders of runs in comparisons (study/member.h) are there before the run. */
static const char *const of_studies[] = { "order", "said" };

/* --- names --------------------------------------------------------------------------- */

static bool is_in(const char *const *list, size_t n, const char *name, size_t length)
{
    for (size_t i = 0; i < n; i++)
        if (strlen(list[i]) == length && strncmp(list[i], name, length) == 0)
            return true;
    return false;
}

/* Without the end of a file that is being written. */
static size_t length_of(const char *name)
{
    const size_t n = strlen(name), k = strlen(".part");

    return n > k && strcmp(name + n - k, ".part") == 0 ? n - k : n;
}

static bool is_ours(const char *name)
{
    return is_in(files, FILES, name, length_of(name));
}

/* "000012.vtkhdf", "0003.csv" */
static bool is_of_series(const char *name)
{
    const size_t n = length_of(name);
    size_t digits = 0;

    while (isdigit((unsigned char)name[digits]))
        digits++;
    return digits >= 4 && ((n == digits + 7 && strncmp(name + digits, ".vtkhdf", 7) == 0)
                           || (n == digits + 4 && strncmp(name + digits, ".csv", 4) == 0));
}

/* --- what is there ------------------------------------------------------------------- */

static bool is_link(const char *path)
{
    struct stat about;

    return lstat(path, &about) == 0 && S_ISLNK(about.st_mode);
}

static bool has_mark(const char *dir)
{
    char path[ASIDE_PATH];
    struct stat about;

    return aside_join(path, dir, mark) == STATUS_DONE && lstat(path, &about) == 0
           && S_ISREG(about.st_mode);
}

static int refuse_link(const char *dir, const char *name)
{
    return status_fail_with(STATUS_IO,
                            (struct status_advice){ .remedy = "remove the link, or choose another "
                                                              "directory (-o)" },
                            "%s/%s is a symbolic link; a run writes files of its own there and "
                            "follows no links", dir, name);
}

static int refuse_links(const char *dir)
{
    char path[ASIDE_PATH];

    for (int i = 0; i < FILES + FOLDERS; i++) {
        const char *name = i < FILES ? files[i] : folders[i - FILES];
        TRY(aside_join(path, dir, name));
        if (is_link(path))
            return refuse_link(dir, name);
    }
    return STATUS_DONE;
}

/* The first file of a directory by name [room], "": there is none. */
static int find_foreign(const char *dir, char *to, size_t room)
{
    struct dirent **entry;
    const int n = scandir(dir, &entry, NULL, alphasort);

    *to = '\0';
    if (n < 0)
        return status_fail(STATUS_IO, "%s: this directory cannot be read: %s", dir,
                           strerror(errno));
    for (int i = 0; i < n; i++) {
        const char *name = entry[i]->d_name;
        if (!*to && strcmp(name, ".") != 0 && strcmp(name, "..") != 0
            && !is_in(of_studies, 2, name, strlen(name)))
            snprintf(to, room, "%s", name);
        free(entry[i]);
    }
    free(entry);
    return STATUS_DONE;
}

static int refuse_foreign(const char *dir)
{
    char name[256];

    TRY(find_foreign(dir, name, sizeof name));
    if (!*name)
        return STATUS_DONE;
    return status_fail_with(STATUS_IO,
                            (struct status_advice){
                                .remedy = "choose another directory (-o); with --force a run takes "
                                          "this one, replaces files that bear the names of its "
                                          "own, and leaves the others" },
                            "%s: there are files in this directory, %s for one, and no run "
                            "has left its mark (%s)", dir, name, mark);
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

static int leave_mark(const char *dir, const char *scene)
{
    const char *slash = strrchr(scene, '/');
    char path[ASIDE_PATH];
    struct aside a;

    TRY(aside_join(path, dir, mark));
    TRY(aside_open(&a, path));
    fprintf(a.to, "This directory is that of a run of stiffwater, which may replace its files.\n"
                  "version %s\nscene %s\n", PACKAGE_VERSION, slash ? slash + 1 : scene);
    return aside_close(&a);
}

int home_take(const struct home *h)
{
    TRY(refuse_links(h->dir));
    if (h->again)
        return STATUS_DONE;
    if (!has_mark(h->dir) && !h->force)
        TRY(refuse_foreign(h->dir));
    TRY(leave_mark(h->dir, h->scene));
    TRY(clear(h->dir, "", is_ours));
    TRY(clear(h->dir, "fields", is_of_series));
    TRY(clear(h->dir, "snapshots", is_of_series));
    figures_room_clear(h->dir);
    return STATUS_DONE;
}
