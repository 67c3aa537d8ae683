/* contact-beside.c -- the points of skins near a particle. */
#include "walls/contact-beside.h"

#include <string.h>

void contact_beside_add(struct contact_beside *b, int point, const double *step)
{
    if (b->n == CONTACT_BESIDE_MOST)
        return;
    b->point[b->n] = point;
    memcpy(b->step[b->n++], step, sizeof b->step[0]);
}

void contact_beside_keep(struct contact_beside *b, int cuts, const double *middle, double half)
{
    const bool all = cuts == CONTACT_BESIDE_CUTS;
    const int n = all ? b->n : b->count[cuts + 1];

    b->count[cuts] = 0;
    for (int i = 0; i < n; i++) {
        const int k = all ? i : b->reach[cuts + 1][i];
        double step[DIM];
        for (int d = 0; d < DIM; d++)
            step[d] = middle[d] - b->step[k][d];
        if (contact_skin_reaches(&b->skin[b->point[k]], step, half))
            b->reach[cuts][b->count[cuts]++] = k;
    }
}

bool contact_beside_fills(const struct contact_beside *b, int cuts, const double *step)
{
    for (int i = 0; i < b->count[cuts]; i++) {
        const int k = b->reach[cuts][i];
        double x[DIM];
        for (int d = 0; d < DIM; d++)
            x[d] = step[d] - b->step[k][d];
        if (contact_skin_fills(&b->skin[b->point[k]], x))
            return true;
    }
    return false;
}
