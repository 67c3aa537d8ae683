/* passes.c -- the passes of an evaluation, a line each.  Their order is the plan's; lines
 * that wait for nothing stay in the order of this table. */
#include "eval/passes.h"

enum { /* questions that passes are for */
    ALL = (1 << PASS_QUESTIONS) - 1,
    FORCES = PASS_FOR_RATES | PASS_FOR_APART | PASS_FOR_OTHERS | PASS_FOR_VELOCITIES,
    EXPLICIT = FORCES | PASS_FOR_DENSITIES,
    PAIRS = EXPLICIT | PASS_FOR_IMPLICIT,
    MOVES = PASS_FOR_RATES | PASS_FOR_APART | PASS_FOR_OTHERS,
    SOLVES = PASS_FOR_RATES | PASS_FOR_APART | PASS_FOR_VELOCITIES
};

static bool particles(const struct plan *p)
{
    return p->particles->n > 0;
}

static bool fluid(const struct plan *p)
{
    return p->row.x >= 0;
}

static bool bodies(const struct plan *p)
{
    return p->bodies > 0;
}

static bool faces(const struct plan *p)
{
    return p->face != NULL;
}

static bool drifts(const struct plan *p)
{
    return p->drifter != NULL;
}

static bool contacts(const struct plan *p)
{
    return p->contacts.kind != NULL;
}

static bool presses(const struct plan *p)
{
    return p->passes.press != NULL;
}

static bool apart(const struct plan *p)
{
    return p->stiff != NULL;
}

/* Body forces other than the weight give momentum, which is added up over all particles. */
static bool pulls(const struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.force && !p->part[i].part->as.force->weight)
            return fluid(p);
    return false;
}

static bool always(const struct plan *p)
{
    (void)p;
    return true;
}

static bool looks_ahead(const struct plan *p)
{
    return plan_ahead(p) > 0;
}

#define FIELDS_OF_PAIRS (PASS_RECORDS | PASS_PAIRS)
#define PLACES (PASS_POSITION | PASS_MOTION)

const struct pass passes_table[] = {
/*  name, kind
    needs, of neighbours, provides, adds to,
    questions, present, run, all */
{ "motion of solids", PASS_BODIES,
    0, 0, PASS_MOTION, 0,
    ALL, NULL, passes_motion, NULL },
{ "list of pairs", PASS_OVER_PAIRS,
    PLACES, PLACES, PASS_PAIRS, 0,
    ALL, particles, passes_list, NULL },
{ "pressure of solids", PASS_POINTWISE,
    PASS_MOTION | PASS_PAIRS, PASS_MOTION, PASS_SOLID_DENSITY | PASS_SOLID_PRESSURE, 0,
    ALL, presses, passes_press, NULL },
{ "records", PASS_POINTWISE,
    PASS_VELOCITY | PLACES | PASS_PAIRS, 0,
    PASS_RECORDS | PASS_PRESSURE | PASS_SOLID_PRESSURE, 0,
    ALL, particles, passes_records, NULL },
{ "sums", PASS_EACH_SUM,
    FIELDS_OF_PAIRS, 0, 0, 0,
    ALL, particles, passes_sum, always },
{ "body forces ahead", PASS_POINTWISE,
    PLACES | PASS_VELOCITY, 0, PASS_PUSH, 0,
    FORCES, fluid, passes_ahead, NULL },
{ "all but pressure", PASS_OVER_PAIRS,
    FIELDS_OF_PAIRS, 0, PASS_OTHERS, 0,
    SOLVES, fluid, passes_others, NULL },
{ "pressure that looks ahead", PASS_SOLVE,
    FIELDS_OF_PAIRS | PLACES | PASS_VELOCITY | PASS_DENSITY | PASS_SOLID_DENSITY | PASS_OTHERS,
    PLACES | PASS_VELOCITY, 0, PASS_PRESSURE | PASS_SOLID_PRESSURE,
    PASS_FOR_RATES | PASS_FOR_APART, looks_ahead, passes_look_ahead, always },
{ "slip at faces", PASS_OVER_PAIRS,
    FIELDS_OF_PAIRS, 0, PASS_SLIP, PASS_PUSH,
    FORCES | PASS_FOR_IMPLICIT, faces, passes_slip, always },
{ "laws between particles", PASS_OVER_PAIRS,
    FIELDS_OF_PAIRS | PASS_PUSH, 0, PASS_FORCE | PASS_POWER | PASS_DENSITY_RATE, 0,
    PAIRS, particles, passes_laws, NULL },
{ "pressure of solids ahead", PASS_POINTWISE,
    PASS_SOLID_PRESSURE, 0, 0, PASS_POWER,
    EXPLICIT, presses, passes_press_ahead, NULL },
{ "pressure between solids", PASS_POINTWISE,
    PASS_MOTION | PASS_SOLID_PRESSURE, PASS_MOTION | PASS_SOLID_PRESSURE, 0, PASS_SOLID_PUSH,
    FORCES, presses, passes_meet, NULL },
{ "forces at faces", PASS_POINTWISE,
    PASS_SLIP, 0, 0, PASS_FORCE | PASS_POWER,
    FORCES | PASS_FOR_IMPLICIT, faces, passes_faces, NULL },
{ "implicit forces apart", PASS_POINTWISE,
    0, 0, 0, PASS_FORCE | PASS_POWER,
    PASS_FOR_APART, apart, passes_apart, always },
{ "rates of the fluid", PASS_POINTWISE,
    PASS_FORCE | PLACES | PASS_VELOCITY | PASS_DENSITY, 0, PASS_ACCELERATION | PASS_POSITION_RATE,
    PASS_DENSITY_RATE,
    EXPLICIT, fluid, passes_fluid, NULL },
{ "other body forces", PASS_POINTWISE,
    PLACES | PASS_VELOCITY, 0, 0, PASS_ACCELERATION,
    FORCES, pulls, passes_pulls, always },
{ "power that looks ahead", PASS_POINTWISE,
    PASS_DENSITY_RATE, 0, 0, PASS_POWER,
    PASS_FOR_RATES | PASS_FOR_APART, looks_ahead, passes_ahead_power, NULL },
{ "drift", PASS_POINTWISE,
    PASS_DRIFT, 0, 0, PASS_POSITION_RATE | PASS_POWER,
    MOVES, drifts, passes_drift, always },
{ "forces of pairs on solids", PASS_POINTWISE,
    PASS_FORCE | PASS_PAIRS, 0, PASS_SOLID_PUSH, 0,
    FORCES, particles, passes_solid_pairs, NULL },
{ "forces on solids", PASS_POINTWISE,
    PASS_SOLID_PUSH, 0, PASS_SOLID_FORCE, 0,
    FORCES, NULL, passes_solids, NULL },
{ "forces on skins", PASS_POINTWISE,
    PASS_SOLID_PUSH, 0, PASS_SKIN_FORCE, 0,
    FORCES, bodies, passes_skins, NULL },
{ "contacts between bodies", PASS_BODIES,
    PASS_MOTION, 0, 0, PASS_SKIN_FORCE,
    FORCES, contacts, passes_contacts, NULL },
{ "loads of bodies", PASS_BODIES,
    PASS_SKIN_FORCE, 0, PASS_BODY_RATES, 0,
    FORCES, bodies, passes_load, NULL },
{ "book", PASS_POINTWISE,
    PASS_POWER | PASS_SOLID_FORCE | PASS_BODY_RATES | PASS_ACCELERATION, 0, PASS_BOOK, 0,
    FORCES, NULL, passes_book, NULL },
{ "book of the half of densities", PASS_POINTWISE,
    PASS_POWER, 0, PASS_HALF_BOOK, 0,
    PASS_FOR_DENSITIES, NULL, passes_half_book, NULL },
{ 0 },
};
