/* nabla-kept.h -- the sums D, G and T of nabla.h with the weights of pairs kept: worked out
 * once, then read for as many sums as one likes at the same positions.
 *
 *     size_t pairs = nabla_kept_pairs(list);       room for j and slope
 *     engine->kept->keep(&job, &kept);
 *     engine->kept->divergence(&kept, kinds, a, to);
 *
 * Only pairs within the support of the job's kernel are kept.  A lane has its neighbours in
 * the order of the list, so no bit depends on the number of threads nor on the lane width;
 * sums differ from those of nabla.h by rounding. */
#ifndef SPACE_NABLA_KEPT_H
#define SPACE_NABLA_KEPT_H

#include "space/nabla.h"

/* The caller's memory; slope on cache lines. */
struct nabla_kept {
    const struct list *list; /* that of the job                                */
    int *rows;               /* [groups of the list] of each group             */
    int *j;                  /* [pairs] entries, [lanes] a row                   */
    double *slope;           /* [pairs][DIM] m_i m_j gradW_ij, [DIM][lanes] a row */
};

/* Room that the pairs of a list may need. */
static inline size_t nabla_kept_pairs(const struct list *list)
{
    return (size_t)list->rows_before[list->groups] * (size_t)list->lanes;
}

/* Arrays are those of struct nabla_engine. */
struct nabla_kept_engine {
    void (*keep)(const struct nabla_job *job, const struct nabla_kept *kept);
    void (*divergence)(const struct nabla_kept *kept, unsigned kinds, const double *a,
                       double *to);
    void (*gradient)(const struct nabla_kept *kept, unsigned kinds, const double *p,
                     double *to);
    void (*squares)(const struct nabla_kept *kept, unsigned kinds, const double *q,
                    double *to);
};
extern const struct nabla_kept_engine nabla_kept_engine_lanes2, nabla_kept_engine_lanes4,
    nabla_kept_engine_lanes8;

#endif
