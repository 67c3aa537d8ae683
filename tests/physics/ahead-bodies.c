/* ahead-bodies.c -- a pressure that looks ahead with beams in the water: it is the one that
 * momentum balance, density and the predicted motion of the skin agree on, (E3) with (E4); its
 * power goes to water, beam and book to rounding; how light the beam is costs nothing. */
#include "tank.h"

#include "base/status.h"
#include "bodies/bending.h"
#include "eval/inside.h"
#include "plan/inside.h"
#include "space/record.h"

#include <math.h>
#include <string.h>

#define BARE "walls = \"own-density\"; effects = { continuity = { }; pressure = { }; };"
#define VISCOUS                                                                               \
    "walls = \"own-density\"; effects = { continuity = { }; pressure = { };"                    \
    " laminar-viscosity = { mu = 5.0; }; };"
#define EOS(residual) "eos = { type = \"look-ahead\"; c0 = 30.0; residual = " residual "; };"
#define BEAM(rest)                                                                            \
    "beam = { plate = { at = [0.0675, 0.0]; length = 0.05; thickness = 4e-3; elements = 4;"    \
    " layers = 3; tip_force = 2.0; " rest " }; };"
#define SOFT "E = 1e-3; density = 1200.0; "
#define HARD "E = 1e7; density = 1200.0; alpha = 3.0; beta = 1e-4; "
#define LIGHT "E = 1e7; density = 1.2; "
#define FAR "theory = \"elastica\";"
#define PREDICTED "response = \"predicted\";"

static const double at_time = 0.01; /* [s] */

static void make(struct tank *t, const char *beam, const char *eos, const char *effects)
{
    tank_make(t, tank_parted_water, tank_frame, beam, eos, effects, NULL);
    tank_shake(t, 7, 0.1, 0.3, 1e-3);
}

static double press(const struct tank *t, int k, int i)
{
    const struct moment *m = t->moment;
    const int place = m->list->slot[m->particles->from[k] + i];

    return m->work->record[(size_t)place * RECORD + RECORD_P2];
}

/* Rates at y + h times the direction. */
static double *rates_near(struct tank *t, double h, const double *direction)
{
    double *y = tank_copy(t, t->y), *rates = tank_copy(t, t->y);

    for (long i = 0; i < t->n; i++)
        y[i] += h * direction[i];
    tank_rates(t, at_time, y, rates);
    test_free(y);
    return rates;
}

/* Their difference over 2 h. */
static double *bend_of(struct tank *t, double h, const double *direction)
{
    double *after = rates_near(t, h, direction), *before = rates_near(t, -h, direction);

    for (long i = 0; i < t->n; i++)
        after[i] = (after[i] - before[i]) / (2 * h);
    test_free(before);
    return after;
}

/* How far P is from (E3), of the largest; `second` has rho''. */
static double off(const struct tank *t, const double *second)
{
    const struct plan *p = t->plan;
    const double tau = plan_ahead(p), c2 = p->scales.c0 * p->scales.c0;
    double worst = 0, most = 0;

    for (int k = 0; k < KINDS; k++)
        for (int i = 0; p->row.density[k] >= 0 && i < particles_count(p->particles, k); i++) {
            const long at = layout_at(plan_layout(p), p->row.density[k]) + i;
            const double rho = t->y[at];
            const double P = c2 * (rho - p->scales.rho0 + tau * t->ydot[at]
                                   + tau * tau * second[at]) / (rho * rho);
            worst = fmax(worst, fabs(P - press(t, k, i)));
            most = fmax(most, fabs(P));
        }
    return worst / most;
}

/* Beams that nothing but their mass holds, and those that move as predicted: what is predicted
 * is what happens, points that turn about a centre line and friction included. */
static void skins_move_as_predicted(void **state)
{
    static const char *const beams[] = { BEAM(SOFT), BEAM(SOFT FAR), BEAM(HARD PREDICTED),
                                         BEAM(HARD PREDICTED FAR), BEAM(LIGHT PREDICTED) };

    (void)state;
    for (int i = 0; i < 5; i++) {
        struct tank t;
        make(&t, beams[i], EOS("1e-13"), i < 4 ? BARE : VISCOUS);
        tank_rates(&t, at_time, t.y, t.ydot);
        double *second = bend_of(&t, 1e-7, t.ydot);
        tank_rates(&t, at_time, t.y, t.ydot);
        const double far = off(&t, second);
        print_message("# %s: (E3) to %.2g\n", beams[i], far);
        check(far < 1e-5, "%s: (E3) is off by %g of the pressure", beams[i], far);
        test_free(second);
        tank_free(&t);
    }
}

/* M v' of what the beam does and (M + tau D + tau^2 K) a of what is predicted differ by tau K v
 * (E4); both go over the rates of deflections in `of`, its other entries are 0. */
static void beyond(const struct tank *t, const struct bending *b, double *of)
{
    const long wr = tank_at(t, "beam.plate.w_rate", NULL);
    const long tr = tank_at(t, "beam.plate.theta_rate", NULL);
    const double tau = plan_ahead(t->plan);
    double a[10], v[10], strain[10], force[10];
    struct bending_work *work;

    assert_int_equal(bending_work_create(b, &work), STATUS_DONE);
    for (int i = 0; i < b->dofs; i++) {
        const long at = (i % 2 ? tr : wr) + i / 2;
        a[i] = bending_held(b, i) ? 0 : t->ydot[at];
        v[i] = bending_held(b, i) ? 0 : t->y[at];
    }
    band_multiply(b->mass_free, a, force);
    band_multiply(b->stiffness_free, v, strain);
    for (int i = 0; i < b->dofs; i++)
        force[i] -= tau * strain[i];
    assert_int_equal(bending_yield(b, work, tau, force), STATUS_DONE);
    memset(of, 0, (size_t)t->n * sizeof *of);
    for (int i = 0; i < b->dofs; i++)
        of[(i % 2 ? tr : wr) + i / 2] = force[i] - a[i];
    bending_work_free(&work);
}

/* A beam with a stiffness moves by its mass alone: (E3) has rho'' of the water as it moves and
 * of the skin as (E4) says. */
static void stiff_beams_are_predicted_by_their_stiffness(void **state)
{
    const struct bending_def def = { .elements = 4, .length = 0.05, .EI = 1e7 * 64e-9 / 12,
                                     .mu = 1200 * 4e-3, .alpha = 3, .beta = 1e-4,
                                     .tip = BENDING_FREE };
    struct bending *b;
    struct tank t;

    (void)state;
    assert_int_equal(bending_create(&def, &b), STATUS_DONE);
    make(&t, BEAM(HARD), EOS("1e-13"), BARE);
    tank_rates(&t, at_time, t.y, t.ydot);
    double *more = tank_copy(&t, t.y), *second = bend_of(&t, 1e-7, t.ydot);
    tank_rates(&t, at_time, t.y, t.ydot);
    beyond(&t, b, more);
    double *skin = bend_of(&t, 1e-4, more);
    tank_rates(&t, at_time, t.y, t.ydot);
    const double without = off(&t, second);
    for (long i = 0; i < t.n; i++)
        second[i] += skin[i];
    const double with = off(&t, second);
    print_message("# (E3) to %.2g; without stiffness in the prediction %.2g\n", with, without);
    check(with < 1e-5, "(E3) and (E4) are off by %g of the pressure", with);
    check(without > 1e-2, "stiffness makes no difference: %g", without);
    test_free(more);
    test_free(second);
    test_free(skin);
    bending_free(&b);
    tank_free(&t);
}

/* --- power ------------------------------------------------------------------------- */

static double booked(const struct tank *t)
{
    const struct plan_book *b = &t->plan->book;
    const double *book = t->ydot + tank_at(t, "book", NULL);

    return book[b->work + t->plan->pressure->slot] + book[b->dissipated];
}

/* Power that pressure gives the fluid, stores, and gives the skin; *size: without signs. */
static double power_of(const struct tank *t, double *size)
{
    const struct plan *p = t->plan;
    const struct particles *all = t->moment->particles;
    const struct moment_body *b = &t->moment->body[0];
    const long u = tank_at(t, "velocity of fluid", NULL);
    const int skin = all->object[b->object].from;
    double sum = 0;

    *size = 0;
    for (int i = 0; i < particles_count(all, KIND_FLUID) * DIM; i++) {
        const double a = t->ydot[u + i] - p->scales.g[i % DIM];
        sum += all->m[i / DIM] * t->y[u + i] * a;
        *size += fabs(all->m[i / DIM] * t->y[u + i] * a);
    }
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; p->row.density[k] >= 0 && i < particles_count(all, k); i++) {
            const long at = layout_at(plan_layout(p), p->row.density[k]) + i;
            const double rho = t->y[at], c = p->scales.c0 / rho;
            sum += all->m[all->from[k] + i] * c * c * (rho - p->scales.rho0) * t->ydot[at];
        }
    for (int j = 0; j < b->skin; j++)
        for (int d = 0; d < DIM; d++)
            sum += b->force[j][d] * all->u[skin + j][d];
    return sum;
}

/* What the book has for a beam: all that takes energy from it or gives some, but the water. */
static double beams_own(const struct tank *t)
{
    return t->moment->body[0].load.damping + t->moment->body[0].load.driven;
}

static double beams_energy(struct tank *t, double h)
{
    const struct moment_body *b = &t->moment->body[0];
    struct energies e = { 0 };
    double *y = tank_copy(t, t->y);

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    b->kind->energy(b->body, b->work, plan_layout(t->plan), y, &e);
    test_free(y);
    return e.kinetic + e.elastic + e.potential;
}

/* Whatever the residual.  The beam's energy is a polynomial of its state: differences are
 * exact, but for the elastica's. */
static void power_is_booked(void **state)
{
    static const struct {
        const char *beam;
        double h, differences;
    } of[] = { { BEAM(HARD), 1e-5, 1e-9 }, { BEAM(HARD PREDICTED), 1e-5, 1e-9 },
               { BEAM(LIGHT PREDICTED), 1e-5, 1e-9 }, { BEAM(HARD FAR), 1e-7, 1e-6 },
               { BEAM(LIGHT FAR PREDICTED), 1e-7, 1e-6 } };

    (void)state;
    for (int i = 0; i < 5; i++) {
        struct tank t;
        double size, work = 0;
        make(&t, of[i].beam, EOS("0.1"), BARE);
        tank_rates(&t, at_time, t.y, t.ydot);
        const double power = power_of(&t, &size), h = of[i].h;
        const struct moment_body *b = &t.moment->body[0];
        for (int j = 0; j < b->skin; j++)
            for (int d = 0; d < DIM; d++)
                work += b->force[j][d]
                      * t.moment->particles->u[t.moment->particles->object[b->object].from + j][d];
        const double gains = (beams_energy(&t, h) - beams_energy(&t, -h)) / (2 * h);
        print_message("# power %.15g, booked %.15g, of %g W; beam %g W by water, %g by itself, %g\n",
                      power, booked(&t), size, work, beams_own(&t), gains);
        check(fabs(power - booked(&t)) < 1e-12 * size, "%s: power %.15g W, booked %.15g",
              of[i].beam, power, booked(&t));
        check(fabs(booked(&t)) > 1e-3 * size, "nothing looks ahead: %g W", booked(&t));
        check(fabs(gains - work - beams_own(&t)) < of[i].differences * (fabs(work) + fabs(gains)),
              "%s: the beam gains %g W, by water %g and by itself %g", of[i].beam, gains, work,
              beams_own(&t));
        tank_free(&t);
    }
}

/* --- masses -------------------------------------------------------------------------- */

/* The matrix is symmetric and positive definite for any mass, and lightness adds no products. */
static void the_lightest_beam_takes_no_more_products(void **state)
{
    static const char *const density[] = { "1e6", "1200.0", "1.0", "1e-3" };
    long products[4];

    (void)state;
    for (int i = 0; i < 4; i++) {
        struct tank t;
        char beam[500];
        snprintf(beam, sizeof beam, BEAM("E = 1e7; density = %s;"), density[i]);
        make(&t, beam, EOS("1e-6"), BARE);
        tank_rates(&t, at_time, t.y, t.ydot);
        products[i] = moment_counts(t.moment)->products;
        print_message("# density %s kg/m^3: %ld products\n", density[i], products[i]);
        check(products[i] > 5 && products[i] <= 2 * products[0], "density %s: %ld products, %ld with "
              "a heavy beam", density[i], products[i], products[0]);
        tank_free(&t);
    }
}

static void refuses(const char *text, const char *says)
{
    char scene[2000];
    struct tank t;

    snprintf(scene, sizeof scene, "%s%s%s", tank_parted_water, tank_frame, text);
    assert_int_equal(tank_try(&t, scene), STATUS_BAD_SCENE);
    check(strstr(status_message(), says), "\"%s\" does not say \"%s\"", status_message(), says);
    status_clear();
    tank_free(&t);
}

static void says_what_a_predicted_beam_needs(void **state)
{
    (void)state;
    refuses(BEAM(HARD PREDICTED) BARE, "eos.type = \"look-ahead\"");
    refuses(BEAM(HARD PREDICTED) BARE "eos = { type = \"look-ahead\"; tau = 0.0; };", "eos.tau");
    refuses(BEAM(HARD PREDICTED FAR) BARE, "eos.type = \"look-ahead\"");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(skins_move_as_predicted),
        cmocka_unit_test(stiff_beams_are_predicted_by_their_stiffness),
        cmocka_unit_test(power_is_booked),
        cmocka_unit_test(the_lightest_beam_takes_no_more_products),
        cmocka_unit_test(says_what_a_predicted_beam_needs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
