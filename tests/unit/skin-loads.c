/* skin-loads.c -- tests of src/bodies/beam-skin and follower-skin: what the nodes of a beam
 * get is the force and the moment that act on its skin, also of each point alone. */
#include "bodies/beam-skin.h"
#include "bodies/elastica.h"
#include "bodies/follower-skin.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

enum { ELEMENTS = 7, NODES = ELEMENTS + 1, LAYERS = 3, POINTS = 63 };
#define LENGTH 0.21  /* [m] */
#define SPACING 0.01

static const struct skin_def def = { .at = { 0.3, 0.1 }, .along = { 0.8, 0.6 },
                                     .normal = { -0.6, 0.8 }, .length = LENGTH,
                                     .spacing = SPACING, .elements = ELEMENTS,
                                     .layers = LAYERS };

struct push {
    double along, across; /* [N/m] */
    double moment;        /* about the root [N] */
};

/* -1 to 1 */
static double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 2147483648.0 - 1;
}

static double part(const double *v, const double *direction)
{
    return v[0] * direction[0] + v[1] * direction[1];
}

/* Some newtons on each point, or on one alone. */
static void push_points(int only, double (*force)[DIM])
{
    unsigned seed = 11;

    for (int i = 0; i < POINTS; i++)
        for (int d = 0; d < DIM; d++) {
            const double f = 5 * noise(&seed);
            force[i][d] = only < 0 || i == only ? f : 0;
        }
}

static void check_push(const struct push *nodes, const struct push *skin, int point)
{
    const double off = fmax(fmax(fabs(nodes->along - skin->along),
                                 fabs(nodes->across - skin->across)),
                            fabs(nodes->moment - skin->moment));

    if (!(off <= 1e-12))
        fail_msg("point %d: nodes get %.15g, %.15g, %.15g, the skin feels %.15g, %.15g, %.15g",
                 point, nodes->along, nodes->across, nodes->moment, skin->along, skin->across,
                 skin->moment);
}

/* The layers of a linear beam move across alone, so that what is along turns nothing. */
static void check_linear(const struct beam_skin *s, int only)
{
    double f[2 * NODES] = {0}, force[POINTS][DIM];
    struct push nodes = {0}, skin = {0};

    push_points(only, force);
    nodes.along = beam_skin_load(s, (const double (*)[DIM])force, f);
    for (int i = 0; i < NODES; i++) {
        nodes.across += f[2 * i];
        nodes.moment += f[2 * i] * LENGTH * i / ELEMENTS + f[2 * i + 1];
    }
    for (int i = 0; i < POINTS; i++) {
        const double *x = s->point[i].rest;
        const double reach[2] = { x[0] - def.at[0], x[1] - def.at[1] };
        skin.along += part(force[i], def.along);
        skin.across += part(force[i], def.normal);
        skin.moment += part(reach, def.along) * part(force[i], def.normal);
    }
    check_push(&nodes, &skin, only);
}

static void linear_nodes_get_what_the_skin_feels(void **state)
{
    struct beam_skin *s = NULL;

    (void)state;
    assert_int_equal(beam_skin_create(&def, &s), 0);
    assert_int_equal(s->points, POINTS);
    for (int only = -1; only < POINTS; only++)
        check_linear(s, only);
    beam_skin_free(&s);
}

/* Turning the bent beam as a whole by a small angle a moves a node by a (-y, x) and its
 * slopes likewise: the work of that on the nodes is a times the moment. */
static void check_follower(const struct follower_skin *s, const double *q, int only)
{
    double f[ELASTICA_NODE * NODES] = {0}, force[POINTS][DIM], x[POINTS][DIM];
    struct push nodes = {0}, skin = {0};

    push_points(only, force);
    follower_skin_load(s, q, (const double (*)[DIM])force, f);
    follower_skin_move(s, q, q, x, NULL);
    for (int i = 0; i < NODES; i++) {
        const double *n = q + ELASTICA_NODE * i, *load = f + ELASTICA_NODE * i;
        nodes.along += load[0];
        nodes.across += load[1];
        nodes.moment += load[1] * (LENGTH * i / ELEMENTS + n[0]) - load[0] * n[1]
                      + load[3] * (1 + n[2]) - load[2] * n[3];
    }
    for (int i = 0; i < POINTS; i++) {
        skin.along += part(force[i], def.along);
        skin.across += part(force[i], def.normal);
        skin.moment += (x[i][0] - def.at[0]) * force[i][1] - (x[i][1] - def.at[1]) * force[i][0];
    }
    check_push(&nodes, &skin, only);
}

static void follower_nodes_get_what_the_skin_feels(void **state)
{
    double q[ELASTICA_NODE * NODES];
    struct follower_skin *s = NULL;
    unsigned seed = 5;

    (void)state;
    for (int i = 0; i < NODES; i++) /* a bow, and some noise */
        for (int c = 0; c < ELASTICA_NODE; c++)
            q[ELASTICA_NODE * i + c] = (c < 2 ? 0.002 : 0.1) * noise(&seed)
                                     + (c == 1 ? 0.1 * i * i / ELEMENTS / ELEMENTS : 0);
    assert_int_equal(follower_skin_create(&def, &s), 0);
    assert_int_equal(s->points, POINTS);
    for (int only = -1; only < POINTS; only++)
        check_follower(s, q, only);
    follower_skin_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_nodes_get_what_the_skin_feels),
        cmocka_unit_test(follower_nodes_get_what_the_skin_feels),
    };

    return cmocka_run_group_tests_name("skin-loads", tests, NULL, NULL);
}
