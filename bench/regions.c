/* regions.c -- counts gcc's parallel regions: the linker puts itself between them and libgomp. */
#include "tools.h"

#include <math.h>

void __real_GOMP_parallel(void (*body)(void *), void *data, unsigned threads, unsigned flags);
void __wrap_GOMP_parallel(void (*body)(void *), void *data, unsigned threads, unsigned flags);

static struct bench_regions so_far;
static bool alone;

/* Of one look at the clock [s]: the least mean of some. */
static double clock_takes(void)
{
    enum { LOOKS = 1000, TIMES = 5 };
    double least = HUGE_VAL;

    for (int k = 0; k < TIMES; k++) {
        const double start = bench_wall();

        for (int i = 1; i < LOOKS; i++)
            bench_wall();
        least = fmin(least, (bench_wall() - start) / LOOKS);
    }
    return least;
}

void bench_regions_alone(bool on)
{
    alone = on;
    so_far.clock = clock_takes();
}

/* The clock on the wall, as that of the process takes a microsecond on some machines, and more of
 * what comes after it; and only while there is something to measure.
 * threads: 1 where the region's `if` says no, 0 for as many as there may be. */
void __wrap_GOMP_parallel(void (*body)(void *), void *data, unsigned threads, unsigned flags)
{
    const bool several = threads != 1, timed = alone && several;
    const double start = timed ? bench_wall() : 0;

    __real_GOMP_parallel(body, data, alone ? 1 : threads, flags);
    so_far.n += several;
    if (timed)
        so_far.inside += bench_wall() - start;
}

struct bench_regions bench_regions(void)
{
    return so_far;
}
