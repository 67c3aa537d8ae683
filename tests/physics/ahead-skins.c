/* ahead-skins.c -- a pressure that looks ahead on beams between walls = "contact": walls and skins
 * press one-sidedly by the mean of densities that the motion leads to, (E3) with (W6) and (E4);
 * the power goes to water, skins and book. */
#include "tank.h"

#include "eval/inside.h"
#include "plan/inside.h"
#include "space/record.h"
#include "walls/contact-press.h"

#include <math.h>
#include <string.h>

#define BARE "walls = \"contact\"; effects = { continuity = { }; pressure = { }; };"
#define EOS "eos = { type = \"look-ahead\"; c0 = 30.0; "
#define BEAM(rest)                                                                            \
    "beam = { plate = { at = [0.0675, 0.0]; length = 0.05; thickness = 4e-3; elements = 4;"    \
    " layers = 3; tip_force = 2.0; " rest " }; };"
#define SOFT "E = 1e-3; density = 1200.0; response = \"predicted\"; "
#define HARD "E = 1e7; density = 1200.0; alpha = 3.0; beta = 1e-4; response = \"predicted\"; "
#define LIGHT "E = 1e7; density = 1.2; response = \"predicted\"; "
#define FAR "theory = \"elastica\"; "

static const double now = 0.01; /* [s] */
static const char *const beams[] = { BEAM(SOFT), BEAM(SOFT FAR), BEAM(HARD), BEAM(HARD FAR),
                                     BEAM(LIGHT), BEAM(LIGHT FAR) };

static void shaken(struct tank *t, const char *beam, const char *eos)
{
    tank_make(t, tank_parted_water, tank_frame, beam, eos, BARE, NULL);
    tank_shake(t, 7, 0.1, 0.3, 1e-3);
    tank_rates(t, now, t->y, t->ydot);
}

static const struct contact_press_self *self_of(const struct tank *t)
{
    return t->plan->passes.press->self;
}

/* That of solid i of the mean among all particles: in a state that was never rearranged, a row is
 * an id. */
static int id_of(const struct tank *t, int i)
{
    return t->plan->particles->from[KIND_WALL] + self_of(t)->mean.solid[i];
}

/* to = sum_w' A_ww' from_w', or its transpose. */
static double *average(const struct contact_mean *m, bool transposed, const double *from)
{
    double *to = test_calloc((size_t)m->n + 1, sizeof *to);

    for (int i = 0; i < m->n; i++)
        for (long e = 0; e < contact_mean_length(m, i / CONTACT_ROWS); e++) {
            const long at = contact_mean_at(m, i, e);
            const int j = m->column[at];
            to[transposed ? j : i] += m->weight[at] * m->inverse[i] * from[transposed ? i : j];
        }
    return to;
}

/* Of r_w = rho_w + g(o_w) the mean, or of rates in a vector like y. */
static double *mean_of(const struct tank *t, const double *y, bool near)
{
    const struct contact_press_self *c = self_of(t);
    const struct plan *p = t->plan;
    double *from = test_calloc((size_t)c->mean.n + 1, sizeof *from), slope;

    for (int i = 0; i < c->mean.n; i++) {
        const int k = c->kind[i];
        from[i] = y[layout_at(plan_layout(p), p->row.density[k]) + id_of(t, i)
                    - p->particles->from[k]];
        if (near)
            from[i] += contact_others_fill(&c->others, i, t->moment->work->press->around[i], &slope);
    }
    double *to = average(&c->mean, false, from);
    test_free(from);
    return to;
}

/* Rates a time h further along those of now; the moment stays there. */
static double *rates_near(struct tank *t, double h)
{
    double *y = tank_copy(t, t->y), *rates = tank_copy(t, t->y);

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    tank_rates(t, now + h, y, rates);
    test_free(y);
    return rates;
}

static void give_back(double *const *memory, int n)
{
    for (int i = 0; i < n; i++)
        test_free(memory[i]);
}

/* --- the law ------------------------------------------------------------------------- */

/* How far q of the solids is off, of the largest: it should be A^T max(0, pi), pi of the mean that
 * comes.  wet: how many of the skin press; without: the same with no second rate. */
static double off_by(struct tank *t, int *wet, double *without)
{
    const struct contact_press_self *c = self_of(t);
    const double h = 1e-7, c2 = pow(t->plan->scales.c0, 2), rho0 = t->plan->scales.rho0;
    const double tau = plan_ahead(t->plan);
    double *after = rates_near(t, h), *before = rates_near(t, -h), worst = 0, most = 0;
    double *pi = test_calloc((size_t)c->mean.n + 1, sizeof *pi);
    double *of_now = test_calloc((size_t)c->mean.n + 1, sizeof *of_now);

    for (long i = 0; i < t->n; i++)
        after[i] = (after[i] - before[i]) / (2 * h);
    tank_rates(t, now, t->y, t->ydot);
    double *rho = mean_of(t, t->y, true), *rate = mean_of(t, t->ydot, false);
    double *bend = mean_of(t, after, false);
    *wet = 0;
    for (int i = 0; i < c->mean.n; i++) {
        const double stiff = c2 / pow(fmax(rho0, rho[i]), 2);
        of_now[i] = fmax(0, stiff * (rho[i] - rho0 + tau * rate[i]));
        pi[i] = fmax(0, stiff * (rho[i] - rho0 + tau * rate[i] + tau * tau * bend[i]));
        *wet += c->kind[i] == KIND_SKIN && pi[i] > 0;
    }
    double *q = average(&c->mean, true, pi), *q_now = average(&c->mean, true, of_now);
    *without = 0;
    for (int i = 0; i < c->mean.n; i++) {
        const int place = t->moment->list->slot[id_of(t, i)];
        const double is = place < 0 ? 0 : t->moment->work->record[(size_t)place * RECORD + RECORD_P2];
        if (is == 0)
            continue; /* no water is near */
        worst = fmax(worst, fabs(is - q[i]));
        *without = fmax(*without, fabs(is - q_now[i]));
        most = fmax(most, is);
    }
    *without /= most;
    give_back((double *const[]){ after, before, pi, of_now, rho, rate, bend, q, q_now }, 9);
    return worst / most;
}

static void skins_press_by_the_mean_they_lead_to(void **state)
{
    static const char *const eos[] = { EOS "residual = 1e-13; };",
                                       EOS "residual = 1e-13; tension = false; };" };

    (void)state;
    for (int i = 0; i < 12; i++) {
        struct tank t;
        double without;
        int wet;
        shaken(&t, beams[i / 2], eos[i % 2]);
        const double off = off_by(&t, &wet, &without);
        print_message("# beam %d, eos %d: q to %.2g, %.2g without rho''; %d of the skin press\n", i / 2,
                      i % 2, off, without, wet);
        check(off < 1e-5, "%s: q is off by %g of the largest", beams[i / 2], off);
        check(without > 1e-2 && wet > 3, "nothing looks ahead: %g, %d", without, wet);
        tank_free(&t);
    }
}

/* --- power ----------------------------------------------------------------------------- */

static double booked(const struct tank *t)
{
    const struct plan_book *b = &t->plan->book;
    const double *book = t->ydot + tank_at(t, "book", NULL);

    return book[b->work + t->plan->pressure->slot] + book[b->dissipated];
}

/* Power of the fluid's motion, and of its energy by (E1); its size. */
static double of_fluid(const struct tank *t, double *size)
{
    const struct plan *p = t->plan;
    const long u = tank_at(t, "velocity of fluid", NULL), at = tank_at(t, "density of fluid", NULL);
    double sum = 0;

    *size = 0;
    for (int i = 0; i < particles_count(p->particles, KIND_FLUID); i++) {
        const double c = p->scales.c0 / t->y[at + i], m = p->particles->m[i];
        for (int d = 0; d < DIM; d++) {
            const double a = t->ydot[u + i * DIM + d] - p->scales.g[d];
            sum += m * t->y[u + i * DIM + d] * a;
            *size += fabs(m * t->y[u + i * DIM + d] * a);
        }
        sum += m * c * c * (t->y[at + i] - p->scales.rho0) * t->ydot[at + i];
    }
    return sum;
}

/* Rate of what solids store; `filled`: rates of r by solids that move against each other. */
static double of_solids(const struct tank *t, const double *filled)
{
    const struct plan *p = t->plan;
    double *rho = mean_of(t, t->y, true), *rate = mean_of(t, t->ydot, false), sum = 0;
    const double rho0 = p->scales.rho0;

    for (int i = 0; i < self_of(t)->mean.n; i++)
        sum += p->scales.mass * pow(p->scales.c0 / fmax(rho0, rho[i]), 2) * fmax(0, rho[i] - rho0)
               * (rate[i] + filled[i]);
    give_back((double *const[]){ rho, rate }, 2);
    return sum;
}

static double on_skin(const struct tank *t)
{
    const struct particles *all = t->moment->particles;
    const struct moment_body *b = &t->moment->body[0];
    double power = 0;

    for (int j = 0; j < b->skin; j++)
        for (int d = 0; d < DIM; d++)
            power += b->force[j][d] * all->u[all->object[b->object].from + j][d];
    return power;
}

/* Rates of the means of g(o), by differences. */
static double *filled_of(struct tank *t)
{
    const double h = 1e-6;

    test_free(rates_near(t, h));
    double *after = mean_of(t, t->y, true);
    test_free(rates_near(t, -h));
    double *before = mean_of(t, t->y, true);
    tank_rates(t, now, t->y, t->ydot);
    for (int i = 0; i < self_of(t)->mean.n; i++)
        after[i] = (after[i] - before[i]) / (2 * h);
    test_free(before);
    return after;
}

/* To rounding but for g(o), whose rate is by differences. */
static void power_goes_to_water_skin_and_book(void **state)
{
    (void)state;
    for (int i = 0; i < 6; i++) {
        struct tank t;
        double size;
        shaken(&t, beams[i], EOS "residual = 1e-13; };");
        double *filled = filled_of(&t);
        const double skin = on_skin(&t), sum = of_fluid(&t, &size) + of_solids(&t, filled) + skin;
        print_message("# beam %d: power %.12g, booked %.12g, of %g W, skin %g W\n", i, sum, booked(&t),
                      size, skin);
        check(fabs(sum - booked(&t)) < 1e-7 * size, "%s: power %.15g W, booked %.15g", beams[i], sum,
              booked(&t));
        check(fabs(booked(&t)) > 1e-3 * size && fabs(skin) > 1e-3 * size,
              "nothing looks ahead or moves: %g, %g of %g W", booked(&t), skin, size);
        test_free(filled);
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(skins_press_by_the_mean_they_lead_to),
        cmocka_unit_test(power_goes_to_water_skin_and_book),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
