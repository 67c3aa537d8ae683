/* lanes.h -- as many particles side by side as the machine has room for.
 *
 * Files that use lanes are compiled once per width: LANES comes from the
 * build, and LANE_NAME() keeps their global names apart.  Vectors wider than
 * the machine's registers are slow (4 times), so 4 lanes are for AVX2 and 8 for
 * AVX-512 only. */
#ifndef BASE_LANES_H
#define BASE_LANES_H

#ifndef LANES
#error "files of hot rooms are compiled with -DLANES=2, 4 or 8"
#endif

typedef double lanes __attribute__((vector_size(8 * LANES)));
typedef long long lanes_mask __attribute__((vector_size(8 * LANES)));

#define LANE_PASTE(name, width) name##_lanes##width
#define LANE_PASTE2(name, width) LANE_PASTE(name, width)
#define LANE_NAME(name) LANE_PASTE2(name, LANES)

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
        root[l] = __builtin_sqrt(a[l]);
    return root;
}

/* The same number in every lane. */
static inline lanes lanes_all(double a)
{
    return a - (lanes){0};
}

#endif
