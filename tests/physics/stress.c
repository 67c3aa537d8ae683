/* stress.c -- particles under tension that repel one another when they come close, (P3),
 * against a double loop with the kernel typed anew; it keeps momentum and its moment,
 * and its work is in the book. */
#include "tank.h"

#include <math.h>
#include <string.h>

#define STRESS(strength) "effects = { continuity = { }; pressure = { };"                  \
    " artificial-stress = { strength = " strength "; }; };"

/* (K1) */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

/* Its slope over r. */
static double slope(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? -20 * sigma * pow(H, -DIM - 2) * pow(1 - q, 3) : 0;
}

/* R over the strength. */
static double tension(const struct tank *t, double rho)
{
    double p;

    plan_pressures(t->plan, 1, &rho, &p);
    return fmax(0, -p) / (rho * rho);
}

/* Acceleration of particle a by (P3) with strength 0.4. */
static void stress(const struct tank *t, const struct view *v, int a, double *to)
{
    const struct scales *s = v->p->scales;
    const double *x = v->x[KIND_FLUID], *rho = v->rho[KIND_FLUID];

    memset(to, 0, DIM * sizeof *to);
    for (int b = 0; b < particles_count(v->p, KIND_FLUID); b++) {
        double apart[DIM], r = 0, f;
        for (int d = 0; d < DIM; d++) {
            apart[d] = x[a * DIM + d] - x[b * DIM + d];
            r += apart[d] * apart[d];
        }
        r = sqrt(r);
        f = wendland_c2(r, s->support) / wendland_c2(s->dx, s->support);
        for (int d = 0; d < DIM; d++)
            to[d] -= v->p->m[b] * 0.4 * (tension(t, rho[a]) + tension(t, rho[b])) * pow(f, 4)
                   * slope(r, s->support) * apart[d];
    }
}

/* What (P3) adds to the rates of velocities of shaken water: test_free() it. */
static double *added(struct tank *with)
{
    struct tank without;
    long u;
    double *more;

    tank_make(with, tank_water, tank_frame, STRESS("0.4"), NULL);
    tank_make(&without, tank_water, tank_frame, STRESS("0"), NULL);
    tank_shake(with, 3, 0.4, 0.3, 0.01);
    tank_rates(with, 0, with->y, with->ydot);
    tank_rates(&without, 0, with->y, without.ydot);
    u = tank_at(with, "velocity of fluid", NULL);
    more = tank_copy(with, with->ydot);
    for (long i = 0; u + i < with->n; i++)
        more[i] = with->ydot[u + i] - without.ydot[u + i];
    tank_free(&without);
    return more;
}

static void stress_is_that_of_the_formula(void **state)
{
    struct tank t;
    double *more = added(&t), most = 0;
    int pulled = 0;
    struct view v;

    (void)state;
    observe_view(t.moment, 0, t.y, &v);
    for (int a = 0; a < particles_count(v.p, KIND_FLUID); a++) {
        double expected[DIM];
        stress(&t, &v, a, expected);
        pulled += tension(&t, v.rho[KIND_FLUID][a]) > 0;
        for (int d = 0; d < DIM; d++) {
            most = fmax(most, fabs(expected[d]));
            check(fabs(more[a * DIM + d] - expected[d]) < 1e-9 * fmax(most, 1),
                  "particle %d: %.12g instead of %.12g m/s^2", a, more[a * DIM + d], expected[d]);
        }
    }
    check(most > 1 && pulled > 20 && pulled < particles_count(v.p, KIND_FLUID) - 20,
          "%g m/s^2 at most, %d under tension", most, pulled);
    test_free(more);
    tank_free(&t);
}

static void momentum_and_its_moment_are_kept(void **state)
{
    struct tank t;
    double *more = added(&t), sum[DIM] = { 0 }, size = 0, turn = 0;
    const double *x;
    struct view v;

    (void)state;
    observe_view(t.moment, 0, t.y, &v);
    x = v.x[KIND_FLUID];
    for (int a = 0; a < particles_count(v.p, KIND_FLUID); a++) {
        const double *m = more + (long)a * DIM;
        for (int d = 0; d < DIM; d++) {
            sum[d] += m[d];
            size += fabs(m[d]);
        }
        turn += x[a * DIM] * m[DIM - 1] - x[a * DIM + DIM - 1] * m[0];
    }
    for (int d = 0; d < DIM; d++)
        check(fabs(sum[d]) < 1e-11 * size, "momentum grows by %g of %g", sum[d], size);
    check(fabs(turn) < 1e-11 * size, "its moment grows by %g of %g", turn, size);
    test_free(more);
    tank_free(&t);
}

static void its_work_is_in_the_book(void **state)
{
    struct tank t;
    double *more = added(&t), power = 0, given;
    struct book_sheet before, after;
    char name[BOOK_WORKS][80];
    int own = -1;
    struct view v;

    (void)state;
    for (int i = 0; i < book_work_names(t.plan, name); i++)
        if (strcmp(name[i], "artificial-stress") == 0)
            own = i;
    check(own >= 0, "it has no column in the book");
    observe_view(t.moment, 0, t.y, &v);
    for (int i = 0; i < particles_count(v.p, KIND_FLUID) * DIM; i++)
        power += v.p->m[i / DIM] * v.u[KIND_FLUID][i] * more[i];
    observe_sheet(t.moment, 0, t.y, &before);
    for (long i = 0; i < t.n; i++)
        t.y[i] += 1e-3 * t.ydot[i];
    observe_sheet(t.moment, 1e-3, t.y, &after);
    given = (after.work[own] - before.work[own]) / 1e-3;
    check(fabs(given - power) < 1e-9 * fabs(power) && power != 0, "it gives %.12g W, booked are "
          "%.12g W", power, given);
    test_free(more);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stress_is_that_of_the_formula),
        cmocka_unit_test(momentum_and_its_moment_are_kept),
        cmocka_unit_test(its_work_is_in_the_book),
    };

    return cmocka_run_group_tests_name("stress", tests, NULL, NULL);
}
