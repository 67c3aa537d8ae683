/* disturb.c -- a start that differs by next to nothing: by how much positions are uncertain
 * after a while is seen only by runs that began apart. */
#include "plan/disturb.h"

#include <stdint.h>

/* Mixes all bits of z into all bits: the output function of SplitMix64, Steele, Lea and
 * Flood, Proc. OOPSLA (2014) 453-472, with the constants of its variant 13. */
static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

/* A number in [-1, 1), evenly distributed, of its own for each seed and i. */
static double chance(uint64_t seed, uint64_t i)
{
    static const uint64_t golden = 0x9e3779b97f4a7c15; /* 2^64 over the golden ratio */
    const uint64_t bits = mix(mix((seed + 1) * golden) + (i + 1) * golden);

    return (double)(bits >> 11) / 4503599627370496.0 - 1; /* 2^53 steps over 2^52 */
}

void disturb_positions(const struct settings_disturbance *s, double dx, double *x, int n)
{
    if (s->size == 0)
        return;
    for (int i = 0; i < n * DIM; i++)
        x[i] += s->size * dx * chance((uint64_t)s->seed, (uint64_t)i);
}
