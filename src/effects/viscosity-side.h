/* viscosity-side.h -- the key by which a viscosity that is linear in velocities is
 * taken explicitly, or implicitly with the stiff side of bodies (plan/viscous.h). */
#ifndef EFFECTS_VISCOSITY_SIDE_H
#define EFFECTS_VISCOSITY_SIDE_H

#include "base/param.h"
#include "effects/effects.h"

#include <string.h>

static const char *const viscosity_sides[] = { "explicit", "implicit", NULL };

#define VISCOSITY_SIDE(self)                                                             \
    { .key = "side", .unit = "", .offset = offsetof(self, side), .type = PARAM_WORD,     \
      .words = viscosity_sides,                                                          \
      .about = "\"implicit\": velocities are solved for, and no step is too long for this " \
               "effect; pays when mu/(rho0 c0 hs) is large (`check` says it)" }

static inline bool viscosity_is_implicit(const char *side)
{
    return strcmp(side, "implicit") == 0;
}

#endif
