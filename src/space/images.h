/* images.h -- directions that repeat: everybody is brought into the domain, and who
 * stands near a periodic side is seen beyond the opposite one, too.
 *
 * A pair is listed when an owner in the domain and a partner, or one of the partner's
 * images, are closer than support + skin. */
#ifndef SPACE_IMAGES_H
#define SPACE_IMAGES_H

#include "space/kinds.h"
#include <stdbool.h>
#include <stddef.h>

struct list;
struct list_def;

/* Starts as { 0 } and stays so where nothing is periodic. */
struct images {
    double (*home)[DIM];   /* [particles] places in the domain         [m]   */
    int (*turns)[DIM];     /* [particles] lengths that were added for it     */
    int n;
    int from[KINDS + 1];   /* images of kind k, in order of creation         */
    int *of;               /* [n] creation index of the original             */
    int (*shift)[DIM];     /* [n] lengths from it to the image: -1, 0 or 1   */
    int *rank;             /* [n] cell                                       */
    size_t of_room, shift_room, rank_room;
};

/* Is any direction periodic? */
bool images_any(const struct list_def *def);

/* Takes the memory that does not change with time; 0 or STATUS_FAILED. */
int images_create(struct list *list);
void images_free(struct images *images);

/* Before sorting: who stands where in the domain. */
void images_bring_home(struct list *list, const struct cloud *cloud);

/* After sorting: slots of images, their grids, all offsets. 0 or STATUS_FAILED (no
 * memory). */
int images_sort(struct list *list, const struct cloud *cloud);

#endif
