/* fill-private.h -- between the files that fill shapes. */
#ifndef FILL_FILL_PRIVATE_H
#define FILL_FILL_PRIVATE_H

#include "fill/carve.h"

/* Items sorted by kind: item k becomes object k. */
struct filling {
    const struct scales *scales;
    int items;
    struct fill_item *item; /* [items]                    */
    struct points *points;  /* [items] where they stand   */
    struct carve *carved;   /* [items] what fluids left to solids */
};

/* Refuses spacings, fills, places and numbers that cannot be, by shapes alone. */
int fill_check(const struct filling *f, double bytes_fluid, double bytes_solid);

bool fill_in_layers(const struct fill_item *item);

#endif
