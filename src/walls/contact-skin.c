/* contact-skin.c -- the room that points of a skin fill, at rest. */
#include "walls/contact-skin.h"

#include <math.h>
#include <string.h>

/* A search among the points of the skin that has point i. */
struct search {
    const struct part_places *at;
    int first, me;            /* id of the first solid; point number            */
    const double *along;      /* points near the line across this; NULL: all      */
    double nearest, step[DIM];
};

static void keep_nearest(void *self, int j, double r, const double *step)
{
    struct search *s = self;
    const int *object = s->at->p->object_of + s->first;
    double part = 0;

    for (int d = 0; s->along && d < DIM; d++)
        part += step[d] * s->along[d];
    if (j == s->me || object[j] != object[s->me] || !(r < s->nearest) || fabs(part) > 0.3 * r)
        return;
    s->nearest = r;
    memcpy(s->step, step, sizeof s->step);
}

#if DIM == 2
void contact_skin_fit(const struct part_places *at, const struct contact_cells *cells, int i,
                      struct contact_skin *to)
{
    const double dx = at->p->scales->dx;
    struct search s = { .at = at, .first = at->p->from[KIND_WALL], .me = i, .nearest = 1.9 * dx,
                        .step = { 1.9 * dx } };

    contact_cells_visit(cells, cells->x[i], keep_nearest, &s);
    to->axis[0][0] = s.step[0] / s.nearest;
    to->axis[0][1] = s.step[1] / s.nearest;
    to->axis[1][0] = -to->axis[0][1];
    to->axis[1][1] = to->axis[0][0];
    to->half[0] = s.nearest < 1.9 * dx ? s.nearest / 2 : dx / 2;
    s.along = to->axis[0];
    s.nearest = 1.9 * dx;
    contact_cells_visit(cells, cells->x[i], keep_nearest, &s);
    to->alone = !(s.nearest < 1.9 * dx);
    to->half[1] = to->alone ? dx / 2 : s.nearest / 2;
}
#else
void contact_skin_fit(const struct part_places *at, const struct contact_cells *cells, int i,
                      struct contact_skin *to)
{
    (void)cells; /* no skin in space has sides that are not along the axes */
    (void)i;
    (void)keep_nearest;
    for (int d = 0; d < DIM; d++) {
        for (int e = 0; e < DIM; e++)
            to->axis[d][e] = d == e;
        to->half[d] = at->p->scales->dx / 2;
    }
}
#endif

bool contact_skin_fills(const struct contact_skin *s, const double *step)
{
    for (int d = 0; d < DIM; d++) {
        double part = 0;
        for (int e = 0; e < DIM; e++)
            part += s->axis[d][e] * step[e];
        if (fabs(part) > s->half[d] * (1 + 1e-9))
            return false;
    }
    return true;
}

bool contact_skin_reaches(const struct contact_skin *s, const double *step, double half)
{
    for (int d = 0; d < DIM; d++) {
        double part = 0, reach = s->half[d];
        for (int e = 0; e < DIM; e++) {
            part += s->axis[d][e] * step[e];
            reach += fabs(s->axis[d][e]) * half;
        }
        if (fabs(part) > reach * (1 + 1e-6))
            return false;
    }
    return true;
}
