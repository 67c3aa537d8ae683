/* list-memory.c -- how the arrays of a pair list grow, and how large they are. */
#include "space/list-private.h"

#include "base/status.h"

#include <stdint.h>
#include <stdlib.h>

bool list_grow(void **array, size_t *room, size_t want, size_t size)
{
    if (want <= *room)
        return true;
    size_t now = *room + *room / 2;
    if (now < want)
        now = want;
    void *bigger = now <= SIZE_MAX / size ? realloc(*array, now * size) : NULL;
    if (!bigger)
        return false;
    *array = bigger;
    *room = now;
    return true;
}

int list_no_memory(const struct list *list)
{
    return status_starved("the pair list of %d particles cannot be had: they are too many for "
                          "this machine, or have drawn together in one place", list->n);
}

/* Positions, order and places, and blocks of them (drift.h) and cells of a particle or two; a group is of
 * four, mostly, and has a segment or two, each noted twice. Where something is periodic also what images.h
 * says, and offsets. */
double list_bytes(double n, double slots, double entries)
{
    const double group = 2 * sizeof(int) + sizeof(int) + sizeof(long)
                       + 1.5 * (sizeof(struct list_segment) + sizeof(struct list_found));
    const double place = DIM * sizeof(double), turns = DIM * sizeof(int), grids = 8;
    const double images = slots > n ? n * (place + turns) + slots * place
                                          + (slots - n) * sizeof(struct image)
                                    : 0;

    return entries * sizeof(int) + n * (place + sizeof(int) + group / 4) + images
         + slots * ((1 + LIST_WORDS + 3) * sizeof(int) + place + grids);
}
