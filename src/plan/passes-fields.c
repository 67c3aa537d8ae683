/* passes-fields.c -- the fields of an evaluation: their names, units and widths. */
#include "plan/passes.h"

#include "space/kinds.h"

#include <stdio.h>

enum { FLUID = KIND_BIT(KIND_FLUID), EVERY = KIND_BIT(KINDS) - 1 };

struct field {
    const char *name, *unit; /* forces and powers in 2D: of a metre of depth */
    int width;               /* numbers of a particle; 0: not of particles           */
    unsigned kinds;          /* whose; 0: of no kind's                                      */
};

static const struct field fields[PASS_FIELDS] = {
    { "position", "m", DIM, FLUID },
    { "velocity", "m/s", DIM, FLUID },
    { "solid motion", "m, m/s", 2 * DIM, KIND_SOLIDS },
    { "pairs", "", 0, EVERY },
    { "records", "", 0, EVERY },
    { "density", "kg/m^3", 1, FLUID },
    { "solid density", "kg/m^3", 1, KIND_SOLIDS },
    { "pressure", "Pa", 1, FLUID },
    { "solid pressure", "Pa", 1, KIND_SOLIDS },
    { "drift", "m/s", DIM, FLUID },
    { "push", "m/s^2", DIM, FLUID },
    { "slip", "m/s", DIM, KIND_STICKY },
    { "acceleration without pressure", "m/s^2", DIM, FLUID },
    { "force", "N", DIM, EVERY },
    { "power", "W", 0, 0 },
    { "rate of density", "kg/m^3/s", 1, EVERY },
    { "rate of position", "m/s", DIM, FLUID },
    { "acceleration", "m/s^2", DIM, FLUID },
    { "force on solids", "N", 0, 0 },
    { "force on skins", "N", DIM, 0 },
    { "rates of bodies", "", 0, 0 },
    { "book", "W, N", 0, 0 },
    { "book of a half", "W", 0, 0 },
    { "push on solids", "N", DIM, KIND_SOLIDS },
};

/* Text goes on at n, which may be beyond the room. */
static size_t append(char *text, size_t room, size_t n, const char *word)
{
    return n < room ? n + (size_t)snprintf(text + n, room - n, "%s", word) : n;
}

void passes_names(unsigned bits, char *text, size_t room)
{
    size_t n = 0;

    text[0] = '\0';
    for (int i = 0; i < PASS_FIELDS; i++) {
        if (!(bits & (1u << i)))
            continue;
        n = append(text, room, n, n > 0 ? ", " : "");
        n = append(text, room, n, fields[i].name);
    }
}

void passes_field(int i, const char **name, const char **unit, int *width)
{
    *name = fields[i].name;
    *unit = fields[i].unit;
    *width = fields[i].width;
}

unsigned passes_of_kinds(unsigned kinds)
{
    unsigned bits = 0;

    for (int i = 0; i < PASS_FIELDS; i++)
        if (!fields[i].kinds || (fields[i].kinds & kinds))
            bits |= 1u << i;
    return bits;
}
