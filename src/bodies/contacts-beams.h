/* contacts-beams.h -- the skins of two beams that touch: each point of the one is a ball of half a
 * spacing, and the other is a ball as wide as its skin that runs along its axis (CT5). */
#ifndef BODIES_CONTACTS_BEAMS_H
#define BODIES_CONTACTS_BEAMS_H

#include "bodies/contacts-rules.h"
#include "bodies/contacts.h"
#include "bodies/touch.h"

struct contacts_beams {
    int body, other;           /* whose points; whose axis                         */
    int rows, across;          /* of the other's skin; points of a row             */
    double trim;               /* where the ball begins and ends [rows]            */
    struct solid point, line;  /* a point; the ball that runs along the axis       */
    struct touch_law law;
    double depth, rate, slow;  /* as in struct contacts_pair                       */
    long from;                 /* its first place, one for each point              */
    int points;
};

/* All but body, other and from; of two bodies that have surfaces. */
void contacts_beams_make(struct contacts_beams *p, const struct contacts_body *body,
                         const struct contacts_body *other, const struct contacts_rub *rub,
                         const struct scales *s);

/* As contacts_pair_meet(); adds to forces on both skins. */
int contacts_beams_meet(const struct contacts_beams *p, const struct scales *s,
                        struct contacts_body *body, struct contacts_body *other, const double *xi,
                        double *xi_rate, double power[2]);

double contacts_beams_rate(const struct contacts_beams *p, const struct scales *s,
                           const struct contacts_body *body, const struct contacts_body *other);

#endif
