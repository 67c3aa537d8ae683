/* polytope.c -- convex polytopes from points and half spaces. */
#include "shapes/polytope.h"

#include "base/status.h"
#include <libqhull_r/libqhull_r.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void polytope_free(struct polytope *p)
{
    free(p->x);
    free(p->face);
    free(p->loop);
    free(p->edge);
    *p = (struct polytope){ .x = NULL };
}

static int take(struct polytope *p, int corners, int faces, int loop, int edges)
{
    *p = (struct polytope){ .x = status_alloc((size_t)corners + 1, sizeof *p->x),
                            .face = status_alloc((size_t)faces + 1, sizeof *p->face),
                            .loop = status_alloc((size_t)loop + 1, sizeof *p->loop),
                            .edge = status_alloc((size_t)edges + 1, sizeof *p->edge) };
    if (p->x && p->face && p->loop && p->edge)
        return STATUS_DONE;
    polytope_free(p);
    return STATUS_FAILED;
}

static int loops(const struct polytope *p)
{
    int sum = 0;

    for (int i = 0; i < p->faces; i++)
        sum += p->face[i].corners;
    return sum;
}

int polytope_copy(const struct polytope *p, struct polytope *out)
{
    TRY(take(out, p->corners, p->faces, loops(p), p->edges));
    memcpy(out->x, p->x, (size_t)p->corners * sizeof *p->x);
    memcpy(out->face, p->face, (size_t)p->faces * sizeof *p->face);
    memcpy(out->loop, p->loop, (size_t)loops(p) * sizeof *p->loop);
    memcpy(out->edge, p->edge, (size_t)p->edges * sizeof *p->edge);
    out->corners = p->corners;
    out->faces = p->faces;
    out->edges = p->edges;
    return STATUS_DONE;
}

int polytope_line(const double *a, const double *b, struct polytope *out)
{
    const bool point = memcmp(a, b, sizeof *out->x) == 0;

    TRY(take(out, 2, 0, 0, 1));
    memcpy(out->x[0], a, sizeof *out->x);
    memcpy(out->x[1], b, sizeof *out->x);
    out->corners = point ? 1 : 2;
    out->edges = point ? 0 : 1;
    out->edge[0][1] = 1;
    return STATUS_DONE;
}

/* Corners of a face in turn: by their angles about its middle, seen from outside. */
struct around {
    double angle;
    int corner;
};

static int by_angle(const void *a, const void *b)
{
    const struct around *p = a, *q = b;

    return (p->angle > q->angle) - (p->angle < q->angle);
}

/* Two directions across n [3], which turn anticlockwise where n points at the reader. */
static void across(const double *n, double *u, double *v)
{
    const int least = fabs(n[0]) <= fabs(n[1]) && fabs(n[0]) <= fabs(n[2]) ? 0
                      : fabs(n[1]) <= fabs(n[2]) ? 1 : 2;
    double length = 0;

    for (int i = 0; i < 3; i++)
        u[i] = (i == least) - n[least] * n[i];
    for (int i = 0; i < 3; i++)
        length += u[i] * u[i];
    for (int i = 0; i < 3; i++)
        u[i] /= sqrt(length);
    for (int i = 0; i < 3; i++)
        v[i] = n[(i + 1) % 3] * u[(i + 2) % 3] - n[(i + 2) % 3] * u[(i + 1) % 3];
}

/* An edge of a polygon has its inside to the left. */
static void frame_of(const struct polytope_face *f, double *u, double *v)
{
    if (DIM == 3) {
        across(f->normal, u, v);
        return;
    }
    u[0] = -f->normal[1];
    u[1] = f->normal[0];
    v[0] = v[1] = 0;
}

/* In the plane the two ends of an edge, along it; in space round the middle. */
static int sort_face(const struct polytope *p, const struct polytope_face *f)
{
    struct around *a = status_alloc((size_t)f->corners + 1, sizeof *a);
    int *loop = p->loop + f->first;
    double middle[DIM] = { 0 }, u[3], v[3];

    if (!a)
        return STATUS_FAILED;
    frame_of(f, u, v);
    for (int i = 0; i < f->corners; i++)
        for (int d = 0; d < DIM; d++)
            middle[d] += p->x[loop[i]][d] / f->corners;
    for (int i = 0; i < f->corners; i++) {
        double along = 0, aside = 0;
        for (int d = 0; d < DIM; d++) {
            along += u[d] * (p->x[loop[i]][d] - middle[d]);
            aside += v[d] * (p->x[loop[i]][d] - middle[d]);
        }
        a[i] = (struct around){ DIM == 2 ? along : atan2(aside, along), loop[i] };
    }
    qsort(a, (size_t)f->corners, sizeof *a, by_angle);
    for (int i = 0; i < f->corners; i++)
        loop[i] = a[i].corner;
    free(a);
    return STATUS_DONE;
}

/* Every edge is in the loops of two faces, once each way round. */
static void list_edges(struct polytope *p)
{
    for (int i = 0; i < p->faces && DIM == 3; i++)
        for (int k = 0; k < p->face[i].corners; k++) {
            const int *loop = p->loop + p->face[i].first;
            const int a = loop[k], b = loop[(k + 1) % p->face[i].corners];
            if (a < b) {
                p->edge[p->edges][0] = a;
                p->edge[p->edges++][1] = b;
            }
        }
}

static int read_faces(qhT *qh, const int *number, struct polytope *out)
{
    facetT *facet;
    vertexT *vertex, **vertexp;
    int used = 0;

    FORALLfacets {
        struct polytope_face *f = &out->face[out->faces++];
        *f = (struct polytope_face){ .offset = -facet->offset, .first = used };
        for (int d = 0; d < DIM; d++)
            f->normal[d] = facet->normal[d];
        FOREACHvertex_(facet->vertices)
            out->loop[used++] = number[qh_pointid(qh, vertex->point)];
        f->corners = used - f->first;
        TRY(sort_face(out, f));
    }
    list_edges(out);
    return STATUS_DONE;
}

/* Corners in the order of the points, so that the same points give the same polytope. */
static void read_corners(qhT *qh, const double (*x)[DIM], int n, int *number, struct polytope *out)
{
    vertexT *vertex;

    for (int i = 0; i < n; i++)
        number[i] = -1;
    FORALLvertices
        number[qh_pointid(qh, vertex->point)] = 0;
    for (int i = 0; i < n; i++)
        if (number[i] == 0) {
            memcpy(out->x[out->corners], x[i], sizeof *x);
            number[i] = out->corners++;
        }
}

static int read_hull(qhT *qh, const double (*x)[DIM], int n, struct polytope *out)
{
    int *number = status_alloc((size_t)n + 1, sizeof *number);
    facetT *facet;
    int loop = 0, code = number ? STATUS_DONE : STATUS_FAILED;

    FORALLfacets
        loop += qh_setsize(qh, facet->vertices);
    if (code == STATUS_DONE)
        code = take(out, qh->num_vertices, qh->num_facets, loop, loop);
    if (code == STATUS_DONE) {
        read_corners(qh, x, n, number, out);
        code = read_faces(qh, number, out);
    }
    free(number);
    return code;
}

/* Corners of a polygon in turn, as its edges lead from one to the next. */
static int order_corners(struct polytope *p)
{
    double (*x)[DIM] = status_alloc((size_t)p->corners + 1, sizeof *x);
    int at = 0;

    if (!x)
        return STATUS_FAILED;
    for (int i = 0; i < p->corners; i++) {
        int next = 0;
        memcpy(x[i], p->x[at], sizeof *x);
        for (int k = 0; k < p->faces; k++)
            if (p->loop[2 * k] == at)
                next = k;
        at = p->loop[2 * next + 1];
    }
    for (int i = 0; i < p->corners; i++) {
        const double *a = x[i], *b = x[(i + 1) % p->corners];
        const double length = hypot(b[0] - a[0], b[1] - a[1]);
        p->loop[2 * i] = i;
        p->loop[2 * i + 1] = (i + 1) % p->corners;
        p->face[i] = (struct polytope_face){ { (b[1] - a[1]) / length, (a[0] - b[0]) / length },
                                             (a[0] * b[1] - a[1] * b[0]) / length, 2 * i, 2 };
    }
    memcpy(p->x, x, (size_t)p->corners * sizeof *x);
    free(x);
    return STATUS_DONE;
}

/* What Qhull has to say of points in a plane goes nowhere: the caller says it better. */
int polytope_hull(const double (*x)[DIM], int n, struct polytope *out)
{
    FILE *nowhere = fopen("/dev/null", "w");
    double *points = status_alloc((size_t)n * DIM + 1, sizeof *points);
    int code = STATUS_FAILED, left, pieces;
    qhT qh;

    *out = (struct polytope){ .x = NULL };
    if (nowhere && points) {
        char command[] = "qhull";
        memcpy(points, x, (size_t)n * sizeof *x);
        qh_zero(&qh, nowhere);
        code = n <= DIM || qh_new_qhull(&qh, DIM, n, points, False, command, NULL, nowhere)
             ? STATUS_DONE : read_hull(&qh, (const double (*)[DIM])points, n, out);
        qh.NOerrexit = True;
        qh_freeqhull(&qh, !qh_ALL);
        qh_memfreeshort(&qh, &left, &pieces);
    }
    if (code == STATUS_DONE && DIM == 2 && out->corners > 0)
        code = order_corners(out);
    if (nowhere)
        fclose(nowhere);
    else
        code = status_fail(STATUS_IO, "cannot open /dev/null, where Qhull writes to");
    free(points);
    if (code != STATUS_DONE)
        polytope_free(out);
    return code;
}
