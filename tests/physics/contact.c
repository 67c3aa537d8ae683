/* contact.c -- walls = "contact": the room around solids against a fine quadrature, means that
 * are means, a pressure that is the derivative of what is stored, forces between solids that
 * are the derivative of it, too, and leave out what no water meets; nothing hangs on a dry
 * wall, and water finds its depth. */
#include "tank.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "matter/eos.h"
#include "eval/inside.h"
#include "shapes/shape.h"
#include "walls/contact-press.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CONTACT "walls = \"contact\";"
#define EFFECTS CONTACT "effects = { continuity = { }; pressure = { }; };"

/* A tank with things in it that are round or slanted or near each other, and a box that moves:
 * it starts a spacing and a half above the floor. */
#if DIM == 2
#define THINGS                                                                           \
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"                \
    "domain = { from = [0.0, 0.0]; to = [0.3, 0.16]; };"                                 \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.06, 0.06]; }; };"     \
    "wall = { tank = { type = \"frame\"; };"                                             \
    " disc = { type = \"disc\"; centre = [0.12, 0.12]; radius = 0.021; };"               \
    " slope = { type = \"polygon\"; points = [[0.1, 0.0], [0.16, 0.0], [0.16, 0.037]]; };" \
    " turned = { type = \"box\"; from = [0.24, 0.1]; to = [0.28, 0.14]; angle = 20.0; };"  \
    " thin = { type = \"box\"; from = [0.2, 0.05]; to = [0.215, 0.13]; };"               \
    " lift = { type = \"box\"; from = [0.24, 0.0075]; to = [0.27, 0.0375];"              \
    "  velocity = [0.3, -0.7]; }; };"
#else
#define THINGS                                                                           \
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, -9.81];"           \
    "kernel = { support = 2.5; };"                                                       \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.6, 0.3, 0.4]; };"                        \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.1]; }; };" \
    "wall = { tank = { type = \"frame\"; };"                                             \
    " ball = { type = \"sphere\"; centre = [0.3, 0.15, 0.25]; radius = 0.07; };"         \
    " lift = { type = \"box\"; from = [0.44, 0.1, 0.02]; to = [0.54, 0.2, 0.1];"        \
    "  velocity = [0.3, 0.2, -0.7]; }; };"
#endif

static const struct contact_press_self *self_of(const struct tank *t)
{
    return t->plan->passes.press->self;
}

/* --- places ------------------------------------------------------------------------------ */

/* Is a place open to what is not of the group of this solid? */
static bool is_open(const struct tank *t, bool moves, const double *x)
{
    const struct plan *p = t->plan;
    bool open = true;

    for (int d = 0; d < DIM; d++)
        open = open && x[d] >= p->scales.low[d] && x[d] < p->scales.high[d];
    for (int i = 0; i < p->walls; i++) {
        if (!shape_contains(&p->in.wall[i].set.shape, x))
            continue;
        if (p->wall[i].moves == moves)
            return false;
        open = true;
    }
    return open;
}

/* (K4) */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

/* dx^D sum phi_c W(x_c - x), phi by FINE^D points in each cell. */
static double room_at(const struct tank *t, bool moves, const double *x)
{
    enum { FINE = DIM == 2 ? 80 : 12, REACH = 3, SIDE = 2 * REACH + 1 };
    const double dx = t->plan->scales.dx;
    int cells = 1, points = 1;
    double sum = 0;

    for (int d = 0; d < DIM; d++) {
        cells *= SIDE;
        points *= FINE;
    }
    for (int c = 0; c < cells; c++) {
        const int at[3] = { c % SIDE - REACH, c / SIDE % SIDE - REACH, c / SIDE / SIDE - REACH };
        double r2 = 0, open = 0;
        for (int d = 0; d < DIM; d++)
            r2 += at[d] * at[d] * dx * dx;
        const double w = wendland_c2(sqrt(r2), t->plan->scales.support);
        for (int k = 0; k < points && w > 0; k++) {
            const int of[3] = { k % FINE, k / FINE % FINE, k / FINE / FINE };
            double place[DIM];
            for (int d = 0; d < DIM; d++)
                place[d] = x[d] + (at[d] - 0.5 + (of[d] + 0.5) / FINE) * dx;
            open += is_open(t, moves, place);
        }
        sum += open / points * w * pow(dx, DIM);
    }
    return sum;
}

static void room_is_that_of_a_fine_quadrature(void **state)
{
    const double most = 5e-3; /* corners within a cell may be missed */
    double off = 0, far = 0;
    struct tank t;

    (void)state;
    tank_make(&t, THINGS, EFFECTS, NULL);
    const struct particles *p = plan_particles(t.plan);
    const struct contact_press_self *c = self_of(&t);
    for (int i = 0; i < c->mean.n; i += DIM == 2 ? 3 : 41) {
        const int id = p->from[KIND_WALL] + c->mean.solid[i];
        const bool moves = strcmp(p->object[p->object_of[id]].name, "lift") == 0;
        const double s = room_at(&t, moves, p->x0[id]);
        off = fmax(off, fabs(c->others.room[i] / t.plan->scales.rho0 - s));
        far = fmax(far, s);
    }
    print_message("# rooms of up to %.3f of the kernel are off by %.2g at most\n", far, off);
    check(off < most && far > 0.3, "rooms off by %g of the kernel, at most %g", off, far);
    tank_free(&t);
}

/* The weight of j in the row of i, and in how many entries it stands. */
static double weight_of(const struct contact_mean *m, int i, int j, int *entries)
{
    double weight = 0;

    *entries = 0;
    for (long e = 0; e < contact_mean_length(m, i / CONTACT_ROWS); e++) {
        const long at = contact_mean_at(m, i, e);
        if (m->column[at] == j && m->weight[at] > 0) {
            weight = m->weight[at];
            ++*entries;
        }
    }
    return weight;
}

static void means_are_means_and_symmetric(void **state)
{
    struct tank t;
    long pairs = 0;

    (void)state;
    tank_make(&t, THINGS, EFFECTS, NULL);
    const struct contact_mean *m = &self_of(&t)->mean;
    double *one = test_calloc(m->n, sizeof *one);
    for (int i = 0; i < m->n; i++)
        one[i] = 1;
    for (int i = 0; i < m->n; i++) {
        double sum[CONTACT_ROWS];
        contact_mean_sums(m, i / CONTACT_ROWS, one, sum);
        sum[0] = sum[i % CONTACT_ROWS] * m->inverse[i];
        check(fabs(sum[0] - 1) < 1e-14, "weights of row %d add up to %.17g", i, sum[0]);
        for (long e = 0; e < contact_mean_length(m, i / CONTACT_ROWS); e++) {
            const long at = contact_mean_at(m, i, e);
            int entries;
            if (!(m->weight[at] > 0))
                continue;
            const double back = weight_of(m, m->column[at], i, &entries);
            check(back == m->weight[at], "weights %g and %g of a pair", back, m->weight[at]);
            check(entries == 1, "%d weights of a pair", entries);
            pairs++;
        }
    }
    check(pairs == m->entries, "%ld of %ld weights have a partner", pairs, m->entries);
    print_message("# %d particles, %.1f weights each, %.0f bytes each, %.1f %% of them filling\n",
                  m->n, (double)m->entries / m->n, contact_mean_memory(m) / m->n,
                  100 - 100.0 * m->entries / m->start[m->slices]);
    test_free(one);
    tank_free(&t);
}

/* --- what is stored -------------------------------------------------------------------------- */

/* Of all solids [J]. */
static double stored(struct tank *t, double time, const double *y)
{
    const struct contact_press_self *c = self_of(t);
    struct view v;
    double sum = 0;

    observe_view(t->moment, time, y, &v);
    for (int k = KIND_WALL; k < KINDS; k++)
        for (int i = 0; i < particles_count(v.p, k); i++)
            sum += v.p->m[v.p->from[k] + i] * eos_energy(&c->eos, v.rho[k][i]);
    return sum;
}

/* q of all solids, by row; to be freed. */
static double *pushes(const struct tank *t)
{
    const struct plan_part *wall = t->plan->passes.press;
    struct view v;

    moment_view(t->moment, 0, t->y, &v);
    const int first = v.p->from[KIND_WALL], n = v.p->n - first;
    double *rho = test_calloc((size_t)n, sizeof *rho), *shown = test_calloc((size_t)n, sizeof *shown);
    double *q = test_calloc((size_t)n, sizeof *q);
    for (int k = KIND_WALL; k < KINDS; k++)
        for (int i = 0; i < particles_count(v.p, k); i++)
            rho[v.p->from[k] - first + i] = v.rho[k][i];
    wall->part->as.wall->press->press(wall->self, t->moment->work->press, v.p,
                                      &(struct part_pressed){ .rho = rho, .shown = shown, .p2 = q,
                                                              .which = PART_SOLIDS_ALL });
    test_free(rho);
    test_free(shown);
    return q;
}

/* q_w m_w = dE/d rho_w, one by one: of one in so many solids. */
static void check_slopes(struct tank *t, int every, const char *what)
{
    const struct particles *p = t->moment->particles;
    double off = 0, most = 0, *all;

    tank_shake(t, 5, 0.2, 0.5, 0.01);
    all = pushes(t);
    for (int k = KIND_WALL; k < KINDS; k++) {
        const int n = particles_count(p, k);
        double *y = n > 0 ? t->y + layout_at(plan_layout(t->plan), t->plan->row.density[k]) : NULL;
        for (int i = 0; i < n; i += every) {
            const double was = y[i], h = 1e-3 * 1e-3 * plan_scales(t->plan)->rho0;
            const double q = all[p->from[k] - p->from[KIND_WALL] + i] * p->m[p->from[k] + i];
            y[i] = was + h;
            double slope = stored(t, 0, t->y);
            y[i] = was - h;
            slope = (slope - stored(t, 0, t->y)) / (2 * h);
            y[i] = was;
            off = fmax(off, fabs(slope - q));
            most = fmax(most, q);
        }
    }
    check(most > 0 && off < 2e-5 * most, "%s: q m is off by %g of %g J m^D/kg", what, off, most);
    test_free(all);
    tank_free(t);
}

static void pressure_is_the_slope_of_what_is_stored(void **state)
{
    const char *const waters[] = { tank_water, tank_parted_water };
    const char *const beams[] = { "", tank_beam };
    struct tank t;

    (void)state;
    for (int beam = 0; beam < (DIM == 2 ? 2 : 1); beam++) {
        tank_make(&t, waters[beam], tank_frame, beams[beam], EFFECTS, NULL);
        check_slopes(&t, 7, beams[beam]);
    }
}

/* With every kernel that weighs densities: what is open is measured with it, and
 * before a face it is less than half. */
static void every_kernel_weighs_the_room(void **state)
{
    const struct kernel *const *kernels = engine_pick()->kernels;

    (void)state;
    for (int i = 0; kernels[i]; i++) {
        char text[256];
        struct tank t;
        snprintf(text, sizeof text, "kernel = { support = 2.5; density = \"%s\"; };" EFFECTS,
                 kernels[i]->name);
        tank_make(&t, tank_bare_water, tank_frame, text, NULL);
        const struct contact_press_self *c = self_of(&t);
        double least = HUGE_VAL, most = 0;
        for (int k = 0; k < c->mean.n; k++) {
            least = fmin(least, c->others.room[k] / t.plan->scales.rho0);
            most = fmax(most, c->others.room[k] / t.plan->scales.rho0);
        }
        print_message("# %s: rooms from %.2g to %.3f of the kernel\n", kernels[i]->name, least,
                      most);
        check(least > 0 && most > 0.05 && most < 0.5, "%s: rooms from %g to %g", kernels[i]->name,
              least, most);
        check_slopes(&t, 41, kernels[i]->name);
    }
}

/* What moves against other solids gives them what they store: dE/dt = -F.v of the lift, where
 * no water is. */
static void solids_push_each_other_by_what_they_store(void **state)
{
    const double h = 1e-7, time = 2e-3, v[3] = { 0.3, DIM == 2 ? -0.7 : 0.2, -0.7 };
    double power = 0, sum[DIM] = { 0 };
    struct tank t;

    (void)state;
    tank_make(&t, THINGS, EFFECTS, NULL);
    const struct particles *p = plan_particles(t.plan);
    for (int k = 0; k < particles_count(p, KIND_WALL); k++) /* so that there is something */
        t.y[layout_at(plan_layout(t.plan), t.plan->row.density[KIND_WALL]) + k] += 350;
    assert_int_equal(observe_forces(t.moment, time, t.y), STATUS_DONE);
    for (int o = 0; o < p->objects; o++)
        for (int d = 0; d < DIM; d++) {
            const double f = observe_force(t.moment, o)[d];
            power += strcmp(p->object[o].name, "lift") == 0 ? f * v[d] : 0;
            if (strcmp(p->object[o].name, "lift") == 0)
                sum[d] = f;
        }
    const double slope = (stored(&t, time + h, t.y) - stored(&t, time - h, t.y)) / (2 * h);
    check(fabs(power) > 1, "the lift is pushed by %g W only", power);
    check(fabs(slope + power) < 1e-6 * fabs(power), "%g W stored, %g W given (%g N, %g N)", slope,
          -power, sum[0], sum[DIM - 1]);
    tank_free(&t);
}

/* --- what forces ask for ------------------------------------------------------------------- */

/* Has the solid at x fluid in reach of the kernel? */
static bool is_met(const struct view *v, const struct scales *s, const double *x)
{
    for (int i = 0; i < particles_count(v->p, KIND_FLUID); i++) {
        double r2 = 0;
        for (int d = 0; d < DIM; d++)
            r2 += pow(v->x[KIND_FLUID][(size_t)i * DIM + d] - x[d], 2);
        if (r2 < s->support * s->support)
            return true;
    }
    return false;
}

/* Right-hand sides leave out solids that are far from water, and those only; the others press
 * as if nothing had been left out, to the bit. */
static void forces_ask_for_solids_that_water_meets(void **state)
{
    struct tank t;
    struct view v;
    int met = 0, left = 0;

    (void)state;
    tank_make(&t, THINGS, EFFECTS, NULL);
    const struct particles *p = plan_particles(t.plan);
    const int n = p->n - p->from[KIND_WALL];
    double *ydot = test_calloc((size_t)plan_size(t.plan), sizeof *ydot);
    double *near = test_calloc((size_t)n, sizeof *near);
    assert_int_equal(moment_eval(t.moment, ASK_ALL, 0, t.y, ydot), STATUS_DONE);
    memcpy(near, t.moment->work->p2, (size_t)n * sizeof *near);
    double *all = pushes(&t);
    moment_view(t.moment, 0, t.y, &v);
    for (int i = 0; i < n; i++) {
        const double q = all[i];
        const bool wet = is_met(&v, plan_scales(t.plan), v.x[KIND_WALL] + (size_t)i * DIM);
        check(near[i] == q || (near[i] == 0 && !wet), "solid %d presses with %.17g, not %.17g", i,
              near[i], q);
        met += wet && q > 0;
        left += near[i] == 0 && q > 0;
    }
    print_message("# %d solids of %d are met, %d are left out\n", met, n, left);
    check(met > 0 && left > n / 10, "%d met, %d left out", met, left);
    test_free(ydot);
    test_free(near);
    test_free(all);
    tank_free(&t);
}

/* --- water ------------------------------------------------------------------------------------- */

/* A dry wall does not press, and no solid ever pulls. */
static void dry_walls_do_not_press(void **state)
{
    struct tank t;
    struct view v;
    double most = 0;

    (void)state;
    tank_make(&t, THINGS, EFFECTS, NULL);
    const struct scales *s = plan_scales(t.plan);
    double *all = pushes(&t);
    moment_view(t.moment, 0, t.y, &v);
    for (int i = 0; i < particles_count(v.p, KIND_WALL); i++) {
        const double *x = v.x[KIND_WALL] + (size_t)i * DIM, q = all[i];
        check(q >= 0, "wall particle %d pulls: %g", i, q);
        if (strcmp(v.p->object[v.p->object_of[v.p->from[KIND_WALL] + i]].name, "lift")
            && x[0] > s->low[0] + 0.1 * DIM + 2 * s->support && x[0] < s->high[0] - s->support
            && x[DIM - 1] > s->high[DIM - 1] - 0.05 * DIM)
            most = fmax(most, q);
    }
    check(most < 1e-6 * s->c0 * s->c0 / s->rho0, "dry walls press with %g c0^2/rho0",
          most * s->rho0 / s->c0 / s->c0);
    test_free(all);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(room_is_that_of_a_fine_quadrature),
        cmocka_unit_test(means_are_means_and_symmetric),
        cmocka_unit_test(pressure_is_the_slope_of_what_is_stored),
        cmocka_unit_test(every_kernel_weighs_the_room),
        cmocka_unit_test(solids_push_each_other_by_what_they_store),
        cmocka_unit_test(forces_ask_for_solids_that_water_meets),
        cmocka_unit_test(dry_walls_do_not_press),
    };

    return cmocka_run_group_tests_name("contact", tests, NULL, NULL);
}
