/* columns.c -- gathers the header of a table and opens it. */
#include "run/columns.h"

#include "base/status.h"
#include "output/aside.h"

#include <stdarg.h>
#include <stdio.h>

void columns_start(struct columns *c)
{
    c->n = 0;
    columns_add(c, "s", "t");
}

void columns_add(struct columns *c, const char *unit, const char *format, ...)
{
    va_list args;

    if (c->n++ >= COLUMNS_MOST)
        return;
    va_start(args, format);
    vsnprintf(c->name[c->n - 1], COLUMNS_NAME, format, args);
    va_end(args);
    snprintf(c->unit[c->n - 1], sizeof c->unit[0], "%s", unit);
}

int columns_open(const struct columns *c, struct series **out, const char *dir, const char *file)
{
    const char *name[COLUMNS_MOST], *unit[COLUMNS_MOST];
    char path[ASIDE_PATH];

    if (c->n == 1)
        return STATUS_DONE;
    if (c->n > COLUMNS_MOST)
        return status_fail(STATUS_BAD_SCENE, "%s would have %d columns, more than %d: use fewer "
                           "walls, beams, bodies, panels or probes", file, c->n, COLUMNS_MOST);
    if (c->tried)
        return STATUS_DONE;
    for (int i = 0; i < c->n; i++) {
        name[i] = c->name[i];
        unit[i] = c->unit[i];
    }
    TRY(aside_join(path, dir, file));
    return c->again ? series_open_again(out, path, c->n)
                    : series_open(out, path, c->n, name, unit);
}

void columns_close(struct series **s, int *status)
{
    const int closed = series_close(s);

    if (*status == STATUS_DONE)
        *status = closed;
}
