/* liquid.c -- of the fastest wave of a liquid: it is that of the fastest particle, to the bit. */
#include "pressure/liquid.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum { N = 3000 };

static double random_number(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 4294967296.0;
}

/* The same by a look at each; with ids, of equally fast ones that with the least. */
static void look_at_all(const struct liquid *l, const struct view *v, double *speed, int *where)
{
    *speed = -1;
    for (int i = 0; i < N; i++) {
        const int id = v->p->id[KIND_FLUID] ? v->p->id[KIND_FLUID][i] : i;
        double u2 = 0;

        for (int d = 0; d < DIM; d++)
            u2 += v->u[KIND_FLUID][i * DIM + d] * v->u[KIND_FLUID][i * DIM + d];
        const double its = eos_sound(&l->eos, v->rho[KIND_FLUID][i]) + sqrt(u2);
        if (its > *speed || (its == *speed && id < *where)) {
            *speed = its;
            *where = id;
        }
    }
}

/* Velocities of about `fast`; every fifth particle is as fast as the one before. */
static void fill(unsigned seed, double fast, double *u, double *rho, int *id)
{
    for (int i = 0; i < N; i++) {
        for (int d = 0; d < DIM; d++)
            u[i * DIM + d] = i % 5 ? fast * (random_number(&seed) - 0.5)
                                   : u[(i > 0 ? i - 1 : 0) * DIM + d];
        rho[i] = i % 5 || i == 0 ? 990 + 20 * random_number(&seed) : rho[i - 1];
        id[i] = N - 1 - i;
    }
}

static void the_fastest_is_found(void **state)
{
    static double u[N * DIM], rho[N];
    static int id[N];
    struct particles p = { .n = N };

    (void)state;
    for (int k = KIND_FLUID; k < KINDS; k++)
        p.from[k + 1] = N;
    for (unsigned seed = 0; seed < 200; seed++) {
        const double gamma = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 7 : 1.4;
        const struct liquid l = { .eos = { 1000, 20, gamma, false }, .reach = 3 };
        struct view v = { .p = &p, .u = { [KIND_FLUID] = u }, .rho = { [KIND_FLUID] = rho } };
        struct limit found = { .where = -1 };
        double speed;
        int where;

        fill(seed, seed % 7 == 0 ? 0 : pow(10, seed % 7 - 3.0), u, rho, id);
        p.id[KIND_FLUID] = seed % 2 ? id : NULL;
        look_at_all(&l, &v, &speed, &where);
        liquid_limit(&l, &v, &found);
        assert_true(found.found == speed && found.rate == 3 * speed);
        assert_int_equal(found.where, where);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(the_fastest_is_found) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
