/* polytope-measure.c -- how deep a place is in a polytope, what of it is near, how large it is. */
#include "shapes/polytope.h"

#include <math.h>
#include <string.h>

static double dot(const double *a, const double *b)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

double polytope_depth(const struct polytope *p, const double *x)
{
    double least = p->faces > 0 ? HUGE_VAL : -HUGE_VAL;

    for (int i = 0; i < p->faces; i++)
        least = fmin(least, p->face[i].offset - dot(p->face[i].normal, x));
    return least;
}

double polytope_reach(const struct polytope *p)
{
    double most = 0;

    for (int i = 0; i < p->corners; i++)
        most = fmax(most, dot(p->x[i], p->x[i]));
    return sqrt(most);
}

void polytope_tell(struct polytope *p, const double *origin, double (*const R)[DIM])
{
    for (int i = 0; i < p->corners + p->faces; i++) {
        double *v = i < p->corners ? p->x[i] : p->face[i - p->corners].normal, own[DIM] = { 0 };
        if (i >= p->corners)
            p->face[i - p->corners].offset -= dot(v, origin);
        for (int k = 0; k < DIM; k++)
            for (int d = 0; d < DIM; d++)
                own[k] += R[d][k] * (v[d] - (i < p->corners ? origin[d] : 0));
        memcpy(v, own, sizeof own);
    }
}

/* The nearer of `to`, `least` away (squared), and the point of a..b that is nearest to x. */
static void try_edge(const double *a, const double *b, const double *x, double *to, double *least)
{
    double e[DIM], r[DIM], at[DIM], square = 0;

    for (int d = 0; d < DIM; d++) {
        e[d] = b[d] - a[d];
        r[d] = x[d] - a[d];
    }
    const double ee = dot(e, e), along = ee > 0 ? fmin(fmax(dot(e, r) / ee, 0), 1) : 0;
    for (int d = 0; d < DIM; d++) {
        at[d] = a[d] + along * e[d];
        square += (x[d] - at[d]) * (x[d] - at[d]);
    }
    if (square < *least) {
        *least = square;
        memcpy(to, at, sizeof at);
    }
}

#if DIM == 3
/* Is x, in the plane of the face, to the left of its edge a..b seen from outside? */
static bool is_left(const double *n, const double *a, const double *b, const double *x)
{
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum += n[i] * ((b[j] - a[j]) * (x[k] - a[k]) - (b[k] - a[k]) * (x[j] - a[j]));
    }
    return sum >= 0;
}
#endif

/* Of a face that x is `out` [m] in front of. */
static void try_face(const struct polytope *p, const struct polytope_face *f, const double *x,
                     double out, double *to, double *least)
{
    const int *loop = p->loop + f->first;

    (void)out;
    for (int k = 0; k < f->corners; k++)
        try_edge(p->x[loop[k]], p->x[loop[(k + 1) % f->corners]], x, to, least);
#if DIM == 3
    double at[DIM];
    bool in = out * out < *least;
    for (int d = 0; d < DIM; d++)
        at[d] = x[d] - out * f->normal[d];
    for (int k = 0; k < f->corners && in; k++)
        in = is_left(f->normal, p->x[loop[k]], p->x[loop[(k + 1) % f->corners]], at);
    if (!in)
        return;
    *least = out * out;
    memcpy(to, at, sizeof at);
#endif
}

void polytope_nearest(const struct polytope *p, const double *x, double *to)
{
    double least = HUGE_VAL;

    memcpy(to, p->faces > 0 ? x : p->x[0], DIM * sizeof *to);
    for (int i = 0; i < p->faces; i++) {
        const double out = dot(p->face[i].normal, x) - p->face[i].offset;
        if (out > 0)
            try_face(p, &p->face[i], x, out, to, &least);
    }
    for (int i = 0; i < p->edges && p->faces == 0; i++)
        try_edge(p->x[p->edge[i][0]], p->x[p->edge[i][1]], x, to, &least);
}

/* Adds the simplex of the origin and corners of a face; `big` is DIM! times its volume. */
static void add_simplex(const double *const *corner, double big, struct polytope_moments *to)
{
    double sum[DIM] = { 0 };

    for (int k = 0; k < DIM; k++)
        for (int d = 0; d < DIM; d++)
            sum[d] += corner[k][d];
    to->volume += big / (DIM == 2 ? 2 : 6);
    for (int i = 0; i < DIM; i++) {
        to->centre[i] += sum[i] * big / (DIM == 2 ? 6 : 24);
        for (int j = 0; j < DIM; j++) {
            double products = sum[i] * sum[j];
            for (int k = 0; k < DIM; k++)
                products += corner[k][i] * corner[k][j];
            to->second[i][j] += products * big / (DIM == 2 ? 24 : 120);
        }
    }
}

static double determinant(const double *const *x)
{
#if DIM == 2
    return x[0][0] * x[1][1] - x[0][1] * x[1][0];
#else
    double sum = 0;

    for (int i = 0; i < 3; i++)
        sum += x[0][i] * (x[1][(i + 1) % 3] * x[2][(i + 2) % 3]
                          - x[1][(i + 2) % 3] * x[2][(i + 1) % 3]);
    return sum;
#endif
}

/* Simplices from a corner of the polytope, so that no place far from the origin costs digits. */
void polytope_moments(const struct polytope *p, struct polytope_moments *to)
{
    *to = (struct polytope_moments){ .volume = 0 };
    for (int i = 0; i < p->faces; i++) {
        const int *loop = p->loop + p->face[i].first;
        for (int k = DIM - 1; k < p->face[i].corners; k++) {
            double x[DIM][DIM];
            const double *corner[DIM];
            for (int c = 0; c < DIM; c++) {
                const double *from = p->x[loop[c == 0 ? 0 : k - DIM + 1 + c]];
                corner[c] = x[c];
                for (int d = 0; d < DIM; d++)
                    x[c][d] = from[d] - p->x[0][d];
            }
            add_simplex(corner, determinant(corner), to);
        }
    }
    for (int i = 0; i < DIM && to->volume > 0; i++)
        to->centre[i] /= to->volume;
    for (int i = 0; i < DIM; i++)
        for (int j = 0; j < DIM; j++)
            to->second[i][j] -= to->volume * to->centre[i] * to->centre[j];
    for (int i = 0; i < DIM && p->corners > 0; i++)
        to->centre[i] += p->x[0][i];
}

double polytope_face_area(const struct polytope *p, const struct polytope_face *f)
{
    double sum = 0;

    for (int k = 0; k < f->corners; k++) {
        const double *a = p->x[p->loop[f->first + k]];
        const double *b = p->x[p->loop[f->first + (k + 1) % f->corners]];
        if (DIM == 2)
            return hypot(b[0] - a[0], b[1] - a[1]);
        for (int i = 0; i < DIM; i++) {
            const int j = (i + 1) % DIM, l = (i + 2) % DIM;
            sum += 0.5 * f->normal[i] * (a[j] * b[l] - a[l] * b[j]);
        }
    }
    return sum;
}

double polytope_surface(const struct polytope *p)
{
    double sum = 0;

    for (int i = 0; i < p->faces; i++)
        sum += polytope_face_area(p, &p->face[i]);
    return sum;
}
