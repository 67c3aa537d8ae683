/* summed.c -- tests of number-density.c, the summed field of doc/adding-a-part.md. */
#include "added.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

#define NUMBER "effects = { number-density = { }; pressure = { }; };"

static void it_is_listed_and_explained(void **state)
{
    (void)state;
    added_is_told(ADDED_EFFECTS, "number-density");
}

static void absent_it_costs_nothing(void **state)
{
    (void)state;
    added_costs_nothing("number-density");
}

/* m_a sum_b W(r), images of a periodic box among the b, typed anew. */
static double number_density(const struct view *v, int a)
{
    const struct scales *s = v->p->scales;
    const double H = s->support, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);
    double sum = 0;

    for (int b = 0; b < particles_count(v->p, KIND_FLUID); b++) {
        double r2 = 0;
        for (int d = 0; d < DIM; d++) {
            const double x = v->x[KIND_FLUID][a * DIM + d] - v->x[KIND_FLUID][b * DIM + d];
            r2 += pow(x - s->period[d] * round(x / s->period[d]), 2);
        }
        const double q = sqrt(r2) / H;
        if (q < 1)
            sum += sigma / pow(H, DIM) * pow(1 - q, 4) * (1 + 4 * q);
    }
    return v->p->m[a] * sum;
}

static void check_all(struct tank *t)
{
    struct view v;

    observe_view(t->moment, 0, t->y, &v);
    for (int a = 0; a < particles_count(v.p, KIND_FLUID); a++) {
        const double expected = number_density(&v, a), found = v.rho[KIND_FLUID][a];
        check(fabs(found / expected - 1) < 1e-12, "particle %d: %.17g, not %.17g", a, found,
              expected);
    }
}

/* On the lattice it is that of water, within the error of the sum; everywhere it is the sum. */
static void check_density(void)
{
    struct tank t;
    struct view v;

    tank_make(&t, added_lattice, NUMBER, NULL);
    check_all(&t);
    observe_view(t.moment, 0, t.y, &v);
    check(fabs(v.rho[KIND_FLUID][7] / v.p->scales->rho0 - 1) < 0.01, "lattice: %g",
          v.rho[KIND_FLUID][7]);
    tank_shake(&t, 3, 0.3, 1, 0);
    tank_rates(&t, 0, t.y, t.ydot);
    check_all(&t);
    tank_free(&t);
}

static void it_is_the_sum_over_neighbours(void **state)
{
    (void)state;
    added_at_all_widths(check_density);
}

static void check_refused(const char *water, const char *effects, const char *why)
{
    char text[2048] = "";
    struct tank t;

    strcat(strcat(text, water), effects);
    assert_int_equal(tank_try(&t, text), STATUS_BAD_SCENE);
    check(strstr(status_message(), why), "refused, but: %s", status_message());
    tank_free(&t);
}

/* What it stands for may not be there, nor another density; and no wall model knows it. */
static void what_does_not_go_together_is_refused(void **state)
{
    (void)state;
    check_refused(added_lattice, "effects = { continuity = { }; number-density = { }; };",
                  "stands for");
    check_refused(added_lattice, "effects = { summation = { }; number-density = { }; };",
                  "both give the fluid its density");
    check_refused(tank_water, "wall = { tank = { type = \"frame\"; }; };" NUMBER,
                  "does not go with effects.number-density");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_listed_and_explained),
        cmocka_unit_test(absent_it_costs_nothing),
        cmocka_unit_test(it_is_the_sum_over_neighbours),
        cmocka_unit_test(what_does_not_go_together_is_refused),
    };

    return cmocka_run_group_tests_name("summed", tests, NULL, NULL);
}
