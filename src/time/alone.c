/* alone.c -- does a scene hold bodies and nothing else that moves? */
#include "time/alone.h"

static bool lies_in(const struct layout_row *r, int ranges, const long (*range)[2])
{
    for (int k = 0; k < ranges; k++)
        if (r->offset >= range[k][0] && r->offset < range[k][1])
            return true;
    return false;
}

bool alone_bodies(const struct plan *plan)
{
    const struct layout *l = plan_layout(plan);
    long range[LAYOUT_ROWS][2];
    const int ranges = plan_stiff_ranges(plan, l, LAYOUT_ROWS, range);

    for (int i = 0; i < l->rows; i++)
        if (l->row[i].scale > 0 && !lies_in(&l->row[i], ranges, (const long (*)[2])range))
            return false;
    return ranges > 0;
}
