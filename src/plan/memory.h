/* memory.h -- what a run will need memory for, before it takes any.
 *
 * An estimate of the peak of a run, for `check` and for the room check before
 * particles are placed; tests/memory.sh holds runs to it.  A run has taken all of it
 * when it writes its second output field. */
#ifndef PLAN_MEMORY_H
#define PLAN_MEMORY_H

#include "plan/plan.h"
#include "state/part.h"

/* Bytes. */
struct plan_memory {
    double state;      /* y, and the method's vectors of its size              */
    double lists;      /* pair lists: the run's, and the outputs' own          */
    double sums;       /* what one evaluation of the pair sums works in        */
    double records;    /* of these, what ranks have for their part: records of pairs, sums of them */
    double particles;  /* what does not evolve                                 */
    double idle;       /* of these, velocities of solids that never move, which take memory in
                          large pages alone, as ranks have none                 */
    double beside;     /* of these, but for that, of a second moment            */
    double outputs;    /* frames, gauges                                        */
    double frames;     /* of these, what many ranks share                       */
    double company;    /* of these, what each rank with such a part has in any case */
};

/* Bytes of one more particle that may be company of others, as ranks have of what is near. */
enum { PLAN_COMPANY = 4 };

/* For a method that holds so many vectors of the size of y.  `pairs`: entries of the list
 * as it is, moment_pairs(); NAN: as a full lattice would make it. */
void plan_memory(const struct plan *plan, double pairs, int vectors, struct plan_memory *out);

/* Shows large arrays of a plan, which nothing writes to. */
void plan_show(const struct plan *plan, part_see *see, void *whose);

/* All of it in large pages, of which the last of an array is not full; measured. */
double plan_memory_sum(const struct plan_memory *m);

#endif
