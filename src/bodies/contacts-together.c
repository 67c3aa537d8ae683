/* contacts-together.c -- two solids that press at several places at once. */
#include "bodies/contacts-together.h"

#include <math.h>
#include <string.h>

/* No place meets more than that many times what it meets alone: what others lift away from it
 * would meet infinitely much. */
static const double most = 2;

/* Along which a place pushes: normal in space, levers of a and b, each in its own frame.  Signs are those
 * of the push on a. */
struct line {
    double normal[DIM], lever[2][TURNING_SPINS];
};

static void line_of(const struct contacts_guest guest[2], const struct contacts_spot *s, int which,
                    struct line *to)
{
    const struct contacts_guest *g = &guest[which];

    solid_space(g->partner_at, s->normal, to->normal);
    contacts_spot_levers(g, s, to->lever[which], to->lever[!which]);
    for (int d = 0; d < DIM && which; d++)
        to->normal[d] = -to->normal[d];
    for (int k = 0; k < TURNING_SPINS && which; k++) {
        to->lever[0][k] = -to->lever[0][k];
        to->lever[1][k] = -to->lever[1][k];
    }
}

/* What a push along the one accelerates the other by. */
static double yields(const struct contacts_guest *g, const struct line *one, const struct line *other)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += one->normal[d] * other->normal[d];
    sum *= 1 / g->guest->mass + 1 / g->partner->mass;
    for (int k = 0; k < TURNING_SPINS; k++)
        sum += one->lever[0][k] * other->lever[0][k] / g->guest->inertia[k]
             + one->lever[1][k] * other->lever[1][k] / g->partner->inertia[k];
    return sum;
}

/* Without k, which all of a pair have in common. */
static double pressing(const struct contacts_spot *s)
{
    return s->share * s->depth * sqrt(s->depth);
}

void contacts_together(const struct contacts_guest guest[2], struct contacts_spots *of)
{
    struct line all = { .normal = { 0 } }, one;

    for (int i = 0; i < of->n; i++) {
        const double by = pressing(&of->spot[i]);
        line_of(guest, &of->spot[i], of->which[i], &one);
        for (int d = 0; d < DIM; d++)
            all.normal[d] += by * one.normal[d];
        for (int k = 0; k < TURNING_SPINS; k++) {
            all.lever[0][k] += by * one.lever[0][k];
            all.lever[1][k] += by * one.lever[1][k];
        }
    }
    for (int i = 0; i < of->n; i++) {
        struct contacts_spot *s = &of->spot[i];
        const double by = pressing(s);
        line_of(guest, s, of->which[i], &one);
        const double alone = by * yields(guest, &one, &one), together = yields(guest, &one, &all);
        s->carried = fmin(most, together > 0 ? alone / together : most) / s->share;
    }
}
