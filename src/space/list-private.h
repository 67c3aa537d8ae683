/* list-private.h -- what the files of the pair list share. */
#ifndef SPACE_LIST_PRIVATE_H
#define SPACE_LIST_PRIVATE_H

#include "space/cells.h"
#include "space/drift.h"
#include "space/images.h"
#include "space/list.h"

enum {
    LIST_PAD = 64,              /* positions are read so far beyond the last   */
    LIST_UNITS = 1 << 13,       /* of positions in support + margin            */
    LIST_WORDS = (DIM + 1) / 2  /* of two coordinates each                     */
};

/* The rows one thread made; what a thread needs to make them. */
struct list_store {
    int from;              /* first group of this thread                     */
    int *j;                /* [room] rows                                    */
    size_t used, room;     /* entries                                        */
    struct list_found *found;
    size_t founds, found_room;
    int *near;             /* [lanes][near_room] neighbours of one group     */
    size_t near_room;
    bool failed;           /* out of memory                                  */
};

/* A segment whose rows may still move in memory. */
struct list_found {
    int partner, rows;
    size_t at; /* first entry in its store                                   */
};

struct list_private {
    double *built;      /* [n][DIM] position at the last rebuild [m];
                           infinite for those left out; of those that are here */
    int *place[LIST_WORDS]; /* [listed + LIST_PAD] the same by place and in
                           units, two coordinates modulo 2^16 in a word      */
    const double *stand; /* [n][DIM] where all stood then, as the list sees
                            it: built, or own->images.home                   */
    size_t order_room, place_room[LIST_WORDS], offset_room;
    double per_metre;   /* units of a place                         [1/m]    */
    unsigned sorted;    /* kinds whose places are those of `built`, KIND_BITs */
    struct cells cells[KINDS];
    struct cells image_cells[KINDS];
    struct images images;
    struct drift drift;
    int stores;
    struct list_store *store; /* [stores]                                    */
    int *group_slot, *group_kind, *segment_from;
    long *rows_before;
    struct list_segment *segment;
    size_t segment_room;
};

/* A list whose rows are `lanes` wide. */
int list_create(struct list **list, const struct list_def *def, int lanes);
void list_free(struct list **list);
bool list_stale(const struct list *list, const struct cloud *cloud);

/* Makes the list right; `rows` makes the rows of the stores for one thread's
 * groups from..to-1. */
typedef void list_rows(struct list *list, struct list_store *store, int from, int to);
int list_update(struct list *list, const struct cloud *cloud, list_rows *rows);
int list_rebuild(struct list *list, const struct cloud *cloud, list_rows *rows);
int list_rearrange(struct list *list, const int *const from[KINDS],
                   const int *const row[KINDS], list_rows *rows);

/* Do particles of this kind stand where they stood when the list was made?  Not asked where a list has all
 * particles, and a rank owns some of them. */
static inline bool list_is_still(const struct list *list, int kind)
{
    return (list->def.still & KIND_BIT(kind)) && (!list->mine || list->whole);
}

/* All count as left out: before the first build, and where some will be that were not, as they are not
 * here any more.  A list that has a part of the particles never asks where they were. */
void list_leave_out(struct list *list);

/* Where rows of a kind stand as the list sees them, [rows of the kind][DIM]. */
static inline const double *list_homes(const struct list *list, const struct cloud *cloud, int kind)
{
    return list->own->images.home ? list->own->images.home[list->def.from[kind]] : cloud->x[kind];
}

/* Room for `want` entries in all in an array that grows by half at least;
 * false without memory, the array is as it was. */
bool list_grow(void **array, size_t *room, size_t want, size_t size);

/* The failure that goes with it; for one thread at a time. */
int list_no_memory(const struct list *list);

#endif
