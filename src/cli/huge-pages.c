/* huge-pages.c -- memory in large pages for the program that is started next.
 *
 * Arrays of particles are read in an order of their own, so that with pages of 4 kB the processor
 * looks for addresses much of the time.  glibc asks for large pages where its tunable says so
 * (https://sourceware.org/glibc/manual/html_node/Memory-Allocation-Tunables.html); it reads that
 * when a program starts.  Other libraries and kernels take no notice. */
#include "cli/cli.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void cli_huge_pages(void)
{
    static const char name[] = "GLIBC_TUNABLES", ours[] = "glibc.malloc.hugetlb";
    const char *given = getenv(name);
    char all[4096];

    if (given && strstr(given, ours)) /* the user knows better */
        return;
    if (snprintf(all, sizeof all, "%s%s%s=1", given ? given : "", given && *given ? ":" : "", ours)
        < (int)sizeof all)
        setenv(name, all, 1);
}
