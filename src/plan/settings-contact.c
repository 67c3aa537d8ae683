/* settings-contact.c -- rows of the group `contact`. */
#include "plan/settings-contact.h"

#include <math.h>
#include <stddef.h>

#define AT(member) .offset = offsetof(struct settings_contact, member)

static const char *const laws[] = { "as-others", "soft", "hertz-mindlin", NULL };

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
    { .key = "law", .unit = "", .type = PARAM_WORD, AT(law), .words = laws,
      .about = "soft: as deep as softness says; hertz-mindlin (3D): as hard as balls of these materials, which "
      "has its price in steps; as-others: as another `contact` that fits has it, and soft without" },
    { .key = "young", .unit = "Pa", AT(young), .max = 1e15,
      .about = "of hertz-mindlin: Young's modulus of the first" },
    { .key = "poisson", .unit = "", AT(poisson), .fallback = 0.3, .max = 0.5,
      .about = "Poisson's ratio of the first" },
    { .key = "young_with", .unit = "Pa", AT(young_with), .max = 1e15,
      .about = "Young's modulus of the other; 0: that of the first" },
    { .key = "poisson_with", .unit = "", AT(poisson_with), .fallback = NAN, .max = 0.5,
      .about = "Poisson's ratio of the other; computed: that of the first" },
    { 0 },
};
