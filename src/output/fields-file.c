/* fields-file.c -- one moment of the particles as an HDF5 file that VTK 9.1 reads.
 *
 * The layout is version 1.0 of VTK's own for a UnstructuredGrid in one piece:
 * https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html */
#include "output/fields-file.h"

#include "base/status.h"
#include "output/fields-grid.h"
#include "output/pieces.h"
#include <stdint.h>
#include <string.h>

/* --- rows of arrays ------------------------------------------------------------------------ */

/* VTK knows three components only. */
static void deepen(const struct cloud_frame *c, const double *from, long first, long n, double *to)
{
    for (long i = 0; i < n; i++)
        for (int d = 0; d < 3; d++)
            to[3 * i + d] = d < c->dim ? from[(first + i) * c->dim + d] : 0;
}

static void points(const void *frame, long first, long n, void *to)
{
    const struct cloud_frame *c = frame;

    deepen(c, c->x, first, n, to);
}

static void velocities(const void *frame, long first, long n, void *to)
{
    const struct cloud_frame *c = frame;

    deepen(c, c->u, first, n, to);
}

static void counts(const void *frame, long first, long n, void *to)
{
    (void)frame;
    for (long i = 0; i < n; i++)
        ((int64_t *)to)[i] = first + i;
}

static void types(const void *frame, long first, long n, void *to)
{
    enum { VTK_VERTEX = 1 };

    (void)frame;
    (void)first;
    memset(to, VTK_VERTEX, (size_t)n);
}

static void ids(const void *frame, long first, long n, void *to)
{
    (void)frame;
    for (long i = 0; i < n; i++)
        ((int *)to)[i] = (int)(first + i);
}

static void bytes(const void *from, long first, long n, void *to)
{
    memcpy(to, (const unsigned char *)from + first, (size_t)n);
}

/* --- a file ---------------------------------------------------------------------------------- */

/* Arrays that all ranks write, in the order in which write_groups() leaves them out. */
enum { POINTS, VELOCITY, DENSITY, PRESSURE, ARRAYS };

static int write_groups(struct image *to, const struct cloud_frame *c)
{
    const hsize_t n = (hsize_t)c->n;
    const int64_t points_are = c->n;
    const struct fields_grid_array grid[] = {
        { "NumberOfPoints", H5T_NATIVE_INT64, 1, 0, .data = &points_are },
        { "NumberOfCells", H5T_NATIVE_INT64, 1, 0, .data = &points_are },
        { "NumberOfConnectivityIds", H5T_NATIVE_INT64, 1, 0, .data = &points_are },
        { "Points", H5T_NATIVE_DOUBLE, n, 3, .data = NULL },
        { "Connectivity", H5T_NATIVE_INT64, n, 0, .regular = 1, .fill = counts },
        { "Offsets", H5T_NATIVE_INT64, n + 1, 0, .regular = 1, .fill = counts },
        { "Types", H5T_NATIVE_UCHAR, n, 0, .regular = 1, .fill = types },
        { .name = NULL },
    };
    const struct fields_grid_array values[] = {
        { "velocity", H5T_NATIVE_DOUBLE, n, 3, .data = NULL },
        { "density", H5T_NATIVE_DOUBLE, n, 0, .data = NULL },
        { "pressure", H5T_NATIVE_DOUBLE, n, 0, .data = NULL },
        { "dye", H5T_NATIVE_UCHAR, n, 0, .regular = 1, .fill = bytes, .self = c->dye },
        { "kind", H5T_NATIVE_UCHAR, n, 0, .regular = 1, .fill = bytes, .self = c->kind },
        { "id", H5T_NATIVE_INT, n, 0, .regular = 1, .fill = ids },
        { .name = NULL },
    };

    return fields_grid_write(to, "VTKHDF", grid, c->t)
           && fields_grid_write(to, "VTKHDF/PointData", values, c->t);
}

enum { POINT = 160 }; /* bytes of a particle in a file, an upper bound */

/* What is small, on the first rank. */
static int start(const char *path, const struct cloud_frame *c, struct image *image, struct aside *a)
{
    const bool begun = image_begin(image, (size_t)c->n * POINT), fine = begun && write_groups(image, c);

    if (!image_end(image, fine))
        return image_refused(image, path);
    TRY(aside_open(a, path));
    if (image_put(image, a->to))
        return STATUS_DONE;
    aside_drop(a);
    a->to = NULL;
    return image_refused(image, path);
}

static int write_all(int status, struct aside *a, const struct image *image, const struct cloud_frame *c)
{
    const size_t number = sizeof(double);
    const struct piece piece[ARRAYS] = {
        [POINTS] = { POINTS, c->from, c->here, 3 * number, points, c },
        [VELOCITY] = { VELOCITY, c->from, c->here, 3 * number, velocities, c },
        [DENSITY] = { DENSITY, c->from, c->here, number, pieces_numbers, c->rho },
        [PRESSURE] = { PRESSURE, c->from, c->here, number, pieces_numbers, c->p },
    };
    const struct pieces all = { c->shared, c->n > 0 ? ARRAYS : 0, piece };

    return pieces_write(status, a, image, 0, &all, false);
}

int fields_file_write(const char *path, const struct cloud_frame *c)
{
    struct image image = { .file = -1, .memory = -1 };
    struct aside a = { .to = NULL };
    int status = path ? start(path, c, &image, &a) : STATUS_DONE;

    status = write_all(status, path ? &a : NULL, &image, c);
    image_free(&image);
    if (status == STATUS_DONE && a.to)
        return aside_close(&a);
    if (a.to)
        aside_drop(&a);
    return status;
}
