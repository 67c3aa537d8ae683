/* contact-others.h -- how much of the kernel around a particle of a solid other solids fill,
 * those that move against its own:
 *
 *   o_w = sum_v m_v W(x_w - x_v)                                   v of other groups
 *   g(o) = s (sqrt(1 + h^2) - sqrt((o/s - 1)^2 + h^2)),  h = 0.02, s = rho0 s_w
 *
 * g is o up to s, where no room is left, and falls where solids stand in one another, so that
 * these do not press. */
#ifndef WALLS_CONTACT_OTHERS_H
#define WALLS_CONTACT_OTHERS_H

#include "walls/contact-mean.h"

struct contact_others {
    const struct kernel_use *kernel;
    const struct scales *scales;
    int n, groups, still; /* members of the first groups that never move          */
    int *from, *member;  /* [groups + 1] into member: particles of the mean, by group */
    double *room;        /* [n] s [kg/m^D]                                             */
};

enum { CONTACT_BLOCK = 16 }; /* members that have a box in common */

/* What a search works in. */
struct contact_others_work {
    double (*x)[DIM];           /* [n] where particles of the mean are now [m]  */
    double (*low)[DIM], (*high)[DIM]; /* [groups] the box of each               */
    double (*box)[2][DIM];      /* of its blocks                                 */
    int placed;                 /* so many members stand where they are for good */
    int *one, *other;           /* [n] those that may be near each other        */
    int *last, *before;         /* [n] chains of the others in a bin             */
};

int contact_others_create(struct contact_others *o, const struct part_places *at,
                          const struct contact_mean *mean, const struct contact_share *share);
void contact_others_free(struct contact_others *o);
int contact_others_work(const struct contact_others *o, struct contact_others_work *w);
void contact_others_work_free(struct contact_others_work *w);

/* Particles i and j of the mean at w->x, r apart; step from i to j. */
typedef void contact_others_see(void *self, int i, int j, double r, const double *step);

/* To be called when w->x of members w->placed and on are new, before visits. */
void contact_others_place(const struct contact_others *o, struct contact_others_work *w);

/* Tells of all pairs of different groups within the support, once each, always in the same
 * order. */
void contact_others_visit(const struct contact_others *o, struct contact_others_work *w,
                          contact_others_see *see, void *self);

/* g of particle i, and its slope; where no others are, as around most, g is 0 to the bit. */
#define CONTACT_SOFT 0.02 /* h */
double contact_others_near(const struct contact_others *o, int i, double around, double *slope);

static inline double contact_others_fill(const struct contact_others *o, int i, double around,
                                         double *slope)
{
    if (around != 0)
        return contact_others_near(o, i, around, slope);
    *slope = 1 / __builtin_sqrt(1 + CONTACT_SOFT * CONTACT_SOFT);
    return 0;
}

#endif
