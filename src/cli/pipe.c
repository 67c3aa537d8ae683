/* pipe.c -- a scene that comes through a pipe, as in `stiffwater check <(sed ... a.scene)`.
 *
 * It is read more than once: by this program for its dimension, by the next for the rest, by
 * `compare` again for each run.  So its bytes go into a file without a name, and that takes
 * the pipe's descriptor: the path leads to the file from then on. */
#include "cli/cli.h"

#include "base/status.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST = 9 << 20 }; /* a scene may have 8 MB: its reader refuses more */

/* The descriptor that the path names, -1 if it is another path. */
static int descriptor(const char *path)
{
    static const char *const before[] = { "/dev/fd/", "/proc/self/fd/" };

    if (strcmp(path, "/dev/stdin") == 0)
        return STDIN_FILENO;
    for (size_t i = 0; i < sizeof before / sizeof *before; i++) {
        const char *digits = path + strlen(before[i]);
        const bool fits = strncmp(path, before[i], strlen(before[i])) == 0;

        if (fits && digits[0] && strlen(digits) < 9 && !digits[strspn(digits, "0123456789")])
            return atoi(digits);
    }
    return -1;
}

/* 0, or -1 and errno. */
static int copy(int from, FILE *to)
{
    static char bytes[1 << 16];
    ssize_t got = 1;

    for (long n = 0; n < MOST && got > 0; n += got) {
        got = read(from, bytes, sizeof bytes);
        if (got > 0 && fwrite(bytes, 1, (size_t)got, to) != (size_t)got)
            return -1;
    }
    return got < 0 || fflush(to) != 0 ? -1 : 0;
}

static int keep(const char *path, int pipe)
{
    FILE *file = tmpfile();
    const bool kept = file && copy(pipe, file) == 0 && dup2(fileno(file), pipe) == pipe;

    if (!kept)
        status_fail(STATUS_IO, "%s: this scene cannot be kept in a file until it is read again: "
                    "%s", path, strerror(errno));
    if (file)
        fclose(file);
    return kept ? STATUS_DONE : STATUS_IO;
}

int cli_keep_pipe(const char *path)
{
    const int pipe = descriptor(path);
    struct stat about;

    if (stat(path, &about) != 0 || S_ISREG(about.st_mode) || S_ISDIR(about.st_mode))
        return STATUS_DONE;
    if (pipe >= 0)
        return keep(path, pipe);
    if (S_ISFIFO(about.st_mode)) /* the second time, opening it would wait for ever */
        return status_fail(STATUS_BAD_SCENE, "%s: this scene is a pipe with a name, which can be "
                           "read once only; give it as standard input: /dev/stdin <%s", path, path);
    return STATUS_DONE;
}
