/* fields-bodies.c -- one moment of the surfaces of rigid bodies as an HDF5 file that VTK 9.1 reads. */
#include "output/fields-file.h"

#include "base/status.h"
#include "output/fields-grid.h"
#include <stdint.h>
#include <stdlib.h>

enum { CORNER = 160 }; /* bytes of one in a file, an upper bound */
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

static int write_faces(struct image *to, const struct cloud_looks *l, const struct faces *w, double t)
{
    const hsize_t corners = (hsize_t)l->corners, faces = (hsize_t)l->faces;
    const int64_t points = l->corners, cells = l->faces, ends = w->first[l->faces];
    const struct fields_grid_array grid[] = {
        { "NumberOfPoints", H5T_NATIVE_INT64, 1, 0, .data = &points },
        { "NumberOfCells", H5T_NATIVE_INT64, 1, 0, .data = &cells },
        { "NumberOfConnectivityIds", H5T_NATIVE_INT64, 1, 0, .data = &ends },
        { "Points", H5T_NATIVE_DOUBLE, corners, 3, .data = w->x },
        { "Connectivity", H5T_NATIVE_INT64, (hsize_t)ends, 0, .data = w->loop, .regular = 1 },
        { "Offsets", H5T_NATIVE_INT64, faces + 1, 0, .data = w->first, .regular = 1 },
        { "Types", H5T_NATIVE_UCHAR, faces, 0, .data = w->type, .regular = 1 },
        { .name = NULL },
    };
    const struct fields_grid_array points_have[] = {
        { "velocity", H5T_NATIVE_DOUBLE, corners, 3, .data = w->u }, { .name = NULL } };
    const struct fields_grid_array cells_have[] = {
        { "body", H5T_NATIVE_INT, faces, 0, .data = l->of, .regular = 1 }, { .name = NULL } };
    const struct fields_grid_array index_has[] = {
        { "Mixed", H5T_NATIVE_INT, (hsize_t)w->mixed_n, 0, .data = w->mixed, .regular = 1 }, { .name = NULL } };

    return fields_grid_write(to, "VTKHDF", grid, t)
           && fields_grid_write(to, "VTKHDF/PointData", points_have, t)
           && fields_grid_write(to, "VTKHDF/CellData", cells_have, t)
           && fields_grid_write(to, "XDMF", index_has, t);
}

int fields_bodies_write(const char *path, const struct cloud_frame *frame)
{
    const struct cloud_looks *l = frame->looks;
    struct image image = { .file = -1, .memory = -1 };
    struct faces work = { 0 };
    int code = faces_fill(&work, l, frame->dim);

    if (code == STATUS_DONE) {
        const bool begun = image_begin(&image, (size_t)l->corners * CORNER);
        const bool fine = image_end(&image, begun && write_faces(&image, l, &work, frame->t));
        code = fields_grid_keep(path, &image, fine);
    }
    image_free(&image);
    faces_free(&work);
    return code;
}
