/* ahead-decay.c -- what a pressure that looks ahead takes falls apart into what comes back and
 * what does not: with x = rho'/rho, rho' and rho'' by a plain loop over all pairs,
 *
 *   d/dt [kinetic + potential + (E1)'s + sum of m c0^2 tau^2 x^2/2]
 *       = -sum of m c0^2 tau x^2 (1 + tau x) + power of walls
 *
 * to rounding, and the book has the two by name. */
#include "tank.h"

#include "eval/inside.h"
#include "kernels/kernel.h"
#include "matter/eos.h"
#include "plan/inside.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define BARE "walls = \"own-density\"; effects = { continuity = { }; pressure = { }; };"
#define EXACT "eos = { type = \"look-ahead\"; c0 = 30.0; residual = 1e-13; tau = "
#if DIM == 2
#define SWINGS "wall = { tank = { type = \"frame\"; amplitude = [0.01, 0.003]; frequency = 2.0; }; };"
#else
#define SWINGS                                                                                \
    "wall = { tank = { type = \"frame\"; amplitude = [0.01, 0.0, 0.003]; frequency = 2.0; }; };"
#endif

static const double now = 0.05; /* when walls that swing are on their way [s] */

/* One particle as the loop sees it. */
struct point {
    double x[DIM], u[DIM], a[DIM], m, rho, rate, further; /* rho', rho'' */
    bool fluid;
};

static void read_points(const struct tank *t, struct point *to)
{
    const struct particles *all = t->plan->particles, *at = t->moment->particles;
    const long x = tank_at(t, "position of fluid", NULL), u = tank_at(t, "velocity of fluid", NULL);
    const long fluid = tank_at(t, "density of fluid", NULL);
    const long wall = tank_at(t, "density of walls", NULL);
    const int n = particles_count(all, KIND_FLUID);

    for (int i = 0; i < all->n; i++) {
        struct point *p = &to[i];
        *p = (struct point){ .m = all->m[i], .fluid = i < n,
                             .rho = t->y[i < n ? fluid + i : wall + i - n] };
        for (int d = 0; d < DIM; d++) {
            p->x[d] = i < n ? t->y[x + i * DIM + d] : at->x[i][d];
            p->u[d] = i < n ? t->y[u + i * DIM + d] : at->u[i][d];
            p->a[d] = i < n ? t->ydot[u + i * DIM + d] : 0;
        }
        if (i >= n)
            object_acceleration(&at->object[at->object_of[i]], at->x[i], p->a);
    }
}

/* rho' and rho'' that b gives a.  Of Wendland's C2, W = (1 - q)^4 (1 + 4 q) up to a factor with
 * q = r/H, W'' is W'/r (1 - 4 q)/(1 - q). */
static void add_pair(const struct plan *p, struct point *a, const struct point *b)
{
    double r2 = 0, along = 0, speed2 = 0, pull = 0;

    for (int d = 0; d < DIM; d++) {
        const double x = a->x[d] - b->x[d], v = a->u[d] - b->u[d];
        r2 += x * x;
        along += x * v;
        speed2 += v * v;
        pull += x * (a->a[d] - b->a[d]);
    }
    const double r = sqrt(r2), q = r / p->scales.support;
    if (q >= 1 || !(a->fluid || b->fluid))
        return;
    const double slope = kernel_gradient(p->kernel[PART_PRESSURE], r) / r;
    const double bend = slope * (1 - 4 * q) / (1 - q);
    a->rate += b->m * slope * along;
    a->further += b->m * (slope * pull + bend * along * along / r2
                          + slope * (speed2 - along * along / r2));
}

static struct point *points(const struct tank *t)
{
    const int n = t->plan->particles->n;
    struct point *p = test_malloc((size_t)n * sizeof *p);

    read_points(t, p);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            if (i != j)
                add_pair(t->plan, &p[i], &p[j]);
    return p;
}

/* Powers [W]: of motion and of (E1); of what looking ahead stores; what it dissipates; and the
 * size of what moves. */
struct powers {
    double moved, stored, lost, size;
};

static struct powers powers_of(const struct tank *t)
{
    const struct plan *p = t->plan;
    const double tau = plan_ahead(p), c2 = pow(p->scales.c0, 2);
    struct point *all = points(t);
    struct powers to = { 0 };

    for (int i = 0; i < p->particles->n; i++) {
        const struct point *a = &all[i];
        const double x = a->rate / a->rho;
        to.moved += a->m * c2 * (a->rho - p->scales.rho0) / a->rho * x;
        to.stored += a->m * c2 * tau * tau * x * (a->further / a->rho - x * x);
        to.lost -= a->m * c2 * tau * x * x * (1 + tau * x);
        for (int d = 0; d < DIM && a->fluid; d++) {
            const double power = a->m * a->u[d] * (a->a[d] - p->scales.g[d]);
            to.moved += power;
            to.size += fabs(power);
        }
    }
    to.moved += t->moment->wall_power;
    test_free(all);
    return to;
}

static double booked(const struct tank *t, bool dissipated)
{
    const struct plan *p = t->plan;

    return t->ydot[tank_at(t, "book", NULL)
                   + (dissipated ? p->book.dissipated : p->book.work + p->pressure->slot)];
}

static void what_is_taken_comes_back_or_does_not(void **state)
{
    static const char *const tau[] = { EXACT "0.1; };", EXACT "0.5; };", EXACT "2.0; };" };

    (void)state;
    for (int i = 0; i < 6; i++) {
        struct tank t;
        tank_make(&t, tank_water, i % 2 ? SWINGS : tank_frame, tau[i / 2], BARE, NULL);
        tank_shake(&t, 7, 0.1, 0.3, 1e-3);
        tank_rates(&t, now, t.y, t.ydot);
        const struct powers is = powers_of(&t);
        const double held = booked(&t, false), lost = booked(&t, true);
        print_message("# tau %d, walls %d: moved %.6g, stored %.6g, dissipated %.6g W; off by %.2g of "
                      "%g W\n", i / 2, i % 2, is.moved, is.stored, is.lost,
                      fabs(is.moved + is.stored - is.lost) / is.size, is.size);
        check(fabs(is.moved + is.stored - is.lost) < 1e-12 * (is.size - is.lost),
              "the identity is off by %g of %g W", is.moved + is.stored - is.lost, is.size);
        check(fabs(lost - is.lost) < 1e-12 * -is.lost, "dissipated: %.15g W, booked %.15g", is.lost,
              lost);
        check(fabs(held + is.stored) < 1e-12 * (is.size - is.lost), "stored: %.15g W, booked %.15g", is.stored,
              -held);
        check(is.lost < -1e-3 * is.size && fabs(is.stored) > 1e-3 * is.size,
              "nothing looks ahead: %g and %g of %g W", is.lost, is.stored, is.size);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_taken_comes_back_or_does_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
