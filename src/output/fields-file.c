/* fields-file.c -- one moment of the particles as an HDF5 file that VTK 9.1 reads.
 *
 * The layout is version 1.0 of VTK's own for a UnstructuredGrid in one piece:
 * https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html */
#include "output/fields-file.h"

#include "base/status.h"
#include "output/fields-grid.h"
#include "output/image.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* What one file has, and work arrays of it: three components, where there are two, and the cells. */
struct work {
    const double *x, *u; /* [n][3] */
    double *deep;        /* [2][n][3] those; NULL: the frame's */
    int64_t *count;      /* [n+1] 0, 1, 2, ... */
    unsigned char *type; /* [n] VTK_VERTEX */
    int *id;             /* [n] */
};

static void work_free(struct work *w)
{
    free(w->deep);
    free(w->count);
    free(w->type);
    free(w->id);
}

/* VTK knows three components only. */
static int deepen(struct work *w, const struct cloud_frame *c)
{
    const size_t n = (size_t)c->n, dim = (size_t)c->dim;

    w->x = c->x;
    w->u = c->u;
    if (dim == 3)
        return STATUS_DONE;
    if (!(w->deep = status_alloc(2 * n, 3 * sizeof *w->deep)))
        return STATUS_FAILED;
    for (size_t i = 0; i < n; i++) {
        memcpy(w->deep + 3 * i, c->x + dim * i, dim * sizeof *w->deep);
        memcpy(w->deep + 3 * (n + i), c->u + dim * i, dim * sizeof *w->deep);
    }
    w->x = w->deep;
    w->u = w->deep + 3 * n;
    return STATUS_DONE;
}

static int work_fill(struct work *w, const struct cloud_frame *c)
{
    const size_t n = (size_t)c->n;

    TRY(deepen(w, c));
    w->count = status_alloc(n + 1, sizeof *w->count);
    w->type = status_alloc(n, sizeof *w->type);
    w->id = status_alloc(n, sizeof *w->id);
    if (!w->count || !w->type || !w->id)
        return STATUS_FAILED;
    for (size_t i = 0; i < n; i++) {
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
    const struct fields_grid_array grid[] = {
        { "NumberOfPoints", H5T_NATIVE_INT64, 1, 0, &points, 0 },
        { "NumberOfCells", H5T_NATIVE_INT64, 1, 0, &points, 0 },
        { "NumberOfConnectivityIds", H5T_NATIVE_INT64, 1, 0, &points, 0 },
        { "Points", H5T_NATIVE_DOUBLE, n, 3, w->x, 0 },
        { "Connectivity", H5T_NATIVE_INT64, n, 0, w->count, 1 },
        { "Offsets", H5T_NATIVE_INT64, n + 1, 0, w->count, 1 },
        { "Types", H5T_NATIVE_UCHAR, n, 0, w->type, 1 },
        { .name = NULL },
    };
    const struct fields_grid_array values[] = {
        { "velocity", H5T_NATIVE_DOUBLE, n, 3, w->u, 0 },
        { "density", H5T_NATIVE_DOUBLE, n, 0, c->rho, 0 },
        { "pressure", H5T_NATIVE_DOUBLE, n, 0, c->p, 0 },
        { "dye", H5T_NATIVE_UCHAR, n, 0, c->dye, 1 },
        { "kind", H5T_NATIVE_UCHAR, n, 0, c->kind, 1 },
        { "id", H5T_NATIVE_INT, n, 0, w->id, 1 },
        { .name = NULL },
    };

    return fields_grid_write(file, "VTKHDF", grid, c->t)
           && fields_grid_write(file, "VTKHDF/PointData", values, c->t);
}

enum { POINT = 160 }; /* bytes of a particle in it */

static void *make_image(const struct cloud_frame *c, const struct work *w, size_t *size)
{
    const hid_t file = image_open((size_t)c->n * POINT);

    return image_close(file, file >= 0 && write_groups(file, c, w), size);
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
        code = fields_grid_keep(path, image, size);
    free(image);
    return code;
}
