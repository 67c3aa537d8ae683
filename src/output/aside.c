/* aside.c -- writes a file under a temporary name and renames it when it is whole. */
#include "output/aside.h"

#include "base/status.h"
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int aside_join(char *to, const char *dir, const char *name)
{
    const int n = snprintf(to, ASIDE_PATH, "%s/%s", dir, name);

    if (n < 0 || n >= ASIDE_PATH - 16)
        return status_fail(STATUS_IO,
                           "%.200s.../%s: this path is longer than %d characters; "
                           "choose an output directory nearer to the root",
                           dir, name, ASIDE_PATH);
    return STATUS_DONE;
}

/* Parents that are missing are made too; what cannot be made shows at the end. */
static void make_parents(const char *path)
{
    char part[ASIDE_PATH];

    for (const char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - path), path);
        mkdir(part, 0777);
    }
}

int aside_directory(const char *path)
{
    if (path[0])
        make_parents(path);
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
        return status_fail(STATUS_IO, "%s: this directory cannot be made: %s", path,
                           strerror(errno));
    return STATUS_DONE;
}

int aside_name(struct aside *a, const char *path)
{
    const int n = snprintf(a->path, sizeof a->path, "%s", path);

    a->to = NULL;
    if (n < 0 || n >= ASIDE_PATH - 16)
        return status_fail(STATUS_IO, "%.200s...: this path is too long", path);
    snprintf(a->temporary, sizeof a->temporary, "%.*s.part", n, path);
    return STATUS_DONE;
}

int aside_open(struct aside *a, const char *path)
{
    int file;

    TRY(aside_name(a, path));
    file = open(a->temporary, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
    a->to = file >= 0 ? fdopen(file, "w") : NULL;
    if (!a->to && file >= 0)
        close(file);
    if (!a->to)
        return status_fail(STATUS_IO, "%s: cannot be opened for writing: %s", a->temporary,
                           strerror(errno));
    return STATUS_DONE;
}

void aside_drop(struct aside *a)
{
    fclose(a->to);
    remove(a->temporary);
}

int aside_close(struct aside *a)
{
    const int written = fflush(a->to) == 0 && !ferror(a->to);
    int error = errno;

    if (fclose(a->to) != 0 && written)
        error = errno;
    else if (written && rename(a->temporary, a->path) == 0)
        return STATUS_DONE;
    else if (written)
        error = errno;
    remove(a->temporary);
    return status_fail(STATUS_IO, "%s: cannot be written: %s", a->path,
                       strerror(error ? error : EIO));
}

int aside_sync(const char *path)
{
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    const bool fine = file >= 0 && (fsync(file) == 0 || errno == EINVAL); /* EINVAL: a pipe */
    const int error = errno;

    if (file >= 0)
        close(file);
    return fine ? STATUS_DONE : status_fail(STATUS_IO, "%s: cannot be brought to the disk: %s",
                                            path, strerror(error));
}

/* Names are on the disk, too. */
static void sync_directory(const char *path)
{
    char directory[ASIDE_PATH];
    const char *slash = strrchr(path, '/');
    int file;

    snprintf(directory, sizeof directory, "%.*s", slash ? (int)(slash - path) : 1,
             slash ? path : ".");
    file = open(*directory ? directory : "/", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file >= 0) {
        fsync(file);
        close(file);
    }
}

int aside_close_safely(struct aside *a, const char *before)
{
    char path[ASIDE_PATH];

    memcpy(path, a->path, sizeof path);
    if (fflush(a->to) != 0 || ferror(a->to) || fsync(fileno(a->to)) != 0) {
        const int error = errno;
        aside_drop(a);
        return status_fail(STATUS_IO, "%s: cannot be written: %s", path,
                           strerror(error ? error : EIO));
    }
    if (rename(path, before) != 0 && errno != ENOENT) {
        const int error = errno;
        aside_drop(a);
        return status_fail(STATUS_IO, "%s: cannot be kept as %s: %s", path, before,
                           strerror(error));
    }
    TRY(aside_close(a));
    sync_directory(path);
    return STATUS_DONE;
}
