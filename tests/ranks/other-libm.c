/* other-libm.c -- a function of another library, preloaded to one rank by tests/ranks.sh: pow() in the last
 * bits; or with COUNTS hypot(), so that walls are longer. */
#define _GNU_SOURCE
#include <dlfcn.h>

#ifdef COUNTS
double hypot(double x, double y)
{
    double (*const usual)(double, double) = (double (*)(double, double))dlsym(RTLD_NEXT, "hypot");

    return 1.2 * usual(x, y);
}
#else
double pow(double x, double y)
{
    double (*const usual)(double, double) = (double (*)(double, double))dlsym(RTLD_NEXT, "pow");

    return usual(x, y) * (1 + 0x1p-50);
}
#endif
