/* laws.h -- which laws act between two kinds: tables, filled by files that know nothing of
 * lanes.  What a law sees is in pairs.h. */
#ifndef SPACE_LAWS_H
#define SPACE_LAWS_H

#include "space/kinds.h"

struct side; /* pairs.h, lanes wide */
struct block;
struct sum;
struct field_sum;
struct kernel_use; /* kernels/kernel.h */

/* Rows a law asks for; r and mm are there for all laws. */
enum need {
    NEED_X = 1 << 0,     /* x                                                */
    NEED_V = 1 << 1,     /* v                                                */
    NEED_RHO = 1 << 2,   /* rho                                              */
    NEED_P2 = 1 << 3,    /* p2                                               */
    NEED_MASS = 1 << 4,  /* m                                                */
    NEED_IRHO = 1 << 5,  /* irho                                             */
    NEED_R2 = 1 << 6,    /* r2                                               */
    NEED_XV = 1 << 7,    /* xv                                               */
    NEED_GRADW = 1 << 8, /* gw                                               */
    NEED_W = 1 << 9,     /* w                                                */
    NEED_GRADW_R2 = 1 << 10, /* gw_r2                                         */
    NEED_LAPW = 1 << 11    /* lw                                              */
};

enum { PAIRS_FIELD = 2 + DIM }; /* numbers added up for a summed density              */

typedef void pairs_field(const void *self, const struct side *a, const struct block *b,
                         struct field_sum *to);
typedef void pairs_law(const void *self, const struct side *a, const struct block *b,
                       struct sum *to);

/* One law at work between two kinds. */
struct pairs_work {
    pairs_law *law;
    const void *self;
    const struct kernel_use *kernel;
    int slot;       /* column of the book it is accounted in                 */
    unsigned needs; /* NEED_ bits that its kernel is asked for before it; 0: the
                       rows stand as a law before left them                  */
};

enum { PAIRS_LAWS = 12 };

/* Adds what all laws of a table give on the rows of b to the sums of their columns. */
struct pairs_table;
typedef void pairs_laws(const struct pairs_table *table, const struct side *a, struct block *b,
                        struct sum *sum);

/* The same on the next n rows of the list, which go through the laws one by one: none is
 * stored. */
struct pairs_source; /* single-row.h */
typedef void pairs_straight(const struct pairs_table *table, const struct pairs_source *from,
                            int n, struct sum *sum);

/* Everything that acts on owners of one kind from partners of one kind, in the
 * order in which sums are added; laws that share a kernel stand together. */
struct pairs_table {
    int n;
    unsigned needs; /* NEED_ bits of all of them                             */
    pairs_laws *laws; /* how they are run: plan/sum.h arranges it            */
    pairs_straight *straight; /* likewise; NULL: there is no such loop     */
    struct pairs_work work[PAIRS_LAWS];
};

#endif
