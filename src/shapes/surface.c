/* surface.c -- surfaces of solids, corner by corner and face by face. */
#include "shapes/surface.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* *list gets room for n things of `size` bytes. */
static int make_room(void **list, int *room, int n, size_t size)
{
    void *more;

    if (n <= *room)
        return STATUS_DONE;
    more = realloc(*list, (size_t)(2 * n) * size);
    if (!more)
        return status_starved("a surface of %d corners or faces cannot be kept", n);
    *list = more;
    *room = 2 * n;
    return STATUS_DONE;
}

int surface_corner(struct surface *s, const double *x)
{
    void *list = s->x;

    TRY(make_room(&list, &s->corner_room, s->corners + 1, sizeof *s->x));
    s->x = list;
    memcpy(s->x[s->corners++], x, sizeof *s->x);
    return STATUS_DONE;
}

int surface_face(struct surface *s, const int *corner, int corners)
{
    void *first = s->first, *loop = s->loop;
    int code = make_room(&first, &s->face_room, s->faces + 2, sizeof *s->first);

    s->first = first;
    TRY(code);
    code = make_room(&loop, &s->loop_room, s->ends + corners, sizeof *s->loop);
    s->loop = loop;
    TRY(code);
    memcpy(s->loop + s->ends, corner, (size_t)corners * sizeof *corner);
    s->first[s->faces++] = s->ends;
    s->ends += corners;
    s->first[s->faces] = s->ends;
    return STATUS_DONE;
}

/* Corners first, first + 1, ..., which are its faces in turn. */
static int add_corners(struct surface *s, const double (*x)[DIM], int n)
{
    for (int i = 0; i < n; i++)
        TRY(surface_corner(s, x[i]));
    return STATUS_DONE;
}

static int add_face(struct surface *s, const int *corner, int corners, int from)
{
    int *moved = status_alloc((size_t)corners, sizeof *moved), code = STATUS_FAILED;

    for (int i = 0; moved && i < corners; i++)
        moved[i] = from + (corner ? corner[i] : i);
    if (moved)
        code = surface_face(s, moved, corners);
    free(moved);
    return code;
}

int surface_polytope(struct surface *s, const struct polytope *p)
{
    const int from = s->corners;

    TRY(add_corners(s, (const double (*)[DIM])p->x, p->corners));
    if (DIM == 2)
        return add_face(s, NULL, p->corners, from);
    for (int i = 0; i < p->faces; i++)
        TRY(add_face(s, p->loop + p->face[i].first, p->face[i].corners, from));
    return STATUS_DONE;
}

int surface_box(struct surface *s, const double *half)
{
    static const int face[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
                                    { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    static const int outline[4] = { 0, 1, 3, 2 };
    const int from = s->corners;

    for (int i = 0; i < 1 << DIM; i++) {
        double x[DIM];
        for (int d = 0; d < DIM; d++)
            x[d] = i & 1 << d ? half[d] : -half[d];
        TRY(surface_corner(s, x));
    }
    if (DIM == 2)
        return add_face(s, outline, 4, from);
    for (int i = 0; i < 6; i++)
        TRY(add_face(s, face[i], 4, from));
    return STATUS_DONE;
}

#if DIM == 2
static double cone(const double *a, const double *b)
{
    return (a[0] * b[1] - a[1] * b[0]) / 2;
}
#else
static double cone(const double *a, const double *b, const double *c)
{
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
}
#endif

/* Cones from the origin to edges, in space to triangles of faces. */
double surface_volume(const struct surface *s)
{
    double sum = 0;

    for (int f = 0; f < s->faces; f++) {
        const int *at = s->loop + s->first[f], n = s->first[f + 1] - s->first[f];
#if DIM == 2
        for (int i = 0; i < n; i++)
            sum += cone(s->x[at[i]], s->x[at[(i + 1) % n]]);
#else
        for (int i = 1; i + 1 < n; i++)
            sum += cone(s->x[at[0]], s->x[at[i]], s->x[at[i + 1]]);
#endif
    }
    return sum;
}

/* Newell's normal of a face is twice its area long. */
double surface_area(const struct surface *s)
{
    double sum = 0;

    for (int f = 0; f < s->faces && DIM == 3; f++) {
        const int *at = s->loop + s->first[f], n = s->first[f + 1] - s->first[f];
        double normal[3] = { 0 };
        for (int i = 0; i < n; i++) {
            const double *a = s->x[at[i]], *b = s->x[at[(i + 1) % n]];
            for (int d = 0; d < 3; d++)
                normal[d] += (a[(d + 1) % 3] - b[(d + 1) % 3]) * (a[(d + 2) % 3] + b[(d + 2) % 3]);
        }
        sum += sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]) / 2;
    }
    return sum;
}

void surface_free(struct surface *s)
{
    free(s->x);
    free(s->first);
    free(s->loop);
    *s = (struct surface){ 0 };
}
