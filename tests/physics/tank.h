/* tank.h -- a small tank of water for tests: a plan made from a few lines of
 * scene, and states of it that are as general as they get. */
#ifndef TESTS_PHYSICS_TANK_H
#define TESTS_PHYSICS_TANK_H

#include "eval/observe.h"
#include "scene/scene.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

/* All the physics there is between particles. */
#define TANK_EFFECTS                                                                     \
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.1; };"  \
    " laminar-viscosity = { mu = 0.7; }; density-diffusion = { delta = 0.1; }; };"

/* Artificial viscosity that is no friction at solids; densities that heal. */
#define TANK_SLIPS                                                                       \
    "effects = { continuity = { }; pressure = { }; density-diffusion = { delta = 0.1; };"     \
    " artificial-viscosity = { alpha = 0.1; stick = \"none\"; }; };"
#define TANK_HEALED                                                                      \
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.1; };"  \
    " density-healing = { strength = 0.9; }; };"

/* Summed densities, between walls that are fluid otherwise. */
#define TANK_SUMMED "walls = \"ghost\"; effects = { summation = { }; pressure = { }; };"

/* A closed tank, 0.1 m wide and 0.08 m high, filled up to 0.06 m: 240 particles
 * of water in 2D (dx = 5 mm), 150 in 3D (dx = 20 mm, the tank 0.1 m deep). */
extern const char *const tank_water;

/* The same without a word about kernels, to go with one of these: one for all, and
 * one for each use as Toth (2012) has them. */
extern const char *const tank_bare_water;
#define TANK_ONE_KERNEL "kernel = { support = 2.5; };"
#define TANK_SEED_KERNELS                                                                \
    "kernel = { support = 2.52; density = \"poly6\"; pressure = \"spiky\";"              \
    " viscosity = \"viscosity-log\"; };"

/* The walls of that tank, at rest. */
extern const char *const tank_frame;

/* A soft beam of 4 elements that stands in the water, and the water around it (2D). */
extern const char *const tank_beam, *const tank_parted_water;

struct tank {
    struct scene *scene;
    const struct plan *plan;
    struct moment *moment;
    long n;
    double *y, *ydot; /* [n] */
};

/* A plan of the scene that these texts make together (NULL-ended), y at t = 0. */
void tank_make(struct tank *t, const char *first, ...);
void tank_free(struct tank *t);

/* The same, when it may be refused: the status of plan_create. */
int tank_try(struct tank *t, const char *text);

/* Moves y away from anything special: positions by up to far dx, velocities by up
 * to fast m/s, densities by up to dense rho0, beams by comparable amounts. */
void tank_shake(struct tank *t, unsigned seed, double far, double fast, double dense);

double tank_random(unsigned *seed); /* -1 to 1 */

/* First entry of the row of that name; the row in *row unless NULL. */
long tank_at(const struct tank *t, const char *name, const struct layout_row **row);

/* ydot of everything at (time, y); fails the test when refused. */
void tank_rates(struct tank *t, double time, const double *y, double *ydot);

double *tank_copy(const struct tank *t, const double *y); /* test_free() it */

/* Whether a test is to be brief: a sanitizer makes each step ten times as slow, and sees as much
 * in few. */
#ifdef __SANITIZE_ADDRESS__
#define tank_brief() (getenv("STIFFWATER_LONG") == NULL)
#else
#define tank_brief() false
#endif

/* Fails with a sentence when `good` is false. */
#define check(good, ...)           \
    do {                           \
        if (!(good))               \
            fail_msg(__VA_ARGS__); \
    } while (0)

#endif
