/* space.c -- kernels, pair list, sums, divergence: the tests of space/ and plan/sum.c. */
#include "space.h"

#include <stdlib.h>

int space_engines(void)
{
#ifdef STIFFWATER_V3
    __builtin_cpu_init();
#ifdef STIFFWATER_V4
    if (__builtin_cpu_supports("x86-64-v4"))
        return 3;
#endif
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? 2 : 1;
#else
    return 1;
#endif
}

const struct sum_engine *space_engine(int i)
{
    static const struct sum_engine *const engines[] = {
        &sum_engine_lanes2,
#ifdef STIFFWATER_V3
        &sum_engine_lanes4,
#endif
#ifdef STIFFWATER_V4
        &sum_engine_lanes8,
#endif
    };

    return engines[i];
}

static uint64_t seed = 1;

void space_seed(unsigned s)
{
    seed = s;
}

/* Linear congruence with Knuth's constants; the upper bits are good enough. */
double space_random(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / (double)(UINT64_C(1) << 53);
}

struct space_cloud *space_cloud(const int count[KINDS], double support, double margin)
{
    struct space_cloud *c = test_calloc(1, sizeof *c);

    for (int k = 0; k < KINDS; k++) {
        c->def.from[k + 1] = c->def.from[k] + count[k];
        c->def.acts[k] = k == KIND_SKIN_SLIP ? 0 : KIND_BIT(KIND_FLUID) | KIND_SOLIDS;
    }
    c->def.support = support;
    c->def.skin = margin;
    for (int d = 0; d < DIM; d++)
        c->def.high[d] = 1;
    c->n = c->def.from[KINDS];
    c->x = test_malloc(((size_t)c->n + 1) * DIM * sizeof *c->x);
    for (int i = 0; i < c->n * DIM; i++)
        c->x[i] = space_random();
    for (int k = 0; k < KINDS; k++)
        c->cloud.x[k] = c->x + (size_t)c->def.from[k] * DIM;
    for (int k = 0; k <= KINDS; k++)
        c->cloud.from[k] = c->def.from[k];
    return c;
}

void space_cloud_free(struct space_cloud *c)
{
    test_free(c->x);
    test_free(c);
}

int space_kind(const struct space_cloud *c, int i)
{
    int k = 0;

    while (i >= c->def.from[k + 1])
        k++;
    return k;
}

double space_distance2(const struct space_cloud *c, int i, int j)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++) {
        const double x = c->x[i * DIM + d] - c->x[j * DIM + d];
        r2 += x * x;
    }
    return r2;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kernel_integrates_to_one),
        cmocka_unit_test(kernel_laplacian_integrates),
        cmocka_unit_test(kernel_derivatives_agree),
        cmocka_unit_test(kernel_laplacian_at_centre),
        cmocka_unit_test(kernel_signs),
        cmocka_unit_test(kernel_as_published),
        cmocka_unit_test(kernel_corrections_of_print),
        cmocka_unit_test(kernel_laplacian_linear),
        cmocka_unit_test(kernel_density_of_lattice),
        cmocka_unit_test(kernel_rows_agree),
        cmocka_unit_test(kernel_ends_at_support),
        cmocka_unit_test(kernel_same_bits_lanes),
        cmocka_unit_test(list_finds_all),
        cmocka_unit_test(list_takes_odd_clouds),
        cmocka_unit_test(list_keeps_outsiders_out),
        cmocka_unit_test(list_sorts_the_same),
        cmocka_unit_test(list_knows_when_stale),
        cmocka_unit_test(list_reports_bad_positions),
        cmocka_unit_test(list_bounds_its_grid),
        cmocka_unit_test(list_misses_nobody_moving),
        cmocka_unit_test(list_of_parts_is_that_of_all),
        cmocka_unit_test(list_need_not_ask_what_stands_still),
        cmocka_unit_test(rows_change_no_list),
        cmocka_unit_test(rows_move_under_a_list),
        cmocka_unit_test(rows_tell_the_smallest_bad_id),
        cmocka_unit_test(images_find_all),
        cmocka_unit_test(images_meet_across_a_side),
        cmocka_unit_test(images_miss_nobody_moving),
        cmocka_unit_test(sum_agrees_with_brute_force),
        cmocka_unit_test(sum_same_bits_lanes_and_threads),
        cmocka_unit_test(sum_padding_adds_nothing),
        cmocka_unit_test(sum_writes_every_place),
        cmocka_unit_test(sum_writes_rates_in_place),
        cmocka_unit_test(sum_keeps_momentum),
        cmocka_unit_test(nabla_agrees_with_brute_force),
        cmocka_unit_test(nabla_is_its_transpose),
        cmocka_unit_test(nabla_gives_a_diagonal),
        cmocka_unit_test(nabla_of_linear_fields),
        cmocka_unit_test(nabla_same_bits_lanes_and_threads),
    };

    return cmocka_run_group_tests_name(DIM == 2 ? "space in 2D" : "space in 3D", tests, NULL, NULL);
}
