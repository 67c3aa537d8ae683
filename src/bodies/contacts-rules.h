/* contacts-rules.h -- friction and restitution of pairs of materials, where a scene names them. */
#ifndef BODIES_CONTACTS_RULES_H
#define BODIES_CONTACTS_RULES_H

#include "bodies/contacts.h"

struct contacts_rub { /* of one pair; NaN: as both have it                         */
    double restitution, friction;
    bool made;              /* of these, by Hertz and Mindlin                   */
    struct touch_material material[2];
};

/* Of a pair of these; the last rule that fits counts. */
struct contacts_rub contacts_rules_of(const struct contacts_scene *s, const char *a, const char *b);

/* STATUS_BAD_SCENE: a rule names what is not there, or says nothing. */
int contacts_rules_check(const struct contacts_scene *s);

/* "body.NAME", "beam.NAME", "wall.NAME", or "side" for a side of the domain that is no wall's;
 * part: a body, or a wall from `bodies` on. */
const char *contacts_rules_path(const struct contacts_scene *s, int part);

#endif
