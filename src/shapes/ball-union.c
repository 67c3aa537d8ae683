/* ball-union.c -- what discs or balls of one radius fill together, by lines through them. */
#include "shapes/ball-union.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { UP = DIM - 1, LINES = DIM == 2 ? 40000 : 300 }; /* across each of the other axes */

static const double grown = 5e-3; /* of the radius, for the surface */

struct piece {
    double from, to;
};

static int by_start(const void *a, const void *b)
{
    const double x = ((const struct piece *)a)->from, y = ((const struct piece *)b)->from;

    return (x > y) - (x < y);
}

/* What of a line is in balls; returns how many pieces. */
static int cut(const double (*x)[DIM], int n, double radius, const double *line, struct piece *piece)
{
    int count = 0;

    for (int i = 0; i < n; i++) {
        double rest = radius * radius;
        for (int d = 0; d < UP; d++)
            rest -= (x[i][d] - line[d]) * (x[i][d] - line[d]);
        if (rest > 0)
            piece[count++] = (struct piece){ x[i][UP] - sqrt(rest), x[i][UP] + sqrt(rest) };
    }
    qsort(piece, (size_t)count, sizeof *piece, by_start);
    return count;
}

/* One piece of a line that stands for `area`: integrals of 1, x_i, x_i x_j. */
static void add(const double *line, double from, double to, double area, struct polytope_moments *m)
{
    double mean[DIM];
    const double length = area * (to - from);

    memcpy(mean, line, UP * sizeof *mean);
    mean[UP] = 0.5 * (from + to);
    m->volume += length;
    for (int i = 0; i < DIM; i++) {
        m->centre[i] += length * mean[i];
        for (int j = 0; j < DIM; j++)
            m->second[i][j] += length * mean[i] * mean[j];
    }
    m->second[UP][UP] += length * (to - from) * (to - from) / 12;
}

/* Those of a line that overlap are one. */
static void add_line(const double *line, const struct piece *piece, int n, double area,
                     struct polytope_moments *m)
{
    for (int i = 0; i < n;) {
        double end = piece[i].to;
        int k = i + 1;
        for (; k < n && piece[k].from <= end; k++)
            end = fmax(end, piece[k].to);
        add(line, piece[i].from, end, area, m);
        i = k;
    }
}

static void to_centre(struct polytope_moments *m)
{
    for (int d = 0; d < DIM; d++)
        m->centre[d] /= m->volume;
    for (int i = 0; i < DIM; i++)
        for (int j = 0; j < DIM; j++)
            m->second[i][j] -= m->volume * m->centre[i] * m->centre[j];
}

int ball_union_moments(const double (*x)[DIM], int n, double radius, struct polytope_moments *to)
{
    struct piece *piece = status_alloc((size_t)n, sizeof *piece);
    double low[DIM], step[DIM], area = 1;
    int all = 1;

    if (!piece)
        return STATUS_FAILED;
    *to = (struct polytope_moments){ .volume = 0 };
    for (int d = 0; d < UP; d++) {
        double high = -HUGE_VAL;
        low[d] = HUGE_VAL;
        for (int i = 0; i < n; i++) {
            low[d] = fmin(low[d], x[i][d] - radius);
            high = fmax(high, x[i][d] + radius);
        }
        step[d] = (high - low[d]) / LINES;
        area *= step[d];
        all *= LINES;
    }
    for (int i = 0; i < all; i++) {
        double line[DIM] = { 0 };
        for (int d = 0, rest = i; d < UP; d++, rest /= LINES)
            line[d] = low[d] + (rest % LINES + 0.5) * step[d];
        add_line(line, piece, cut(x, n, radius, line, piece), area, to);
    }
    free(piece);
    to_centre(to);
    return STATUS_DONE;
}

int ball_union_surface(const double (*x)[DIM], int n, double radius, double *to)
{
    struct polytope_moments more, less;

    TRY(ball_union_moments(x, n, radius * (1 + grown), &more));
    TRY(ball_union_moments(x, n, radius * (1 - grown), &less));
    *to = (more.volume - less.volume) / (2 * grown * radius);
    return STATUS_DONE;
}
