/* contacts-skin.h -- the skin of a beam that touches a solid: each of its points is a ball of
 * half a spacing, so that the skin's face is where it is for the water (CT3). */
#ifndef BODIES_CONTACTS_SKIN_H
#define BODIES_CONTACTS_SKIN_H

#include "bodies/contacts-rules.h"
#include "bodies/contacts.h"
#include "bodies/touch.h"

struct contacts_skin {
    int body;                  /* whose skin                                       */
    int second;                /* the solid                                        */
    const struct solid *solid;
    struct solid point;        /* one point                                        */
    struct touch_law law;
    double depth, rate, slow;  /* as in struct contacts_pair                       */
    long from;                 /* its first place, one for each point              */
    int points;
};

/* All but body, second and from; of a body that has a surface. */
void contacts_skin_make(struct contacts_skin *p, const struct contacts_body *body,
                        const struct body_surface *surface, const struct solid *solid,
                        const struct contacts_rub *rub, const struct scales *s);

/* As contacts_pair_meet(); adds to forces on the skin, and to its push what walls give. */
int contacts_skin_meet(const struct contacts_skin *p, const struct scales *s,
                       struct contacts_body *body, const struct solid_place *at, const double *xi,
                       double *xi_rate, struct body_push *on_solid, double power[2]);

double contacts_skin_rate(const struct contacts_skin *p, const struct scales *s,
                          const struct contacts_body *body, const struct solid_place *at);

#endif
