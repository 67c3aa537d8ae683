/* ahead.c -- a pressure that looks ahead is the one that momentum balance and density agree on
 * (E3), its power is booked to rounding, and without looking ahead it is the linear one. */
#include "tank.h"

#include "base/status.h"
#include "eval/inside.h"
#include "matter/eos.h"
#include "plan/inside.h"
#include "space/record.h"

#include <math.h>
#include <string.h>

#define BARE "walls = \"own-density\"; effects = { continuity = { }; pressure = { }; };"
#define EXACT "eos = { type = \"look-ahead\"; c0 = 30.0; residual = 1e-13; tau = "
#if DIM == 2
#define AMPLITUDE "[0.01, 0.003]"
#else
#define AMPLITUDE "[0.01, 0.0, 0.003]"
#endif
#define DRIVEN(amplitude)                                                                     \
    "wall = { tank = { type = \"frame\"; amplitude = " amplitude "; frequency = 2.0; }; };"

static void shaken(struct tank *t, const char *wall, const char *eos, const char *effects)
{
    tank_make(t, tank_water, wall, eos, effects, NULL);
    tank_shake(t, 7, 0.1, 0.3, 1e-3);
}

/* p/rho^2 of particle i of kind k at the last evaluation. */
static double press(const struct tank *t, int k, int i)
{
    const struct moment *m = t->moment;
    const int place = m->list->slot[m->particles->from[k] + i];

    return m->work->record[(size_t)place * RECORD + RECORD_P2];
}

static const double now = 0.05; /* when walls that swing are on their way [s] */

static const char *const density[] = { [KIND_FLUID] = "density of fluid",
                                       [KIND_WALL] = "density of walls" };

/* Rates of density a time h further along rates of now, of which solids know the time alone. */
static double *rates_near(struct tank *t, double h)
{
    double *y = tank_copy(t, t->y), *rates = tank_copy(t, t->y);

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    tank_rates(t, now + h, y, rates);
    test_free(y);
    return rates;
}

static bool clamped(const struct tank *t)
{
    return ((const struct eos *)t->plan->pressure->self)->clamped;
}

/* How far (E3) is off with rho'' by differences, of the largest p, where it may have less
 * than 0 if there is no tension; the power by the works of tau rho' and tau^2 rho''. */
static void agrees(struct tank *t, double *off, double *power)
{
    const struct plan *p = t->plan;
    const double h = 1e-7, tau = plan_ahead(p), c2 = p->scales.c0 * p->scales.c0;
    double *after = rates_near(t, h), *before = rates_near(t, -h), worst = 0, most = 0;

    tank_rates(t, now, t->y, t->ydot);
    *power = 0;
    for (int k = KIND_FLUID; k <= KIND_WALL; k++)
        for (int i = 0; i < particles_count(p->particles, k); i++) {
            const long at = tank_at(t, density[k], NULL) + i;
            const double rho = t->y[at], rate = t->ydot[at];
            const double further = tau * rate
                                   + tau * tau * (after[at] - before[at]) / (2 * h);
            const double P = c2 * (rho - p->scales.rho0 + further) / (rho * rho);
            const double is = press(t, k, i);
            worst = fmax(worst, fabs(clamped(t) && is == 0 ? fmax(0, P) : P - is));
            most = fmax(most, fabs(is));
            *power -= p->particles->m[p->particles->from[k] + i] * rate * c2 * further
                      / (rho * rho);
        }
    *off = worst / most;
    test_free(after);
    test_free(before);
}

/* Particles that have a pressure, in percent; none has one below 0. */
static int pressed(const struct tank *t)
{
    const struct particles *all = t->plan->particles;
    int many = 0;

    for (int k = KIND_FLUID; k <= KIND_WALL; k++)
        for (int i = 0; i < particles_count(all, k); i++) {
            check(press(t, k, i) >= 0, "%s, particle %d: p/rho^2 = %g", density[k], i,
                  press(t, k, i));
            many += press(t, k, i) > 0;
        }
    return 100 * many / all->n;
}

static double booked(const struct tank *t)
{
    const struct plan_book *b = &t->plan->book;
    const double *book = t->ydot + tank_at(t, "book", NULL);

    return book[b->work + t->plan->pressure->slot] + book[b->dissipated];
}

static void is_that_of_the_density_it_leads_to(void **state)
{
    static const char *const walls[] = { "wall = { tank = { type = \"frame\"; }; };",
                                         DRIVEN(AMPLITUDE) };

    (void)state;
    for (int i = 0; i < 2; i++) {
        struct tank t;
        double off, power;

        shaken(&t, walls[i], EXACT "0.5; };", BARE);
        tank_rates(&t, now, t.y, t.ydot);
        agrees(&t, &off, &power);
        print_message("# walls %d: (E3) to %.2g, power %g and %g W\n", i, off, power, booked(&t));
        check(off < 1e-5, "walls %d: (E3) is off by %g of the pressure", i, off);
        check(fabs(power - booked(&t)) < 1e-5 * fabs(power), "power %g, booked %g", power,
              booked(&t));
        tank_free(&t);
    }
}

static void without_tension_it_complements_what_it_leads_to(void **state)
{
    struct tank t;
    double off, power;

    (void)state;
    shaken(&t, DRIVEN(AMPLITUDE), EXACT "0.5; tension = false; };", BARE);
    tank_rates(&t, now, t.y, t.ydot);
    agrees(&t, &off, &power);
    print_message("# (E3) to %.2g, %d %% have a pressure\n", off, pressed(&t));
    check(off < 1e-5, "(E3) is off by %g of the pressure", off);
    assert_in_range(pressed(&t), 10, 90);
    tank_free(&t);
}

/* Kinetic, potential and (E1)'s energy change by what the book says, whatever the residual. */
static void check_power(const char *eos, const char *effects)
{
    struct tank t;
    double sum = 0, size = 0;

    shaken(&t, tank_frame, eos, effects);
    tank_rates(&t, 0, t.y, t.ydot);
    const struct plan *p = t.plan;
    const long u = tank_at(&t, "velocity of fluid", NULL);
    for (int i = 0; i < particles_count(p->particles, KIND_FLUID) * DIM; i++) {
        const double a = t.ydot[u + i] - p->scales.g[i % DIM];
        sum += p->particles->m[i / DIM] * t.y[u + i] * a;
        size += fabs(p->particles->m[i / DIM] * t.y[u + i] * a);
    }
    for (int k = KIND_FLUID; k <= KIND_WALL; k++)
        for (int i = 0; i < particles_count(p->particles, k); i++) {
            const long at = tank_at(&t, density[k], NULL) + i;
            const double rho = t.y[at], c = p->scales.c0 / rho;
            const double above = fmax(rho - p->scales.rho0, clamped(&t) ? 0 : -rho);
            sum += p->particles->m[p->particles->from[k] + i] * c * c * above * t.ydot[at];
        }
    print_message("# power %.15g, booked %.15g, of %g W\n", sum, booked(&t), size);
    check(fabs(sum - booked(&t)) < 1e-12 * size, "power %.15g W, booked %.15g", sum, booked(&t));
    check(fabs(booked(&t)) > 1e-3 * size, "nothing looks ahead: %g of %g W", booked(&t), size);
    tank_free(&t);
}

static void power_is_booked(void **state)
{
    (void)state;
    check_power("eos = { type = \"look-ahead\"; c0 = 30.0; residual = 0.1; };", BARE);
    check_power("eos = { type = \"look-ahead\"; c0 = 30.0; residual = 0.1; tension = false; };",
                BARE);
    check_power("eos = { type = \"look-ahead\"; c0 = 30.0; residual = 0.1; tension = false; };",
                "walls = \"own-density\"; effects = { continuity = { }; pressure = { };"
                "density-healing = { }; };");
}

static void check_linear(const char *eos, const char *looking)
{
    struct tank linear, ahead;

    shaken(&linear, tank_frame, eos, BARE);
    shaken(&ahead, tank_frame, looking, BARE);
    tank_rates(&linear, 0, linear.y, linear.ydot);
    tank_rates(&ahead, 0, ahead.y, ahead.ydot);
    const long book = tank_at(&linear, "book", NULL);
    assert_int_equal(book, tank_at(&ahead, "book", NULL));
    assert_memory_equal(linear.y, ahead.y, (size_t)book * sizeof *linear.y);
    assert_memory_equal(linear.ydot, ahead.ydot, (size_t)book * sizeof *linear.ydot);
    tank_free(&linear);
    tank_free(&ahead);
}

#define AS_FAST "}; reference = { speed = 1.0; };"

static void without_looking_it_is_linear(void **state)
{
    (void)state;
    check_linear("eos = { type = \"linear\"; c0 = 30.0; " AS_FAST, EXACT "0.0; " AS_FAST);
    check_linear("eos = { type = \"linear\"; c0 = 30.0; tension = false; " AS_FAST,
                 EXACT "0.0; tension = false; " AS_FAST);
}

/* Kutta's third order, n steps to `end`; into y [n]. */
static void kutta(struct tank *t, double end, int n, double *y)
{
    double *k[3], *at = tank_copy(t, t->y);
    const double h = end / n;

    for (int s = 0; s < 3; s++)
        k[s] = tank_copy(t, t->y);
    memcpy(y, t->y, (size_t)t->n * sizeof *y);
    for (int step = 0; step < n; step++) {
        tank_rates(t, step * h, y, k[0]);
        for (long i = 0; i < t->n; i++)
            at[i] = y[i] + h / 2 * k[0][i];
        tank_rates(t, (step + 0.5) * h, at, k[1]);
        for (long i = 0; i < t->n; i++)
            at[i] = y[i] + h * (2 * k[1][i] - k[0][i]);
        tank_rates(t, (step + 1) * h, at, k[2]);
        for (long i = 0; i < t->n; i++)
            y[i] += h / 6 * (k[0][i] + 4 * k[1][i] + k[2][i]);
    }
    for (int s = 0; s < 3; s++)
        test_free(k[s]);
    test_free(at);
}

static double apart(const struct tank *t, const double *a, const double *b)
{
    const long u = tank_at(t, "velocity of fluid", NULL);
    double sum = 0;

    for (int i = 0; i < particles_count(t->plan->particles, KIND_FLUID) * DIM; i++)
        sum += (a[u + i] - b[u + i]) * (a[u + i] - b[u + i]);
    return sqrt(sum);
}

static void steps_keep_their_order(void **state)
{
    const int n[] = { 8, 16, 32 };
    struct tank t;
    double *y[3], coarse, fine;

    (void)state;
    tank_make(&t, tank_water, tank_frame, EXACT "0.5; };", BARE, NULL);
    tank_shake(&t, 7, 0.02, 0.02, 1e-5);
    for (int i = 0; i < 3; i++) {
        y[i] = tank_copy(&t, t.y);
        kutta(&t, 4 * plan_ahead(t.plan), n[i], y[i]);
    }
    coarse = apart(&t, y[0], y[1]);
    fine = apart(&t, y[1], y[2]);
    print_message("# order %.2f (%g, %g m/s)\n", log2(coarse / fine), coarse, fine);
    check(fine > 0 && log2(coarse / fine) > 2.8, "order %g", log2(coarse / fine));
    for (int i = 0; i < 3; i++)
        test_free(y[i]);
    tank_free(&t);
}

static void refuses(const char *text, const char *says)
{
    char scene[2000];
    struct tank t;

    snprintf(scene, sizeof scene, "%s%s%s", tank_water, tank_frame, text);
    assert_int_equal(tank_try(&t, scene), STATUS_BAD_SCENE);
    check(strstr(status_message(), says), "\"%s\" does not say \"%s\"", status_message(), says);
    status_clear();
    tank_free(&t);
}

static void says_what_it_does_not_go_with(void **state)
{
    (void)state;
    refuses("eos = { type = \"look-ahead\"; }; walls = \"adami\";"
            "effects = { continuity = { }; pressure = { }; };", "own-density");
    refuses(EXACT "0.5; }; walls = \"own-density\"; effects = { continuity = { };"
            "pressure = { }; laminar-viscosity = { side = \"implicit\"; }; };", "explicit");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_that_of_the_density_it_leads_to),
        cmocka_unit_test(without_tension_it_complements_what_it_leads_to),
        cmocka_unit_test(power_is_booked),
        cmocka_unit_test(without_looking_it_is_linear),
        cmocka_unit_test(steps_keep_their_order),
        cmocka_unit_test(says_what_it_does_not_go_with),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
