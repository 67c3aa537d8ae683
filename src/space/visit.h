/* visit.h -- the traversal of pairs: all that adds up over pairs goes this way.
 *
 * Threads take chunks of groups, a function of the client visits each group:
 *
 *     visit_chunks(list, kinds, function, job);
 *
 *     struct visit v = visit_group(list, g);
 *     if (!visit_is_idle(&v))   (owners of such a group are not fetched in vain)
 *         gather_side(record, v.first, v.end, list->listed, &a);
 *     while (visit_segment(&v, partners))
 *         while (visit_rows(&v, record, needs, kernel, &a, &b))
 *             ... add what the rows of b give to sums of the client
 *     visit_write(&v, width, sums, to);
 *
 * A client with numbers of its own for each row, in the order of the list, finds those of
 * the rows at hand from visit_row(&v) on; entries of neighbours are in v.j.  A client that
 * needs no geometry calls no visit_rows(): v.j and v.segment->rows are those of the
 * whole segment.
 *
 * A lane adds up its own neighbours in the order of the list, and groups write to places
 * of their own: no bit depends on the number of threads nor on the lane width.  All is
 * copied into the client, where width, needs and NULL are constants. */
#ifndef SPACE_VISIT_H
#define SPACE_VISIT_H

#include "space/fetch.h"
#include "space/gather.h"
#include "space/list.h"

enum {
    VISIT_CHUNK = 128, /* slots of one kind, one after the other on one thread */
    VISIT_GROUPS = VISIT_CHUNK / LANES,
    VISIT_ALL = (1 << KINDS) - 1 /* all kinds, KIND_BITs                     */
};

/* Groups from..to-1, all of one kind; b is the thread's, for blocks of rows. */
typedef void visit_chunk(const void *job, int chunk, int from, int to, struct block *b);

/* How many chunks there are of owners of these kinds (KIND_BITs). */
#define visit_count LANE_NAME(visit_count)
int visit_count(const struct list *list, unsigned kinds);

/* Calls function(job, ...) for all of them, chunk 0.. of visit_count(); threads begin with
 * equal shares of rows, and help those that are behind. */
#define visit_chunks LANE_NAME(visit_chunks)
void visit_chunks(const struct list *list, unsigned kinds, visit_chunk *function,
                  const void *job);

/* The same where a row costs cost[kind of its owners]: so are shares weighed. */
#define visit_shares LANE_NAME(visit_shares)
void visit_shares(const struct list *list, unsigned kinds, const int *cost,
                  visit_chunk *function, const void *job);

/* A group under way. */
struct visit {
    int kind;                           /* enum kind of the owners              */
    int first, end;                     /* their first slot; of their kind, the slot
                                           after the last                       */
    const struct list_segment *segment; /* at hand                              */
    const int *j;                       /* [rows at hand][LANES] entries          */
    const struct list_segment *next, *last;
    size_t row, after;                  /* rows of the list before this segment, before
                                           the next                             */
    int done;                           /* rows of the segment that were at hand */
};

LANES_INLINE struct visit visit_group(const struct list *list, int g)
{
    const int kind = list->group_kind[g];

    return (struct visit){
        .kind = kind,
        .first = list->group_slot[g],
        .end = list->start[kind + 1],
        .next = list->segment + list->segment_from[g],
        .last = list->segment + list->segment_from[g + 1],
        .after = (size_t)list->rows_before[g],
    };
}

/* Does no owner have a neighbour, as in groups that other ranks own? */
LANES_INLINE bool visit_is_idle(const struct visit *v)
{
    return v->next == v->last;
}

/* Owners in the group, at most LANES. */
LANES_INLINE int visit_owners(const struct visit *v)
{
    return v->end - v->first < LANES ? v->end - v->first : LANES;
}

/* On to the next segment whose partners are of these kinds; false: there is none. */
LANES_INLINE bool visit_segment(struct visit *v, unsigned partners)
{
    while (v->next < v->last) {
        v->segment = v->next++;
        v->row = v->after;
        v->after += (size_t)v->segment->rows;
        v->j = v->segment->j;
        v->done = 0;
        if (partners & KIND_BIT(v->segment->partner))
            return true;
    }
    return false;
}

/* On to the next rows of the segment: fills b with all that `needs` (NEED_ bits) ask for,
 * what the kernel gives only with a kernel.  False: there are none. */
LANES_INLINE bool visit_rows(struct visit *v, const double *record, unsigned needs,
                             const struct kernel_use *kernel, const struct side *a,
                             struct block *b)
{
    const int left = v->segment->rows - v->done;

    if (left <= 0)
        return false;
    b->n = left < PAIRS_ROWS ? left : PAIRS_ROWS;
    v->j = v->segment->j + (size_t)v->done * LANES;
    v->done += b->n;
    gather_choose(needs)(record, v->j, b->n, a, b);
    if (kernel)
        gather_kernel(needs, kernel, b);
    return true;
}

/* Rows of the list before those at hand. */
LANES_INLINE size_t visit_row(const struct visit *v)
{
    return v->row + (size_t)(v->j - v->segment->j) / LANES;
}

/* Values [width] of the owners, lanes beyond have the dummy's; as fetch_values(). */
LANES_INLINE void visit_own(const struct visit *v, int dummy, const double *value, int width,
                            lanes *own)
{
    int j[LANES];

    for (int l = 0; l < LANES; l++)
        j[l] = list_entry(v->first + l < v->end ? v->first + l : dummy);
    fetch_values(value, j, width, own);
}

/* Sums [width] of the owners go to their slots: to [slots][width]. */
LANES_INLINE void visit_write(const struct visit *v, int width, const lanes *sum, double *to)
{
    const int owners = visit_owners(v);

    for (int l = 0; l < owners; l++)
        for (int d = 0; d < width; d++)
            to[(size_t)(v->first + l) * (size_t)width + (size_t)d] = sum[d][l];
}

/* Kinds of `kinds` that own nothing: 0 to their slots, to [slots][width]. */
#define visit_clear LANE_NAME(visit_clear)
void visit_clear(const struct list *list, unsigned kinds, int width, double *to);

#endif
