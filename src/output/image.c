/* image.c -- HDF5 files in memory, by its "core" driver. */
#include "output/image.h"

#include "base/status.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
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

enum { OWN = 8 << 20 }; /* what HDF5 itself takes, an upper bound [bytes] */

/* HDF5 1.10 does not look at all it asks for: without memory it crashes or ends the program, also
 * in what it does at exit.  The file, its growth and our copy of it are 3 times its bytes. */
static bool begin(size_t bytes)
{
    static bool begun;

    if (broken || status_reserve(3 * bytes + OWN, "a file of HDF5") != STATUS_DONE)
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

hid_t image_open(size_t bytes)
{
    hid_t access, file;

    if (!begin(bytes))
        return -1;
    access = H5Pcreate(H5P_FILE_ACCESS);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    H5Pset_fapl_core(access, (size_t)1 << 22, 0);
    file = H5Fcreate(nowhere, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    return file;
}

static void *take(hid_t file, size_t *size)
{
    const ssize_t wanted = H5Fget_file_image(file, NULL, 0);
    void *image = wanted > 0 ? status_alloc((unsigned long)wanted, 1) : NULL;

    if (image && H5Fget_file_image(file, image, (size_t)wanted) != wanted) {
        free(image);
        return NULL;
    }
    *size = (size_t)wanted;
    return image;
}

void *image_close(hid_t file, bool fine, size_t *size)
{
    void *image = NULL;

    if (file >= 0 && fine && H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0)
        image = take(file, size);
    if (file >= 0)
        H5Fclose(file);
    broken = broken || !image;
    writes = false;
    return image;
}

int image_refused(const char *path)
{
    return status_starved("HDF5 cannot make %s", path);
}

hid_t image_read(const void *bytes, size_t size)
{
    hid_t access, file = -1;

    if (!begin(size))
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
