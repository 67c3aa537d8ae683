/* ahead-contact.c -- a pressure that looks ahead between walls = "contact": the walls' is the
 * one-sided law of the mean of densities that it leads to, (E3) with (W6), its power is booked
 * to rounding, between solids that move, too, and without looking far it is that law itself. */
#include "tank.h"

#include "base/status.h"
#include "eval/inside.h"
#include "plan/inside.h"
#include "space/record.h"
#include "walls/contact-press.h"

#include <math.h>
#include <string.h>

#define BARE "walls = \"contact\"; effects = { continuity = { }; pressure = { }; };"
#define EOS "eos = { type = \"look-ahead\"; c0 = 30.0; "
#define EXACT EOS "residual = 1e-13; "

/* Water beside a box that swings a spacing and a half above the floor. */
#if DIM == 2
#define WATER_AND_LIFT                                                                        \
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"                     \
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.08]; };"                                      \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.05, 0.06]; }; };"
#define LIFT "wall = { tank = { type = \"frame\"; }; lift = { type = \"box\"; "                \
             "from = [0.055, 0.0075]; to = [0.085, 0.0475]; amplitude = [-0.003, -0.002];"    \
             "frequency = 4.0; }; };"
#define SWINGS "wall = { tank = { type = \"frame\"; amplitude = [0.01, 0.003]; frequency = 2.0; }; };"
#else
#define WATER_AND_LIFT                                                                        \
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, -9.81];"                \
    "kernel = { support = 2.5; };"                                                            \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.22, 0.1, 0.16]; };"                           \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.12]; }; };"
#define LIFT "wall = { tank = { type = \"frame\"; }; lift = { type = \"box\"; "                \
             "from = [0.12, 0.0, 0.03]; to = [0.2, 0.1, 0.11];"                               \
             "amplitude = [-0.01, 0.0, -0.01]; frequency = 4.0; }; };"
#define SWINGS                                                                                \
    "wall = { tank = { type = \"frame\"; amplitude = [0.01, 0.0, 0.003]; frequency = 2.0; }; };"
#endif

static const double now = 0.02; /* when walls that swing are on their way [s] */

static const struct contact_press_self *self_of(const struct tank *t)
{
    return t->plan->passes.press->self;
}

static void shaken(struct tank *t, const char *water, const char *wall, const char *eos)
{
    tank_make(t, water, wall, eos, BARE, NULL);
    tank_shake(t, 7, 0.1, 0.3, 1e-3);
}

/* p/rho^2 that particle i of kind k has pushed with. */
static double press(const struct tank *t, int k, int i)
{
    const struct moment *m = t->moment;
    const int place = m->list->slot[m->particles->from[k] + i];

    return place < 0 ? 0 : m->work->record[(size_t)place * RECORD + RECORD_P2];
}

/* --- means, one by one, without slices -------------------------------------------------------- */

/* to = sum_w' A_ww' from_w', or its transpose, of numbers in the order of the mean. */
static void average(const struct contact_mean *m, bool transposed, const double *from, double *to)
{
    for (int i = 0; i < m->n; i++)
        to[i] = 0;
    for (int i = 0; i < m->n; i++)
        for (long e = 0; e < contact_mean_length(m, i / CONTACT_ROWS); e++) {
            const long at = contact_mean_at(m, i, e);
            const double a = m->weight[at] * m->inverse[i];
            const int j = m->column[at];
            if (transposed)
                to[j] += a * from[i];
            else
                to[i] += a * from[j];
        }
}

/* Of r_w = rho_w + g(o_w) the mean, or of rates: rows of walls in a vector like y. */
static double *mean_of(const struct tank *t, const double *y, bool near)
{
    const struct contact_press_self *c = self_of(t);
    const double *rho = y + tank_at(t, "density of walls", NULL);
    double *from = test_calloc((size_t)c->mean.n + 1, sizeof *from);
    double *to = test_calloc((size_t)c->mean.n + 1, sizeof *to), slope;

    for (int i = 0; i < c->mean.n; i++)
        from[i] = rho[c->mean.solid[i]]
                  + (near ? contact_others_fill(&c->others, i, t->moment->work->press->around[i],
                                                &slope) : 0);
    average(&c->mean, false, from, to);
    test_free(from);
    return to;
}

static double *rates_near(struct tank *t, double h)
{
    double *y = tank_copy(t, t->y), *rates = tank_copy(t, t->y);

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    tank_rates(t, now + h, y, rates);
    test_free(y);
    return rates;
}

/* --- the law ------------------------------------------------------------------------------------ */

/* How far q is off, of the largest: it should be A^T max(0, pi), pi of the mean that comes. */
static double off_by(struct tank *t, double tau, int *wet)
{
    const struct contact_press_self *c = self_of(t);
    const double h = 1e-7, c2 = pow(t->plan->scales.c0, 2), rho0 = t->plan->scales.rho0;
    double *after = rates_near(t, h), *before = rates_near(t, -h), worst = 0, most = 0;
    double *pi = test_calloc((size_t)c->mean.n + 1, sizeof *pi);
    double *q = test_calloc((size_t)c->mean.n + 1, sizeof *q);

    for (long i = 0; i < t->n; i++)
        after[i] = (after[i] - before[i]) / (2 * h);
    tank_rates(t, now, t->y, t->ydot);
    double *rho = mean_of(t, t->y, true), *rate = mean_of(t, t->ydot, false);
    double *slope = mean_of(t, after, false);
    *wet = 0;
    for (int i = 0; i < c->mean.n; i++) {
        const double coming = rho[i] - rho0 + tau * rate[i] + tau * tau * slope[i];
        pi[i] = fmax(0, c2 * coming / pow(fmax(rho0, rho[i]), 2));
        *wet += pi[i] > 0;
    }
    average(&c->mean, true, pi, q);
    for (int i = 0; i < c->mean.n; i++) {
        const double is = press(t, KIND_WALL, c->mean.solid[i]);
        check(is >= 0, "wall particle %d pulls: %g", c->mean.solid[i], is);
        if (is == 0)
            continue; /* no water is near */
        worst = fmax(worst, fabs(is - q[i]));
        most = fmax(most, is);
    }
    double *const memory[] = { after, before, pi, q, rho, rate, slope };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        test_free(memory[i]);
    return worst / most;
}

static void is_one_sided_and_of_the_mean_it_leads_to(void **state)
{
    static const char *const walls[] = { "wall = { tank = { type = \"frame\"; }; };", SWINGS };
    static const char *const eos[] = { EXACT "};", EXACT "tension = false; };" };

    (void)state;
    for (int i = 0; i < 4; i++) {
        struct tank t;
        int wet;
        shaken(&t, tank_water, walls[i / 2], eos[i % 2]);
        tank_rates(&t, now, t.y, t.ydot);
        const double off = off_by(&t, plan_ahead(t.plan), &wet);
        print_message("# walls %d, eos %d: q to %.2g, %d of %d wall particles press\n", i / 2, i % 2,
                      off, wet, self_of(&t)->mean.n);
        check(off < 1e-5, "walls %d, eos %d: q is off by %g of the largest", i / 2, i % 2, off);
        assert_in_range(100 * wet / self_of(&t)->mean.n, 10, 90);
        tank_free(&t);
    }
}

/* A short look: q of the densities as they are, but for what goes with tau. */
static void without_looking_far_it_is_the_law_of_now(void **state)
{
    double off[2];

    (void)state;
    for (int i = 0; i < 2; i++) {
        struct tank t;
        int wet;
        shaken(&t, tank_water, tank_frame,
               i == 0 ? EXACT "tau = 1e-2; }; reference = { speed = 1.0; };"
                      : EXACT "tau = 1e-3; }; reference = { speed = 1.0; };");
        tank_rates(&t, now, t.y, t.ydot);
        off[i] = off_by(&t, 0, &wet);
        tank_free(&t);
    }
    print_message("# off by %g with tau = 1e-2 dx/U, by %g with 1e-3\n", off[0], off[1]);
    check(off[0] < 1 && off[1] < 0.11 * off[0], "off by %g and %g", off[0], off[1]);
}

/* --- power ---------------------------------------------------------------------------------------- */

static double booked(const struct tank *t)
{
    const struct plan_book *b = &t->plan->book;
    const double *book = t->ydot + tank_at(t, "book", NULL);

    return book[b->work + t->plan->pressure->slot] + book[b->dissipated];
}

/* Power of the fluid's motion, and of energies by (E1) of the fluid; its size. */
static double of_fluid(const struct tank *t, double *size)
{
    const struct plan *p = t->plan;
    const long u = tank_at(t, "velocity of fluid", NULL), at = tank_at(t, "density of fluid", NULL);
    const bool clamped = ((const struct eos *)p->pressure->self)->clamped;
    double sum = 0;

    *size = 0;
    for (int i = 0; i < particles_count(p->particles, KIND_FLUID) * DIM; i++) {
        const double a = t->ydot[u + i] - p->scales.g[i % DIM];
        sum += p->particles->m[i / DIM] * t->y[u + i] * a;
        *size += fabs(p->particles->m[i / DIM] * t->y[u + i] * a);
    }
    for (int i = 0; i < particles_count(p->particles, KIND_FLUID); i++) {
        const double rho = t->y[at + i], c = p->scales.c0 / rho;
        sum += p->particles->m[i] * c * c * fmax(rho - p->scales.rho0, clamped ? 0 : -rho)
               * t->ydot[at + i];
    }
    return sum;
}

/* Rate of what solids store, for rates of the means. */
static double of_solids(const struct tank *t, const double *rho, const double *rate)
{
    const struct plan *p = t->plan;
    const double m = p->scales.mass, rho0 = p->scales.rho0;
    double sum = 0;

    for (int i = 0; i < self_of(t)->mean.n; i++)
        sum += m * pow(p->scales.c0 / fmax(rho0, rho[i]), 2) * fmax(0, rho[i] - rho0) * rate[i];
    return sum;
}

static void power_is_booked(void **state)
{
    static const char *const eos[] = { EOS "residual = 0.1; };",
                                       EOS "residual = 0.1; tension = false; };" };

    (void)state;
    for (int i = 0; i < 2; i++) {
        struct tank t;
        double size;
        shaken(&t, tank_water, tank_frame, eos[i]);
        tank_rates(&t, now, t.y, t.ydot);
        double *rho = mean_of(&t, t.y, true), *rate = mean_of(&t, t.ydot, false);
        const double sum = of_fluid(&t, &size) + of_solids(&t, rho, rate);
        print_message("# power %.15g, booked %.15g, of %g W\n", sum, booked(&t), size);
        check(fabs(sum - booked(&t)) < 1e-12 * size, "power %.15g W, booked %.15g", sum, booked(&t));
        check(fabs(booked(&t)) > 1e-3 * size, "nothing looks ahead: %g of %g W", booked(&t), size);
        test_free(rho);
        test_free(rate);
        tank_free(&t);
    }
}

/* Beside solids that move against each other: what they get from walls is lost by these, and
 * o' is by differences. */
static void between_solids_power_is_booked(void **state)
{
    const double h = 1e-6;
    struct tank t;
    double size;

    (void)state;
    shaken(&t, WATER_AND_LIFT, LIFT, EXACT "};");
    for (int k = 0; k < particles_count(t.plan->particles, KIND_WALL); k++)
        t.y[tank_at(&t, "density of walls", NULL) + k] += 350; /* else none presses there */
    test_free(rates_near(&t, h));
    double *after = mean_of(&t, t.y, true);
    test_free(rates_near(&t, -h));
    double *before = mean_of(&t, t.y, true);
    tank_rates(&t, now, t.y, t.ydot);
    double *rho = mean_of(&t, t.y, true), *rate = mean_of(&t, t.ydot, false);
    double between = 0;
    for (int i = 0; i < self_of(&t)->mean.n; i++) {
        const double moved = (after[i] - before[i]) / (2 * h);
        between = fmax(between, fabs(moved));
        rate[i] += moved;
    }
    const double sum = of_fluid(&t, &size) + of_solids(&t, rho, rate) + t.moment->wall_power;
    print_message("# power %.12g, booked %.12g, of %g W, by walls %g W; solids fill by %g kg/m^D/s\n",
                  sum, booked(&t), size, t.moment->wall_power, between);
    check(fabs(sum - booked(&t)) < 1e-7 * size, "power %.15g W, booked %.15g", sum, booked(&t));
    check(between > 1 && fabs(t.moment->wall_power) > 1e-3 * size, "no solids are near: %g, %g W",
          between, t.moment->wall_power);
    double *const memory[] = { after, before, rho, rate };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        test_free(memory[i]);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_one_sided_and_of_the_mean_it_leads_to),
        cmocka_unit_test(without_looking_far_it_is_the_law_of_now),
        cmocka_unit_test(power_is_booked),
        cmocka_unit_test(between_solids_power_is_booked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
