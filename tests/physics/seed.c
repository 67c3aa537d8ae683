/* seed.c -- the dam-break method of Toth (2012), equation by equation as printed, against
 * the accelerations of a scene that names its parts: as printed, and put right.  2D. */
#include "tank.h"

#include <math.h>
#include <string.h>

#define GHOST(effects) "walls = \"ghost\"; effects = { summation = { }; " effects " };"
#define AS_PRINTED GHOST("pressure-printed = { }; viscosity-printed = { mu = 0.5; };")
#define PUT_RIGHT GHOST("pressure = { }; laplacian-viscosity = { mu = 0.5; };")

static const double mu = 0.5, rho0 = 1000, k = 1e4, c0 = 20; /* [Pa s] [kg/m^3] [m^2/s^2] [m/s] */

/* (14), (15): all particles j, i among them. */
static double density(const struct particles *p, const double (*x)[2], int i, double h)
{
    double rho = 0;

    for (int j = 0; j < p->n; j++) {
        const double r2 = pow(x[i][0] - x[j][0], 2) + pow(x[i][1] - x[j][1], 2);
        if (r2 < h * h)
            rho += p->m[j] * 4 / (M_PI * pow(h, 8)) * pow(h * h - r2, 3);
    }
    return rho;
}

/* (19) */
static double linear(double rho)
{
    return k * (rho - rho0);
}

/* (20), without tension */
static double tait(double rho)
{
    return rho > rho0 ? rho0 * c0 * c0 / 7 * (pow(rho / rho0, 7) - 1) : 0;
}

typedef double equation_of_state(double rho);

struct water {
    const struct particles *p;
    double (*x)[2], (*u)[2], *rho, *pressure;
    double h;
};

static struct water look(struct tank *t, equation_of_state *eos)
{
    const struct particles *p = plan_particles(t->plan);
    struct water w = { p, test_malloc(p->n * sizeof *w.x), test_malloc(p->n * sizeof *w.u),
                       test_malloc(p->n * sizeof *w.rho), test_malloc(p->n * sizeof *w.rho),
                       p->scales->support };
    struct view v;

    observe_view(t->moment, 0, t->y, &v);
    memcpy(w.x, v.x[KIND_FLUID], p->from[KIND_WALL] * sizeof *w.x);
    memcpy(w.u, v.u[KIND_FLUID], p->from[KIND_WALL] * sizeof *w.u);
    memcpy(w.x + p->from[KIND_WALL], v.x[KIND_WALL], particles_count(p, KIND_WALL) * sizeof *w.x);
    memcpy(w.u + p->from[KIND_WALL], v.u[KIND_WALL], particles_count(p, KIND_WALL) * sizeof *w.u);
    for (int i = 0; i < p->n; i++) {
        w.rho[i] = density(p, (const double (*)[2])w.x, i, w.h);
        w.pressure[i] = eos(w.rho[i]);
    }
    return w;
}

static void forget(struct water *w)
{
    test_free(w->x);
    test_free(w->u);
    test_free(w->rho);
    test_free(w->pressure);
}

/* Force densities on i: pressure with powers 1 of the density by (24), (26), with
 * powers 2 as (P1) has it; viscosity by (28) and (31), the power of h there 4 as printed. */
static void forces(const struct water *w, int i, int power_rho, int power_h, double *pressure,
                   double *viscosity)
{
    const double h = w->h;

    for (int d = 0; d < 2; d++)
        pressure[d] = viscosity[d] = 0;
    for (int j = 0; j < w->p->n; j++) {
        const double x[2] = { w->x[i][0] - w->x[j][0], w->x[i][1] - w->x[j][1] };
        const double r = hypot(x[0], x[1]), m = w->p->m[j];
        if (j == i || r >= h)
            continue;
        for (int d = 0; d < 2; d++) {
            const double grad = -30 / (M_PI * pow(h, 5)) * x[d] / r * pow(h - r, 2);
            const double lap = -40 / (M_PI * pow(h, power_h)) * (h - r);
            pressure[d] -= w->rho[i] * (w->pressure[i] / pow(w->rho[i], power_rho)
                                        + w->pressure[j] / pow(w->rho[j], power_rho)) * m * grad;
            viscosity[d] -= mu * (w->u[j][d] - w->u[i][d]) * m / w->rho[j] * lap;
        }
    }
}

static double length(const double *v)
{
    return hypot(v[0], v[1]);
}

/* (33) a = F/rho, F of (24), (28), (32) */
static void check_accelerations(const char *effects, const char *eos, equation_of_state *law,
                                bool printed)
{
    struct tank t;
    struct water w;
    const double *udot;

    tank_make(&t, tank_bare_water, tank_frame, TANK_SEED_KERNELS, eos, effects, NULL);
    tank_shake(&t, 2, 0.1, 1, 0);
    tank_rates(&t, 0, t.y, t.ydot);
    w = look(&t, law);
    udot = t.ydot + tank_at(&t, "velocity of fluid", NULL);
    for (int i = 0; i < w.p->from[KIND_WALL]; i++) {
        double p[2], v[2];
        forces(&w, i, printed ? 1 : 2, printed ? 4 : 5, p, v);
        for (int d = 0; d < 2; d++) {
            const double a = (p[d] + v[d]) / w.rho[i] + plan_scales(t.plan)->g[d];
            check(fabs(udot[2 * i + d] - a) <= 1e-11 * (length(p) + length(v)) / w.rho[i] + 1e-12,
                  "%s\nparticle %d: %.17g instead of %.17g m/s^2", effects, i, udot[2 * i + d], a);
        }
    }
    forget(&w);
    tank_free(&t);
}

static void accelerations_are_those_of_the_thesis(void **state)
{
    (void)state;
    for (int printed = 0; printed < 2; printed++) {
        const char *const effects = printed ? AS_PRINTED : PUT_RIGHT;
        check_accelerations(effects, "eos = { type = \"linear\"; k = 1e4; };", linear, printed);
        check_accelerations(effects, "eos = { c0 = 20.0; tension = false; };", tait, printed);
    }
}

/* What the misprints are worth in this water. */
static void misprints_are_large(void **state)
{
    double right[2][2], printed[2][2], sum[2][2] = { { 0 } }, ratio[2];
    struct tank t;
    struct water w;

    (void)state;
    tank_make(&t, tank_bare_water, tank_frame, TANK_SEED_KERNELS, AS_PRINTED,
              "eos = { type = \"linear\"; k = 1e4; };", NULL);
    tank_shake(&t, 2, 0.1, 1, 0);
    w = look(&t, linear);
    for (int i = 0; i < w.p->from[KIND_WALL]; i++) {
        forces(&w, i, 2, 5, right[0], right[1]);
        forces(&w, i, 1, 4, printed[0], printed[1]);
        for (int f = 0; f < 2; f++) {
            sum[f][0] += length(printed[f]);
            sum[f][1] += length(right[f]);
        }
    }
    for (int f = 0; f < 2; f++)
        ratio[f] = sum[f][0] / sum[f][1];
    print_message("# as printed: pressure %.4g times, viscosity 1/%.6g\n", ratio[0],
                  1 / ratio[1]);
    check(ratio[0] > 500 && ratio[0] < 1500, "pressure %g times", ratio[0]);
    check(fabs(ratio[1] / w.h - 1) < 1e-12, "viscosity %g times, the support is %g m", ratio[1],
          w.h);
    forget(&w);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(accelerations_are_those_of_the_thesis),
        cmocka_unit_test(misprints_are_large),
    };

    return cmocka_run_group_tests_name("seed", tests, NULL, NULL);
}
