/* turned.c -- nature knows no axes: a scene turned by 90 degrees, or seen in a
 * mirror, has the same rates and goes the same way, beam included. */
#include "tank.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TURNED_EFFECTS                                                                   \
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.1; };"  \
    " laminar-viscosity = { mu = 0.7; }; density-diffusion = { delta = 0.1; }; };"

/* A turn: x goes to sign * x of another axis; all scenes lie about the origin. */
struct turn {
    const char *name;
    int axis[DIM];  /* new component d is sign[d] * old component axis[d] */
    int sign[DIM];
    double deflection; /* sign of a beam's deflection in the turned scene */
    double angle;      /* of the turned beam [deg]                        */
};

static const struct turn turns[] = {
#if DIM == 2
    { "quarter turn", { 1, 0 }, { -1, 1 }, 1, 180 },
    { "mirror", { 0, 1 }, { -1, 1 }, -1, 90 },
    { "diagonal mirror", { 1, 0 }, { 1, 1 }, -1, 0 },
#else
    { "quarter turn", { 1, 0, 2 }, { -1, 1, 1 }, 1, 0 },
    { "mirror", { 0, 1, 2 }, { 1, -1, 1 }, 1, 0 },
    { "axes in turn", { 2, 0, 1 }, { 1, 1, 1 }, 1, 0 },
#endif
};
static const struct turn none = {
#if DIM == 2
    "none", { 0, 1 }, { 1, 1 }, 1, 90
#else
    "none", { 0, 1, 2 }, { 1, 1, 1 }, 1, 0
#endif
};
enum { TURNS = sizeof turns / sizeof turns[0] };

static void turn_vector(const struct turn *turn, const double *from, double *to)
{
    for (int d = 0; d < DIM; d++)
        to[d] = turn->sign[d] * from[turn->axis[d]];
}

/* "[a, b]" with every digit; call by call into the next of four buffers. */
static const char *vector(const struct turn *turn, const double *v)
{
    static char text[4][120];
    static int next;
    char *to = text[next++ % 4];
    double x[DIM];
    int n = 0;

    turn_vector(turn, v, x);
    for (int d = 0; d < DIM; d++)
        n += snprintf(to + n, 120 - n, "%s%.17g", d ? ", " : "[", x[d]);
    snprintf(to + n, 120 - n, "]");
    return to;
}

/* NAME = { ... from = [..]; to = [..]; } of the turned box. */
static void box(const struct turn *turn, const char *head, const double *low, const double *high,
                char *text, size_t size)
{
    double a[DIM], b[DIM], from[DIM], to[DIM];
    const size_t n = strlen(text);

    turn_vector(turn, low, a);
    turn_vector(turn, high, b);
    for (int d = 0; d < DIM; d++) {
        from[d] = fmin(a[d], b[d]);
        to[d] = fmax(a[d], b[d]);
    }
    snprintf(text + n, size - n, "%s from = %s; to = %s; };", head, vector(&none, from),
             vector(&none, to));
}

/* Lengths are powers of two times the spacing, so that places round alike. */
static void make(struct tank *t, const struct turn *turn)
{
    const double dx = DIM == 2 ? 0.0078125 : 0.03125; /* 1/128, 1/32 m */
    const double far = DIM == 2 ? 8 * dx : 4 * dx;
    const double low[3] = { -far, -far, -far }, high[3] = { far, far, far };
    const double top[3] = { 0, far / 2, far };
    const double g[3] = { 1.5, DIM == 2 ? -9.75 : 0.5, -9.75 }, root[2] = { 2.5 * dx, -far };
    char text[2000];

    snprintf(text, sizeof text, "dimension = %d; until = 1.0; spacing = %.17g; gravity = %s;"
             "eos = { c0 = 16.0; }; kernel = { support = 2.5; };", DIM, dx, vector(turn, g));
    box(turn, "domain = {", low, high, text, sizeof text);
    box(turn, "fluid = { water = { type = \"box\"; initial = \"rest\";", low, top, text,
        sizeof text);
    strcat(text, "};");
    if (DIM == 2)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 "beam = { plate = { at = %s; angle = %g; length = 0.0625; thickness = 4e-3;"
                 " E = 2e6; density = 1200.0; elements = 2; layers = 3; alpha = 3.0;"
                 " beta = 1e-4; }; };", vector(turn, root), turn->angle);
    tank_make(t, text, tank_frame, TURNED_EFFECTS, NULL);
}

/* For each particle of a its image in b. */
static int *pair_up(const struct tank *a, const struct tank *b, const struct turn *turn)
{
    const struct particles *p = plan_particles(a->plan), *q = plan_particles(b->plan);
    int *image = test_malloc(p->n * sizeof *image);

    check(p->n == q->n, "%d particles here, %d there", p->n, q->n);
    for (int i = 0; i < p->n; i++) {
        double x[DIM];
        turn_vector(turn, p->x0[i], x);
        image[i] = -1;
        for (int j = 0; j < q->n; j++) {
            double off = 0;
            for (int d = 0; d < DIM; d++)
                off = fmax(off, fabs(q->x0[j][d] - x[d]));
            if (off < 1e-12)
                image[i] = j;
        }
        check(image[i] >= 0, "%s: particle %d has no image", turn->name, i);
    }
    return image;
}

/* One row of a state or of its rates, turned. */
static void turn_row(const struct tank *a, const struct turn *turn, const int *image,
                     const struct layout_row *r, const double *from, double *to)
{
    const struct particles *p = plan_particles(a->plan);
    int kind = KIND_FLUID;

    if (strcmp(r->name, "book") == 0)
        return;
    if (strncmp(r->name, "beam.", 5) == 0) {
        for (int i = 0; i < r->n; i++)
            to[r->offset + i] = turn->deflection * from[r->offset + i];
        return;
    }
    if (strstr(r->name, "of walls"))
        kind = KIND_WALL;
    if (strstr(r->name, "of skins"))
        kind = KIND_SKIN;
    for (int i = 0; i < r->n; i++) {
        const int j = image[p->from[kind] + i] - p->from[kind];
        if (r->components == DIM)
            turn_vector(turn, from + r->offset + i * DIM, to + r->offset + j * DIM);
        else
            to[r->offset + j] = from[r->offset + i];
    }
}

static void turn_state(const struct tank *a, const struct turn *turn, const int *image,
                       const double *from, double *to)
{
    const struct layout *l = plan_layout(a->plan);

    for (int i = 0; i < l->rows; i++)
        turn_row(a, turn, image, &l->row[i], from, to);
}

/* Largest difference of the rows of that name, and in *size their largest entry. */
static double difference(const struct layout_row *r, const double *a, const double *b,
                         double *size)
{
    double off = 0;

    *size = 0;
    for (long i = r->offset; i < r->offset + (long)r->n * r->components; i++) {
        off = fmax(off, fabs(a[i] - b[i]));
        *size = fmax(*size, fabs(a[i]));
    }
    return off;
}

static void compare(struct tank *a, struct tank *b, const struct turn *turn, const int *image)
{
    const struct layout *l = plan_layout(a->plan);
    double *turned = test_calloc(a->n, sizeof *turned);

    tank_rates(a, 0, a->y, a->ydot);
    tank_rates(b, 0, b->y, b->ydot);
    turn_state(a, turn, image, a->ydot, turned);
    for (int i = 0; i < l->rows; i++) {
        double size, off = difference(&l->row[i], turned, b->ydot, &size);
        check(strcmp(l->row[i].name, "book") == 0 || (size > 0 && off <= 1e-11 * size),
              "%s: rates of %s differ by %g of %g", turn->name, l->row[i].name, off, size);
    }
    test_free(turned);
}

static void rates_turn_with_the_scene(void **state)
{

    (void)state;
    for (int i = 0; i < TURNS; i++)
        for (unsigned seed = 1; seed <= 3; seed++) {
            struct tank a, b;
            int *image;
            make(&a, &none);
            make(&b, &turns[i]);
            image = pair_up(&a, &b, &turns[i]);
            tank_shake(&a, seed, 0.2, 1.0, 0.02);
            turn_state(&a, &turns[i], image, a.y, b.y);
            compare(&a, &b, &turns[i], image);
            test_free(image);
            tank_free(&a);
            tank_free(&b);
        }
}

/* The classical Runge-Kutta method; y is replaced. */
static void march(struct tank *t, double until, int steps)
{
    const double h = until / steps, weight[4] = { h / 6, h / 3, h / 3, h / 6 };
    const double reach[4] = { 0, h / 2, h / 2, h };
    double *k = test_calloc(t->n, sizeof *k), *stage = tank_copy(t, t->y);
    double *sum = tank_copy(t, t->y);

    for (int i = 0; i < steps; i++) {
        for (int s = 0; s < 4; s++) {
            for (long j = 0; j < t->n; j++)
                stage[j] = t->y[j] + reach[s] * k[j];
            tank_rates(t, i * h + reach[s], stage, k);
            for (long j = 0; j < t->n; j++)
                sum[j] += weight[s] * k[j];
        }
        memcpy(t->y, sum, t->n * sizeof *sum);
    }
    test_free(k);
    test_free(stage);
    test_free(sum);
}

/* a has gone its way: does its image go there too? */
static void follow(const struct tank *a, const struct turn *turn, double until, int steps)
{
    const double dx = plan_scales(a->plan)->dx;
    double *turned = test_calloc(a->n, sizeof *turned), size, off;
    const struct layout_row *r;
    struct tank b;
    int *image;

    make(&b, turn);
    image = pair_up(a, &b, turn);
    march(&b, until, steps);
    turn_state(a, turn, image, a->y, turned);
    tank_at(a, "position of fluid", &r);
    off = difference(r, turned, b.y, &size);
    check(off <= 1e-9 * dx, "%s: after %g s positions differ by %g dx", turn->name, until,
          off / dx);
    print_message("# %s: %.2g dx after %g s, %ld rebuilds\n", turn->name, off / dx, until,
                  moment_counts(a->moment)->rebuilds);
    test_free(image);
    test_free(turned);
    tank_free(&b);
}

/* A fall from rest: rounding is all that may tell the scenes apart. */
static void run_turns_with_the_scene(void **state)
{
    const double until = DIM == 2 ? 0.1 : 0.06;
    const int steps = DIM == 2 ? 200 : 24;
    struct tank a;

    (void)state;
    make(&a, &none);
    march(&a, until, steps);
    for (int i = 0; i < TURNS; i++)
        follow(&a, &turns[i], until, steps);
    tank_free(&a);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_turn_with_the_scene),
        cmocka_unit_test(run_turns_with_the_scene),
    };

    return cmocka_run_group_tests_name("turned", tests, NULL, NULL);
}
