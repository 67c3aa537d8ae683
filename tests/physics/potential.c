/* potential.c -- solids that repel by a potential, (W7): its force is the gradient of the energy
 * by a double loop with the kernel typed anew, nothing else acts between fluid and solids, and
 * what does not go with it is refused. */
#include "tank.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define WALLS "walls = \"potential\";"
#define EFFECTS(strength)                                                                \
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { };"          \
    " density-diffusion = { };" strength " };"
#define REPELS(strength) EFFECTS("contact-potential = { n = 3; strength = " strength "; };")

/* (K1) */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

/* What particle a of the fluid at x and all walls have with strength 0.6, n = 3 [J]. */
static double energy(const struct view *v, int a, const double *x)
{
    const struct scales *s = v->p->scales;
    double sum = 0;

    for (int b = 0; b < particles_count(v->p, KIND_WALL); b++) {
        double square = 0;
        for (int d = 0; d < DIM; d++)
            square += pow(x[d] - v->x[KIND_WALL][b * DIM + d], 2);
        sum += v->p->m[v->p->from[KIND_WALL] + b]
             * pow(wendland_c2(sqrt(square), s->support) / wendland_c2(s->dx, s->support), 3);
    }
    return 0.6 * s->speed * s->speed * v->p->m[a] / s->mass * sum;
}

/* Its gradient along axis d, by differences of fourth order. */
static double slope(const struct view *v, int a, int d)
{
    const double h = 1e-3 * v->p->scales->dx;
    double x[DIM], at[4];

    for (int k = 0; k < 4; k++) {
        memcpy(x, v->x[KIND_FLUID] + a * DIM, sizeof x);
        x[d] += h * (k < 2 ? k - 2 : k - 1);
        at[k] = energy(v, a, x);
    }
    return (8 * (at[2] - at[1]) - (at[3] - at[0])) / (12 * h);
}

static void force_is_the_gradient_of_the_energy(void **state)
{
    struct tank strong, weak;
    struct view v;
    double most = 0;
    long u;
    int pushed = 0;

    (void)state;
    tank_make(&strong, tank_water, tank_frame, WALLS, REPELS("0.7"), NULL);
    tank_make(&weak, tank_water, tank_frame, WALLS, REPELS("0.1"), NULL);
    tank_shake(&strong, 5, 0.3, 0.3, 0.01);
    tank_rates(&strong, 0, strong.y, strong.ydot);
    tank_rates(&weak, 0, strong.y, weak.ydot);
    u = tank_at(&strong, "velocity of fluid", NULL);
    observe_view(strong.moment, 0, strong.y, &v);
    for (int a = 0; a < particles_count(v.p, KIND_FLUID); a++)
        for (int d = 0; d < DIM; d++) {
            const double force = v.p->m[a] * (strong.ydot[u + a * DIM + d] - weak.ydot[u + a * DIM + d]);
            const double expected = -slope(&v, a, d);
            most = fmax(most, fabs(expected));
            pushed += fabs(expected) > 1e-6;
            check(fabs(force - expected) < 1e-7 * fmax(most, 1e-3), "particle %d: %.12g instead of "
                  "%.12g N", a, force, expected);
        }
    check(pushed > 50, "%d components only: the test is void", pushed);
    tank_free(&strong);
    tank_free(&weak);
}

/* Densities and forces of the water are those of the same water alone, but for (W7). */
static void nothing_else_acts(void **state)
{
    struct tank with, alone;
    long rho, u;

    (void)state;
    tank_make(&with, tank_water, tank_frame, WALLS, REPELS("0.001"), NULL);
    tank_make(&alone, tank_water, WALLS, EFFECTS(""), NULL);
    tank_shake(&alone, 6, 0.3, 0.3, 0.01);
    rho = tank_at(&with, "density of fluid", NULL);
    u = tank_at(&with, "velocity of fluid", NULL);
    memcpy(with.y + tank_at(&with, "position of fluid", NULL),
           alone.y + tank_at(&alone, "position of fluid", NULL),
           (size_t)particles_count(plan_particles(with.plan), KIND_FLUID) * DIM * sizeof *with.y);
    memcpy(with.y + u, alone.y + tank_at(&alone, "velocity of fluid", NULL),
           (size_t)particles_count(plan_particles(with.plan), KIND_FLUID) * DIM * sizeof *with.y);
    memcpy(with.y + rho, alone.y + tank_at(&alone, "density of fluid", NULL),
           (size_t)particles_count(plan_particles(with.plan), KIND_FLUID) * sizeof *with.y);
    tank_rates(&with, 0, with.y, with.ydot);
    tank_rates(&alone, 0, alone.y, alone.ydot);
    for (int a = 0; a < particles_count(plan_particles(with.plan), KIND_FLUID); a++) {
        const double is = with.ydot[rho + a];
        const double expected = alone.ydot[tank_at(&alone, "density of fluid", NULL) + a];
        check(fabs(is - expected) < 1e-10 * fmax(1, fabs(expected)), "density of particle %d grows by "
              "%.12g instead of %.12g", a, is, expected);
    }
    for (long i = 0; i < with.n; i++) /* of solids */
        check(i < tank_at(&with, "density of walls", NULL)
              || i >= tank_at(&with, "density of walls", NULL)
                      + particles_count(plan_particles(with.plan), KIND_WALL)
              || with.ydot[i] == 0, "the density of wall particle %ld changes", i);
    tank_free(&with);
    tank_free(&alone);
}

static void refuses(const char *text, const char *words)
{
    char all[4096];
    struct tank t;

    snprintf(all, sizeof all, "%s%s%s", tank_water, tank_frame, text);
    check(tank_try(&t, all) == STATUS_BAD_SCENE && strstr(status_message(), words), "%s\nis not refused "
          "with \"%s\" but with: %s", text, words, status_message());
    tank_free(&t);
}

static void refuses_what_does_not_go_together(void **state)
{
    (void)state;
    refuses(WALLS EFFECTS(""), "name effects.contact-potential");
    refuses(REPELS("0.5"), "count twice: set walls = \"potential\"");
    refuses("walls = \"adami\";" REPELS("0.5"), "count twice");
    refuses(WALLS EFFECTS("contact-potential = { }; laminar-viscosity = { mu = 1.0; side = "
                          "\"implicit\"; };"), "set its side = \"explicit\"");
    refuses(WALLS REPELS("0.5") "eos = { type = \"look-ahead\"; };", "density of their own");
    refuses(WALLS "effects = { summation = { }; pressure = { }; contact-potential = { }; };",
            "does not go with effects.summation");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(force_is_the_gradient_of_the_energy),
        cmocka_unit_test(nothing_else_acts),
        cmocka_unit_test(refuses_what_does_not_go_together),
    };

    return cmocka_run_group_tests_name("potential", tests, NULL, NULL);
}
