/* viscosity-side.h -- the keys by which a viscosity that is linear in velocities is
 * taken explicitly, or implicitly with the stiff side of bodies (implicit/viscous.h), and
 * sticks to solids at their faces or where their particles are (eval/face.h). */
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

/* The file's words `sticks`: its default first. */
#define VISCOSITY_STICK(self)                                                            \
    { .key = "stick", .unit = "", .offset = offsetof(self, stick), .type = PARAM_WORD,   \
      .words = sticks,                                                                   \
      .about = "where the fluid has the velocity of a solid: at its \"face\", or where its " \
               "\"particles\" are, half a spacing and more behind the face" }

static inline bool viscosity_at_faces(const char *stick)
{
    return strcmp(stick, "face") == 0;
}

static inline bool viscosity_is_implicit(const char *side)
{
    return strcmp(side, "implicit") == 0;
}

#endif
