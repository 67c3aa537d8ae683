/* image.c -- HDF5 files in memory: written to a file on no disk, read by HDF5's "core" driver. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* memfd_create() */
#endif
#include "output/image.h"

#include "base/status.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static bool broken; /* what a failure left behind in HDF5 is not to be trusted */
static bool writes; /* HDF5 is at work                                         */

/* HDF5 1.10 calls exit(-1) where it cannot go on. */
static void last_words(void)
{
    static const char words[] = "stiffwater: HDF5 ended the program, which it does when it gets "
                                "no memory; use fewer particles (a larger spacing) or a machine "
                                "with more memory\n";

    if (writes)
        _exit(write(STDERR_FILENO, words, strlen(words)) < 0 ? STATUS_IO : STATUS_FAILED);
}

/* HDF5 opens no image whose name is that of a file, so this is one that no file can have. */
static const char nowhere[] = "/dev/null/image";

enum {
    OWN = 8 << 20,      /* what HDF5 itself takes, an upper bound [bytes] */
    OVERHEAD = 1 << 16  /* of its structures in a file, too               */
};

/* HDF5 1.10 does not look at all it asks for: without memory it crashes or ends the program, also
 * in what it does at exit.  bytes: of a file that is read, which it copies more than once. */
static bool begin(size_t bytes)
{
    static bool begun;

    if (broken || status_reserve(bytes + OWN, "a file of HDF5") != STATUS_DONE)
        return false;
    writes = true;
    if (!begun) {
        atexit(last_words);
        H5dont_atexit();
        begun = true;
        broken = H5open() < 0;
    }
    return !broken;
}

/* A file without a name that is on no disk, where the system has such. */
static int open_memory(void)
{
#ifdef MFD_CLOEXEC
    return memfd_create("stiffwater", MFD_CLOEXEC);
#else
    FILE *file = tmpfile();
    const int memory = file ? dup(fileno(file)) : -1;

    if (file)
        fclose(file);
    return memory;
#endif
}

/* HDF5 resolves links of files that it opens by its usual driver, and this one leads nowhere: not so
 * by that of C's own files. */
static hid_t create(const char *path)
{
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    hid_t file = -1;

    if (H5Pset_fapl_stdio(access) >= 0)
        file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    return file;
}

/* May files be as long?  What is on no disk counts as one. */
static bool may_write(size_t bytes)
{
    struct rlimit most;

    return getrlimit(RLIMIT_FSIZE, &most) != 0 || most.rlim_cur == RLIM_INFINITY
           || bytes + OVERHEAD <= most.rlim_cur;
}

bool image_begin(struct image *m, size_t bytes)
{
    char path[40];

    *m = (struct image){ .file = -1, .memory = -1 };
    if (!may_write(bytes)) {
        m->error = EFBIG;
        return false;
    }
    if (!begin(0) || (m->memory = open_memory()) < 0)
        return false;
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    snprintf(path, sizeof path, "/dev/fd/%d", m->memory);
    if (access(path, F_OK) != 0) { /* HDF5 would not say so */
        m->error = ENOENT;
        return false;
    }
    m->file = create(path);
    return m->file >= 0;
}

bool image_room(hid_t making)
{
    return H5Pset_alloc_time(making, H5D_ALLOC_TIME_EARLY) >= 0
           && H5Pset_fill_time(making, H5D_FILL_TIME_NEVER) >= 0;
}

bool image_leave(struct image *m, hid_t set)
{
    const haddr_t at = H5Dget_offset(set);

    if (at == HADDR_UNDEF || m->arrays == IMAGE_ARRAYS)
        return false;
    m->array[m->arrays++] = (struct image_array){ (long)at, (long)H5Dget_storage_size(set) };
    return true;
}

bool image_end(struct image *m, bool fine)
{
    if (m->file >= 0)
        fine = H5Fclose(m->file) >= 0 && fine;
    m->file = -1;
    if (m->error == 0) /* else HDF5 was not asked */
        broken = broken || !fine;
    writes = false;
    return fine;
}

void image_free(struct image *m)
{
    if (m->memory >= 0)
        close(m->memory);
    m->memory = -1;
}

/* Bytes from .. to - 1; false: they are not there. */
static bool put_range(const struct image *m, long from, long end, FILE *to)
{
    char piece[1 << 16];

    while (from < end) {
        const size_t wanted = end - from < (long)sizeof piece ? (size_t)(end - from) : sizeof piece;
        const ssize_t n = pread(m->memory, piece, wanted, from);
        if (n <= 0)
            return false;
        fwrite(piece, 1, (size_t)n, to);
        from += n;
    }
    return true;
}

/* The first array that is left out at `from` or behind it; NULL: none. */
static const struct image_array *next_array(const struct image *m, long from)
{
    const struct image_array *next = NULL;

    for (int i = 0; i < m->arrays; i++)
        if (m->array[i].at >= from && (!next || m->array[i].at < next->at))
            next = &m->array[i];
    return next;
}

bool image_put(const struct image *m, FILE *to)
{
    const struct image_array *array;
    struct stat about;
    long from = 0;

    if (fstat(m->memory, &about) != 0)
        return false;
    while ((array = next_array(m, from))) {
        if (!put_range(m, from, array->at, to) || fseeko(to, (off_t)array->bytes, SEEK_CUR) != 0)
            return false;
        from = array->at + array->bytes;
    }
    return put_range(m, from, (long)about.st_size, to);
}

int image_refused(const struct image *m, const char *path)
{
    if (m->error == ENOENT)
        return status_fail(STATUS_IO, "%s: cannot be made, as there is no /dev/fd here: mount /proc", path);
    if (m->error != 0)
        return status_fail(STATUS_IO, "%s: cannot be written: %s", path, strerror(m->error));
    return status_starved("HDF5 cannot make %s", path);
}

hid_t image_read(const void *bytes, size_t size)
{
    hid_t access, file = -1;

    if (!begin(3 * size))
        return -1;
    access = H5Pcreate(H5P_FILE_ACCESS);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    if (H5Pset_fapl_core(access, (size_t)1 << 22, 0) >= 0
        && H5Pset_file_image(access, (void *)(uintptr_t)bytes, size) >= 0) /* copies them */
        file = H5Fopen(nowhere, H5F_ACC_RDONLY, access);
    H5Pclose(access);
    writes = false;
    return file;
}
