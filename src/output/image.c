/* image.c -- HDF5 files in memory, by its "core" driver. */
#include "output/image.h"

#include "base/status.h"

#include <stdlib.h>

hid_t image_open(void)
{
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    hid_t file;

    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    H5Pset_fapl_core(access, (size_t)1 << 22, 0);
    file = H5Fcreate("image", H5F_ACC_TRUNC, H5P_DEFAULT, access);
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
    return image;
}

hid_t image_read(const void *bytes, size_t size)
{
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    hid_t file = -1;

    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    if (H5Pset_fapl_core(access, (size_t)1 << 22, 0) >= 0
        && H5Pset_file_image(access, (void *)(uintptr_t)bytes, size) >= 0) /* copies them */
        file = H5Fopen("image", H5F_ACC_RDONLY, access);
    H5Pclose(access);
    return file;
}
