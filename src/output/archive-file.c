/* archive-file.c -- an archive in an HDF5 file behind a header with its hash.
 *
 * HDF5 1.10 checks its own structures, not the numbers, and may crash over damaged ones: so
 * all bytes are compared with the hash before HDF5 sees any. */
#include "output/archive-file.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/hash.h"
#include "ranks/ranks.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum {
    HEADER = 512, /* HDF5 looks for itself at 0, 512, 1024, ... */
    ENTRY = 1024  /* bytes of one beside its numbers, an upper bound */
};

/* The header of so many bytes with this hash. */
static void make_header(char header[HEADER], size_t size, uint64_t sum)
{
    char hash[HASH_TEXT];

    memset(header, 0, HEADER);
    snprintf(header, HEADER, "stiffwater checkpoint 1\nbytes %zu\nhash %s\n", size,
             hash_text(sum, hash));
}

/* --- writing ----------------------------------------------------------------------- */

static hid_t type_of(enum archive_type type)
{
    if (type == ARCHIVE_NUMBERS)
        return H5T_NATIVE_DOUBLE;
    return type == ARCHIVE_INTEGERS ? H5T_NATIVE_LONG : H5T_NATIVE_UCHAR;
}

/* Numbers of a set that is there. */
static bool write_numbers(struct image *to, hid_t set, const struct archive_entry *e)
{
    if (e->n == 0)
        return true;
    return e->data ? H5Dwrite(set, type_of(e->type), H5S_ALL, H5S_ALL, H5P_DEFAULT, e->data) >= 0
                   : image_leave(to, set);
}

static bool write_entry(struct image *to, const struct archive_entry *e)
{
    const hsize_t n = (hsize_t)e->n;
    const hid_t space = H5Screate_simple(1, &n, NULL), making = H5Pcreate(H5P_DATASET_CREATE);
    const bool ready = e->data || e->n == 0 || image_room(making);
    const hid_t set = H5Dcreate2(to->file, e->name, type_of(e->type), space, H5P_DEFAULT, making,
                                 H5P_DEFAULT);
    bool fine = ready && set >= 0 && write_numbers(to, set, e);

    if (set >= 0)
        fine = H5Dclose(set) >= 0 && fine;
    H5Pclose(making);
    H5Sclose(space);
    return fine;
}

static bool make_image(const struct archive *a, struct image *image)
{
    size_t bytes = 0;
    bool fine;

    for (int i = 0; i < archive_entries(a); i++)
        bytes += archive_bytes(archive_entry(a, i)) + ENTRY;
    fine = image_begin(image, bytes);
    for (int i = 0; fine && i < archive_entries(a); i++)
        fine = write_entry(image, archive_entry(a, i));
    return image_end(image, fine);
}

/* All but the header and numbers that are elsewhere, on the first rank. */
static int start(const struct archive *a, const char *path, struct image *image, struct aside *to)
{
    static const char header[HEADER];

    if (!make_image(a, image))
        return image_refused(image, path);
    TRY(aside_open(to, path));
    fwrite(header, 1, HEADER, to->to);
    if (image_put(image, to->to))
        return STATUS_DONE;
    aside_drop(to);
    to->to = NULL;
    return image_refused(image, path);
}

/* Of what stands on the disk behind the header, whoever wrote it. */
static int hash_file(const char *path, size_t *size, uint64_t *sum)
{
    FILE *from = fopen(path, "rb");
    char piece[1 << 16];
    size_t n;
    bool fine;

    if (!from)
        return status_fail(STATUS_IO, "%s: cannot be read: %s", path, strerror(errno));
    *sum = HASH_START;
    *size = 0;
    fine = fseeko(from, HEADER, SEEK_SET) == 0;
    while (fine && (n = fread(piece, 1, sizeof piece, from)) > 0) {
        *sum = hash_bytes(*sum, piece, n);
        *size += n;
    }
    fine = fine && !ferror(from);
    fclose(from);
    return fine ? STATUS_DONE : status_fail(STATUS_IO, "%s: cannot be read", path);
}

static int sign(struct aside *to)
{
    char header[HEADER];
    uint64_t sum = 0;
    size_t size = 0;

    TRY(hash_file(to->temporary, &size, &sum));
    make_header(header, size, sum);
    rewind(to->to);
    fwrite(header, 1, HEADER, to->to);
    return STATUS_DONE;
}

static int finish(int status, struct aside *to, const char *before)
{
    if (!to->to)
        return status;
    if (status == STATUS_DONE)
        status = sign(to);
    if (status == STATUS_DONE)
        return aside_close_safely(to, before);
    aside_drop(to);
    return status;
}

int archive_file_write(const struct archive *a, const char *path, const char *before,
                       const struct pieces *pieces)
{
    static const struct pieces none = { .n = 0 };
    const struct pieces *numbers = pieces ? pieces : &none;
    struct image image = { .file = -1, .memory = -1 };
    struct aside to = { .to = NULL };
    int status = a ? start(a, path, &image, &to) : STATUS_DONE;

    status = pieces_write(status, a ? &to : NULL, &image, HEADER, numbers, true);
    image_free(&image);
    status = finish(status, &to, before);
    return numbers->shared ? ranks_agree(status) : status;
}

/* --- reading ----------------------------------------------------------------------- */

static int damaged(const char *path, const char *why)
{
    return status_fail(STATUS_IO, "%s is damaged: %s", path, why);
}

/* The whole file [*size], free() it. */
static int read_bytes(const char *path, bool *found, char **out, size_t *size)
{
    FILE *from = fopen(path, "rb");
    struct stat about;
    int status = STATUS_DONE;

    *out = NULL;
    *found = from || errno != ENOENT;
    if (!from)
        return status_fail(STATUS_IO, "%s: cannot be read: %s", path, strerror(errno));
    if (fstat(fileno(from), &about) != 0 || !S_ISREG(about.st_mode))
        status = damaged(path, "it is no file");
    else if (!(*out = status_alloc((unsigned long)about.st_size + 1, 1)))
        status = STATUS_FAILED;
    else
        *size = fread(*out, 1, (size_t)about.st_size, from);
    fclose(from);
    return status;
}

static int check_bytes(const char *path, const char *bytes, size_t size)
{
    char header[HEADER];

    if (size <= HEADER)
        return damaged(path, "it ends in its header");
    make_header(header, size - HEADER, hash_bytes(HASH_START, bytes + HEADER, size - HEADER));
    if (memcmp(header, bytes, HEADER) != 0)
        return damaged(path, "it is not what its header says (bytes are missing or have changed)");
    return STATUS_DONE;
}

static bool type_from(hid_t set, enum archive_type *type)
{
    const hid_t is = H5Dget_type(set);
    const bool number = H5Tget_class(is) == H5T_FLOAT;
    const size_t size = H5Tget_size(is);

    *type = number ? ARCHIVE_NUMBERS : size == 1 ? ARCHIVE_TEXT : ARCHIVE_INTEGERS;
    H5Tclose(is);
    return size == 1 || size == sizeof(double);
}

static int read_set(const char *path, hid_t set, const char *name, struct archive *a)
{
    const hid_t space = H5Dget_space(set);
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    enum archive_type type;
    void *data = n >= 0 && type_from(set, &type) ? status_alloc((unsigned long)n + 1, 8) : NULL;
    int status = STATUS_FAILED;

    H5Sclose(space);
    if (!data)
        return damaged(path, "an array in it has no length");
    if (n > 0 && H5Dread(set, type_of(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
        status = damaged(path, "an array in it cannot be read");
    else
        status = archive_add(a, name, type, (long)n, data);
    free(data);
    return status;
}

static int read_sets(const char *path, hid_t file, struct archive *a)
{
    H5G_info_t about;

    if (H5Gget_info(file, &about) < 0)
        return damaged(path, "HDF5 cannot read it");
    for (hsize_t i = 0; i < about.nlinks; i++) {
        char name[ARCHIVE_NAME] = "";
        hid_t set;
        int status;
        if (H5Lget_name_by_idx(file, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, sizeof name,
                               H5P_DEFAULT) < 0
            || (set = H5Dopen2(file, name, H5P_DEFAULT)) < 0)
            return damaged(path, "HDF5 cannot read it");
        status = read_set(path, set, name, a);
        H5Dclose(set);
        TRY(status);
    }
    return STATUS_DONE;
}

static int read_image(const char *path, const char *bytes, size_t size, struct archive *a)
{
    const hid_t file = image_read(bytes, size);
    int status;

    if (file < 0)
        return damaged(path, "HDF5 cannot read it");
    status = read_sets(path, file, a);
    H5Fclose(file);
    return status;
}

int archive_file_read(const char *path, bool *found, struct archive **out)
{
    char *bytes;
    size_t size = 0;
    int status = read_bytes(path, found, &bytes, &size);

    *out = NULL;
    if (status == STATUS_DONE)
        status = check_bytes(path, bytes, size);
    if (status == STATUS_DONE)
        status = archive_create(out);
    if (status == STATUS_DONE)
        status = read_image(path, bytes + HEADER, size - HEADER, *out);
    free(bytes);
    if (status != STATUS_DONE)
        archive_free(out);
    else
        archive_turn(*out);
    return status;
}
