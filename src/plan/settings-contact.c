/* settings-contact.c -- rows of the group `contact`. */
#include "plan/settings-contact.h"

#include <math.h>
#include <stddef.h>

#define AT(member) .offset = offsetof(struct settings_contact, member)

const struct param settings_contact_params[] = {
    { .key = "of", .unit = "", .type = PARAM_TEXT, AT(of), .required = 1,
      .about = "one solid, as body.NAME, beam.NAME or wall.NAME, or all of a kind: body, beam, wall, or "
      "side, of the domain" },
    { .key = "with", .unit = "", .type = PARAM_TEXT, AT(with), .required = 1,
      .about = "the other, named likewise" },
    { .key = "friction", .unit = "", AT(friction), .fallback = NAN, .max = 10,
      .about = "coefficient of friction between these two; computed: by those of both" },
    { .key = "restitution", .unit = "", AT(restitution), .fallback = NAN, .min = 0.1, .max = 1,
      .about = "speed after a central impact of these two by that before it; computed: by those of "
      "both" },
    { 0 },
};
