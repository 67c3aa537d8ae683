/* contact-cells.c -- which of many points are near a place: a grid of cells over them all. */
#include "walls/contact-cells.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>

static int cell_along(const struct contact_cells *c, int d, double x)
{
    const double k = floor((x - c->low[d]) / c->width);

    return (int)fmin(fmax(k, 0), c->count[d] - 1);
}

static long cell_of(const struct contact_cells *c, const double *x)
{
    long cell = 0;

    for (int d = DIM - 1; d >= 0; d--)
        cell = cell * c->count[d] + cell_along(c, d, x[d]);
    return cell;
}

/* Cells no narrower than reach, and not many more than points. */
static long lay_out(struct contact_cells *c, int n, double reach)
{
    double high[DIM];
    long cells;

    for (int d = 0; d < DIM; d++) {
        c->low[d] = HUGE_VAL;
        high[d] = -HUGE_VAL;
        for (int i = 0; i < n; i++) {
            c->low[d] = fmin(c->low[d], c->x[i][d]);
            high[d] = fmax(high[d], c->x[i][d]);
        }
    }
    c->width = reach;
    do {
        double all = 1;
        for (int d = 0; d < DIM; d++)
            all *= floor((high[d] - c->low[d]) / c->width) + 1;
        if (all < 4.0 * n + 1000)
            break;
        c->width *= 2;
    } while (true);
    cells = 1;
    for (int d = 0; d < DIM; d++) {
        c->count[d] = n > 0 ? (int)floor((high[d] - c->low[d]) / c->width) + 1 : 1;
        cells *= c->count[d];
    }
    return cells;
}

int contact_cells_create(struct contact_cells *c, const struct scales *s,
                         const double (*x)[DIM], int n, double reach)
{
    long cells;

    *c = (struct contact_cells){ .scales = s, .x = x, .reach = reach };
    cells = n > 0 ? lay_out(c, n, reach) : 0;
    c->start = status_alloc((unsigned long)cells + 2, sizeof *c->start);
    c->member = status_alloc((unsigned long)n + 1, sizeof *c->member);
    if (!c->start || !c->member) {
        contact_cells_free(c);
        return STATUS_FAILED;
    }
    for (int i = 0; i < n; i++)
        c->start[cell_of(c, x[i])]++;
    for (long k = 0; k < cells; k++)
        c->start[k + 1] += c->start[k];
    for (int i = n - 1; i >= 0; i--)
        c->member[--c->start[cell_of(c, x[i])]] = i;
    return STATUS_DONE;
}

void contact_cells_free(struct contact_cells *c)
{
    free(c->start);
    free(c->member);
    c->start = c->member = NULL;
}

static void see_cell(const struct contact_cells *c, long cell, const double *x,
                     contact_cells_see *see, void *self)
{
    const double farthest = c->reach * c->reach * (1 + 1e-9); /* whatever rounding does */

    for (int m = c->start[cell]; m < c->start[cell + 1]; m++) {
        double step[DIM], r2 = 0;
        for (int d = 0; d < DIM; d++) {
            step[d] = c->x[c->member[m]][d] - x[d];
            r2 += step[d] * step[d];
        }
        if (r2 <= farthest)
            see(self, c->member[m], sqrt(r2), step);
    }
}

/* The cells around one image of the place. */
static void see_around(const struct contact_cells *c, const double *x, contact_cells_see *see,
                       void *self)
{
    int low[3] = { 0 }, high[3] = { 0 };

    for (int d = 0; d < DIM; d++) {
        if (x[d] + c->width < c->low[d] || x[d] > c->low[d] + (c->count[d] + 1) * c->width)
            return;
        low[d] = cell_along(c, d, x[d] - c->width);
        high[d] = cell_along(c, d, x[d] + c->width);
    }
    for (int k = low[2]; k <= high[2]; k++)
        for (int j = low[1]; j <= high[1]; j++)
            for (int i = low[0]; i <= high[0]; i++)
                see_cell(c, ((long)k * c->count[1] + j) * c->count[0] + i, x, see, self);
}

/* Along d and those after it: the place itself, and its images a length away. */
static void see_images(const struct contact_cells *c, int d, double *x, contact_cells_see *see,
                       void *self)
{
    if (d == DIM) {
        see_around(c, x, see, self);
        return;
    }
    const double length = c->scales->period[d], here = x[d];
    for (int image = length > 0 ? -1 : 0; image <= (length > 0 ? 1 : 0); image++) {
        x[d] = here + image * length;
        see_images(c, d + 1, x, see, self);
    }
    x[d] = here;
}

void contact_cells_visit(const struct contact_cells *c, const double *x,
                         contact_cells_see *see, void *self)
{
    double at[DIM];

    for (int d = 0; d < DIM; d++)
        at[d] = x[d];
    if (c->count[0] > 0)
        see_images(c, 0, at, see, self);
}
