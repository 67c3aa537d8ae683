/* claims.c -- claims that all ranks make together. */
#include "claims.h"

#include "ranks/ranks.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>

static int tried, failed;

void claim(bool true_here, const char *format, ...)
{
    double wrong = !true_here;
    va_list more;

    ranks_most(1, &wrong);
    tried++;
    failed += wrong > 0;
    if (ranks_me() > 0)
        return;
    printf("%s %d ranks: ", wrong > 0 ? "NOT SO " : "ok     ", ranks_count());
    va_start(more, format);
    vprintf(format, more);
    va_end(more);
    printf("\n");
}

int claims_end(void)
{
    return tried == 0 || failed > 0;
}

/* A step of splitmix64 (Steele, Lea and Flood 2014). */
double claims_random(unsigned number)
{
    uint64_t z = (number + 1) * UINT64_C(0x9e3779b97f4a7c15);

    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}
