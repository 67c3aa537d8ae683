/* bytes.h -- for targets of libFuzzer: bytes as a file that has a path. */
#ifndef FUZZ_BYTES_H
#define FUZZ_BYTES_H

#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* memfd_create */
#endif
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/* A file without a name; its path goes to `path' [64].  Close it. */
static inline int bytes_open(const uint8_t *bytes, size_t n, char *path)
{
    const int file = memfd_create("bytes", 0);

    if (file < 0 || write(file, bytes, n) != (ssize_t)n)
        abort();
    snprintf(path, 64, "/proc/self/fd/%d", file);
    return file;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n);

#endif
