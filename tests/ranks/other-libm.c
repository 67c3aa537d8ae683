/* other-libm.c -- pow() of another library, in the last bits: preloaded to one rank by tests/ranks.sh. */
#define _GNU_SOURCE
#include <dlfcn.h>

double pow(double x, double y)
{
    double (*const usual)(double, double) = (double (*)(double, double))dlsym(RTLD_NEXT, "pow");

    return usual(x, y) * (1 + 0x1p-50);
}
