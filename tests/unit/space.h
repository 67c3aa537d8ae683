/* space.h -- random clouds of particles, and what the tests of space/ share. */
#ifndef TESTS_UNIT_SPACE_H
#define TESTS_UNIT_SPACE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "plan/sum.h"

#ifdef STIFFWATER_V3
enum { SPACE_ENGINES = 2 };
#else
enum { SPACE_ENGINES = 1 };
#endif

/* Particles in creation order. */
struct space_cloud {
    struct list_def def;
    struct cloud cloud;
    int n;
    double *x; /* [n][DIM] */
};

/* The lane widths that this machine can run: 2, and 4 if it has AVX2. */
int space_engines(void);
const struct sum_engine *space_engine(int i);

/* A number from 0 to 1 that depends on the calls so far alone. */
double space_random(void);
void space_seed(unsigned seed);

/* count[k] particles of kind k at random in the unit box, radius H = support;
 * all kinds act on all, but skins that slip own nothing. */
struct space_cloud *space_cloud(const int count[KINDS], double support, double margin);
void space_cloud_free(struct space_cloud *c);

int space_kind(const struct space_cloud *c, int i);
double space_distance2(const struct space_cloud *c, int i, int j); /* [m^2] */

/* Fails with a sentence when `good` is false. */
#define check(good, ...)                     \
    do {                                     \
        if (!(good)) {                       \
            print_error(__VA_ARGS__);        \
            fail();                          \
        }                                    \
    } while (0)

void kernel_integrates_to_one(void **state);
void kernel_laplacian_integrates(void **state);
void kernel_derivatives_agree(void **state);
void kernel_laplacian_at_centre(void **state);
void kernel_signs(void **state);
void kernel_as_published(void **state);
void kernel_corrections_of_print(void **state);
void kernel_laplacian_linear(void **state);
void kernel_density_of_lattice(void **state);
void kernel_rows_agree(void **state);
void kernel_ends_at_support(void **state);
void kernel_same_bits_lanes(void **state);

void list_finds_all(void **state);
void list_takes_odd_clouds(void **state);
void list_keeps_outsiders_out(void **state);
void list_sorts_the_same(void **state);
void list_knows_when_stale(void **state);
void list_reports_bad_positions(void **state);
void list_bounds_its_grid(void **state);
void list_misses_nobody_moving(void **state);

void list_of_parts_is_that_of_all(void **state);

void list_need_not_ask_what_stands_still(void **state);

void rows_change_no_list(void **state);
void rows_move_under_a_list(void **state);
void rows_tell_the_smallest_bad_id(void **state);

void images_find_all(void **state);
void images_meet_across_a_side(void **state);
void images_miss_nobody_moving(void **state);

void sum_agrees_with_brute_force(void **state);
void sum_same_bits_lanes_and_threads(void **state);
void sum_padding_adds_nothing(void **state);
void sum_writes_every_place(void **state);
void sum_writes_rates_in_place(void **state);
void sum_keeps_momentum(void **state);

void nabla_agrees_with_brute_force(void **state);
void nabla_is_its_transpose(void **state);
void nabla_gives_a_diagonal(void **state);
void nabla_of_linear_fields(void **state);
void nabla_same_bits_lanes_and_threads(void **state);

#endif
