/* version.c -- versions of the program and of what it stands on. */
#include "cli/cli.h"

#include <gsl/gsl_version.h>
#include <libconfig.h>
#include <stdio.h>
#include <sundials/sundials_config.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

void cli_version(void)
{
    printf("stiffwater %s\nSUNDIALS %s\nGSL %s (built with %s)\nlibconfig %d.%d.%d\n",
           PACKAGE_VERSION, SUNDIALS_VERSION, gsl_version, GSL_VERSION,
           LIBCONFIG_VER_MAJOR, LIBCONFIG_VER_MINOR, LIBCONFIG_VER_REVISION);
#ifdef STIFFWATER_HDF5_VERSION
    printf("HDF5 %s\n", STIFFWATER_HDF5_VERSION);
#endif
#ifdef _OPENMP
    printf("OpenMP %d\n", _OPENMP);
#else
    puts("OpenMP: not built in");
#endif
    puts("Licence GPL-3.0-or-later; no warranty.");
}
