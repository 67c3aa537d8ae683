/* contact-look.c -- is a box all open to water, or all shut? */
#include "walls/contact-look.h"

#include "shapes/shape.h"

/* Does the box miss a shape for certain?  A frame has a hole. */
static bool misses(const struct shape *s, double (*const bounds)[DIM], const double *low,
                   const double *high)
{
    bool in_hole = s->kind == SHAPE_FRAME, beside = false;

    for (int d = 0; d < DIM; d++) {
        beside = beside || high[d] < bounds[0][d] || low[d] > bounds[1][d];
        in_hole = in_hole && s->low[d] <= low[d] && high[d] < s->high[d];
    }
    return beside || in_hole;
}

/* In the domain, beyond one of its sides, or across one. */
static enum contact_look place_of(const struct scales *s, const double *low, const double *high)
{
    enum contact_look place = CONTACT_OPEN;

    for (int d = 0; d < DIM; d++) {
        if (s->low[d] <= low[d] && high[d] < s->high[d])
            continue;
        if (s->period[d] > 0)
            return CONTACT_MIXED;
        if (high[d] < s->low[d] || low[d] >= s->high[d])
            place = CONTACT_SHUT;
        else if (place == CONTACT_OPEN)
            place = CONTACT_MIXED;
    }
    return place;
}

/* Solids of other groups may leave, so that their room is open wherever they stand. */
enum contact_look contact_look(const struct part_places *at, double (*const bounds)[2][DIM],
                               int group, bool skins, const double *low, const double *high)
{
    const enum contact_look place = place_of(at->p->scales, low, high);
    bool own = skins;

    for (int o = 0; o < at->p->objects && place != CONTACT_MIXED; o++) {
        const struct part_solid *solid = &at->solid[o];
        if (solid->group < 0 || !solid->shape || misses(solid->shape, bounds[o], low, high))
            continue;
        if (solid->group != group)
            return CONTACT_MIXED;
        own = true;
    }
    return place == CONTACT_OPEN && own ? CONTACT_MIXED : place;
}
