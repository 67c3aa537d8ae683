/* settings-contact.h -- the group `contact` of a scene: friction and restitution of pairs. */
#ifndef PLAN_SETTINGS_CONTACT_H
#define PLAN_SETTINGS_CONTACT_H

#include "base/param.h"

struct settings_contact {
    const char *of, *with;         /* paths of solids, or their groups         */
    double friction, restitution;  /* NaN: as both have it            [1]      */
    const char *law;               /* "as-others", "soft", "hertz-mindlin"    */
    double young, poisson;         /* of `of`                         [Pa, 1]  */
    double young_with, poisson_with; /* of `with`; 0, NaN: the same    [Pa, 1]  */
};

extern const struct param settings_contact_params[];

#endif
