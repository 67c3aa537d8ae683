/* settings.c -- rows of the keys that belong to no part. */
#include "plan/settings.h"

#include "algebra/norm.h"
#include "plan/plan.h"

#include <math.h>
#include <stddef.h>

enum { WORDS = 32 };

/* Words that tables of other rooms bring; see settings_prepare(). */
static const char *kernel_words[WORDS], *use_words[WORDS] = { "same" }, *eos_words[WORDS],
                  *wall_words[WORDS], *side_words[WORDS] = { "all" };

static const char *const initial_words[] = { "hydrostatic", "rest", "released", NULL };
static const char *const precision_words[] = { "double", "single", NULL };
static const char *const delta_words[] = { "consistent", "toth", NULL };
static const char *const axis_words[] = { "x", "y", DIM == 3 ? "z" : NULL, NULL };
static const char *const probe_words[] = { "pressure", "height", "velocity", NULL };

#define AT(type, member) .offset = offsetof(struct type, member)

const struct param settings_params[] = {
    { .key = "title", .unit = "", .type = PARAM_TEXT, AT(settings, title),
      .about = "what the scene shows" },
    { .key = "dimension", .unit = "", .type = PARAM_INTEGER, AT(settings, dimension),
      .fallback = DIM, .min = 2, .max = 3, .about = "2 or 3" },
    { .key = "gravity", .unit = "m/s^2", .type = PARAM_VECTOR, AT(settings, gravity),
      .min = -1e4, .max = 1e4, .about = "acceleration of gravity; zero: no such effect" },
    { .key = "until", .unit = "s", AT(settings, until), .min = 1e-9, .max = 1e6, .required = 1,
      .about = "time at which the run ends" },
    { .key = "spacing", .unit = "m", AT(settings, spacing), .fallback = NAN, .min = 1e-9,
      .max = 1e6, .about = "distance of particles at the start; needed when there are any" },
    { .key = "particle_mass", .unit = DIM == 2 ? "kg/m" : "kg", AT(settings, particle_mass),
      .fallback = NAN, .min = 1e-30, .max = 1e12,
      .about = "mass of every particle; computed: rho0 times the volume of a site. Another one "
               "presses the fluid together or pulls it apart at the start" },
    { .key = "method", .unit = "", .type = PARAM_TEXT, AT(settings, method),
      .about = "time integration (see `list methods`); empty: the default for the scene" },
    { .key = "tol", .unit = "1", AT(settings, tol), .fallback = PLAN_TOL, .min = 1e-12, .max = 10,
      .about = "error allowed in a step, in units of the scales of each block" },
    { .key = "norm", .unit = "", .type = PARAM_WORD, AT(settings, norm), .words = vector_norm_words,
      .about = "how the errors of all entries become one: largest, mean 8th power, rms" },
    { .key = "substep", .unit = "s", AT(settings, substep), .fallback = NAN, .min = 1e-9,
      .max = 1e6, .about = "largest step of bodies in the methods staggered and mri; computed: no "
                           "limit, one step as the fluid's or as long as tol allows" },
    { .key = "walls", .unit = "", .type = PARAM_WORD, AT(settings, walls), .words = wall_words,
      .about = "how solids meet the fluid (see `list walls`)" },
    { .key = "precision", .unit = "", .type = PARAM_WORD, AT(settings, precision),
      .words = precision_words, .about = "of what pairs of particles give; all else is double. "
      "single takes 0.75 to 0.85 of the time, is as good as double down to tol 1e-3, below which it buys "
      "nothing, and rounds momentum" },
    { 0 },
};

const struct param settings_kernel_params[] = {
    { .key = "type", .unit = "", .type = PARAM_WORD, AT(settings_kernel, type),
      .words = kernel_words, .about = "smoothing kernel (see `list kernels`)" },
    { .key = "density", .unit = "", .type = PARAM_WORD, AT(settings_kernel, use[PART_DENSITY]),
      .words = use_words, .about = "kernel of densities, if another than type" },
    { .key = "pressure", .unit = "", .type = PARAM_WORD, AT(settings_kernel, use[PART_PRESSURE]),
      .words = use_words, .about = "kernel of the pressure force, if another than type" },
    { .key = "viscosity", .unit = "", .type = PARAM_WORD, AT(settings_kernel, use[PART_VISCOSITY]),
      .words = use_words, .about = "kernel of viscosities, if another than type" },
    { .key = "support", .unit = "spacings", AT(settings_kernel, support), .fallback = 3,
      .min = 1.2, .max = 10, .about = "radius H beyond which the kernel is zero" },
    { .key = "skin", .unit = "H", AT(settings_kernel, skin), .fallback = NAN, .min = 0.001,
      .max = 1,
      .about = "Verlet margin of the pair list; changes speed, and only the last bits of results; "
      "computed: 0.05, 0.1 with pairs in single precision" },
    { 0 },
};

const struct param settings_domain_params[] = {
    { .key = "from", .unit = "m", .type = PARAM_VECTOR, AT(settings_domain, from),
      .fallback = NAN, .min = -1e6, .max = 1e6, .about = "lowest corner of the domain" },
    { .key = "to", .unit = "m", .type = PARAM_VECTOR, AT(settings_domain, to),
      .fallback = NAN, .min = -1e6, .max = 1e6, .about = "highest corner of the domain" },
    { .key = "lid", .unit = "", .type = PARAM_FLAG, AT(settings_domain, lid), .fallback = 1,
      .max = 1, .about = "whether a frame closes the top" },
    { .key = "open", .unit = "", .type = PARAM_WORDS, AT(settings_domain, open),
      .words = shape_sides, .about = "sides on which a frame has no wall" },
    { .key = "periodic", .unit = "", .type = PARAM_WORDS, AT(settings_domain, periodic),
      .words = axis_words, .about = "directions that repeat: what leaves through one side comes in "
      "through the other; no frame there" },
    { 0 },
};

const struct param settings_reference_params[] = {
    { .key = "speed", .unit = "m/s", AT(settings_reference, speed), .fallback = NAN, .min = 1e-9,
      .max = 1e6, .about = "speed U that scales error weights; computed: c0/10" },
    { 0 },
};

const struct param settings_disturbance_params[] = {
    { .key = "size", .unit = "spacings", AT(settings_disturbance, size), .max = 0.01,
      .about = "largest shift of a fluid particle along each axis at the start, by chance; 0: none" },
    { .key = "seed", .unit = "", .type = PARAM_INTEGER, AT(settings_disturbance, seed),
      .fallback = 1, .max = 1e9, .about = "which chance: another seed is another shift of each "
      "particle, the same seed the same" },
    { 0 },
};

const struct param settings_pcisph_params[] = {
    { .key = "limit", .unit = "1", AT(settings_pcisph, limit), .fallback = 0.01, .min = 1e-6,
      .max = 1, .about = "largest compression of the fluid that a step may leave, of the density "
                         "of its lattice" },
    { .key = "least", .unit = "", .type = PARAM_INTEGER, AT(settings_pcisph, least),
      .fallback = 3, .min = 1, .max = 1000, .about = "iterations of a step at least" },
    { .key = "most", .unit = "", .type = PARAM_INTEGER, AT(settings_pcisph, most),
      .fallback = 50, .min = 1, .max = 100000,
      .about = "iterations of a step at most; then the step is halved" },
    { .key = "gain", .unit = "1", AT(settings_pcisph, gain), .fallback = 1, .min = 0.01,
      .max = 10, .about = "factor on delta: how much of the error an iteration corrects" },
    { .key = "delta", .unit = "", .type = PARAM_WORD, AT(settings_pcisph, delta),
      .words = delta_words, .about = "delta of the kernel that density and pressure have in "
      "common, or as Toth (2012) has it, of the density's alone, which allows two kernels" },
    { 0 },
};

const struct param settings_eos_params[] = {
    { .key = "type", .unit = "", .type = PARAM_WORD, AT(settings_eos, type), .words = eos_words,
      .about = "equation of state (see `list eos`)" },
    { .key = "lowest", .unit = "rho0", AT(settings_eos, lowest), .fallback = 0.2, .min = 0.01,
      .max = 0.99, .about = "density below which the right-hand side refuses to answer" },
    { .key = "highest", .unit = "rho0", AT(settings_eos, highest), .fallback = 3, .min = 1.01,
      .max = 100, .about = "density above which it refuses" },
    { .key = "fastest", .unit = "c0", AT(settings_eos, fastest), .fallback = 5, .min = 0.1,
      .max = 1e6, .about = "speed of a fluid particle at which the run is given up" },
    { 0 },
};

const struct param settings_output_params[] = {
    { .key = "interval", .unit = "s", AT(settings_output, interval), .fallback = NAN,
      .min = 1e-9, .max = 1e6, .about = "time between rows of the CSV files; computed: until/500" },
    { .key = "fields", .unit = "s", AT(settings_output, fields), .fallback = NAN, .min = 1e-9,
      .max = 1e6, .about = "time between output fields; computed: until/50" },
    { .key = "profiles", .unit = "s", AT(settings_output, profiles), .fallback = NAN, .min = 1e-9,
      .max = 1e6, .about = "time between profiles of probes; computed: until/50" },
    { .key = "checkpoint", .unit = "s", AT(settings_output, checkpoint), .max = 1e6,
      .about = "time between checkpoints, from which `stiffwater resume` goes on; a step ends at "
               "each, so that bits depend on it; 0: none" },
    { .key = "checkpoint_minutes", .unit = "min", AT(settings_output, checkpoint_minutes),
      .max = 1e5, .about = "the same by the clock; bits then depend on where these fall; 0: none" },
    { .key = "snapshots", .unit = "", .type = PARAM_INTEGER, AT(settings_output, snapshots),
      .fallback = 6, .min = 0, .max = 1000,
      .about = "pictures of the particles, evenly spread from start to end" },
    { 0 },
};

const struct param settings_fluid_params[] = {
    { .key = "dye", .unit = "", .type = PARAM_INTEGER, AT(settings_fluid, dye), .max = 7,
      .about = "colour that its particles keep, 0 to 7" },
    { .key = "initial", .unit = "", .type = PARAM_WORD, AT(settings_fluid, initial),
      .words = initial_words, .about = "density at the start: under its own weight, at rest (rho0), "
      "or that of fluid let go at t = 0 (its pressure is solved for)" },
    { .key = "surface", .unit = "m", AT(settings_fluid, surface), .fallback = NAN, .min = -1e6,
      .max = 1e6, .about = "level from which hydrostatic depth counts; computed: its own top" },
    { .key = "velocity", .unit = "m/s", .type = PARAM_VECTOR, AT(settings_fluid, velocity),
      .min = -1e5, .max = 1e5, .about = "velocity at the start" },
    { 0 },
};

const struct param settings_wall_params[] = {
    { .key = "slip", .unit = "", .type = PARAM_FLAG, AT(settings_wall, slip), .max = 1,
      .about = "the fluid slips along it: viscosity does not act" },
    { .key = "surface", .unit = "m/s", .type = PARAM_VECTOR, AT(settings_wall, surface),
      .min = -1e4, .max = 1e4, .about = "velocity along its face with which it drags the fluid, "
      "while its particles stay: a belt, a lid that slides" },
    { .key = "rim", .unit = "m", AT(settings_wall, rim), .fallback = NAN, .min = -1e6, .max = 1e6,
      .about = "of a frame: height at which its sides end, below the domain's top, which is open "
      "then; water may rise above it and fall back, and is lost beyond the sides" },
    { 0 },
};

const struct param settings_probe_params[] = {
    { .key = "at", .unit = "m", .type = PARAM_VECTOR, AT(settings_probe, at), .min = -1e6,
      .max = 1e6, .required = 1, .about = "where it is" },
    { .key = "what", .unit = "", .type = PARAM_WORD, AT(settings_probe, what),
      .words = probe_words,
      .about = "pressure: mean of the fluid within H, weighted by Wendland's C2 function; walls "
      "have no part in it, and where there is less than a sixteenth of a full "
      "surrounding the rest is air without pressure. height: level of the water there, "
      "half a spacing above its highest particle, over the domain's lowest point. "
      "velocity: speed of the water" },
    { .key = "to", .unit = "m", .type = PARAM_VECTOR, AT(settings_probe, to), .fallback = NAN,
      .min = -1e6, .max = 1e6,
      .about = "measures over an area and not at a point: in 2D the other end of a segment, in "
      "3D the opposite corner of a rectangle along two axes. The reading is the mean of"
      " points at most half a spacing apart, dry ones too (as 0): times the area it is "
      "the load of a pressure; computed: none" },
    { .key = "radius", .unit = "m", AT(settings_probe, radius), .fallback = NAN, .min = 1e-9,
      .max = 1e6,
      .about = "3D: measures over a disc around `at`, in the same way; computed: none" },
    { .key = "normal", .unit = "", .type = PARAM_VECTOR, AT(settings_probe, normal), .min = -1e6,
      .max = 1e6, .about = "direction across the disc, of any length" },
    { .key = "window", .unit = "s", AT(settings_probe, window), .max = 1e6,
      .about = "adds a column NAME.mean: the mean over the last so many seconds (less at the "
      "start) of the polygon through the readings at all accepted steps, the "
      "trapezoidal rule; 0: none. output.interval does not change it. A gauge that is "
      "slow reads so; a raw peak may be that of one particle" },
    { .key = "profile", .unit = "", .type = PARAM_FLAG, AT(settings_probe, profile), .max = 1,
      .about = "writes each of its points to profiles.csv, every output.profiles" },
    { 0 },
};

const struct param settings_panel_params[] = {
    { .key = "of", .unit = "", .type = PARAM_TEXT, AT(settings_panel, of), .required = 1,
      .about = "name of the wall or beam it is a part of" },
    { .key = "side", .unit = "", .type = PARAM_WORD, AT(settings_panel, side), .words = side_words,
      .about = "of a frame: one of its sides. A particle of a corner belongs to the side it lies "
      "further behind, so that the sides make up the frame" },
    { .key = "from", .unit = "m", .type = PARAM_VECTOR, AT(settings_panel, from), .fallback = NAN,
      .min = -1e6, .max = 1e6, .about = "lowest corner of a box: only particles that lie in it at "
      "t = 0, and go with it when it moves; computed: no bound" },
    { .key = "to", .unit = "m", .type = PARAM_VECTOR, AT(settings_panel, to), .fallback = NAN,
      .min = -1e6, .max = 1e6, .about = "highest corner of that box; computed: no bound" },
    { .key = "about", .unit = "m", .type = PARAM_VECTOR, AT(settings_panel, about), .min = -1e6,
      .max = 1e6, .about = "fixed point about which its moment is taken" },
    { .key = "along", .unit = "", .type = PARAM_VECTOR, AT(settings_panel, along), .min = -1e6,
      .max = 1e6,
      .about = "direction of the flow, of any length: adds a column NAME.drag, the force along "
      "it" },
    { 0 },
};

static void copy_words(const char **to, const char *const *from)
{
    int n = 0;

    while (from[n] && n < WORDS - 2) {
        to[n] = from[n];
        n++;
    }
    to[n] = NULL;
}

void settings_prepare(const char *const *kernels, const char *const *eos,
                      const char *const *walls)
{
    copy_words(kernel_words, kernels);
    copy_words(use_words + 1, kernels);
    copy_words(eos_words, eos);
    copy_words(wall_words, walls);
    copy_words(side_words + 1, shape_sides);
}
