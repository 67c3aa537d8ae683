/* rearrange.c -- a pair list when particles change rows. */
#include "space/list-private.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

/* Row i becomes what row from[i] was. */
static void move_rows(double *x, int n, const int *from, double *scratch)
{
    memcpy(scratch, x, (size_t)n * DIM * sizeof *x);
    for (int i = 0; i < n; i++)
        memcpy(x + (size_t)i * DIM, scratch + (size_t)from[i] * DIM, DIM * sizeof *x);
}

/* All else in a list follows from these positions. Those left out are infinite, and
 * are left out again. */
int list_rearrange(struct list *list, const int *const from[KINDS],
                   const int *const row[KINDS], list_rows *rows)
{
    const long builds = list->builds;
    struct cloud cloud = { 0 };
    double *scratch;
    int status;

    if (!list->stands)
        return STATUS_DONE;
    scratch = malloc(((size_t)list->n + 1) * DIM * sizeof *scratch);
    if (!scratch)
        return list_no_memory(list);
    for (int kind = 0; kind < KINDS; kind++) {
        double *built = list->own->built + (size_t)list->def.from[kind] * DIM;

        if (from[kind]) {
            move_rows(built, list->def.from[kind + 1] - list->def.from[kind], from[kind], scratch);
            list->own->sorted &= ~KIND_BIT(kind);
        }
        cloud.x[kind] = built;
        cloud.row[kind] = row[kind];
    }
    memcpy(cloud.from, list->def.from, sizeof cloud.from);
    status = list_rebuild(list, &cloud, rows);
    free(scratch);
    list->builds = builds;
    return status;
}
