/* list-written.c -- how much of a list's arrays is written, as it stands. */
#include "space/list-private.h"

#include "base/pages.h"

static double stores_written(const struct list_private *own)
{
    double bytes = 0;

    for (int t = 0; t < own->stores; t++)
        bytes += (double)own->store[t].used * sizeof(int) + (double)own->store[t].founds * sizeof(struct list_found);
    return bytes;
}

static double cells_written(const struct list_private *own)
{
    double bytes = 0;

    for (int k = 0; k < KINDS; k++)
        bytes += (double)(own->cells[k].room + own->image_cells[k].room) * sizeof(int);
    return bytes;
}

static double images_written(const struct list *list)
{
    const struct images *i = &list->own->images;
    const double place = DIM * sizeof(double), turns = DIM * sizeof(int);

    return i->home ? list->n * (place + turns) + list->listed * place + (double)i->room * sizeof *i->all : 0;
}

double list_written(const struct list *list)
{
    const double group = 3 * sizeof(int) + sizeof(long), place = (1 + LIST_WORDS) * sizeof(int);
    const struct list_private *own = list->own;

    return list->n * (double)sizeof(int) + list->listed * place + list->groups * group
           + list->segment_from[list->groups] * (double)sizeof(struct list_segment)
           + pages_bytes(0, list->listed, list->order, DIM * sizeof *own->built) + stores_written(own)
           + cells_written(own) + images_written(list) + drift_written(list);
}
