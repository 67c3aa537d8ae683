/* scan.h -- finds the neighbours of SCAN_OWNERS owners at a time.
 *
 *     scan_start(&scan, list, memory, room);       once
 *     scan_group(&scan, group, owners);            for each group
 *     scan_near(&scan, &list->own->cells[kind], NULL);   near and count are made */
#ifndef SPACE_SCAN_H
#define SPACE_SCAN_H

#include "space/lanes.h"
#include "space/list-private.h"

enum {
    SCAN_OWNERS = LANES < 4 ? LANES : 4, /* more have too many around them    */
    SCAN_WIDE = 2 * SCAN_OWNERS, /* candidates compared at a time             */
    SCAN_HITS = 1 << SCAN_WIDE, /* outcomes                                   */
    SCAN_CHUNKS = 128,          /* of SCAN_WIDE candidates collected at most  */
    SCAN_BLOCK = 4              /* chunks collected without asking            */
};
_Static_assert(SCAN_WIDE <= (int)LIST_PAD, "places are read SCAN_WIDE at a time");

typedef int scan_ints __attribute__((vector_size(4 * SCAN_WIDE)));
typedef unsigned scan_sums __attribute__((vector_size(4 * SCAN_WIDE)));
typedef unsigned short scan_places __attribute__((vector_size(4 * SCAN_WIDE)));

struct scan {
    int count[SCAN_OWNERS];  /* neighbours found of each owner               */
    int *near[SCAN_OWNERS];  /* [count, and SCAN_WIDE more] their slots      */

    /* The group at work. */
    int group, owners;           /* first slot, lanes in use                 */
    double low[DIM], high[DIM];  /* the box around them, and the reach   [m] */
    bool apart;                  /* they are far from one another            */
    unsigned char looks[SCAN_OWNERS]; /* all bits: looks for neighbours, else 0 */
    scan_places owner[SCAN_OWNERS][LIST_WORDS]; /* places of owners          */

    /* Candidates in chunks of SCAN_WIDE consecutive slots. */
    int chunks;
    int slot[SCAN_CHUNKS + SCAN_BLOCK]; /* first slot of each chunk          */
    unsigned char there[SCAN_CHUNKS + SCAN_BLOCK][SCAN_OWNERS]; /* bit i: slot i counts */

    /* The same for all groups. */
    const struct list *list;
    double reach;             /* widened radius                        [m]    */
    int bound;                /* its square                          [units^2] */
    scan_ints hit[SCAN_HITS]; /* the set bits of a mask in turn               */
};

/* near[] is [SCAN_OWNERS][room] of the caller, room at least listed + 2 SCAN_WIDE. */
#define scan_start LANE_NAME(scan_start)
void scan_start(struct scan *s, const struct list *list, int *near, size_t room);

/* `owners` may be 0: then nobody is found. */
#define scan_group LANE_NAME(scan_group)
void scan_group(struct scan *s, int group, int owners);

/* Of the cells of a kind, then of those of its images (NULL: nothing is periodic). */
#define scan_near LANE_NAME(scan_near)
void scan_near(struct scan *s, const struct cells *c, const struct cells *images);

#endif
