/* engine.c -- picks the compiled lane width, once. */
#include "plan/engine.h"

#include <stdlib.h>
#include <string.h>

extern const struct part *const effects_table_lanes2[], *const walls_table_lanes2[];
extern const struct part *const effects_table_single4[];
extern const struct kernel *const kernel_table_lanes2[], *const kernel_table_single4[];

static const struct engine two = {
    2, &sum_engine_lanes2, effects_table_lanes2, walls_table_lanes2, kernel_table_lanes2,
    &couple_engine_lanes2, &nabla_engine_lanes2, &nabla_kept_engine_lanes2,
    effects_table_lanes2, kernel_table_lanes2
};

static const struct engine two_single = {
    2, &sum_engine_single_lanes2, effects_table_lanes2, walls_table_lanes2,
    kernel_table_lanes2, &couple_engine_lanes2, &nabla_engine_lanes2,
    &nabla_kept_engine_lanes2, effects_table_single4, kernel_table_single4
};

#ifdef STIFFWATER_V3
extern const struct part *const effects_table_lanes4[], *const walls_table_lanes4[];
extern const struct part *const effects_table_single8[];
extern const struct kernel *const kernel_table_lanes4[], *const kernel_table_single8[];

static const struct engine four = {
    4, &sum_engine_lanes4, effects_table_lanes4, walls_table_lanes4, kernel_table_lanes4,
    &couple_engine_lanes4, &nabla_engine_lanes4, &nabla_kept_engine_lanes4,
    effects_table_lanes4, kernel_table_lanes4
};

static const struct engine four_single = {
    4, &sum_engine_single_lanes4, effects_table_lanes4, walls_table_lanes4,
    kernel_table_lanes4, &couple_engine_lanes4, &nabla_engine_lanes4,
    &nabla_kept_engine_lanes4, effects_table_single8, kernel_table_single8
};

#ifdef STIFFWATER_V4
extern const struct part *const effects_table_lanes8[], *const walls_table_lanes8[];
extern const struct part *const effects_table_single16[];
extern const struct kernel *const kernel_table_lanes8[], *const kernel_table_single16[];

static const struct engine eight = {
    8, &sum_engine_lanes8, effects_table_lanes8, walls_table_lanes8, kernel_table_lanes8,
    &couple_engine_lanes8, &nabla_engine_lanes8, &nabla_kept_engine_lanes8,
    effects_table_lanes8, kernel_table_lanes8
};

static const struct engine eight_single = {
    8, &sum_engine_single_lanes8, effects_table_lanes8, walls_table_lanes8,
    kernel_table_lanes8, &couple_engine_lanes8, &nabla_engine_lanes8,
    &nabla_kept_engine_lanes8, effects_table_single16, kernel_table_single16
};
#endif

const struct engine *engine_pick(void)
{
    const char *wish = getenv("STIFFWATER_LANES");

    if (wish && strcmp(wish, "2") == 0)
        return &two;
    __builtin_cpu_init();
#ifdef STIFFWATER_V4
    if (!(wish && strcmp(wish, "4") == 0) && __builtin_cpu_supports("x86-64-v4"))
        return &eight;
#endif
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &four : &two;
}
#else
const struct engine *engine_pick(void)
{
    return &two;
}
#endif

const struct engine *engine_single(const struct engine *engine)
{
#ifdef STIFFWATER_V4
    if (engine == &eight)
        return &eight_single;
#endif
#ifdef STIFFWATER_V3
    if (engine == &four)
        return &four_single;
#endif
    (void)engine;
    return &two_single;
}

const struct part_law *engine_law(const struct engine *engine, const struct part *part)
{
    for (int i = 0; engine->effects[i]; i++)
        if (engine->effects[i] == part)
            return engine->laws[i]->as.law;
    return part->as.law;
}
