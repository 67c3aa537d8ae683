/* pcisph.c -- prediction and correction: what a full lattice answers to a pressure, two
 * iterations against a plain loop over all particles, and bits that no history changes. */
#include "tank.h"

#include "base/status.h"
#include "eval/inside.h"
#include "solved/pcisph-inside.h"

#include <math.h>
#include <string.h>

#define WALLS "walls = \"own-density\"; effects = { continuity = { }; pressure = { };"         \
              " artificial-viscosity = { alpha = 0.1; }; };"
#define TWO "pcisph = { limit = 1.0; least = 2; gain = 0.8; };"

/* The density at the centre of a lattice when every neighbour is pushed off by P m h^2. */
static double pushed(const struct kernel_use *d, const struct kernel_use *f, double m, double push)
{
    const int reach = 4, deep = DIM == 3 ? reach : 0;
    double rho = 0;

    for (int k = -deep; k <= deep; k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const double r = sqrt((double)(i * i + j * j + k * k));
                rho += m * kernel_w(d, r > 0 ? r - push * m * 2 * kernel_gradient(f, r) : 0);
            }
    return rho;
}

/* Positive P pushes off: the density falls by 2 h^2 m^2 B P.  One kernel, and two. */
static void the_lattice_answers(void **state)
{
    struct tank t;

    (void)state;
    for (int two = 0; two < (DIM == 2 ? 2 : 1); two++) {
        tank_make(&t, tank_bare_water, two ? TANK_SEED_KERNELS : TANK_ONE_KERNEL, tank_frame,
                  WALLS, NULL);
        const struct plan *p = t.plan;
        const struct kernel_use d = kernel_use_make(p->kernel[PART_DENSITY]->kernel, 2.5, DIM);
        const struct kernel_use f = kernel_use_make(p->kernel[PART_PRESSURE]->kernel, 2.5, DIM);
        const double m = 1.3, push = 1e-7;
        const double fall = (pushed(&d, &f, m, -push) - pushed(&d, &f, m, push)) / 2;
        const double want = 2 * m * m * pcisph_lattice_response(&d, &f, 1) * push;
        check(fabs(fall - want) < 1e-7 * want, "density falls by %g, not %g", fall, want);
        check(fabs(pcisph_lattice_density(&d, m, 1) - pushed(&d, &f, m, 0)) < 1e-12,
              "density of the lattice");
        tank_free(&t);
    }
}

/* All particles: places and velocities of now, pressure by P rho0^2, force by pressure. */
struct plain {
    int n, fluid;
    double *P, *sum;
    double (*x)[DIM], (*u)[DIM], (*later)[DIM], (*push)[DIM];
};

static double apart(const double *a, const double *b, double *to)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++) {
        to[d] = a[d] - b[d];
        r2 += to[d] * to[d];
    }
    return sqrt(r2);
}

static void plain_make(struct plain *a, const struct tank *t)
{
    const struct particles *all = t->moment->particles;
    const double *x = t->y + tank_at(t, "position of fluid", NULL);
    const double *u = t->y + tank_at(t, "velocity of fluid", NULL);

    *a = (struct plain){ .n = all->n, .fluid = particles_count(all, KIND_FLUID) };
    a->P = test_calloc((size_t)a->n, sizeof *a->P);
    a->sum = test_calloc((size_t)a->n, sizeof *a->sum);
    a->x = test_calloc((size_t)a->n, sizeof *a->x);
    a->u = test_calloc((size_t)a->n, sizeof *a->u);
    a->later = test_calloc((size_t)a->n, sizeof *a->later);
    a->push = test_calloc((size_t)a->n, sizeof *a->push);
    for (int i = 0; i < a->n; i++)
        for (int d = 0; d < DIM; d++) {
            a->x[i][d] = i < a->fluid ? x[i * DIM + d] : all->x[i][d];
            a->u[i][d] = i < a->fluid ? u[i * DIM + d] : all->u[i][d];
        }
}

static void plain_free(struct plain *a)
{
    test_free(a->P);
    test_free(a->sum);
    test_free(a->x);
    test_free(a->u);
    test_free(a->later);
    test_free(a->push);
}

/* (PC1), (PC2), (PC5), and the force of the new P, once. */
static void plain_iterate(struct plain *a, const struct plan *p, double h, const double *rate,
                          double gain)
{
    const struct kernel_use *use = p->kernel[PART_DENSITY];
    const double *m = p->particles->m, dx = p->scales.dx, mass = p->scales.mass;
    const double B = pcisph_lattice_response(use, use, dx);
    double e[DIM];

    for (int i = 0; i < a->n; i++)
        for (int d = 0; d < DIM; d++)
            a->later[i][d] = a->x[i][d] + h * (a->u[i][d] + (i < a->fluid
                           ? h * (rate[i * DIM + d] - a->push[i][d] / m[i]) : 0));
    for (int i = 0; i < a->n; i++) {
        double rho = 0;
        for (int j = 0; j < a->n; j++)
            rho += m[j] * kernel_w(use, apart(a->later[i], a->later[j], e));
        a->P[i] += gain / (2 * h * h * mass * mass * B)
                 * (rho - pcisph_lattice_density(use, mass, dx));
        a->P[i] = fmax(a->P[i], 0);
    }
    memset(a->push, 0, (size_t)a->n * sizeof *a->push);
    for (int i = 0; i < a->fluid; i++)
        for (int j = 0; j < a->n; j++) {
            const double r = apart(a->x[i], a->x[j], e);
            for (int d = 0; d < DIM && j != i; d++)
                a->push[i][d] += m[i] * m[j] * (a->P[i] + a->P[j]) * kernel_gradient(use, r) / r
                               * e[d];
        }
}

/* p/rho^2 of particle i, whose density stands in y. */
static double found(const struct tank *t, int i)
{
    const struct particles *all = t->moment->particles;
    const enum kind k = all->object[all->object_of[i]].kind;
    const double rho = t->y[layout_at(&t->moment->layout, t->plan->row.density[k]) + i
                            - all->from[k]];
    double p;

    plan_pressures(t->plan, 1, &rho, &p);
    return p / (rho * rho);
}

static void two_iterations_are_those_of_a_plain_loop(void **state)
{
    const double h = 2e-3;
    struct pcisph *solve;
    struct plain a;
    struct tank t;
    double most = 0;

    (void)state;
    tank_make(&t, tank_water, tank_frame, WALLS, TWO, "eos = { tension = false; };", NULL);
    tank_shake(&t, 5, 0.1, 0.3, 0);
    tank_rates(&t, 0, t.y, t.ydot);
    plain_make(&a, &t);
    for (int k = 0; k < 2; k++)
        plain_iterate(&a, t.plan, h, t.ydot + tank_at(&t, "velocity of fluid", NULL), 0.8);
    assert_int_equal(pcisph_create(t.moment, &solve), STATUS_DONE);
    for (int again = 0; again < 2; again++) /* the second one knows nothing of the first */
        assert_int_equal(pcisph_solve(solve, 0, h, t.ydot, t.y), STATUS_DONE);
    for (int i = 0; i < a.n; i++)
        most = fmax(most, a.P[i]);
    for (int i = 0; i < a.n; i++)
        check(fabs(found(&t, i) - a.P[i]) < 1e-9 * most, "P of particle %d: %g, not %g", i,
              found(&t, i), a.P[i]);
    check(most > 0, "there is a pressure");
    pcisph_free(&solve);
    plain_free(&a);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_lattice_answers),
        cmocka_unit_test(two_iterations_are_those_of_a_plain_loop),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
