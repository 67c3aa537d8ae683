/* laws.c -- what the effects are called conservation laws for: momentum and energy
 * of the rates themselves, for each effect alone and for all, between walls that
 * move and with a beam in the water. */
#include "tank.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOVING "wall = { tank = { type = \"frame\"; velocity = " VECTOR "; frequency = 3.0;" \
               " amplitude = " VECTOR "; }; };"
#if DIM == 2
#define VECTOR "[0.011, -0.007]"
#else
#define VECTOR "[0.011, -0.007, 0.004]"
#endif
#define SLIDING "wall = { tank = { type = \"frame\"; slip = true; velocity = " VECTOR "; }; };"

/* Where pressure and density together make no energy at all. */
enum closes {
    NOWHERE,
    WITHOUT_BEAM, /* sums over solids that move to each other: summation.c tells */
    EVERYWHERE
};

/* What acts beside gravity. */
static const struct {
    const char *text;
    enum closes closes;
} effects[] = {
    { "effects = { continuity = { }; pressure = { }; };", EVERYWHERE },
    { "effects = { continuity = { }; artificial-viscosity = { alpha = 0.5; }; };", NOWHERE },
    { "effects = { continuity = { };"
      " artificial-viscosity = { alpha = 0.5; only_approaching = true; }; };", NOWHERE },
    { "effects = { continuity = { }; artificial-viscosity = { alpha = 0.5; stick = \"none\"; }; };",
      NOWHERE },
    { TANK_SLIPS, EVERYWHERE },
    { "walls = \"adami\";" TANK_SLIPS, NOWHERE },
    { "effects = { continuity = { }; laminar-viscosity = { mu = 5.0; }; };", NOWHERE },
    { "effects = { continuity = { }; stress-viscosity = { mu = 5.0; }; };", NOWHERE },
    { "effects = { continuity = { }; density-diffusion = { delta = 0.3; }; };", NOWHERE },
    { TANK_EFFECTS, EVERYWHERE },
    { TANK_EFFECTS "eos = { tension = false; };", EVERYWHERE },
    { TANK_HEALED "eos = { tension = false; };", EVERYWHERE },
    { TANK_EFFECTS "eos = { type = \"linear\"; k = 250.0; };", EVERYWHERE },
    { TANK_EFFECTS TANK_SEED_KERNELS, NOWHERE },
    { TANK_SUMMED, WITHOUT_BEAM },
    { TANK_SUMMED "eos = { tension = false; };", WITHOUT_BEAM },
    { TANK_SUMMED "eos = { type = \"linear\"; tension = false; };", WITHOUT_BEAM },
    { "walls = \"ghost\"; effects = { summation = { }; pressure = { };"
      " laplacian-viscosity = { mu = 5.0; }; };" TANK_SEED_KERNELS, NOWHERE },
    { "walls = \"ghost\"; effects = { summation = { }; pressure-printed = { }; };", NOWHERE },
    { "walls = \"adami\";" TANK_EFFECTS, NOWHERE },
    { "walls = \"adami\"; effects = { summation = { }; pressure = { }; };", NOWHERE },
    { "walls = \"own-density\";" TANK_EFFECTS "eos = { type = \"look-ahead\"; };", EVERYWHERE },
    { "walls = \"potential\"; effects = { continuity = { }; pressure = { }; contact-potential = { };"
      " artificial-viscosity = { alpha = 0.1; }; density-diffusion = { delta = 0.1; }; };", EVERYWHERE },
    { "walls = \"contact\";" TANK_EFFECTS, EVERYWHERE },
    { "walls = \"contact\";" TANK_EFFECTS "eos = { type = \"linear\"; k = 250.0; };", EVERYWHERE },
};
enum { EFFECTS = sizeof effects / sizeof effects[0], SEEDS = DIM == 2 ? 3 : 1 };

static const double when = 0.013; /* [s] */

/* One state of one combination; the name of the effects for complaints. */
struct look {
    const char *what;
    bool closes;
};

/* Every combination of effects and walls (in 2D with a beam too), three times in 2D. */
static void for_all(void (*look)(struct tank *t, const struct look *of))
{
    const char *const walls[] = { tank_frame, MOVING, SLIDING };

    for (int e = 0; e < EFFECTS; e++)
        for (int w = 0; w < 3; w++)
            for (int beam = 0; beam < (DIM == 2 ? 2 : 1); beam++)
                for (unsigned seed = 1; seed <= SEEDS; seed++) {
                    struct tank t;
                    const struct look of = { effects[e].text, effects[e].closes > (beam != 0) };
                    tank_make(&t, beam ? tank_parted_water : tank_bare_water, walls[w],
                              beam ? tank_beam : "", effects[e].text,
                              strstr(of.what, "kernel") ? "" : TANK_ONE_KERNEL, NULL);
                    tank_shake(&t, seed, 0.2, 1.0, 0.02);
                    look(&t, &of);
                    tank_free(&t);
                }
}

/* Fluid alone: sum m u' + forces on all solids = m g. */
static void check_momentum(struct tank *t, const struct look *of)
{
    const struct particles *p = plan_particles(t->plan);
    const double *g = plan_scales(t->plan)->g;
    const int n = particles_count(p, KIND_FLUID);

    tank_rates(t, when, t->y, t->ydot);
    for (int d = 0; d < DIM; d++) {
        const double *udot = t->ydot + tank_at(t, "velocity of fluid", NULL);
        double sum = 0, size = 0;
        for (int i = 0; i < n; i++) {
            sum += p->m[i] * (udot[i * DIM + d] - g[d]);
            size += p->m[i] * fabs(udot[i * DIM + d]);
        }
        for (int o = 0; o < p->objects; o++)
            sum += p->object[o].kind == KIND_FLUID ? 0 : moment_force(t->moment, o)[d];
        check(fabs(sum) <= 1e-12 * size, "%s\ndirection %d: %g N of %g N come from nowhere",
              of->what, d, sum, size);
    }
}

static void momentum_comes_from_walls_and_weight(void **state)
{
    (void)state;
    for_all(check_momentum);
}

/* (total, sum of works, pressure_defect) at y + h ydot, t + h. */
static void sheet_at(struct tank *t, double h, struct book_sheet *s)
{
    double *y = tank_copy(t, t->y);

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    observe_sheet(t->moment, when + h, y, s);
    test_free(y);
}

/* So short a time [s] that few cross the density at rest, where a slope may jump. */
static const double step = 2e-8;

/* Sheets at -2, -1, 1 and 2 steps along the rates. */
static void sheets_around(struct tank *t, struct book_sheet s[4])
{
    for (int k = 0; k < 4; k++)
        sheet_at(t, step * (k < 2 ? k - 2 : k - 1), &s[k]);
}

/* d/dt along the rates, by central differences of fourth order. */
static double slope(const struct book_sheet s[4], double (*of)(const struct book_sheet *s))
{
    return (8 * (of(&s[2]) - of(&s[1])) - (of(&s[3]) - of(&s[0]))) / (12 * step);
}

static double kinetic(const struct book_sheet *s)
{
    return s->energy.kinetic;
}

static double defect(const struct book_sheet *s)
{
    double given = s->pressure_defect;

    for (int i = 0; i < s->works; i++)
        given += s->work[i];
    return s->total - given;
}

static double pressure_defect(const struct book_sheet *s)
{
    return s->pressure_defect;
}

/* |power| of everything that changes kinetic energy, to compare with [W]. */
static double turnover(const struct tank *t)
{
    const struct particles *p = plan_particles(t->plan);
    const double *u = t->y + tank_at(t, "velocity of fluid", NULL);
    const double *udot = t->ydot + tank_at(t, "velocity of fluid", NULL);
    double sum = 0;

    for (int i = 0; i < particles_count(p, KIND_FLUID) * DIM; i++)
        sum += p->m[i / DIM] * fabs(u[i] * udot[i]);
    return sum;
}

static void check_energy(struct tank *t, const struct look *of)
{
    struct book_sheet s[4];
    double size;

    tank_rates(t, when, t->y, t->ydot);
    sheets_around(t, s);
    size = turnover(t);
    check(fabs(slope(s, kinetic)) > 1e-4 * size, "%s\nnothing happens: the test is void",
          of->what);
    check(fabs(slope(s, defect)) <= 1e-8 * size,
          "%s\nenergy changes by %g W more than the book says, of %g W", of->what,
          slope(s, defect), size);
    check(fabs(slope(s, pressure_defect)) <= 1e-10 * size || !of->closes,
          "%s\npressure and density make %g W of %g W", of->what, slope(s, pressure_defect), size);
}

/* d(kinetic + potential + internal + elastic)/dt = sum of the booked powers. */
static void energy_changes_by_the_booked_powers(void **state)
{
    (void)state;
    for_all(check_energy);
}

/* Fluid and bodies together change by what the sheet says was given. */
static void check_momentum_sheet(struct tank *t, const struct look *of)
{
    const double h = 1e-3;
    struct book_sheet a, b;
    double size = 0;

    tank_rates(t, when, t->y, t->ydot);
    sheet_at(t, -h, &a);
    sheet_at(t, h, &b);
    for (int d = 0; d < DIM; d++)
        size += fabs(b.momentum[d] - a.momentum[d]) + a.mass * 9.81 * h;
    for (int d = 0; d < DIM; d++) {
        const double off = b.momentum[d] - a.momentum[d]
                         - (b.momentum_given[d] - a.momentum_given[d]);
        check(fabs(off) <= 1e-10 * size, "%s\ndirection %d: momentum is off by %g of %g N s",
              of->what, d, off, size);
    }
    check(a.mass > 0 && a.mass == b.mass, "mass went from %g to %g", a.mass, b.mass);
}

static void momentum_book_closes(void **state)
{
    (void)state;
    for_all(check_momentum_sheet);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(momentum_comes_from_walls_and_weight),
        cmocka_unit_test(energy_changes_by_the_booked_powers),
        cmocka_unit_test(momentum_book_closes),
    };

    return cmocka_run_group_tests_name(DIM == 2 ? "laws in 2D" : "laws in 3D", tests, NULL, NULL);
}
