/* memory.c -- how much memory this machine can give, and how much was taken. */
#include "state/memory.h"

#include <stdio.h>
#include <sys/resource.h>
#include <unistd.h>

static double free_pages(void)
{
#ifdef _SC_AVPHYS_PAGES
    const double pages = sysconf(_SC_AVPHYS_PAGES), size = sysconf(_SC_PAGESIZE);

    return pages > 0 && size > 0 ? pages * size : 0;
#else
    return 0;
#endif
}

double memory_available(const char *meminfo)
{
    char line[256];
    double kib = 0;
    FILE *file = fopen(meminfo, "r");

    while (file && !(kib > 0) && fgets(line, sizeof line, file))
        if (sscanf(line, "MemAvailable: %lf kB", &kib) != 1)
            kib = 0;
    if (file)
        fclose(file);
    return kib > 0 ? 1024 * kib : free_pages();
}

double memory_peak(void)
{
    struct rusage u;

    getrusage(RUSAGE_SELF, &u);
    return 1024.0 * u.ru_maxrss;
}
