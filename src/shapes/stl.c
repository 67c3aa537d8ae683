/* stl.c -- corners of the triangles of an STL file.
 *
 * Of bytes: a header of 80, how many triangles (4 bytes, the lowest first), then for each a normal and three
 * corners of three 4-byte IEEE numbers and 2 bytes besides.  Of words: "solid", and then
 * "vertex X Y Z" for each corner.  (3D Systems, StereoLithography Interface Specification, 1989.) */
#include "shapes/stl.h"

#include "base/status.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#if DIM == 3

enum { HEADER = 84, TRIANGLE = 50, CORNERS = 3, NORMAL = 12, MOST_TRIANGLES = 10000000 };

static int refuse(const char *path, const char *what)
{
    return status_fail(STATUS_BAD_SCENE, "%s: %s; save it as STL again", path, what);
}

static uint32_t number_at(const unsigned char *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static double real_at(const unsigned char *bytes)
{
    const uint32_t bits = number_at(bytes);
    float x;

    memcpy(&x, &bits, sizeof x);
    return (double)x;
}

static int add(const char *path, const double *x, struct points *to)
{
    for (int d = 0; d < DIM; d++)
        if (!isfinite(x[d]))
            return refuse(path, "a corner of its triangles is no number");
    return points_add(to, x);
}

static int read_bytes(const char *path, FILE *from, long triangles, struct points *to)
{
    unsigned char bytes[TRIANGLE];

    for (long i = 0; i < triangles; i++) {
        if (fread(bytes, TRIANGLE, 1, from) != 1)
            return refuse(path, "it ends within a triangle");
        for (int k = 0; k < CORNERS; k++) {
            double x[DIM];
            for (int d = 0; d < DIM; d++)
                x[d] = real_at(bytes + NORMAL + 4 * (k * DIM + d));
            TRY(add(path, x, to));
        }
    }
    return STATUS_DONE;
}

static int read_words(const char *path, FILE *from, struct points *to)
{
    char word[64];

    while (fscanf(from, "%63s", word) == 1) {
        double x[DIM];
        if (strcmp(word, "vertex") != 0)
            continue;
        if (fscanf(from, "%lf %lf %lf", &x[0], &x[1], &x[2]) != DIM)
            return refuse(path, "a \"vertex\" is not followed by three numbers");
        if (to->n >= CORNERS * (long)MOST_TRIANGLES)
            return refuse(path, "it has more than ten million triangles");
        TRY(add(path, x, to));
    }
    return STATUS_DONE;
}

/* Some programs begin files of bytes with "solid", too, so that their length decides. */
static int read_either(const char *path, FILE *from, struct points *to)
{
    unsigned char header[HEADER] = { 0 };
    const size_t got = fread(header, 1, HEADER, from);
    const long triangles = number_at(header + HEADER - 4);
    long size;

    if (fseek(from, 0, SEEK_END) != 0 || (size = ftell(from)) < 0)
        return status_fail(STATUS_IO, "%s cannot be read: %s; it has to be a file", path, strerror(errno));
    if (got == HEADER && triangles <= MOST_TRIANGLES && size == HEADER + TRIANGLE * triangles)
        return fseek(from, HEADER, SEEK_SET) != 0 ? STATUS_IO : read_bytes(path, from, triangles, to);
    if (memcmp(header, "solid", 5) != 0)
        return refuse(path, "it neither begins with \"solid\" nor is as long as the number of triangles in "
                            "it asks for, so it is no STL file, or was cut off");
    rewind(from);
    return read_words(path, from, to);
}

int stl_read(const char *path, struct points *to)
{
    FILE *from = fopen(path, "rb");
    int code;

    if (!from)
        return status_fail(STATUS_IO, "%s cannot be read: %s", path, strerror(errno));
    code = read_either(path, from, to);
    fclose(from);
    if (code == STATUS_DONE && to->n == 0)
        code = refuse(path, "it has no triangle");
    return code;
}

#endif
