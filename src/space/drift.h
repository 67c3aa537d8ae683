/* drift.h -- whether a list is still right although a particle moved further than
 * half its margin.
 *
 * A pair can only be missing when its two moved against each other by more than
 * the margin.  Neighbours in water mostly move along together, so displacements
 * are compared block by block of the domain, and one by one where blocks do not
 * answer. */
#ifndef SPACE_DRIFT_H
#define SPACE_DRIFT_H

#include "space/kinds.h"
#include <stdbool.h>
#include <stddef.h>

struct list;

enum { DRIFT_FARTHEST = 2 }; /* displacement that blocks allow for [margins] */

/* Entries allocated in the arrays of these names. */
struct drift_room {
    size_t block, run, member, row, was, end, count, first, moving, thread, used, range;
};

/* Blocks are so wide that particles that may meet stand in one block or in two that
 * touch.  Starts as { 0 }. */
struct drift {
    double low[DIM];       /* corner of the grid                   [m]       */
    double per_metre[DIM]; /* blocks                               [1/m]     */
    int n[DIM];            /* blocks; the outermost are empty                */
    int *block;            /* [places] where each stood                      */
    int *run;              /* [runs + 1] first places of runs, which have one block and kind;
                              the last is `listed`                           */
    int run_from[2 * KINDS + 1]; /* runs of each kind, then of images of each */
    int *member;           /* [places] places, block by block                */
    int *row;              /* [places] rows of the members                   */
    double (*was)[DIM];    /* [places] where the particles of members were   [m] */
    int *end;              /* [blocks] the first member of the next block    */
    int *count;            /* [blocks] members                               */
    int *first;            /* [blocks] of them, those of the first kind: they come first,
                              unless they are images                         */
    int *moving;           /* [blocks] of them, those that can move: they come before those
                              that stand still                               */
    int *thread;           /* [blocks] of them, the thread that gathers it when it is made; then
                              marks of drift_mark()                          */
    int *used;             /* [useds] blocks that are compared: something can move there, or
                              in one behind that touches it; on many ranks, by this one */
    int useds, mines;      /* of them, the first `mines` with those behind that touch them; the
                              others are asked for their range alone         */
    double *range;         /* [blocks][2][DIM] least and largest displacement [m] */
    bool far;              /* since then one was seen beyond half the margin */
    struct drift_room room;
};

/* Notes where all particles stand, right after sorting. 0 or STATUS_FAILED (no
 * memory). */
int drift_note(struct list *list, const struct cloud *cloud);

/* True when no pair is missing; false when one is, a particle moved further than
 * two margins, or a rebuild costs less than to find out. */
bool drift_harmless(const struct list *list, const struct cloud *cloud);

/* What is wrong with a list. */
enum drift_harm {
    DRIFT_NONE,
    DRIFT_MISSING, /* a pair may be: one is, or a particle went further than two margins */
    DRIFT_NOWHERE  /* a particle is at no place that has a number, or seems to be        */
};

/* Where a list has a part of the particles: is there harm in what this rank has to look at, which is a
 * block with its neighbours where it owns the first member?  Adds pairs that were looked at: where
 * there is harm on no rank, there is some still if all together are more than patience allows. */
enum drift_harm drift_harms(const struct list *list, const struct cloud *cloud, double *pairs);
double drift_patience(const struct list *list);

/* The grid of blocks over these of cells. */
struct cells;
size_t drift_shape(const struct list *list, const struct cells *cells, const struct cells *images,
                   struct drift *drift);

/* Of blocks with members, those that need not be compared go: nothing moves there, or others compare them.
 * Those that this rank compares come first. */
void drift_choose(struct list *list);

void drift_free(struct drift *drift);

/* Bytes of its arrays that are written, of a list that stands.  Lists before and after it have blocks from
 * another corner: `range` is written on half as many other pages. */
double drift_written(const struct list *list);

/* Offsets to a block and to one of each two opposite blocks that touch it: half of 27, and the
 * block itself. */
enum { DRIFT_TOUCHING = 14 };
int drift_touching(const struct drift *drift, int offset[DRIFT_TOUCHING]);

enum { DRIFT_TOUCHES = 1, DRIFT_HAS = 2 }; /* marks of a block */

/* Marks blocks that have places of these, of [listed], and blocks that touch one.  Until the list is made
 * anew drift_is_near() is true of each place that has one of these as a neighbour.  Where a cloud has rows
 * beyond, all these are to be marked before it is compared. */
void drift_mark(const struct list *list, const bool *of);
bool drift_is_near(const struct list *list, int place);

/* Of a place of some owner of a group. */
bool drift_near_group(const struct list *l, int g);

/* Where the particle or image of this place stands when the particle is at x. */
void drift_place(const struct list *list, int slot, const double *x, double *to);

#endif
