/* looks-file.c -- surfaces of rigid bodies as plain CSV. */
#include "output/looks-file.h"

#include "base/status.h"
#include "output/aside.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static const double sharp = 0.8; /* cosine: edges of faces that meet at more than 37 degrees show */

/* Corner i of face f, which counts around. */
static const double *corner(const struct cloud_looks *l, int dim, int f, int i)
{
    const int n = l->first[f + 1] - l->first[f];

    return l->x + (size_t)dim * (size_t)l->loop[l->first[f] + i % n];
}

/* Newell's: the sum over edges, of length 1. */
static void normal_of(const struct cloud_looks *l, int f, double *to)
{
    double length;

    to[0] = to[1] = to[2] = 0;
    for (int i = 0; i < l->first[f + 1] - l->first[f]; i++) {
        const double *a = corner(l, 3, f, i), *b = corner(l, 3, f, i + 1);
        for (int d = 0; d < 3; d++)
            to[d] += (a[(d + 1) % 3] - b[(d + 1) % 3]) * (a[(d + 2) % 3] + b[(d + 2) % 3]);
    }
    length = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    for (int d = 0; d < 3; d++)
        to[d] /= length > 0 ? length : 1;
}

static void head(FILE *to, double t, const struct cloud_looks *l)
{
    fprintf(to, "# t = %.12g s; bodies:", t);
    for (int i = 0; i < l->bodies; i++)
        fprintf(to, " %d %s", i, l->name[i]);
    fputc('\n', to);
}

static void face(FILE *to, int dim, const struct cloud_looks *l, int f)
{
    double n[3] = { 0 };

    if (dim == 3)
        normal_of(l, f, n);
    for (int i = 0; i <= l->first[f + 1] - l->first[f]; i++) {
        const double *x = corner(l, dim, f, i);
        for (int d = 0; d < dim; d++)
            fprintf(to, "%.10g,", x[d]);
        for (int d = 0; d < dim && dim == 3; d++)
            fprintf(to, "%.6g,", n[d]);
        fprintf(to, "%d\n", l->of[f]);
    }
    fputs(f + 1 < l->faces && l->of[f + 1] != l->of[f] ? "\n\n" : "\n", to);
}

int looks_file_write(const char *path, int dim, double t, const struct cloud_looks *looks)
{
    struct aside a;

    TRY(aside_open(&a, path));
    head(a.to, t, looks);
    fprintf(a.to, dim == 2 ? "# units: m,m,\nx,y,body\n" : "# units: m,m,m,,,,\nx,y,z,nx,ny,nz,body\n");
    for (int f = 0; f < looks->faces; f++)
        face(a.to, dim, looks, f);
    return aside_close(&a);
}

/* --- points --------------------------------------------------------------------------- */

struct edge {
    int low, high, face; /* its corners, and the face beside it */
};

static int by_corners(const void *one, const void *two)
{
    const struct edge *a = one, *b = two;

    return a->low != b->low ? (a->low > b->low) - (a->low < b->low)
                            : (a->high > b->high) - (a->high < b->high);
}

static void point(FILE *to, const double *x, const double *n, int edge, int body)
{
    fprintf(to, "%.7g,%.7g,%.7g,%.4g,%.4g,%.4g,%d,%d\n", x[0], x[1], x[2], n[0], n[1], n[2], edge,
            body);
}

static double distance(const double *a, const double *b)
{
    return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

/* Rows along a, b - a and c - a. */
static void triangle(FILE *to, const double *a, const double *b, const double *c, double step,
                     const double *n, int body)
{
    const int rows = (int)ceil(distance(a, b) / step), columns = (int)ceil(distance(a, c) / step);

    for (int i = 0; i < rows; i++)
        for (int k = 0; k < columns; k++) {
            const double p = (i + 1 / 3.0) / rows, q = (k + 1 / 3.0) / columns;
            double x[3];
            if (p + q > 1)
                break;
            for (int d = 0; d < 3; d++)
                x[d] = a[d] + p * (b[d] - a[d]) + q * (c[d] - a[d]);
            point(to, x, n, 0, body);
        }
}

static void edge_points(FILE *to, const struct cloud_looks *l, const struct edge *e, double step,
                        const double *n)
{
    const double *a = l->x + 3 * (size_t)e->low, *b = l->x + 3 * (size_t)e->high;
    const int most = (int)ceil(distance(a, b) / step) + 1;

    for (int i = 0; i <= most; i++) {
        double x[3];
        for (int d = 0; d < 3; d++)
            x[d] = a[d] + i * (b[d] - a[d]) / most;
        point(to, x, n, 1, l->of[e->face]);
    }
}

static void edges(FILE *to, const struct cloud_looks *l, struct edge *edge, double step)
{
    int n = 0;

    for (int f = 0; f < l->faces; f++)
        for (int i = l->first[f]; i < l->first[f + 1]; i++) {
            const int a = l->loop[i], b = l->loop[i + 1 < l->first[f + 1] ? i + 1 : l->first[f]];
            edge[n++] = (struct edge){ a < b ? a : b, a < b ? b : a, f };
        }
    qsort(edge, (size_t)n, sizeof *edge, by_corners);
    for (int i = 0; i + 1 < n; i++) {
        double one[3], two[3], both[3];
        if (by_corners(&edge[i], &edge[i + 1]) != 0)
            continue;
        normal_of(l, edge[i].face, one);
        normal_of(l, edge[i + 1].face, two);
        if (one[0] * two[0] + one[1] * two[1] + one[2] * two[2] > sharp)
            continue;
        for (int d = 0; d < 3; d++)
            both[d] = one[d] + two[d];
        edge_points(to, l, &edge[i], step / 3, both);
    }
}

/* --- a cut ------------------------------------------------------------------------------ */

/* Where a face is cut: from one of its edges to another, each by its corners. */
struct piece {
    int end[2][2], body;
    bool used;
};

static double above(const struct cloud_looks *l, int corner, double at)
{
    const double y = l->x[3 * (size_t)corner + 1] - at;

    return y != 0 ? y : 1e-300; /* a corner in the plane is above it */
}

/* The crossings of a face in turn: up to the plane and down from it. */
static int pieces_of(const struct cloud_looks *l, int f, double at, struct piece *to)
{
    int n = 0;

    to->body = l->of[f];
    to->used = false;
    for (int i = l->first[f]; i < l->first[f + 1] && n < 2; i++) {
        const int a = l->loop[i], b = l->loop[i + 1 < l->first[f + 1] ? i + 1 : l->first[f]];
        if ((above(l, a, at) > 0) == (above(l, b, at) > 0))
            continue;
        to->end[n][0] = a < b ? a : b;
        to->end[n++][1] = a < b ? b : a;
    }
    return n == 2;
}

static void crossing(FILE *to, const struct cloud_looks *l, const int *edge, double at, int body)
{
    const double *a = l->x + 3 * (size_t)edge[0], *b = l->x + 3 * (size_t)edge[1];
    const double p = above(l, edge[0], at) / (above(l, edge[0], at) - above(l, edge[1], at));

    fprintf(to, "%.10g,%.10g,%.10g,%d\n", a[0] + p * (b[0] - a[0]), at, a[2] + p * (b[2] - a[2]),
            body);
}

/* The piece that goes on from this edge, which becomes its other edge. */
static int next_piece(struct piece *piece, int n, int *edge)
{
    for (int i = 0; i < n; i++)
        for (int e = 0; e < 2 && !piece[i].used; e++)
            if (piece[i].end[e][0] == edge[0] && piece[i].end[e][1] == edge[1]) {
                piece[i].used = true;
                memcpy(edge, piece[i].end[1 - e], sizeof piece->end[0]);
                return 1;
            }
    return 0;
}

static void outlines(FILE *to, const struct cloud_looks *l, double at, struct piece *piece, int n)
{
    for (int i = 0; i < n; i++) {
        int edge[2];
        if (piece[i].used)
            continue;
        piece[i].used = true;
        crossing(to, l, piece[i].end[0], at, piece[i].body);
        memcpy(edge, piece[i].end[1], sizeof edge);
        do
            crossing(to, l, edge, at, piece[i].body);
        while (next_piece(piece, n, edge));
        fputs("\n", to);
    }
}

int looks_file_write_cut(const char *path, double t, double at, const struct cloud_looks *looks)
{
    struct piece *piece = status_alloc((size_t)looks->faces, sizeof *piece);
    struct aside a;
    int n = 0, code = piece ? aside_open(&a, path) : STATUS_FAILED;

    if (code == STATUS_DONE) {
        head(a.to, t, looks);
        fputs("# units: m,m,m,\nx,y,z,body\n", a.to);
        for (int f = 0; f < looks->faces; f++)
            n += pieces_of(looks, f, at, &piece[n]);
        outlines(a.to, looks, at, piece, n);
        code = aside_close(&a);
    }
    free(piece);
    return code;
}

/* --- all points ------------------------------------------------------------------------- */

/* Skins hide below surfaces. */
void looks_file_add_points(FILE *to, const struct cloud_frame *c)
{
    for (size_t i = 0; i < (size_t)c->here; i++) {
        const int kind = c->kind[(size_t)c->from + i];
        if (kind < 3)
            point(to, c->x + 3 * i, c->u + 3 * i, kind == 0 ? 2 : 3, -1);
    }
}

int looks_file_open_points(struct aside *a, const char *path, double step,
                           const struct cloud_frame *frame)
{
    const struct cloud_looks *looks = frame->looks;
    struct edge *edge = status_alloc((size_t)looks->first[looks->faces], sizeof *edge);
    int code = edge ? aside_open(a, path) : STATUS_FAILED;

    if (code == STATUS_DONE) {
        head(a->to, frame->t, looks);
        fputs("# units: m,m,m,,,,,\nx,y,z,nx,ny,nz,what,body\n", a->to);
        for (int f = 0; f < looks->faces; f++) {
            double n[3];
            normal_of(looks, f, n);
            for (int i = 1; i + 1 < looks->first[f + 1] - looks->first[f]; i++)
                triangle(a->to, corner(looks, 3, f, 0), corner(looks, 3, f, i),
                         corner(looks, 3, f, i + 1), step, n, looks->of[f]);
        }
        edges(a->to, looks, edge, step);
    }
    free(edge);
    return code;
}
