/* version.c -- versions of the program and of what it stands on. */
#include "cli/cli.h"

#include <H5public.h>
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
    printf("HDF5 %d.%d.%d\n", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
#ifdef _OPENMP
    printf("OpenMP %d\n", _OPENMP);
#else
    puts("OpenMP: not built in");
#endif
    puts("Licence GPL-3.0-or-later; no warranty.");
}
