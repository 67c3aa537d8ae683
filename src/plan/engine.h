/* engine.h -- the hot rooms at the lane width that this machine runs best. */
#ifndef PLAN_ENGINE_H
#define PLAN_ENGINE_H

#include "plan/couple.h"
#include "plan/sum.h"
#include "space/nabla-kept.h"
#include "state/part.h"

struct kernel;

struct engine {
    int lanes;
    const struct sum_engine *sum;
    const struct part *const *effects;    /* NULL-ended */
    const struct part *const *walls;      /* NULL-ended, the first is the default */
    const struct kernel *const *kernels;  /* NULL-ended */
    const struct couple_engine *couple;
    const struct nabla_engine *nabla;
    const struct nabla_kept_engine *nabla_kept;

    /* Whose laws and rows sums of pairs take, one for one as above: in the precision of pairs. */
    const struct part *const *laws;
    const struct kernel *const *law_kernels;
};

/* Eight lanes where the processor has AVX-512, four where it has AVX2 and FMA, else
 * two; the environment variable STIFFWATER_LANES=2 or 4 asks for so many at most.
 * Results do not depend on it. */
const struct engine *engine_pick(void);

/* The one that sums pairs in single precision, for one of engine_pick(). */
const struct engine *engine_single(const struct engine *engine);

/* A part's law as sums of pairs take it; the part is an effect of the engine. */
const struct part_law *engine_law(const struct engine *engine, const struct part *part);

#endif
