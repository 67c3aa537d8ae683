/* canvas.c -- a buffer of depths: for each point of a picture the nearest disc. */
#include "output/canvas.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>

int canvas_make(struct canvas *c, double left, double right, double bottom, double above,
                double fine)
{
    size_t n;

    *c = (struct canvas){ .left = left, .bottom = bottom, .fine = fine };
    c->across = (int)ceil((right - left) / c->fine) + 1;
    c->up = (int)ceil((above - bottom) / c->fine) + 1;
    n = (size_t)c->across * (size_t)c->up;
    c->depth = status_alloc(n, sizeof *c->depth);
    c->id = status_alloc(n, sizeof *c->id);
    if (!c->depth || !c->id)
        return STATUS_FAILED;
    for (size_t i = 0; i < n; i++)
        c->id[i] = -1;
    return STATUS_DONE;
}

void canvas_disc(struct canvas *c, double x, double y, double r, double depth, int id)
{
    const double at_x = (x - c->left) / c->fine, at_y = (y - c->bottom) / c->fine;
    const double wide = r / c->fine;

    if (!(at_x + wide >= 0 && at_y + wide >= 0 && at_x - wide < c->across && at_y - wide < c->up))
        return;
    const int first = (int)fmax(0, ceil(at_y - wide));
    const int last = (int)fmin(c->up - 1, floor(at_y + wide));
    for (int k = first; k <= last; k++) {
        const double half = sqrt(fmax(0, wide * wide - (k - at_y) * (k - at_y)));
        const int from = (int)fmax(0, ceil(at_x - half));
        const int to = (int)fmin(c->across - 1, floor(at_x + half));
        for (int i = from; i <= to; i++) {
            const size_t point = (size_t)k * (size_t)c->across + (size_t)i;
            if (c->id[point] >= 0 && c->depth[point] > depth)
                continue;
            c->depth[point] = (float)depth;
            c->id[point] = id;
        }
    }
}

void canvas_mark(const struct canvas *c, unsigned char *mark)
{
    const size_t n = (size_t)c->across * (size_t)c->up;

    for (size_t i = 0; i < n; i++)
        if (c->id[i] >= 0)
            mark[c->id[i]] = 1;
}

void canvas_free(struct canvas *c)
{
    free(c->depth);
    free(c->id);
}
