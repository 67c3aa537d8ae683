/* beam-def.c -- a beam as a scene gives it: parameters, refusals, derived numbers.
 *
 *   EI = E b^3 / 12 per metre of width; with plane = "strain" / (1 - nu^2)   (BE3)
 *
 * A wide plate that bends about one axis only cannot narrow sideways, which makes
 * it stiffer by 1/(1 - nu^2): Timoshenko and Woinowsky-Krieger, Theory of Plates
 * and Shells, 1959, chapter 1. */
#include "bodies/beam-def.h"

#include "base/status.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

#define AT(member) .offset = offsetof(struct beam_def, member)

static const char *const theories[] = { "auto", "linear", "elastica", NULL };
static const char *const responses[] = { "own", "predicted", NULL };
static const char *const planes[] = { "none", "stress", "strain", NULL };
static const char *const inertias[] = { "consistent", "lumped", "lumped-ends", NULL };
static const char *const roots[] = { "clamped", "pinned", "free", NULL };
static const char *const tips[] = { "free", "pinned", "clamped", NULL };

const struct param beam_def_params[] = {
    { .key = "theory", .unit = "", AT(theory), .type = PARAM_WORD, .words = theories,
      .about = "linear: small deflections, a tip that bends by a fifth of the length is 4 % off; "
               "elastica: bends and turns as far as it likes, and its skin with it; auto: linear, "
               "and beyond a fifth the run ends" },
    { .key = "at", .unit = "m", AT(at), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .required = 1, .about = "position of the root (first node), on the axis" },
    { .key = "angle", .unit = "deg", AT(angle), .fallback = 90, .min = -360, .max = 360,
      .about = "direction of the axis from root to tip, counted from +x; 90 is upright" },
    { .key = "length", .unit = "m", AT(length), .min = 1e-9, .max = 1e6, .required = 1,
      .about = "from root to tip" },
    { .key = "thickness", .unit = "m", AT(thickness), .min = 1e-9, .max = 1e6, .required = 1,
      .about = "height of the section in stiffness and mass; the water feels the skin's layers" },
    { .key = "E", .unit = "Pa", AT(E), .min = 1e-3, .max = 1e15, .required = 1,
      .about = "Young's modulus" },
    { .key = "nu", .unit = "", AT(nu), .fallback = 0.3, .min = 0, .max = 0.5,
      .about = "Poisson's ratio; counts with plane = \"strain\" only" },
    { .key = "plane", .unit = "", AT(plane), .type = PARAM_WORD, .words = planes,
      .about = "strain: a wide plate, EI/(1 - nu^2); stress and none: a narrow strip, EI" },
    { .key = "density", .unit = "kg/m^3", AT(density), .max = 1e6,
      .about = "of the material; give this or mass, 0 is not given" },
    { .key = "mass", .unit = "kg/m", AT(mass), .max = 1e9,
      .about = "of the whole beam per metre of width; give this or density, 0 is not given" },
    { .key = "elements", .unit = "", AT(elements), .fallback = 20, .min = 1, .max = 1000,
      .type = PARAM_INTEGER, .about = "number of equal finite elements" },
    { .key = "inertia", .unit = "", AT(inertia), .type = PARAM_WORD, .words = inertias,
      .about = "mass matrix; lumped is (44) of Toth (2012) as printed, m and m l^2/12 at every "
               "node: the beam is heavier by the m of one element, and with 10 of them swings "
               "9 % too slowly; lumped-ends has halves at the ends" },
    { .key = "root", .unit = "", AT(root), .type = PARAM_WORD, .words = roots,
      .about = "how the first end is held" },
    { .key = "tip", .unit = "", AT(tip), .type = PARAM_WORD, .words = tips,
      .about = "how the last end is held" },
    { .key = "alpha", .unit = "1/s", AT(alpha), .max = 1e9,
      .about = "damping by mass, D = alpha M + beta K; damps slow modes, ratio alpha/(2 omega)" },
    { .key = "beta", .unit = "s", AT(beta), .max = 1e3,
      .about = "damping by stiffness; damps fast modes, ratio beta omega/2; in water "
               "its entry in the book needs a small tol: prefer damping_ratio; elastica: the "
               "moment is EI (kappa + beta dkappa/dt), which brakes no turn as a whole" },
    { .key = "damping_ratio", .unit = "", AT(damping_ratio), .max = 10,
      .about = "of the first mode: adds 2 damping_ratio omega_1 to alpha; elastica: "
               "2 damping_ratio/omega_1 to beta, which turns with the beam" },
    { .key = "drag", .unit = "N s/m^2", AT(drag), .max = 1e9,
      .about = "(45) of Toth (2012): one number on the deflection and on the rotation (N s) of "
               "every node, so that damping grows with elements; with the paper's 0.01 a beam of "
               "10 elements swings, one of 100 does not: prefer damping_ratio" },
    { .key = "layers", .unit = "", AT(layers), .max = 100, .type = PARAM_INTEGER,
      .about = "layers of the skin; 0: as many as the kernel's support covers" },
    { .key = "slip", .unit = "", AT(slip), .type = PARAM_FLAG,
      .about = "true: viscosity does not act on the skin" },
    { .key = "contact", .unit = "", AT(contact), .type = PARAM_FLAG,
      .about = "true: its skin touches rigid bodies, walls and such beams, and they it; false: when it meets one the "
               "run ends" },
    { .key = "restitution", .unit = "", AT(restitution), .fallback = 0.6, .min = 0.1, .max = 1,
      .about = "with contact: speed after an impact by that before it; with a body the root of the product" },
    { .key = "friction", .unit = "", AT(friction), .fallback = 0.35, .max = 10,
      .about = "with contact: coefficient of friction; with a body the root of the product" },
    { .key = "response", .unit = "", AT(response), .type = PARAM_WORD, .words = responses,
      .about = "own: by its mass alone; predicted, with eos.type = \"look-ahead\" only: as the pressure "
               "takes it to yield within tau, (E4), which the lightest beam in water stands, and which "
               "damps a vibration omega by the ratio omega tau/2" },
    { .key = "tip_force", .unit = "N/m", AT(tip_force), .min = -1e12, .max = 1e12,
      .about = "force across the tip from t = 0; positive to the left, looking from root to tip" },
    { .key = "load", .unit = "N/m^2", AT(load), .min = -1e12, .max = 1e12,
      .about = "uniform load across the beam from t = 0; positive as tip_force" },
    { .key = "load_until", .unit = "s", AT(load_until), .max = 1e9,
      .about = "when tip_force and load end and the beam swings freely; 0: never" },
    { .key = "follower", .unit = "", AT(follower), .type = PARAM_FLAG,
      .about = "true: tip_force and load turn with the beam; elastica only" },
    { .key = "bent", .unit = "deg", AT(bent), .min = -3600, .max = 3600,
      .about = "how far the tip has turned at t = 0, in a smooth bow from the root; elastica "
               "only" },
    { .key = "bent_rate", .unit = "deg/s", AT(bent_rate), .min = -1e9, .max = 1e9,
      .about = "how fast that angle grows at t = 0; elastica only" },
    { 0 },
};

static enum bending_end end_of(const char *word)
{
    if (strcmp(word, "clamped") == 0)
        return BENDING_CLAMPED;
    return strcmp(word, "pinned") == 0 ? BENDING_PINNED : BENDING_FREE;
}

static enum bending_inertia inertia_of(const char *word)
{
    if (strcmp(word, "consistent") == 0)
        return BENDING_CONSISTENT;
    return strcmp(word, "lumped") == 0 ? BENDING_LUMPED : BENDING_LUMPED_ENDS;
}

static int check_mass(const struct beam_def *d, const char *path)
{
    if (d->density > 0 && d->mass > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: both density = %g kg/m^3 and mass = %g kg/m are "
                           "given, and density times thickness times length is %g kg/m; leave "
                           "one of them out", path, d->density, d->mass,
                           d->density * d->thickness * d->length);
    if (!(d->density > 0 || d->mass > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: neither density nor mass is given, so the beam "
                           "has no inertia; set density (kg/m^3, steel is 7850) or mass (of the "
                           "whole beam, kg per metre of width)", path);
    return STATUS_DONE;
}

bool beam_def_far(const struct beam_def *d)
{
    return strcmp(d->theory, "elastica") == 0;
}

bool beam_def_predicted(const struct beam_def *d)
{
    return strcmp(d->response, "predicted") == 0;
}

static int check_ends(const struct beam_def *d, const char *path)
{
    const enum bending_end root = end_of(d->root), tip = end_of(d->tip);

    if (root == BENDING_FREE && tip == BENDING_FREE)
        return status_fail(STATUS_BAD_SCENE, "%s: root and tip are both free: the beam could drift "
                           "along its own axis, a motion for which its elements have no degree of "
                           "freedom, and no support takes the load along the axis; clamp or pin "
                           "one end (root = \"clamped\")", path);
    if (root == BENDING_CLAMPED && tip == BENDING_CLAMPED && d->elements == 1)
        return status_fail(STATUS_BAD_SCENE, "%s: elements = 1 between two clamped ends leaves "
                           "nothing that can move; set elements = 2 or more", path);
    if (tip != BENDING_FREE && d->tip_force != 0)
        return status_fail(STATUS_BAD_SCENE, "%s: tip_force = %g N/m pushes a tip that is %s and "
                           "cannot give way; set tip = \"free\", or use load", path,
                           d->tip_force, d->tip);
    return STATUS_DONE;
}

static int check_linear(const struct beam_def *d, const char *path)
{
    if (d->follower || d->bent != 0 || d->bent_rate != 0)
        return status_fail(STATUS_BAD_SCENE, "%s: %s is for beams that bend far; set theory = "
                           "\"elastica\", or leave it out", path,
                           d->follower ? "follower" : d->bent != 0 ? "bent" : "bent_rate");
    return STATUS_DONE;
}

static int check_elastica(const struct beam_def *d, const char *path)
{
    if ((d->bent != 0 || d->bent_rate != 0) && end_of(d->tip) != BENDING_FREE)
        return status_fail(STATUS_BAD_SCENE, "%s: bent and bent_rate make a bow, whose tip is "
                           "not where a tip that is %s stays; set tip = \"free\"", path, d->tip);
    return STATUS_DONE;
}

int beam_def_check(const struct beam_def *d, const char *path)
{
    if (DIM != 2)
        return status_fail(STATUS_BAD_SCENE, "%s: a beam in three dimensions is not there yet; "
                           "set dimension = 2, or leave the beam out", path);
    TRY(check_mass(d, path));
    TRY(check_ends(d, path));
    TRY(beam_def_far(d) ? check_elastica(d, path) : check_linear(d, path));
    if (d->thickness > d->length)
        return status_fail(STATUS_BAD_SCENE, "%s: thickness = %g m is more than length = %g m: "
                           "that is a block, not a beam; are the two exchanged?", path,
                           d->thickness, d->length);
    if (d->load_until > 0 && d->tip_force == 0 && d->load == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: load_until = %g s ends a load that is not there; "
                           "set tip_force or load, or leave load_until out", path, d->load_until);
    if (d->length < 5 * d->thickness)
        status_warn("%s: length / thickness = %.2g: this beam has no shear, so that it bends too "
                    "little by 3 %% and more when it is that stocky", path,
                    d->length / d->thickness);
    return STATUS_DONE;
}

/* How much less a wide plate gives way. */
static double wide(const struct beam_def *d)
{
    return strcmp(d->plane, "strain") == 0 ? 1 - d->nu * d->nu : 1;
}

double beam_def_axial(const struct beam_def *d)
{
    return d->E * d->thickness / wide(d);
}

struct bending_def beam_def_bending(const struct beam_def *d)
{
    struct bending_def b = {
        .elements = d->elements, .length = d->length,
        .EI = d->E * pow(d->thickness, 3) / 12 / wide(d),
        .mu = d->mass > 0 ? d->mass / d->length : d->density * d->thickness,
        .alpha = d->alpha, .beta = d->beta, .drag = d->drag, .inertia = inertia_of(d->inertia),
        .root = end_of(d->root), .tip = end_of(d->tip),
    };

    if (beam_def_far(d))
        b.beta += 2 * d->damping_ratio / bending_first(&b);
    else
        b.alpha += 2 * d->damping_ratio * bending_first(&b);
    return b;
}

void beam_def_axes(const struct beam_def *d, double *along, double *across)
{
    const double turns = round(d->angle / 90), rest = (d->angle - 90 * turns) * M_PI / 180;
    const int quarter = ((int)turns % 4 + 4) % 4;
    const double c = cos(rest), s = sin(rest);
    const double e[4][2] = { { c, s }, { -s, c }, { -c, -s }, { s, -c } };

    along[0] = e[quarter][0];
    along[1] = e[quarter][1];
    across[0] = -along[1];
    across[1] = along[0];
}

double beam_def_potential(const struct beam_def *d, const struct scales *s, double mass)
{
    double along[DIM] = { 0 }, across[DIM] = { 0 }, potential = 0;

    beam_def_axes(d, along, across);
    for (int i = 0; i < DIM; i++)
        potential -= mass * s->g[i] * (d->at[i] + 0.5 * d->length * along[i] - s->low[i]);
    return potential;
}

struct skin_def beam_def_skin(const struct beam_def *d, const struct scales *s, const char *path)
{
    const int needed = s->dx > 0 ? (int)ceil(s->support / s->dx - 1e-9) : 0;
    struct skin_def skin = { .length = d->length, .spacing = s->dx, .elements = d->elements,
                             .layers = d->layers > 0 ? d->layers : needed };

    memcpy(skin.at, d->at, sizeof skin.at);
    beam_def_axes(d, skin.along, skin.normal);
    if (s->fluid && skin.layers < needed)
        status_warn("%s: layers = %d is less than the %d that the kernel's support covers: water "
                    "on one side feels water on the other through the beam", path, skin.layers,
                    needed);
    return skin;
}
