/* movie-bodies.c -- rigid bodies in particle files of a run as tables. */
#include "output/movie-bodies.h"

#include "base/status.h"
#include "output/looks-file.h"
#include "output/movie-set.h"

#include <stdbool.h>
#include <stdlib.h>

/* Their surfaces, with numbers as a file of theirs has them. */
struct bodies {
    hsize_t corners, faces, ends;
    double *x;              /* [corners][3] */
    int *first, *loop, *of; /* [faces + 1], [ends], [faces] */
};

static void free_bodies(struct bodies *b)
{
    free(b->x);
    free(b->first);
    free(b->loop);
    free(b->of);
}

static hsize_t read_count(hid_t file, const char *name)
{
    long long *count = movie_set(file, name, H5T_NATIVE_LLONG, 1, sizeof *count);
    const hsize_t n = count && *count > 0 && *count < 1 << 28 ? (hsize_t)*count : 0;

    free(count);
    return n;
}

/* Do faces and corners name only what is there? */
static bool are_whole(const struct bodies *b)
{
    for (hsize_t f = 0; f < b->faces; f++)
        if (b->first[f] < 0 || b->first[f] >= b->first[f + 1] || b->of[f] < 0)
            return false;
    for (hsize_t i = 0; i < b->ends; i++)
        if (b->loop[i] < 0 || (hsize_t)b->loop[i] >= b->corners)
            return false;
    return b->first[b->faces] == (int)b->ends;
}

static bool read_bodies(const char *path, struct bodies *b)
{
    hid_t file;

    *b = (struct bodies){ 0 };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0)
        return false;
    b->corners = read_count(file, "/VTKHDF/NumberOfPoints");
    b->faces = read_count(file, "/VTKHDF/NumberOfCells");
    b->ends = read_count(file, "/VTKHDF/NumberOfConnectivityIds");
    b->x = movie_set(file, "/VTKHDF/Points", H5T_NATIVE_DOUBLE, 3 * b->corners, sizeof *b->x);
    b->first = movie_set(file, "/VTKHDF/Offsets", H5T_NATIVE_INT, b->faces + 1, sizeof *b->first);
    b->loop = movie_set(file, "/VTKHDF/Connectivity", H5T_NATIVE_INT, b->ends, sizeof *b->loop);
    b->of = movie_set(file, "/VTKHDF/CellData/body", H5T_NATIVE_INT, b->faces, sizeof *b->of);
    H5Fclose(file);
    return b->x && b->first && b->loop && b->of && are_whole(b);
}

/* Points of files have three numbers, of which those of the plane are the first two. */
static void flatten(struct bodies *b)
{
    for (hsize_t i = 0; i < b->corners; i++)
        for (hsize_t d = 0; d < 2; d++)
            b->x[2 * i + d] = b->x[3 * i + d];
}

int movie_bodies(const char *from, const char *to, int dim, double middle)
{
    struct bodies b;
    int status;

    if (!read_bodies(from, &b)) {
        free_bodies(&b);
        return status_fail(STATUS_IO, "%s: no rigid bodies can be read from this file", from);
    }
    if (dim == 2)
        flatten(&b);
    const struct cloud_looks looks = { .corners = (int)b.corners, .faces = (int)b.faces,
                                       .x = b.x, .of = b.of, .first = b.first, .loop = b.loop };
    status = dim == 2 ? looks_file_write(to, 2, 0, &looks)
                      : looks_file_write_cut(to, 0, middle, &looks);
    free_bodies(&b);
    return status;
}
