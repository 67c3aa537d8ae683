/* images.h -- directions that repeat: particles are brought into the domain, and what
 * stands near a periodic side is seen beyond the opposite one, too.
 *
 * A pair is listed when an owner in the domain and a partner, or one of the partner's
 * images, are closer than support + margin. */
#ifndef SPACE_IMAGES_H
#define SPACE_IMAGES_H

#include "space/kinds.h"
#include <stdbool.h>
#include <stddef.h>

struct list;
struct list_bounds;
struct list_def;

struct image {
    int of, rank;          /* row of the original; cell                      */
    int turns[DIM];        /* lengths from its position to the image         */
    double at[DIM];        /* where the image stands                   [m]   */
};

/* Starts as { 0 } and stays so where nothing is periodic. */
struct images {
    double low[DIM], high[DIM]; /* what is between is not near a periodic side [m] */
    double (*home)[DIM];   /* [particles] positions in the domain      [m]   */
    int (*turns)[DIM];     /* [particles] lengths that were added for it     */
    int n;
    struct image *all;     /* [n] those of kind k by ascending id: from[k] ..  */
    int from[KINDS + 1];
    size_t room;
};

/* Is any direction periodic? */
bool images_any(const struct list_def *def);

/* Takes the memory that does not change with time; 0 or STATUS_FAILED. */
int images_create(struct list *list);
void images_free(struct images *images);

/* Are there images near the box low..high? */
static inline bool images_near(const struct images *images, const double *low,
                               const double *high)
{
    for (int d = 0; d < DIM; d++)
        if (low[d] < images->low[d] || high[d] > images->high[d])
            return true;
    return false;
}

/* Before sorting: where each particle stands in the domain. */
void images_bring_home(const struct list *list, const struct cloud *cloud);

/* Widens a box by the images of a particle at x in a row that is in the domain. */
void images_widen(const struct list *list, const double *x, int row, struct list_bounds *to);

/* After cells_sort(): images, their places, grids, offsets. 0 or STATUS_FAILED (no memory). */
int images_sort(struct list *list, const struct cloud *cloud);

#endif
