/* effects.h -- the effects that a scene can call for, one file each.
 *
 * Files of this room are compiled once per lane width. */
#ifndef EFFECTS_EFFECTS_H
#define EFFECTS_EFFECTS_H

#include "space/pairs.h"
#include "state/part.h"

/* All effects of the compiled width, NULL-ended, in the order of their sums. */
#define effects_table LANE_NAME(effects_table)
extern const struct part *const effects_table[];

/* What couple() of a part gives: F_ab = -c (v_a - v_b). */
struct coupling {
    lanes c[PAIRS_ROWS]; /* [kg/s, 2D: kg/(m s)]                                */
};

/* Which kinds meet: every kind meets the fluid, the fluid meets every kind. */
#define EFFECTS_ACT_ALL                                                                  \
    {                                                                                    \
        [KIND_FLUID] = KIND_BIT(KIND_FLUID) | KIND_SOLIDS,                               \
        [KIND_WALL] = KIND_BIT(KIND_FLUID), [KIND_WALL_SLIP] = KIND_BIT(KIND_FLUID),     \
        [KIND_SKIN] = KIND_BIT(KIND_FLUID), [KIND_SKIN_SLIP] = KIND_BIT(KIND_FLUID),     \
    }

/* The same without solids along which the fluid slips. */
#define EFFECTS_ACT_STICKY                                                               \
    {                                                                                    \
        [KIND_FLUID] = KIND_BIT(KIND_FLUID) | KIND_STICKY,                               \
        [KIND_WALL] = KIND_BIT(KIND_FLUID), [KIND_SKIN] = KIND_BIT(KIND_FLUID),          \
    }

/* Fluid with solids only. */
#define EFFECTS_ACT_SOLIDS                                                               \
    {                                                                                    \
        [KIND_FLUID] = KIND_SOLIDS,                                                      \
        [KIND_WALL] = KIND_BIT(KIND_FLUID), [KIND_WALL_SLIP] = KIND_BIT(KIND_FLUID),     \
        [KIND_SKIN] = KIND_BIT(KIND_FLUID), [KIND_SKIN_SLIP] = KIND_BIT(KIND_FLUID),     \
    }

/* Fluid with fluid only. */
#define EFFECTS_ACT_FLUID                                                                \
    {                                                                                    \
        [KIND_FLUID] = KIND_BIT(KIND_FLUID),                                             \
    }

#endif
