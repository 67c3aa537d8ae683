/* fields-grid.c -- arrays of a particle file, in groups that VTK 9.1 reads. */
#include "output/fields-grid.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/image.h"
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static int is_fine(hid_t id)
{
    return id >= 0;
}

static int write_data(hid_t group, const struct fields_grid_array *a, hid_t space, hid_t making)
{
    const hid_t set = H5Dcreate2(group, a->name, a->type, space, H5P_DEFAULT, making, H5P_DEFAULT);
    int fine = is_fine(set);

    if (fine && a->rows > 0)
        fine = H5Dwrite(set, a->type, H5S_ALL, H5S_ALL, H5P_DEFAULT, a->data) >= 0;
    if (is_fine(set))
        fine = H5Dclose(set) >= 0 && fine;
    return fine;
}

/* Vertex cells are 0, 1, 2, ...: packed they cost next to nothing. */
static int pack(hid_t making, const struct fields_grid_array *a)
{
    const hsize_t chunk = a->rows < 65536 ? a->rows : 65536;

    if (!a->regular || a->rows == 0 || H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0)
        return 1;
    return H5Pset_chunk(making, 1, &chunk) >= 0 && H5Pset_shuffle(making) >= 0
           && H5Pset_deflate(making, 1) >= 0;
}

static int write_array(hid_t group, const struct fields_grid_array *a)
{
    const hsize_t size[2] = { a->rows, a->columns };
    const hid_t space = H5Screate_simple(a->columns > 0 ? 2 : 1, size, NULL);
    const hid_t making = H5Pcreate(H5P_DATASET_CREATE);
    const int fine = H5Pset_obj_track_times(making, 0) >= 0 /* same numbers, same bytes */
                     && pack(making, a) && write_data(group, a, space, making);

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

static int write_all(hid_t group, const struct fields_grid_array *array)
{
    for (; array->name; array++)
        if (!write_array(group, array))
            return 0;
    return 1;
}

int fields_grid_write(hid_t file, const char *name, const struct fields_grid_array *array, double t)
{
    const hid_t group = H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    int fine = is_fine(group) && write_all(group, array);

    if (fine && !strcmp(name, "VTKHDF"))
        fine = write_attributes(group, t);
    return is_fine(group) && H5Gclose(group) >= 0 && fine;
}

int fields_grid_keep(const char *path, const void *image, size_t size)
{
    struct aside a;

    if (!image)
        return image_refused(path);
    TRY(aside_open(&a, path));
    fwrite(image, 1, size, a.to);
    return aside_close(&a);
}
