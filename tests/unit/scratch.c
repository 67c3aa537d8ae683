/* scratch.c -- a directory that a unit test may fill, and numbers that are near. */
#include "scratch.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char scratch[64];

int scratch_make(void **state)
{
    (void)state;
    strcpy(scratch, P_tmpdir "/scratch.XXXXXX");
    return mkdtemp(scratch) ? 0 : -1;
}

int scratch_remove(void **state)
{
    char command[128];

    (void)state;
    snprintf(command, sizeof command, "rm -r %s", scratch);
    return system(command);
}

void near(double found, double wanted, double tolerance)
{
    if (!(fabs(found - wanted) <= tolerance))
        fail_msg("%.15g instead of %.15g", found, wanted);
}
