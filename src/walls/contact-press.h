/* contact-press.h -- the pressure of solids of walls = "contact", once for all lane widths; the
 * equations are in contact.c. */
#ifndef WALLS_CONTACT_PRESS_H
#define WALLS_CONTACT_PRESS_H

#include "matter/eos.h"
#include "walls/contact-mean.h"
#include "walls/contact-others.h"

struct contact_press_self {
    struct eos eos;
    const struct kernel_use *kernel; /* of densities                              */
    struct contact_mean mean;
    struct contact_others others;
    double *missing;                 /* [solids] by id: lack + g(o) at t = 0 [kg/m^D] */
};

/* Members of the part. */
int contact_press_prepare(void *self, const struct scales *s);
extern const struct part_press contact_press;

#endif
