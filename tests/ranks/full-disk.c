/* full-disk.c -- a disk that is full for one rank, for tests/ranks.sh: LD_PRELOAD it.
 *
 *     FULL=NAME   what this rank writes by pwrite() to files whose path has this in it is refused */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

static int is_full(int file)
{
    const char *name = getenv("FULL");
    char link[40], path[4096];
    ssize_t n;

    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    n = readlink(link, path, sizeof path - 1);
    path[n > 0 ? n : 0] = '\0';
    return name && strstr(path, name);
}

ssize_t pwrite(int file, const void *from, size_t n, off_t at)
{
    if (is_full(file)) {
        errno = ENOSPC;
        return -1;
    }
    return syscall(SYS_pwrite64, file, from, n, at);
}

ssize_t pwrite64(int file, const void *from, size_t n, off_t at)
{
    return pwrite(file, from, n, at);
}
