/* fields-grid.c -- arrays of a particle file, in groups that VTK 9.1 reads. */
#include "output/fields-grid.h"

#include "base/status.h"
#include "output/aside.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static int is_fine(hid_t id)
{
    return id >= 0;
}

enum { CHUNK = 65536 }; /* rows */

/* A chunk at a time: no work array is as long as the list. */
static int write_rows(hid_t set, const struct fields_grid_array *a)
{
    const size_t width = H5Tget_size(a->type);
    const hid_t space = H5Dget_space(set);
    void *room = status_alloc(a->rows < CHUNK ? a->rows : CHUNK, width);
    int fine = room != NULL;

    for (hsize_t from = 0; fine && from < a->rows; from += CHUNK) {
        const hsize_t n = a->rows - from < CHUNK ? a->rows - from : CHUNK;
        const hid_t part = H5Screate_simple(1, &n, NULL);
        a->fill(a->self, (long)from, (long)n, room);
        fine = H5Sselect_hyperslab(space, H5S_SELECT_SET, &from, NULL, &n, NULL) >= 0
               && H5Dwrite(set, a->type, part, space, H5P_DEFAULT, room) >= 0;
        H5Sclose(part);
    }
    free(room);
    H5Sclose(space);
    return fine;
}

static bool is_left(const struct fields_grid_array *a)
{
    return !a->data && !a->fill && a->rows > 0;
}

static int write_numbers(struct image *to, hid_t set, const struct fields_grid_array *a)
{
    if (a->rows == 0)
        return 1;
    if (is_left(a))
        return image_leave(to, set);
    return a->fill ? write_rows(set, a)
                   : H5Dwrite(set, a->type, H5S_ALL, H5S_ALL, H5P_DEFAULT, a->data) >= 0;
}

static int write_data(struct image *to, hid_t group, const struct fields_grid_array *a, hid_t space,
                      hid_t making)
{
    const hid_t set = H5Dcreate2(group, a->name, a->type, space, H5P_DEFAULT, making, H5P_DEFAULT);
    int fine = is_fine(set) && write_numbers(to, set, a);

    if (is_fine(set))
        fine = H5Dclose(set) >= 0 && fine;
    return fine;
}

/* Vertex cells are 0, 1, 2, ...: packed they cost next to nothing. */
static int pack(hid_t making, const struct fields_grid_array *a)
{
    const hsize_t chunk = a->rows < CHUNK ? a->rows : CHUNK;

    if (is_left(a))
        return image_room(making);
    if (!a->regular || a->rows == 0 || H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0)
        return 1;
    return H5Pset_chunk(making, 1, &chunk) >= 0 && H5Pset_shuffle(making) >= 0
           && H5Pset_deflate(making, 1) >= 0;
}

static int write_array(struct image *to, hid_t group, const struct fields_grid_array *a)
{
    const hsize_t size[2] = { a->rows, a->columns };
    const hid_t space = H5Screate_simple(a->columns > 0 ? 2 : 1, size, NULL);
    const hid_t making = H5Pcreate(H5P_DATASET_CREATE);
    const int fine = H5Pset_obj_track_times(making, 0) >= 0 /* same numbers, same bytes */
                     && pack(making, a) && write_data(to, group, a, space, making);

    H5Pclose(making);
    H5Sclose(space);
    return fine;
}

static int write_attribute(hid_t group, const char *name, hid_t type, hid_t space,
                           const void *value)
{
    const hid_t attribute = H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const int fine = is_fine(attribute) && H5Awrite(attribute, type, value) >= 0;

    return is_fine(attribute) && H5Aclose(attribute) >= 0 && fine;
}

/* What makes the group a VTK grid: version, type; and the time. */
static int write_attributes(hid_t group, double t)
{
    static const int64_t version[2] = { 1, 0 };
    static const char type[] = "UnstructuredGrid";
    const hsize_t two = 2;
    const hid_t scalar = H5Screate(H5S_SCALAR), pair = H5Screate_simple(1, &two, NULL);
    const hid_t text = H5Tcopy(H5T_C_S1);
    const int fine = H5Tset_size(text, sizeof type - 1) >= 0
                     && write_attribute(group, "Version", H5T_NATIVE_INT64, pair, version)
                     && write_attribute(group, "Type", text, scalar, type)
                     && write_attribute(group, "time", H5T_NATIVE_DOUBLE, scalar, &t);

    H5Tclose(text);
    H5Sclose(pair);
    H5Sclose(scalar);
    return fine;
}

static int write_all(struct image *to, hid_t group, const struct fields_grid_array *array)
{
    for (; array->name; array++)
        if (!write_array(to, group, array))
            return 0;
    return 1;
}

int fields_grid_write(struct image *to, const char *name, const struct fields_grid_array *array,
                      double t)
{
    const hid_t group = H5Gcreate2(to->file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    int fine = is_fine(group) && write_all(to, group, array);

    if (fine && !strcmp(name, "VTKHDF"))
        fine = write_attributes(group, t);
    return is_fine(group) && H5Gclose(group) >= 0 && fine;
}

int fields_grid_keep(const char *path, const struct image *image, bool fine)
{
    struct aside a;

    if (!fine)
        return image_refused(image, path);
    TRY(aside_open(&a, path));
    if (image_put(image, a.to))
        return aside_close(&a);
    aside_drop(&a);
    return image_refused(image, path);
}
