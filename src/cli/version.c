/* version.c -- versions of the program and of what it stands on. */
#include "cli/cli.h"

#include <H5public.h>
#include <gsl/gsl_version.h>
#include <stdio.h>
#include <sundials/sundials_config.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

void cli_version(void)
{
    printf("stiffwater %s\nSUNDIALS %s\nGSL %s (built with %s)\n", PACKAGE_VERSION,
           SUNDIALS_VERSION, gsl_version, GSL_VERSION);
    printf("HDF5 %d.%d.%d\n", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
#ifdef _OPENMP
    printf("OpenMP %d\n", _OPENMP);
#else
    puts("OpenMP: not built in");
#endif
    puts("Licence GPL-3.0-or-later; no warranty.");
}
