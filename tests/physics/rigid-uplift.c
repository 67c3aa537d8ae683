/* rigid-uplift.c -- pressures at the edges of a box and what they do to its faces in narrow gaps,
 * against closed forms; forces on both solids, their moments and what they give. */
#include "bodies/contacts-uplift.h"
#include "state/scales.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { UP = DIM - 1, N = 10, BOTTOM = 2 * UP, MOST = 1000, SPINS = TURNING_SPINS };

static const double dx = 0.01, half = 0.5 * N * 0.01, ball = 0.005;

static void near(double found, double expected, double tolerance)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("found %.12g, expected %.12g within %g", found, expected, tolerance);
}

/* --- a box with a skin of one layer -------------------------------------------------- */

static double place(int cell)
{
    return (cell + 0.5) * dx - half;
}

static int skin(const struct body *b, double (*x)[DIM], enum kind *kind)
{
    int n = 0;

    (void)b;
    for (int i = 0; i < (DIM == 2 ? N * N : N * N * N); i++) {
        bool outside = false;
        for (int d = 0, rest = i; d < DIM; d++, rest /= N) {
            const int at = rest % N;
            x[n][d] = place(at);
            outside |= at == 0 || at == N - 1;
        }
        n += outside;
    }
    *kind = KIND_SKIN;
    return n;
}

static const struct body_kind fake = { .skin = skin };

struct set {
    struct solid box, floor;
    struct solid_place at, ground;
    struct scales scales;
    struct contacts_body body;
    struct contacts_uplift *uplift;
    struct uplift_faces faces;
    double (*arm)[DIM];
    double (*force)[DIM];
};

static void square_up(struct solid *s)
{
    for (int d = 0; d < DIM; d++)
        s->start.R[d][d] = 1;
    s->core.ball = ball;
}

/* The box stands `gap` above the floor, a block twice as wide. */
static void begin(struct set *t, double gap)
{
    enum kind kind;

    *t = (struct set){ .scales = { .dx = dx, .rho0 = 1000 }, .body = { .kind = &fake } };
    t->arm = calloc(MOST, sizeof *t->arm);
    t->force = calloc(MOST, sizeof *t->force);
    assert_non_null(t->arm);
    assert_non_null(t->force);
    t->body.points = skin(NULL, t->arm, &kind);
    square_up(&t->box);
    square_up(&t->floor);
    t->box.mass = t->floor.mass = 1;
    for (int d = 0; d < DIM; d++) {
        t->box.core.half[d] = half - ball;
        t->floor.core.half[d] = 2 * half - ball;
    }
    t->at = t->box.start;
    t->ground = t->floor.start;
    t->ground.x[UP] = -3 * half - gap;
    assert_int_equal(contacts_uplift_create(&t->box, &t->body, &t->scales, &t->uplift), 0);
}

static void end(struct set *t)
{
    contacts_uplift_free(&t->uplift);
    free(t->arm);
    free(t->force);
}

/* A pressure on one side of the box, along d, as it may depend on height. */
static void press(struct set *t, int d, bool high, double (*p)(double up))
{
    for (int i = 0; i < t->body.points; i++) {
        const double side = (high ? 1 : -1) * t->arm[i][d];
        if (side > half - dx)
            t->force[i][d] -= (high ? 1 : -1) * p(t->arm[i][UP]) * pow(dx, DIM - 1);
    }
}

static void push(struct set *t, struct body_push *box, struct body_push *ground, double *power)
{
    struct contacts_guest g;
    double apart[DIM];

    for (int d = 0; d < DIM; d++)
        apart[d] = t->at.x[d] - t->ground.x[d];
    contacts_guest_make(&g, &t->box, &t->at, &t->floor, &t->ground, apart);
    contacts_uplift_read(t->uplift, &t->at, (const double (*)[DIM])t->force, &t->faces);
    contacts_uplift_close(t->uplift, &g, &t->faces);
    memset(box, 0, sizeof *box);
    memset(ground, 0, sizeof *ground);
    *power = 0;
    contacts_uplift_push(t->uplift, &g, &t->faces, box, ground, power);
}

static const double area = DIM == 2 ? 2 * 0.05 : 4 * 0.05 * 0.05;

static double even(double up)
{
    (void)up;
    return 700;
}

static double deep(double up)
{
    return 1000 * 9.81 * (0.2 - up);
}

static double twice(double up)
{
    (void)up;
    return 1400;
}

static void all_round(struct set *t, double (*p)(double))
{
    for (int d = 0; d < UP; d++)
        for (int high = 0; high < 2; high++)
            press(t, d, high, p);
}

/* --- closed forms -------------------------------------------------------------------- */

static void an_even_pressure_acts_on_the_whole_face(void **state)
{
    struct set t;
    struct body_push box, ground;
    double power;

    (void)state;
    begin(&t, 0.2 * dx);
    all_round(&t, even);
    push(&t, &box, &ground, &power);
    near(box.force[UP], 700 * area, 1e-9);
    for (int i = 0; i < SPINS; i++)
        near(box.moment[i], 0, 1e-9);
    end(&t);
}

/* Below the middle of the two rows at an edge there is a spacing more of water. */
static void weight_takes_the_pressure_to_the_gap(void **state)
{
    struct set t;
    struct body_push box, ground;
    double power;

    (void)state;
    begin(&t, 0.2 * dx);
    t.scales.g[UP] = -9.81;
    contacts_uplift_free(&t.uplift);
    assert_int_equal(contacts_uplift_create(&t.box, &t.body, &t.scales, &t.uplift), 0);
    all_round(&t, deep);
    push(&t, &box, &ground, &power);
    near(box.force[UP], deep(-half) * area, 1e-9);
    end(&t);
}

/* p and 2 p at two edges across: 3/2 p in the mean, and their moment, that of a linear pressure, in
 * space of half its slope, as the other two edges are as far away. */
static void a_slope_of_pressure_turns_the_box(void **state)
{
    struct set t;
    struct body_push box, ground;
    const double slope = 700 / (2 * half) * (DIM == 2 ? 1 : 0.5);
    double power, sum = 0;

    (void)state;
    begin(&t, 0.2 * dx);
    press(&t, 0, false, even);
    press(&t, 0, true, twice);
    if (DIM == 3) {
        press(&t, 1, false, even);
        press(&t, 1, true, even);
        press(&t, 1, false, even);
        press(&t, 1, true, even);
    }
    for (int i = 0; i < N; i++)
        sum += slope * place(i) * place(i) * area / N;
    push(&t, &box, &ground, &power);
    near(box.force[UP], (DIM == 2 ? 1.5 : 1.75) * 700 * area, 1e-9);
    near(box.moment[DIM == 2 ? 0 : 1], DIM == 2 ? sum : -sum, 1e-9);
    end(&t);
}

static void wide_gaps_are_left_to_particles(void **state)
{
    const double gap[] = { 0.4, 1.0, 1.6 }, expected[] = { 1, 0.5, 0 };
    struct body_push box, ground;
    double power;

    (void)state;
    for (int i = 0; i < 3; i++) {
        struct set t;
        begin(&t, gap[i] * dx);
        all_round(&t, even);
        push(&t, &box, &ground, &power);
        near(box.force[UP], expected[i] * 700 * area, 1e-9);
        end(&t);
    }
}

/* A side at another solid has no water, and no say. */
static void closed_sides_have_no_say(void **state)
{
    struct set t;
    struct body_push box, ground;
    struct contacts_guest g;
    double power = 0, apart[DIM] = { 0 };

    (void)state;
    begin(&t, 0.2 * dx);
    press(&t, 0, true, even);
    memset(&box, 0, sizeof box);
    memset(&ground, 0, sizeof ground);
    contacts_uplift_read(t.uplift, &t.at, (const double (*)[DIM])t.force, &t.faces);
    for (int k = 0; k < (DIM == 2 ? 1 : 3); k++) /* all but the high side of x */
        t.faces.closed[k == 0 ? 0 : k + 1] = 1;
    apart[UP] = -t.ground.x[UP];
    contacts_guest_make(&g, &t.box, &t.at, &t.floor, &t.ground, apart);
    contacts_uplift_push(t.uplift, &g, &t.faces, &box, &ground, &power);
    near(box.force[UP], 700 * area, 1e-6);
    end(&t);
}

/* --- two bodies that move and turn --------------------------------------------------- */

static double given(const struct body_push *p, const struct solid_place *at)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += p->force[d] * at->v[d];
    for (int i = 0; i < SPINS; i++)
        sum += p->moment[i] * at->spin[i];
    return sum;
}

static void tilt(struct solid_place *at, double angle)
{
    at->R[0][0] = at->R[UP][UP] = cos(angle);
    at->R[0][UP] = -sin(angle);
    at->R[UP][0] = sin(angle);
}

/* What the moments are about the origin: force and moment of both cancel. */
static void both_feel_the_same(void **state)
{
    struct set t;
    struct body_push box, ground;
    double power, total[SPINS] = { 0 };

    (void)state;
    begin(&t, 0.3 * dx);
    press(&t, 0, false, even);
    press(&t, 0, true, twice);
    tilt(&t.at, 0.05);
    tilt(&t.ground, -0.03);
    for (int d = 0; d < DIM; d++) {
        t.at.v[d] = 0.3 - 0.7 * d;
        t.ground.v[d] = 0.2 * d - 0.1;
    }
    for (int i = 0; i < SPINS; i++) {
        t.at.spin[i] = 1.5 - i;
        t.ground.spin[i] = 0.4 * i - 2;
    }
    push(&t, &box, &ground, &power);
    assert_true(fabs(box.force[UP]) > 100 * area);
    for (int d = 0; d < DIM; d++)
        near(box.force[d] + ground.force[d], 0, 1e-9);
    near(power, given(&box, &t.at) + given(&ground, &t.ground), 1e-9);
    for (int b = 0; b < 2; b++) {
        const struct solid_place *at = b ? &t.ground : &t.at;
        const struct body_push *p = b ? &ground : &box;
        double about[SPINS] = { 0 }, own[DIM] = { 0 }, turned[DIM];
        turning_moment(at->x, p->force, about);
        for (int i = 0; i < SPINS && DIM == 3; i++)
            own[i % DIM] = p->moment[i];
        solid_space(at, own, turned);
        for (int i = 0; i < SPINS; i++)
            total[i] += about[i] + (DIM == 3 ? turned[i % DIM] : p->moment[i]);
    }
    for (int i = 0; i < SPINS; i++)
        near(total[i], 0, 1e-9);
    end(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_even_pressure_acts_on_the_whole_face),
        cmocka_unit_test(weight_takes_the_pressure_to_the_gap),
        cmocka_unit_test(a_slope_of_pressure_turns_the_box),
        cmocka_unit_test(wide_gaps_are_left_to_particles),
        cmocka_unit_test(closed_sides_have_no_say),
        cmocka_unit_test(both_feel_the_same),
    };

    return cmocka_run_group_tests_name("rigid-uplift", tests, NULL, NULL);
}
