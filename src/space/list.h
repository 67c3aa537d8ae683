/* list.h -- which particles are near each other.
 *
 *     TRY(engine->create(&list, &def));
 *     TRY(engine->update(list, &cloud));    before every sum: cheap when fresh
 *     for groups g, for segments s of g: rows of entries s->j, list_place() of each
 *     engine->free(&list);
 *
 * The list sorts all particles by kind and cell ("places"), holds for each group of
 * LANES owners the rows of their neighbours, and is rebuilt only when one
 * moved so far that a pair may be missing (space/drift.h).  The
 * order is made from positions and ids alone (kind, then cell, then id), so a
 * rebuild at given positions gives given bits, whatever rows the particles stand
 * in.  What names a particle here names its row.  A lane's
 * neighbours stand in ascending order of places, no particle is its own neighbour,
 * and all pairs closer than support + margin at the last rebuild are there.
 *
 * Particles outside the box are left out: no place, no cell, no pairs, until
 * they come back in, which forces a rebuild.  Particles that leave the box stay in
 * the list until the next rebuild: sums must mask them.
 *
 * Along a periodic direction none is outside.  Positions may lie any number of
 * lengths away: offset[place] brings them into the domain.  One that stands near a
 * periodic side then has images beyond the opposite one, in places of their own
 * after those of particles: neighbours as all others, but never owners
 * (space/images.h).  Offsets stay until the next rebuild. */
#ifndef SPACE_LIST_H
#define SPACE_LIST_H

#include "space/kinds.h"
#include <stdbool.h>
#include <stddef.h>

struct list_def {
    int from[KINDS + 1];         /* rows of kind k: from[k] .. from[k+1]-1   */
    unsigned acts[KINDS];        /* partner kinds by owner kind, KIND_BITs   */
    unsigned still;              /* kinds whose particles never move, KIND_BITs */
    double support;              /* largest kernel support H           [m]   */
    double skin;                 /* Verlet margin: extra radius        [m]   */
    double low[DIM], high[DIM];  /* box outside of which none counts; infinite
                                    along periodic directions         [m]   */
    double period[DIM];          /* of a periodic direction its length, at least
                                    2 (support + margin); else 0      [m]   */
    double side[DIM];            /* of a periodic direction: where it begins [m] */
};

/* Rows of one group of owners against one kind of partner. */
struct list_segment {
    int partner;  /* enum kind                                               */
    int rows;
    const int *j; /* [rows][lanes] entries; that of `listed` where a lane has no more */
};

/* Rows hold places times the bytes of a double, so that a processor forms the address of a
 * record by its scale alone: a shift for each neighbour would be a seventh of gathering. */
enum { LIST_STEP = sizeof(double) };

static inline int list_entry(int place)
{
    return (int)((unsigned)place * LIST_STEP);
}

static inline int list_place(int entry)
{
    return (int)((unsigned)entry / LIST_STEP);
}

/* Where numbers of an entry begin, `width` doubles of each place one after the other. */
static inline const double *list_at(const double *numbers, int entry, int width)
{
    return (const double *)((const char *)numbers + (size_t)(unsigned)entry * (size_t)width);
}

/* A box around some particles, low above high where n, their number, is 0. */
struct list_bounds {
    double low[DIM], high[DIM], n;
};

/* Where a list has a part of the particles, on one of many ranks: which are here, and what is known of
 * all.  Those that are not here count as left out; their positions are never read.  The rows of
 * neighbours, what they are sorted by, and what a rebuild depends on are then those of a list of all. */
struct list_whole {
    int *row, from[KINDS + 1];         /* [n] here: kind k: from[k] .. from[k+1]-1, by ascending id */
    struct list_bounds of[KINDS], images[KINDS]; /* in the domain, and of their images  */
    struct list_bounds mine[KINDS];    /* of `of`, those that are mine                   */
    bool stands;                       /* they are right for kinds that never move       */
};

struct list {
    struct list_def def;
    int lanes;             /* width of the rows                              */
    int n;                 /* particles                                      */
    int listed;            /* places in use; place `listed` is the dummy     */
    int start[KINDS + 1];  /* kind k: places start[k] .. start[k+1]-1        */
    int image[KINDS + 1];  /* images of kind k: places image[k] .. image[k+1]-1,
                              start[KINDS] = image[0], image[KINDS] = listed */
    int *order;            /* [listed] row of the particle in a place, of an image
                              that of its original                           */
    double (*offset)[DIM]; /* [listed] whole lengths, to be added to the position:
                              where it stands; NULL: nothing is periodic [m] */
    int *slot;             /* [n] place of the particle in a row, -1: left out */
    int groups;            /* groups of owners, all kinds                    */
    int group_from[KINDS + 1]; /* owners of kind k: groups [k] .. [k+1]-1;
                              none when def.acts[k] is 0                     */
    const int *group_slot; /* [groups] first place of a group: multiples of
                              lanes after start[kind]; the last group of a
                              kind may reach beyond start[kind + 1]          */
    const int *group_kind; /* [groups] enum kind of its owners               */
    const int *segment_from; /* [groups+1] into segment                      */
    const long *rows_before; /* [groups+1] rows of all groups before: the work */
    const struct list_segment *segment;
    long builds;           /* rebuilds so far                                */
    const bool *mine;      /* [n] rows of particles that are owners here; others have a
                              place and are neighbours, but have no rows.  The caller's,
                              set after create(); NULL: all are              */
    void (*complete)(void *others, unsigned kinds, int width, double *to); /* brings sums
                              [particles][width] by place of owners that are not here, of
                              kinds (KIND_BITs) that own anything; NULL: they stay 0      */
    void *others;          /* its own                                        */
    const struct list_whole *whole; /* NULL: all particles are here          */
    bool stands;           /* there are rows, of the last rebuild            */
    int bad;               /* row of the particle whose position is not finite,
                              of several that with the smallest id, or -1    */
    struct list_private *own;
};

/* One implementation a lane width; the plan picks by the machine. */
struct list_engine {
    int lanes;
    int (*create)(struct list **list, const struct list_def *def);
    void (*free)(struct list **list); /* NULL is welcome */

    /* Makes the list right for these positions: nothing when none moved more
     * than the margin allows, else a rebuild.  0, or STATUS_FAILED with
     * list->bad when a position is not finite. */
    int (*update)(struct list *list, const struct cloud *cloud);

    /* Makes it anew at these positions, all of which are finite.  0 or STATUS_FAILED. */
    int (*make)(struct list *list, const struct cloud *cloud);

    /* True when update() would rebuild or fail (the list is not touched). */
    bool (*stale)(const struct list *list, const struct cloud *cloud);

    /* Particles have changed rows: row i of kind k holds what was in row from[k][i]
     * (NULL: this kind stands as before); row[] as in struct cloud from now on.  By
     * ids the list stays what it is, and when it is made anew next.  It is remade at
     * the positions of the last rebuild.  0 or STATUS_FAILED (no memory). */
    int (*rearrange)(struct list *list, const int *const from[KINDS],
                     const int *const row[KINDS]);
};
extern const struct list_engine list_engine_lanes2, list_engine_lanes4, list_engine_lanes8;

/* Inside the box? NaN is outside.  Without a loop or branches: each particle is asked in
 * every right-hand side. */
static inline bool list_inside(const struct list_def *def, const double *x)
{
    const double *low = def->low, *high = def->high;
    bool inside = (x[0] >= low[0]) & (x[0] <= high[0]) & (x[1] >= low[1]) & (x[1] <= high[1]);

#if DIM == 3
    inside &= (x[2] >= low[2]) & (x[2] <= high[2]);
#endif
    return inside;
}

/* |a - b|^2, written out: each particle is asked in every right-hand side. */
static inline double list_square(const double *a, const double *b)
{
    double sum = (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);

#if DIM == 3
    sum += (a[2] - b[2]) * (a[2] - b[2]);
#endif
    return sum;
}

/* Sums over pairs of owners of these kinds are there, each in its place: of all ranks, where
 * those want all (eval/share-full.c). */
static inline void list_complete(const struct list *list, unsigned kinds, int width, double *to)
{
    if (list->complete)
        list->complete(list->others, kinds, width, to);
}

/* What positions it was last made at is forgotten: the next update() makes it as the first
 * one did.  Memory and the count of rebuilds stay. */
void list_forget(struct list *list);

/* The failure of a position that is not finite, of the particle in a row, with this number by ids. */
int list_nowhere(struct list *list, int row, int id);

/* --- a part of the particles: list-whole.c ------------------------------------------------ */

/* Of particles that are mine, and of all solids, which all ranks know: where they are, but for which
 * are here; box: around all that are mine.  Once others are mine, what stands is to be forgotten. */
void list_bounds(const struct list *list, const struct cloud *cloud, struct list_whole *to,
                 struct list_bounds *box);
void list_widen(struct list_bounds *to, const struct list_bounds *by);

/* Particles that must be here: those near the box of mine, by so much [m], in a zone around it. */
struct list_zone {
    const struct list *list;
    double low[DIM], high[DIM]; /* [m]                                         */
    bool any, repeats;          /* is there a box; has the domain images?      */
};
double list_reach(const struct list *list, const struct list_whole *whole);
struct list_zone list_zone(const struct list *list, const struct list_bounds *box, double reach);

/* Is an image of x in it, or x? */
bool list_image_near(const struct list_zone *zone, const double *x);

/* Is one in it that is at x by list_home(), after list_bounds()? */
static inline bool list_near(const struct list_zone *zone, const double *x)
{
    bool near = zone->any;

    for (int d = 0; d < DIM; d++)
        near &= (x[d] >= zone->low[d]) & (x[d] <= zone->high[d]);
    return near || (zone->repeats && list_image_near(zone, x));
}

/* Could there be one of these in it? */
bool list_meets(const struct list_zone *zone, const struct list_bounds *of);
const double *list_home(const struct list *list, const struct cloud *cloud, int kind, int row);

/* Particles and images, of all ranks. */
static inline double list_known(const struct list *list)
{
    double n = 0;

    for (int k = 0; k < KINDS && list->whole; k++)
        n += list->whole->of[k].n + list->whole->images[k].n;
    return list->whole ? n : list->listed;
}

/* What places are sorted by before ids, the same number on all ranks. */
double list_order(const struct list *list, int row);

/* Entries in all rows, padding included. */
double list_entries(const struct list *list);

/* Bytes that a list of n particles in so many places, with so many entries, takes. */
double list_bytes(double n, double slots, double entries);

/* What of its arrays is written as it stands. */
double list_written(const struct list *list);

#endif
