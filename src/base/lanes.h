/* lanes.h -- as many particles side by side as the machine has room for.
 *
 * Files that use lanes are compiled once per width: LANES comes from the
 * build, and LANE_NAME() keeps their global names apart.  Vectors wider than
 * the machine's registers are slow (4 times), so 4 lanes are for AVX2 and 8 for
 * AVX-512 only.
 *
 * Laws between particles and kernels are compiled once more with -DSINGLE, in which a
 * `real` is a float and twice as many lanes fill a register.  There a double among
 * lanes is written (real)x: the compiler refuses what would lose digits unseen. */
#ifndef BASE_LANES_H
#define BASE_LANES_H

#ifndef LANES
#error "files of hot rooms are compiled with -DLANES=2, 4, 8 or 16"
#endif

#include <float.h>

#ifdef SINGLE
typedef float real;
typedef int real_bits;
#define LANES_ROOT __builtin_sqrtf
#define LANES_LEAST FLT_MIN /* positive, and a divisor */
#else
typedef double real;
typedef long long real_bits;
#define LANES_ROOT __builtin_sqrt
#define LANES_LEAST DBL_MIN
#endif

typedef real lanes __attribute__((vector_size(sizeof(real) * LANES)));
typedef real_bits lanes_mask __attribute__((vector_size(sizeof(real) * LANES)));

#define LANE_PASTE(name, width) name##_lanes##width
#define LANE_PASTE2(name, width) LANE_PASTE(name, width)
#define LANE_PASTE_SINGLE(name, width) name##_single##width
#define LANE_PASTE_SINGLE2(name, width) LANE_PASTE_SINGLE(name, width)

/* LANE_SINGLE_NAME(): that of the single precision which stands beside a double one. */
#ifdef SINGLE
#define LANE_NAME(name) LANE_PASTE_SINGLE2(name, LANES)
#else
#define LANE_NAME(name) LANE_PASTE2(name, LANES)
#if LANES == 2
#define LANE_SINGLE_NAME(name) LANE_PASTE_SINGLE(name, 4)
#elif LANES == 4
#define LANE_SINGLE_NAME(name) LANE_PASTE_SINGLE(name, 8)
#else
#define LANE_SINGLE_NAME(name) LANE_PASTE_SINGLE(name, 16)
#endif
#endif

/* For functions that are only fast with constant arguments: left to itself, the
 * compiler stops copying them when they grow. */
#define LANES_INLINE static inline __attribute__((always_inline))

/* a where the mask is set, else 0 (also when a is not finite). */
static inline lanes lanes_where(lanes_mask mask, lanes a)
{
    return (lanes)((lanes_mask)a & mask);
}

/* max(a, 0). */
static inline lanes lanes_positive(lanes a)
{
    return lanes_where(a > (lanes){0}, a);
}

/* The larger of a and b, lane by lane. */
static inline lanes lanes_max(lanes a, lanes b)
{
    const lanes_mask first = a > b;

    return (lanes)(((lanes_mask)a & first) | ((lanes_mask)b & ~first));
}

/* Exact square root: hidden behind the loads, an approximation is slower. */
static inline lanes lanes_sqrt(lanes a)
{
    lanes root;

    for (int l = 0; l < LANES; l++)
        root[l] = LANES_ROOT(a[l]);
    return root;
}

/* The same number in every lane. */
static inline lanes lanes_all(real a)
{
    return a - (lanes){0};
}

#endif
