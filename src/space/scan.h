/* scan.h -- finds the neighbours of LANES owners at a time.
 *
 *     scan_start(&scan, list, memory, room);       once
 *     scan_group(&scan, group, owners);            for each group
 *     scan_near(&scan, kind);                      near and count are made
 *
 * scan.c says which runs of places hold all neighbours; which of them are is found by
 * scan-sift.h where the machine can compress a register (8 lanes), else by
 * scan-table.h.
 *
 * Positions are whole numbers of 16 bits, so that one instruction squares and adds
 * two differences of each of SCAN_WIDE candidates.  They count modulo 8 radii:
 * those in the cells around are nearer than 4, and where cells had to be coarse
 * one far away may be listed, which changes no sum.  The radius is widened
 * by more than all roundings together, so no pair is ever missed. */
#ifndef SPACE_SCAN_H
#define SPACE_SCAN_H

#include "base/lanes.h"
#include "space/list-private.h"

#include <string.h>

enum { SCAN_WIDE = 2 * LANES }; /* candidates compared at a time */
_Static_assert(4 * SCAN_WIDE <= (int)LIST_PAD, "positions are read as far beyond a run");

typedef int scan_ints __attribute__((vector_size(4 * SCAN_WIDE)));
typedef unsigned scan_sums __attribute__((vector_size(4 * SCAN_WIDE)));
typedef unsigned short scan_places __attribute__((vector_size(4 * SCAN_WIDE)));

#if LANES == 8
enum {
    SCAN_RUNS = 32,   /* runs of candidates collected at most                */
    SCAN_MOST = 1024  /* candidates sifted before they are compared          */
};

struct scan_run {
    int from, to; /* places from..to-1 */
};

struct scan_work {
    int runs;
    struct scan_run run[SCAN_RUNS];
    _Alignas(64) int slot[SCAN_MOST + SCAN_WIDE]; /* places near the box     */
    _Alignas(64) int place[LIST_WORDS][SCAN_MOST + SCAN_WIDE]; /* their places */
};
#else
enum {
    SCAN_HITS = 1 << SCAN_WIDE, /* outcomes of comparing                     */
    SCAN_CHUNKS = 128,          /* of SCAN_WIDE candidates collected at most */
    SCAN_BLOCK = 4              /* chunks collected without asking           */
};

struct scan_work {
    scan_places owner[LANES][LIST_WORDS]; /* places of owners                */
    unsigned char looks[LANES]; /* all bits: looks for neighbours, else 0    */
    int chunks;                 /* of SCAN_WIDE consecutive places           */
    int slot[SCAN_CHUNKS + SCAN_BLOCK]; /* first place of each chunk         */
    unsigned char there[SCAN_CHUNKS + SCAN_BLOCK][LANES]; /* bit i: place i counts */
    scan_ints hit[SCAN_HITS];   /* the set bits of a mask in turn            */
};
#endif

struct scan {
    int count[LANES];  /* neighbours found of each owner                     */
    int *near[LANES];  /* [count, and SCAN_WIDE more] their places           */

    /* The group at work. */
    int group, owners;          /* first place, lanes in use                 */
    bool apart;                 /* they are far from one another             */
    int first, last;            /* lanes first..last-1 look for neighbours   */
    double low[DIM], high[DIM]; /* the box around these                [m]   */
    struct scan_work work;      /* of scan-sift.h or scan-table.h            */

    /* The same for all groups. */
    const struct list *list;
    double wide, reach;     /* widened radius                  [units], [m]  */
    int bound;              /* its square                          [units^2] */
};

/* near[] is [LANES][room] of the caller, room at least listed + 2 SCAN_WIDE. */
#define scan_start LANE_NAME(scan_start)
void scan_start(struct scan *s, const struct list *list, int *near, size_t room);

#define scan_group LANE_NAME(scan_group)
void scan_group(struct scan *s, int group, int owners);

/* Of one kind, its images last. */
#define scan_near LANE_NAME(scan_near)
void scan_near(struct scan *s, int kind);

/* A word of SCAN_WIDE places. */
static inline scan_places scan_places_at(const int *place)
{
    scan_places p;

    memcpy(&p, place, sizeof p);
    return p;
}

/* The word of an owner, for comparing with as many. */
static inline scan_places scan_owner(const struct scan *s, int lane, int word)
{
    return (scan_places)(s->list->own->place[word][s->group + lane] - (scan_ints){ 0 });
}

#endif
