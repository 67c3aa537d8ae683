/* fields-file.c -- one moment of the particles as an HDF5 file that VTK 9.1 reads.
 *
 * The layout is version 1.0 of VTK's own for a UnstructuredGrid in one piece:
 * https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html */
#include "output/fields-file.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/image.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Where one array of the file comes from. */
struct array {
    const char *name;
    hid_t type;
    hsize_t rows, columns; /* columns 0: a list, not a table                  */
    const void *data;
    int regular; /* a pattern: worth compressing                    */
};

static int is_fine(hid_t id)
{
    return id >= 0;
}

static int write_data(hid_t group, const struct array *a, hid_t space, hid_t making)
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
static int pack(hid_t making, const struct array *a)
{
    const hsize_t chunk = a->rows < 65536 ? a->rows : 65536;

    if (!a->regular || a->rows == 0 || H5Zfilter_avail(H5Z_FILTER_DEFLATE) <= 0)
        return 1;
    return H5Pset_chunk(making, 1, &chunk) >= 0 && H5Pset_shuffle(making) >= 0
           && H5Pset_deflate(making, 1) >= 0;
}

static int write_array(hid_t group, const struct array *a)
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

static int write_all(hid_t group, const struct array *array)
{
    for (; array->name; array++)
        if (!write_array(group, array))
            return 0;
    return 1;
}

static int write_group(hid_t file, const char *name, const struct array *array, double t)
{
    const hid_t group = H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    int fine = is_fine(group) && write_all(group, array);

    if (fine && !strcmp(name, "VTKHDF"))
        fine = write_attributes(group, t);
    return is_fine(group) && H5Gclose(group) >= 0 && fine;
}

/* Work arrays of one file: three components, and the cells. */
struct work {
    double *x, *u;       /* [n][3] */
    int64_t *count;      /* [n+1] 0, 1, 2, ... */
    unsigned char *type; /* [n] VTK_VERTEX */
    int *id;             /* [n] */
};

static void work_free(struct work *w)
{
    free(w->x);
    free(w->u);
    free(w->count);
    free(w->type);
    free(w->id);
}

static int work_fill(struct work *w, const struct cloud_frame *c)
{
    const size_t n = (size_t)c->n, dim = (size_t)c->dim;

    w->x = status_alloc(n, 3 * sizeof *w->x);
    w->u = status_alloc(n, 3 * sizeof *w->u);
    w->count = status_alloc(n + 1, sizeof *w->count);
    w->type = status_alloc(n, sizeof *w->type);
    w->id = status_alloc(n, sizeof *w->id);
    if (!w->x || !w->u || !w->count || !w->type || !w->id)
        return STATUS_FAILED;
    for (size_t i = 0; i < n; i++) {
        memcpy(w->x + 3 * i, c->x + dim * i, dim * sizeof *w->x);
        memcpy(w->u + 3 * i, c->u + dim * i, dim * sizeof *w->u);
        w->count[i] = (int64_t)i;
        w->type[i] = 1;
        w->id[i] = c->id ? c->id[i] : (int)i;
    }
    w->count[n] = (int64_t)n;
    return STATUS_DONE;
}

static int write_groups(hid_t file, const struct cloud_frame *c, const struct work *w)
{
    const hsize_t n = (hsize_t)c->n;
    const int64_t points = c->n;
    const struct array grid[] = {
        { "NumberOfPoints", H5T_NATIVE_INT64, 1, 0, &points, 0 },
        { "NumberOfCells", H5T_NATIVE_INT64, 1, 0, &points, 0 },
        { "NumberOfConnectivityIds", H5T_NATIVE_INT64, 1, 0, &points, 0 },
        { "Points", H5T_NATIVE_DOUBLE, n, 3, w->x, 0 },
        { "Connectivity", H5T_NATIVE_INT64, n, 0, w->count, 1 },
        { "Offsets", H5T_NATIVE_INT64, n + 1, 0, w->count, 1 },
        { "Types", H5T_NATIVE_UCHAR, n, 0, w->type, 1 },
        { .name = NULL },
    };
    const struct array values[] = {
        { "velocity", H5T_NATIVE_DOUBLE, n, 3, w->u, 0 },
        { "density", H5T_NATIVE_DOUBLE, n, 0, c->rho, 0 },
        { "pressure", H5T_NATIVE_DOUBLE, n, 0, c->p, 0 },
        { "dye", H5T_NATIVE_UCHAR, n, 0, c->dye, 1 },
        { "kind", H5T_NATIVE_UCHAR, n, 0, c->kind, 1 },
        { "id", H5T_NATIVE_INT, n, 0, w->id, 1 },
        { .name = NULL },
    };

    return write_group(file, "VTKHDF", grid, c->t)
           && write_group(file, "VTKHDF/PointData", values, c->t);
}

enum { POINT = 160 }; /* bytes of a particle in it */

static void *make_image(const struct cloud_frame *c, const struct work *w, size_t *size)
{
    const hid_t file = image_open((size_t)c->n * POINT);

    return image_close(file, is_fine(file) && write_groups(file, c, w), size);
}

/* --- surfaces of bodies ------------------------------------------------------------ */

enum { VTK_POLYGON = 7, XDMF_POLYGON = 3 };

/* Work arrays of these. */
struct faces {
    double *x, *u;              /* [corners][3] */
    int64_t *loop, *first;      /* [ends], [faces + 1] */
    unsigned char *type;        /* [faces] */
    int *mixed, mixed_n;        /* for XDMF: type, corners, and these, of each face */
};

static void faces_free(struct faces *w)
{
    free(w->x);
    free(w->u);
    free(w->loop);
    free(w->first);
    free(w->type);
    free(w->mixed);
}

static void faces_tell(struct faces *w, const struct cloud_looks *l)
{
    for (int f = 0; f <= l->faces; f++)
        w->first[f] = l->first[f];
    for (int f = 0; f < l->faces; f++) {
        const int n = l->first[f + 1] - l->first[f];
        w->type[f] = VTK_POLYGON;
        w->mixed[w->mixed_n++] = XDMF_POLYGON;
        w->mixed[w->mixed_n++] = n;
        for (int i = l->first[f]; i < l->first[f + 1]; i++) {
            w->loop[i] = l->loop[i];
            w->mixed[w->mixed_n++] = l->loop[i];
        }
    }
}

static int faces_fill(struct faces *w, const struct cloud_looks *l, int dim)
{
    const size_t corners = (size_t)l->corners, faces = (size_t)l->faces;
    const size_t ends = (size_t)l->first[l->faces];

    w->x = status_alloc(corners, 3 * sizeof *w->x);
    w->u = status_alloc(corners, 3 * sizeof *w->u);
    w->loop = status_alloc(ends, sizeof *w->loop);
    w->first = status_alloc(faces + 1, sizeof *w->first);
    w->type = status_alloc(faces, sizeof *w->type);
    w->mixed = status_alloc(ends + 2 * faces, sizeof *w->mixed);
    if (!w->x || !w->u || !w->loop || !w->first || !w->type || !w->mixed)
        return STATUS_FAILED;
    for (int i = 0; i < l->corners; i++)
        for (int d = 0; d < dim; d++) {
            w->x[3 * i + d] = l->x[dim * i + d];
            w->u[3 * i + d] = l->u[dim * i + d];
        }
    faces_tell(w, l);
    return STATUS_DONE;
}

static int write_faces(hid_t file, const struct cloud_looks *l, const struct faces *w, double t)
{
    const hsize_t corners = (hsize_t)l->corners, faces = (hsize_t)l->faces;
    const int64_t points = l->corners, cells = l->faces, ends = w->first[l->faces];
    const struct array grid[] = {
        { "NumberOfPoints", H5T_NATIVE_INT64, 1, 0, &points, 0 },
        { "NumberOfCells", H5T_NATIVE_INT64, 1, 0, &cells, 0 },
        { "NumberOfConnectivityIds", H5T_NATIVE_INT64, 1, 0, &ends, 0 },
        { "Points", H5T_NATIVE_DOUBLE, corners, 3, w->x, 0 },
        { "Connectivity", H5T_NATIVE_INT64, (hsize_t)ends, 0, w->loop, 1 },
        { "Offsets", H5T_NATIVE_INT64, faces + 1, 0, w->first, 1 },
        { "Types", H5T_NATIVE_UCHAR, faces, 0, w->type, 1 },
        { .name = NULL },
    };
    const struct array points_have[] = {
        { "velocity", H5T_NATIVE_DOUBLE, corners, 3, w->u, 0 }, { .name = NULL } };
    const struct array cells_have[] = {
        { "body", H5T_NATIVE_INT, faces, 0, l->of, 1 }, { .name = NULL } };
    const struct array index_has[] = {
        { "Mixed", H5T_NATIVE_INT, (hsize_t)w->mixed_n, 0, w->mixed, 1 }, { .name = NULL } };

    return write_group(file, "VTKHDF", grid, t)
           && write_group(file, "VTKHDF/PointData", points_have, t)
           && write_group(file, "VTKHDF/CellData", cells_have, t)
           && write_group(file, "XDMF", index_has, t);
}

static int write_image(const char *path, const void *image, size_t size)
{
    struct aside a;

    if (!image)
        return image_refused(path);
    TRY(aside_open(&a, path));
    fwrite(image, 1, size, a.to);
    return aside_close(&a);
}

int fields_file_write(const char *path, const struct cloud_frame *frame)
{
    struct work work = { 0 };
    void *image = NULL;
    size_t size = 0;
    int code = work_fill(&work, frame);

    if (code == STATUS_DONE)
        image = make_image(frame, &work, &size);
    work_free(&work);
    if (code == STATUS_DONE)
        code = write_image(path, image, size);
    free(image);
    return code;
}

int fields_file_write_bodies(const char *path, const struct cloud_frame *frame)
{
    const struct cloud_looks *l = frame->looks;
    struct faces work = { 0 };
    void *image = NULL;
    size_t size = 0;
    int code = faces_fill(&work, l, frame->dim);

    if (code == STATUS_DONE) {
        const hid_t file = image_open((size_t)l->corners * POINT);
        image = image_close(file, is_fine(file) && write_faces(file, l, &work, frame->t), &size);
    }
    faces_free(&work);
    if (code == STATUS_DONE)
        code = write_image(path, image, size);
    free(image);
    return code;
}
