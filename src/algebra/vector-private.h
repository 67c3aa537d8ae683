/* vector-private.h -- what the files of our vectors share.
 *
 * A vector keeps its numbers in a store, which copies share until one of them is
 * written.  A sum is put off until it is read: many are only read as a
 * part of the next sum, or by a norm, and then fewer passes over memory do.  A
 * store that such a sum reads is not written before the sum is done, so callers
 * see no difference but the time.
 *
 * Where a family has ranges (of stiff entries), what a vector holds inside of
 * them is always there, put off or not; outside it may be 0 without being written. */
#ifndef ALGEBRA_VECTOR_PRIVATE_H
#define ALGEBRA_VECTOR_PRIVATE_H

#include "algebra/vector.h"
#include <nvector/nvector_serial.h>

enum {
    VECTOR_BLOCK = 1024, /* entries whose partial results belong together      */
    VECTOR_LONG = 20000, /* from this length on a second thread pays           */
    VECTOR_TERMS = 64,   /* of a sum                                           */
    VECTOR_PUT_OFF = 8   /* sums of a family at a time                         */
};

struct vector_store {
    double *data;          /* [n] 64-byte aligned, in `memory`                 */
    void *memory;
    int users;             /* vectors; 0: spare                                */
    long written;          /* when, in order of all writing; never 0           */
    double norm;           /* of what it holds, with weights ...               */
    long largest;
    long by;               /* ... written then; 0: not known                   */
    struct vector_store *next; /* of the spare ones                            */
    struct vector_store *other; /* of all of the family                        */
};

/* What all clones of a vector share.  It has as many stores as members. */
struct vector_family {
    enum vector_norm norm;
    long n, largest;
    bool wide;             /* registers                                        */
    double *partial;       /* [2][blocks] of reductions                        */
    int members;
    struct vector_store *all, *spare;
    long *order;           /* [n] entries in the order in which sums take them;
                              NULL: as they stand                              */
    struct vector_content *put_off[VECTOR_PUT_OFF];
    int sums;              /* put off                                          */
    int ranges;
    long (*range)[2];      /* ascending, disjoint                              */
    struct vector_own own; /* no pieces: all entries are here                  */
    long (*piece)[2];      /* its pieces                                       */
};

/* What stands outside of the ranges. */
enum vector_outside {
    VECTOR_HERE,           /* numbers                                          */
    VECTOR_ZERO,           /* 0, not written                                   */
    VECTOR_LATER           /* a sum that is put off; its store is its own      */
};

/* unit + (c[0] x[0] + c[1] x[1] + ...) */
struct vector_sum {
    const struct vector_store *unit; /* NULL: none                             */
    int terms;
    double c[VECTOR_TERMS];
    const struct vector_store *x[VECTOR_TERMS];
};

struct vector_content {
    struct _N_VectorContent_Serial serial; /* first: serial operations see this */
    struct vector_family *family;
    struct vector_store *store;
    enum vector_outside outside;
    bool nothing;          /* VECTOR_ZERO, and 0 inside of the ranges too      */
    struct vector_sum sum; /* of VECTOR_LATER                                  */
};

static inline struct vector_content *vector_content(N_Vector v)
{
    return v->content;
}

static inline long vector_blocks(long n)
{
    return (n + VECTOR_BLOCK - 1) / VECTOR_BLOCK;
}

static inline int vector_block_size(long n, long b)
{
    const long left = n - b * VECTOR_BLOCK;

    return left < VECTOR_BLOCK ? (int)left : VECTOR_BLOCK;
}

/* The next piece of [*from, to) that this rank has; false: there is none. */
static inline bool vector_piece(const struct vector_family *f, long *from, long to, long *end)
{
    *end = to;
    for (int k = 0; k < f->own.pieces; k++) {
        const long *piece = f->piece[k];

        if (piece[1] <= *from || piece[1] == piece[0])
            continue;
        *from = *from < piece[0] ? piece[0] : *from;
        *end = to < piece[1] ? to : piece[1];
        return *from < to;
    }
    return f->own.pieces == 0 && *from < to;
}

/* Block b of x as sums take it: in place, or fetched to `room`. */
static inline const double *vector_in_order(const struct vector_family *f, const double *x,
                                            long b, double *room)
{
    const long from = b * VECTOR_BLOCK;

    if (!f->order)
        return x + from;
    for (int i = 0; i < vector_block_size(f->n, b); i++)
        room[i] = x[f->order[from + i]];
    return room;
}

/* Loops that wait for arithmetic are compiled for wide registers too; which does not
 * change a bit, as products are not contracted. */
#if defined __x86_64__ && defined __GNUC__
#define VECTOR_WIDE __attribute__((target("avx2")))
#endif

/* vector-loops.c */
bool vector_wide(void); /* does this machine have them? */

/* to = unit + (c[0] x[0] + ...), n entries from `from` on. */
void vector_add_up(bool wide, const double *unit, int terms, const double *c,
                   const double *const *x, long from, int n, double *to);

/* Of entries here alone. */
void vector_own_copy(const struct vector_family *f, const double *x, double *to);

/* vector-store.c */
bool vector_join(struct vector_content *c, struct vector_family *f); /* false: no memory */
void vector_leave(struct vector_content *c);
double *vector_renew(struct vector_content *c); /* what was there does not matter */
void vector_share(struct vector_content *from, struct vector_content *to);
void vector_put_off(struct vector_content *c, const struct vector_sum *sum);
void vector_sum_block(const struct vector_content *c, long b); /* of a sum put off */
void vector_summed(struct vector_content *c);  /* all its blocks are done       */
void vector_settle(struct vector_content *c);  /* numbers are here now          */

/* vector-own.c: of entries here alone.  `leading`: of those that have the norm, which is that of
 * block `lead` of partial, the first by the name that all ranks give them. */
long vector_own_leading(const struct vector_family *f, const double *x, const double *weight,
                        const double *partial, long lead);

/* vector-sum.c, vector-norm.c, vector-dot.c, vector-serial.c: operations. */
int vector_sum_combination(int terms, sunrealtype *c, N_Vector *v, N_Vector z);
void vector_sum_two(sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z);
void vector_sum_scale(sunrealtype c, N_Vector x, N_Vector z);
void vector_sum_constant(sunrealtype c, N_Vector z);
sunrealtype vector_norm_weighted(N_Vector v, N_Vector weight);
sunrealtype vector_dot_product(N_Vector x, N_Vector y);
void vector_serial_operations(N_Vector v);

#endif
