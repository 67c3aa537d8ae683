/* settings-mps.c -- rows of the group `mps`, and what its bundles stand for. */
#include "plan/settings-mps.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static const char *const bundles[] = { "standard", "enhanced", "no-cheating", NULL };
static const char *const sources[] = { "bundle", "number-density", "hs", "ecs", NULL };
static const char *const laplacians[] = { "bundle", "standard", "hl", NULL };
static const char *const gradients[] = { "bundle", "minimum", "cmps", "gc", NULL };
static const char *const constants[] = { "lattice", "published", NULL };
static const char *const preconditioners[] = { "ic0", "multigrid", NULL };
static const char *const switches[] = { "bundle", "on", "off", NULL };

#define AT(member) .offset = offsetof(struct settings_mps, member)
#define WORD(member, list) .unit = "", .type = PARAM_WORD, AT(member), .words = list

const struct param settings_mps_params[] = {
    { .key = "bundle", WORD(bundle, bundles),
      .about = "what all keys of this group that say \"bundle\" stand for: standard is MPS of 1996; "
      "enhanced is HS, HL, ECS, GC and DS with clamp and collisions; no-cheating the same "
      "without these two" },
    { .key = "re", .unit = "spacings", AT(re), .fallback = 2.4, .min = 1.5, .max = 4,
      .about = "radius of the weight function; walls must be as thick" },
    { .key = "re_gradient", .unit = "spacings", AT(re_gradient), .fallback = NAN, .min = 1.1,
      .max = 4, .about = "that of the gradient; computed: re. Published: 2.1" },
    { .key = "re_laplacian", .unit = "spacings", AT(re_laplacian), .fallback = NAN, .min = 1.1,
      .max = 4, .about = "that of the Laplacian; computed: re. Published: 3.1" },
    { .key = "beta", .unit = "n0", AT(beta), .fallback = 0.97, .min = 0.5, .max = 1,
      .about = "where the number density is less, there is a surface, and the pressure is 0" },
    { .key = "source", WORD(source, sources),
      .about = "source of the Poisson equation: the deviation of the number density (standard), its "
      "rate (hs), or its rate with corrections (ecs)" },
    { .key = "hs_constant", WORD(hs_constant, constants),
      .about = "lattice: the rate of the number density is divided by what it is for a "
      "divergence of 1; published: it is not" },
    { .key = "gamma", .unit = "1", AT(gamma), .fallback = 1, .min = 0, .max = 1,
      .about = "share of the number density's deviation that one step takes back; 0.2 in later codes. "
      "In 2D with re = 2.4 more than 0.875 makes waves grow from step to step: noise" },
    { .key = "drift", .unit = "1", AT(drift), .fallback = 0, .min = 0, .max = 1,
      .about = "the same share beside source = \"hs\"; 0.005 to 0.05 in papers" },
    { .key = "laplacian", WORD(laplacian, laplacians),
      .about = "of the pressure: standard, or that of weights re/r^3 (hl)" },
    { .key = "hl_constant", WORD(hl_constant, constants),
      .about = "lattice: exact for quadratic pressures on a lattice; published: (5 - D)/n0, which "
      "is 2.3 times too strong in 2D" },
    { .key = "gradient", WORD(gradient, gradients),
      .about = "of the pressure: from the smallest pressure around (minimum), antisymmetric and "
      "so with momentum (cmps), or exact for linear pressures (gc)" },
    { .key = "clamp", WORD(clamp, switches), .about = "whether negative pressures become 0" },
    { .key = "collisions", WORD(collisions, switches),
      .about = "whether particles that are too near to each other collide" },
    { .key = "ds", WORD(ds, switches),
      .about = "dynamic stabilisation: pushes pairs apart that the pressure brought too near" },
    { .key = "restitution", .unit = "1", AT(restitution), .fallback = 0.2, .max = 1,
      .about = "of collisions" },
    { .key = "collision_distance", .unit = "spacings", AT(collision_distance), .fallback = 0.5,
      .min = 0, .max = 1, .about = "nearer particles collide" },
    { .key = "ds_distance", .unit = "spacings", AT(ds_distance), .fallback = 0.8, .min = 0,
      .max = 1, .about = "distance that ds restores; 1 less the CFL number" },
    { .key = "compressibility", .unit = "1/Pa", AT(compressibility), .fallback = 0, .max = 1,
      .about = "of the fluid; fluid without a surface needs it, about 1/(rho0 c0^2). Water has 4.5e-10" },
    { .key = "nu", .unit = "m^2/s", AT(nu), .fallback = 0, .max = 10,
      .about = "kinematic viscosity by the Laplacian of MPS, explicit; laws of the scene act beside it" },
    { .key = "residual", .unit = "1", AT(residual), .fallback = 1e-6, .min = 1e-14, .max = 0.5,
      .about = "of the Poisson equation, over its source, at which the solve ends" },
    { .key = "iterations", .unit = "", .type = PARAM_INTEGER, AT(iterations), .fallback = 2000,
      .min = 1, .max = 1e6, .about = "of one solve; if more are needed the run fails" },
    { .key = "preconditioner", WORD(preconditioner, preconditioners),
      .about = "of the conjugate gradients: an incomplete Cholesky factor without fill (ic0), or a "
      "cycle of HYPRE's BoomerAMG (multigrid), which the programs with MPI have: run --ranks 1" },
    { 0 },
};

static void stand_for(const char **word, const char *choice)
{
    if (strcmp(*word, "bundle") == 0)
        *word = choice;
}

void settings_mps_complete(struct settings_mps *s)
{
    const int better = strcmp(s->bundle, "standard") != 0;
    const char *const cheats = strcmp(s->bundle, "no-cheating") == 0 ? "off" : "on";

    if (isnan(s->re_gradient))
        s->re_gradient = s->re;
    if (isnan(s->re_laplacian))
        s->re_laplacian = s->re;
    stand_for(&s->source, better ? "ecs" : "number-density");
    stand_for(&s->laplacian, better ? "hl" : "standard");
    stand_for(&s->gradient, better ? "gc" : "minimum");
    stand_for(&s->clamp, cheats);
    stand_for(&s->collisions, cheats);
    stand_for(&s->ds, better ? "on" : "off");
}
