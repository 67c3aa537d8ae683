/* quantity.c -- which tables of a run have bands, and what is told of their columns. */
#include "study/quantity.h"

#include "study/bundle.h"

#include <stddef.h>
#include <string.h>

enum table_number { FRONT, FORCES, BEAM, PROBES };

const char *const quantity_tables[] = { "front", "forces", "beam", "probes", NULL };

#define PEAK (1u << BUNDLE_PEAK | 1u << BUNDLE_WHEN)
#define AVERAGE (1u << BUNDLE_AVERAGE)
#define END (1u << BUNDLE_END)

static const struct quantity rows[] = {
    { FRONT, "", true, 1u << BUNDLE_PEAK | END },
    { FORCES, ".ix", false, END },
    { FORCES, ".iy", false, END },
    { FORCES, ".iz", false, END },
    { FORCES, "", false, PEAK | AVERAGE },
    { BEAM, ".tip_x", false, PEAK | AVERAGE | END },
    { BEAM, ".tip_y", false, PEAK | AVERAGE | END },
    { BEAM, ".mid_x", false, 0 },
    { BEAM, ".mid_y", false, 0 },
    { BEAM, ".tip_angle", false, 0 },
    { BEAM, "", false, PEAK | AVERAGE },
    { PROBES, "", false, PEAK | AVERAGE },
};

static bool fits(const struct quantity *q, int table, const char *name)
{
    const size_t n = strlen(name), k = strlen(q->end);

    return q->table == table && n >= k && strcmp(name + n - k, q->end) == 0;
}

const struct quantity *quantity_find(int table, const char *name)
{
    const struct quantity *q = rows;

    while (!fits(q, table, name)) /* each table has a row that all names fit */
        q++;
    return q;
}
