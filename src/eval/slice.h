/* slice.h -- particles in order of ids, shared evenly between ranks: what each writes of a file.
 *
 * Where own rows of y are packed (moment_is_packed()) each rank gets the numbers of its ids from their
 * owners, and all ranks call these together.  Else the first rank has all of y, and so all ids. */
#ifndef EVAL_SLICE_H
#define EVAL_SLICE_H

#include "eval/moment.h"
#include "eval/rearrange.h"

/* Ids from .. from + n - 1, over all kinds. */
struct slice {
    int from, n;
};

struct slice slice_of(const struct moment *m);

/* Numbers of the particles of a slice, each [n]. */
struct slice_frame {
    double (*x)[DIM], (*u)[DIM]; /* x where the domain has it                 [m], [m/s]    */
    double *rho;                 /* that of fluid at rest where a kind has none [kg/m^D]     */
};

/* At (t, y), the run's moment.  STATUS_FAILED, on all: no memory. */
int slice_take_frame(struct moment *run, double t, const double *y, struct slice_frame *out);

enum { SLICE_PIECES = 2 * MOMENT_ROWS + 1 };

/* Numbers of y as it would be if rows were ids: value [n] from number `at` on.  What is of no
 * particle is the first rank's. */
struct slice_state {
    int pieces;
    struct slice_piece {
        long at, n;
        const double *value;
    } piece[SLICE_PIECES];
    double *room;                /* that some of them stand in                */
};

/* by_id [size]: scratch, not y; needed as long as *out.  STATUS_FAILED, on all: no memory. */
int slice_take_state(struct moment *run, const double *y, double *by_id, struct slice_state *out);
void slice_free_state(struct slice_state *state);

#endif
