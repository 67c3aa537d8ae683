/* balance.h -- ranks whose work has become unequal share it anew.
 *
 *     do {
 *         TRY(balance_cut(moment, row, &blocks));      blocks 0: all stays as it is, the end
 *         TRY(method->rearrange(self, blocks, row));   y and all that a method keeps
 *         TRY(balance_carry_out(moment));              all that a moment keeps
 *     } while (balance_goes_on(moment));
 *
 * Between two steps, by all ranks together.  Work is counted in entries of rows of pairs;
 * imbalance is the most that a rank has over the mean.  Space is cut anew, by what each particle
 * has of them, where particles were when the list was made, and the list is remade there: no bit
 * of what follows depends on when that was, or whether.  How much a group of lanes takes that is in
 * part another rank's is known only of the cut before; so where one leaves too much, another follows. */
#ifndef EVAL_BALANCE_H
#define EVAL_BALANCE_H

#include "eval/rearrange.h"

struct balance {
    int every;             /* steps from cut to cut; 0: by imbalance; -1: never */
    long steps, builds;    /* seen so far; list that was looked at last        */
    long cuts, moved;      /* so far; particles that changed their rank by them */
    int tries;             /* cuts before the one that is to come at once      */
    double now;            /* imbalance of the list that stands                */
    double left;           /* that the last cut left; 1 before                 */
    double before, after;  /* the largest before a cut, after one; NAN: none   */
};

/* The environment variable STIFFWATER_BALANCE says "never" or a number of steps, for tests. */
struct balance balance_start(void);

/* The same for all ranks, from a method whose past cannot travel. */
void balance_never(struct moment *moment);

/* Steps count from here, where these say when. */
void balance_count(struct moment *moment);

int balance_cut(struct moment *moment, struct vector_rows row[MOMENT_ROWS], int *blocks);
int balance_carry_out(struct moment *moment);

/* Is there to be another cut at once, as the last left too much? */
bool balance_goes_on(const struct moment *moment);

/* So far; on one rank, no cut. */
struct balance balance_told(const struct moment *moment);

/* A number that this rank brings with each right-hand side from now on, where ranks ask each other in
 * these (false: they do not), and the largest of all in the last one. */
bool moment_wish(struct moment *moment, double wish);
double moment_heard(const struct moment *moment);

struct balance_move;
void balance_free(struct balance_move **move); /* NULL is welcome */

#endif
