/* version.c -- versions of the program and of what it stands on. */
#include "cli/cli.h"

#include <H5public.h>
#include <gsl/gsl_version.h>
#include <stdio.h>
#include <sundials/sundials_config.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

void cli_version(FILE *to)
{
    fprintf(to, "stiffwater %s\nSUNDIALS %s\nGSL %s (built with %s)\n", PACKAGE_VERSION,
           SUNDIALS_VERSION, gsl_version, GSL_VERSION);
    fprintf(to, "HDF5 %d.%d.%d\n", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
#ifdef _OPENMP
    fprintf(to, "OpenMP %d\n", _OPENMP);
#else
    fputs("OpenMP: not built in\n", to);
#endif
    fputs("Licence GPL-3.0-or-later; no warranty.\n", to);
}
