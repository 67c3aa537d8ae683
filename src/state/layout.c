/* layout.c -- which numbers of y mean what: offsets, weights, names. */
#include "state/layout.h"

#include "base/status.h"
#include <stddef.h>
#include <string.h>

static const double unseen = 1e-12; /* weight of what no error test shall see */

static int refuse(const char *name, const char *why)
{
    status_fail(STATUS_FAILED, "the state vector cannot take the block \"%s\": %s", name, why);
    return -1;
}

int layout_add(struct layout *l, enum layout_class what, const char *name, const char *unit,
               int n, int components, double scale)
{
    struct layout_row *row = &l->row[l->rows];

    if (l->rows == LAYOUT_ROWS)
        return refuse(name, "it has as many blocks as it has room for (LAYOUT_ROWS in layout.h)");
    if (strlen(name) >= sizeof row->name)
        return refuse(name, "its name is too long");
    if (n < 0 || components < 1)
        return refuse(name, "its size is negative or it has no components");
    if (!(scale >= 0))
        return refuse(name, "its error scale is negative or not a number");
    *row = (struct layout_row){ .unit = unit, .what = what, .n = n, .components = components,
                                .scale = scale };
    strcpy(row->name, name);
    return l->rows++;
}

static long length(const struct layout_row *row)
{
    return (long)row->n * row->components;
}

void layout_done(struct layout *l)
{
    long next = 0;

    for (int c = 0; c < LAYOUT_CLASSES; c++) {
        l->from[c] = next;
        for (int i = 0; i < l->rows; i++)
            if ((int)l->row[i].what == c) {
                l->row[i].offset = next;
                next += length(&l->row[i]);
            }
    }
    l->from[LAYOUT_CLASSES] = next;
}

long layout_size(const struct layout *l)
{
    return l->from[LAYOUT_CLASSES];
}

long layout_at(const struct layout *l, int row)
{
    return l->row[row].offset;
}

void layout_weights(const struct layout *l, double tol, const int *rows, double *weight)
{
    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *row = &l->row[i];
        const double w = row->scale > 0 ? 1 / (tol * row->scale) : unseen;

        for (long k = 0; k < (rows ? (long)rows[i] * row->components : length(row)); k++)
            weight[row->offset + k] = w;
    }
}

const struct layout_row *layout_find(const struct layout *l, long i, int *which)
{
    for (int r = 0; r < l->rows; r++) {
        const struct layout_row *row = &l->row[r];

        if (i >= row->offset && i < row->offset + length(row)) {
            *which = (int)((i - row->offset) / row->components);
            return row;
        }
    }
    return NULL;
}
