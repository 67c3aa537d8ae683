/* ranks.h -- the processes that carry out one run together, and what they tell each other.
 *
 *     TRY(ranks_begin(&argc, &argv));   first thing in main()
 *     status = ranks_agree(status);     the same status on all, one message
 *     ranks_end();                      last thing
 *
 * Each process has a rank, 0 .. ranks_count() - 1.  The serial programs have one, and what
 * stands here does nothing for them (alone.c); those with MPI are linked with mpi*.c instead.
 * No other file includes mpi.h, but for solved/multigrid-hypre.c, whose library does.
 *
 * All but ranks_count(), ranks_me(), ranks_by_mpi(), ranks_leave() and what is asked of a cut is collective:
 * all ranks call it, in the same order.  No answer depends on the order in which messages
 * arrive. */
#ifndef RANKS_RANKS_H
#define RANKS_RANKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Starts MPI, and hushes warnings on all ranks but the first, which sees the same.
 * STATUS_BAD_SCENE: whoever started this program is of another MPI, or it is a serial one, so
 * that there are as many whole copies of it as ranks were asked for. */
int ranks_begin(int *argc, char ***argv);
void ranks_end(void);

int ranks_count(void);
int ranks_me(void);

/* Does this program have MPI, on one rank or more?  What it starts by fork() then ends by _exit(). */
bool ranks_by_mpi(void);

/* In a child of fork(): from here on it is the only rank of one, and knows nothing of MPI. */
void ranks_leave(void);

/* --- what all know --------------------------------------------------------------------- */

/* STATUS_DONE where all bring that; else, on all, status and message of the lowest rank that
 * brings another. */
int ranks_agree(int status);

/* The same within what is made on all ranks, of which one may fail before it comes there: it meets the
 * others in ranks_agree_after(), where all agree on what has become of it. */
int ranks_agree_within(int status);
int ranks_agree_after(int status);

/* Who has the least key is heard; of equal ones, who has the least order, then the lowest rank:
 * said [bytes] becomes what that rank had there.  Returns it; -1, and nothing has changed, where
 * all keys are infinite.  No key is NaN, and at most RANKS_SAID bytes are said. */
enum { RANKS_SAID = 4200 };
int ranks_first(double key, long order, void *said, size_t bytes);

/* The same of n things at once, at most RANKS_FIRSTS, by key [n] and order [n]: said [n][bytes],
 * who is heard of each is rank [n]. */
enum { RANKS_FIRSTS = 2 };
void ranks_firsts(int n, const double *key, const long *order, void *said, size_t bytes, int *rank);

/* Each x[i] becomes the largest of all ranks; none is NaN. */
void ranks_most(int n, double *x);

/* Each x[i] becomes the sum over all ranks: exact, so without an order. */
void ranks_add(int n, int64_t *x);

/* Rows of so many bytes, count[r] of them on rank r, to all: all [sum of count] has those of
 * rank 0 first.  mine [count[ranks_me()]] may not overlap it; NULL: rows of this rank are there already. */
void ranks_gather(const int *count, size_t bytes, const void *mine, void *all);

/* The same to the first rank alone: elsewhere `all` is not touched. */
void ranks_bring(const int *count, size_t bytes, const void *mine, void *all);

/* A block of so many bytes (the same on all ranks) has the same in it on all, nearly everywhere: where
 * it does, ranks of one machine need memory for it once.  Nothing else changes, and writing to it later
 * is no error, but takes that memory back. */
void ranks_alike(const void *block, size_t bytes);

/* Of n rows in an order that all know, those that this rank takes where they are shared evenly: from
 * here to where those of rank + 1 begin. */
static inline int ranks_part(int n, int rank)
{
    return (int)((int64_t)n * rank / ranks_count());
}

/* --- where each works ------------------------------------------------------------------ */

/* Space cut into boxes that fill it, one a rank. */
struct ranks_cut;

/* Cuts so that the weights of points are shared evenly: n points of this rank, x [n][dim] [m],
 * weight [n], not below 0.  STATUS_FAILED, on all: no memory, or no cut is found. */
int ranks_cut_create(struct ranks_cut **cut, int dim, int n, const double *x,
                     const double *weight);
void ranks_cut_free(struct ranks_cut **cut); /* NULL is welcome */

int ranks_cut_owner(const struct ranks_cut *cut, const double *x);

/* Ranks [ranks_count()] whose boxes the box low..high touches, ascending; returns how many. */
int ranks_cut_near(const struct ranks_cut *cut, const double *low, const double *high, int *rank);

/* --- what travels ---------------------------------------------------------------------- */

/* Which rows of an array go from which rank to which: made once, used for many arrays. */
struct ranks_route;

/* Row row[i] goes to rank to[i], which is another one; n of them leave here, `widest` bytes
 * each at most (the same on all ranks).  status: of what this rank has done for it so far; where
 * that is not STATUS_DONE, the others are not looked at.  On all ranks the first status that is
 * none, with its message; STATUS_FAILED: no memory. */
int ranks_route_create(struct ranks_route **route, int status, size_t widest, int n, const int *to,
                       const int *row);

/* The same of rows that are not all as wide: row i is units[i] pieces long, from piece row[i] on.  The
 * numbers below are those of pieces then, and `widest` and bytes are of one. */
int ranks_route_create_uneven(struct ranks_route **route, int status, size_t widest, int n,
                              const int *to, const int *row, const int *units);
void ranks_route_free(struct ranks_route **route); /* NULL is welcome */

/* Rows that come in. */
int ranks_route_coming(const struct ranks_route *route);

/* Sends rows of so many bytes (not 0) out of `from`.  `in` [coming] gets those of the lowest
 * rank first, those of one rank in the order in which that one named them. */
void ranks_route_go(struct ranks_route *route, size_t bytes, const void *from, void *in);

/* The same in two parts, between which all may ask each other something else, or begin with other routes:
 * all ranks in one order.  Until the second, `from` does not change, and `in` is not read. */
void ranks_route_begin(struct ranks_route *route, size_t bytes, const void *from, void *in);
void ranks_route_end(struct ranks_route *route);

/* Partners that rows go to; rows that leave. */
int ranks_route_partners(const struct ranks_route *route);
int ranks_route_leaving(const struct ranks_route *route);

#endif
