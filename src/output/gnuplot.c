/* gnuplot.c -- runs gnuplot in the directory of the figures. */
#include "output/gnuplot.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/program.h"
#include <errno.h>
#include <string.h>

static int refused(int error)
{
    if (error == ENOENT)
        return status_fail(STATUS_IO,
                           "gnuplot was not found, so no figures were drawn; the data "
                           "are complete. On Debian: apt-get install gnuplot-nox; then draw them "
                           "with `stiffwater plot DIR`");
    return status_fail(STATUS_IO, "gnuplot cannot be started: %s", strerror(error));
}

/* -d: the user's ~/.gnuplot does not change our figures */
int gnuplot_run(const char *directory, const char *script, const char *shown)
{
    char *const words[] = { "gnuplot", "-d", (char *)script, NULL };
    char name[ASIDE_PATH], log[ASIDE_PATH];
    int error;

    TRY(aside_join(log, directory, script));
    snprintf(name, sizeof name, "%s.log", script);
    TRY(aside_join(log, directory, name));
    error = program_run(directory, words, name);
    if (error > 0)
        return refused(error);
    if (error < 0)
        return status_fail(STATUS_IO, "gnuplot could not draw %s/%s; what it said is in %s/%s",
                           shown, script, shown, name);
    remove(log);
    return STATUS_DONE;
}
