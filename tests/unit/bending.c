/* bending.c -- tests of src/bodies/element and src/bodies/bending: matrices against
 * quadrature, deflections and frequencies against beam theory. */
#include "bending.h"

static struct bending *made(int elements, enum bending_end root, enum bending_end tip)
{
    return bending_of((struct bending_def){ .elements = elements, .length = 0.8, .EI = 2.7,
                                            .mu = 3.1, .root = root, .tip = tip });
}

/* Gauss points and weights on 0..1: exact for the sixth powers of mass. */
static const double point[4] = { 0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                 0.93056815579702629 };
static const double weight[4] = { 0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                  0.17392742256872693 };

static void element_matrices_are_integrals_of_shape_functions(void **state)
{
    const double l = 0.37, EI = 2.2, mu = 1.7, q = 0.9, d = 0.01;
    double k[4][4], m[4][4], f[4], K[4][4] = {{0}}, M[4][4] = {{0}}, F[4] = {0};

    (void)state;
    element_stiffness(EI, l, k);
    element_mass(mu, l, m);
    element_uniform(q, l, f);
    for (int g = 0; g < 4; g++) {
        double n[4], slope[4], unused[4], more[4], less[4];
        element_shape(point[g], l, n, slope);
        element_shape(point[g] + d, l, unused, more); /* slopes are quadratic: */
        element_shape(point[g] - d, l, unused, less); /* differences are exact */
        for (int i = 0; i < 4; i++) {
            F[i] += weight[g] * l * q * n[i];
            for (int j = 0; j < 4; j++) {
                M[i][j] += weight[g] * l * mu * n[i] * n[j];
                K[i][j] += weight[g] * l * EI * (more[i] - less[i]) / (2 * d * l)
                         * (more[j] - less[j]) / (2 * d * l);
            }
        }
    }
    for (int i = 0; i < 4; i++) {
        check_close(f[i], F[i], 1e-14, "uniform load");
        for (int j = 0; j < 4; j++) {
            check_close(m[i][j], M[i][j], 1e-13, "consistent mass");
            check_close(k[i][j], K[i][j], 1e-9, "stiffness (43)");
        }
    }
}

static void shapes_carry_nodes_and_slope_is_the_derivative(void **state)
{
    const double l = 0.6, d = 1e-5;

    (void)state;
    for (int end = 0; end < 2; end++) {
        double n[4], slope[4];
        element_shape(end, l, n, slope);
        for (int k = 0; k < 4; k++) {
            check_close(n[k], k == 2 * end ? 1 : 0, 1e-15, "w at the nodes");
            check_close(slope[k], k == 2 * end + 1 ? 1 : 0, 1e-15, "theta at the nodes");
        }
    }
    for (double xi = 0.1; xi < 1; xi += 0.2) {
        double n[4], slope[4], up[4], down[4], unused[4];
        element_shape(xi, l, n, slope);
        element_shape(xi + d, l, up, unused);
        element_shape(xi - d, l, down, unused);
        for (int k = 0; k < 4; k++)
            check_close(slope[k], (up[k] - down[k]) / (2 * d * l), 1e-8, "slope");
    }
}

/* A rigid shift and a rigid turn bend nothing; the shift weighs the whole mass. */
static void rigid_motions_cost_nothing(void **state)
{
    struct bending *b = made(7, BENDING_CLAMPED, BENDING_FREE);
    double shift[16], turn[16];

    (void)state;
    for (int i = 0; i < b->dofs; i++) {
        shift[i] = i % 2 == 0;
        turn[i] = i % 2 ? 1 : i / 2 * b->l;
    }
    check_close(bending_elastic(b, shift), 0, 1e-9, "elastic energy of a shift");
    check_close(bending_elastic(b, turn), 0, 1e-9, "elastic energy of a turn");
    check_close(2 * bending_kinetic(b, shift), 3.1 * 0.8, 1e-13, "mass");
    check_close(2 * bending_kinetic(b, turn), 3.1 * pow(0.8, 3) / 3, 1e-13,
                "moment of inertia about the root");
    bending_free(&b);
}

/* w = F L^3/(3 EI), theta = F L^2/(2 EI) at the tip, with any number of elements. */
static void tip_load_is_exact_with_any_number_of_elements(void **state)
{
    (void)state;
    for (int n = 1; n <= 100; n++) {
        struct bending *b = made(n, BENDING_CLAMPED, BENDING_FREE);
        struct band_factor *f = NULL;
        double x[202] = {0};
        assert_int_equal(band_factor_create(b->dofs, 3, &f), STATUS_DONE);
        band_hold(b->stiffness_free, 0, 1);
        band_hold(b->stiffness_free, 1, 1);
        assert_int_equal(band_factor_set(f, b->stiffness_free), STATUS_DONE);
        x[2 * n] = 5;
        band_factor_solve(f, x);
        check_close(x[2 * n] / (5 * pow(0.8, 3) / (3 * 2.7)), 1, 1e-8, "F L^3/(3 EI)");
        check_close(x[2 * n + 1] / (5 * 0.64 / (2 * 2.7)), 1, 1e-8, "F L^2/(2 EI)");
        band_factor_free(&f);
        bending_free(&b);
    }
}

/* beta L of data/reference A08a, and of clamped-pinned (tan x = tanh x). */
static const struct {
    enum bending_end root, tip;
    int rigid; /* modes that do not bend */
    double beta_L[3];
} theory[] = {
    { BENDING_CLAMPED, BENDING_FREE, 0, { 1.875104069, 4.694091133, 7.854757438 } },
    { BENDING_FREE, BENDING_CLAMPED, 0, { 1.875104069, 4.694091133, 7.854757438 } },
    { BENDING_CLAMPED, BENDING_CLAMPED, 0, { 4.730040745, 7.853204624, 10.99560784 } },
    { BENDING_PINNED, BENDING_PINNED, 0, { 3.141592654, 6.283185307, 9.424777961 } },
    { BENDING_CLAMPED, BENDING_PINNED, 0, { 3.926602312, 7.068582746, 10.21017612 } },
    { BENDING_PINNED, BENDING_FREE, 1, { 3.926602312, 7.068582746, 10.21017612 } },
};
enum { THEORY = sizeof theory / sizeof theory[0] };

static void ten_elements_have_three_frequencies_to_a_thousandth(void **state)
{
    (void)state;
    for (int c = 0; c < THEORY; c++) {
        struct bending *b = made(10, theory[c].root, theory[c].tip);
        double omega[BENDING_MOST];
        bending_frequencies(b, omega);
        for (int i = 0; i < 3; i++) {
            const double exact = pow(theory[c].beta_L[i] / 0.8, 2) * sqrt(2.7 / 3.1);
            check_close(omega[theory[c].rigid + i] / exact, 1, 1e-3, "frequency / theory");
        }
        check_close(bending_first(&b->def) / (pow(theory[c].beta_L[0] / 0.8, 2) * sqrt(2.7 / 3.1)),
                    1, 1e-8, "bending_first");
        bending_free(&b);
    }
}

static void fastest_is_a_bound_from_above_within_one_per_cent(void **state)
{
    (void)state;
    for (int c = 0; c < THEORY; c++)
        for (int elements = 2; elements <= 20; elements += 6) {
            struct bending *b = made(elements, theory[c].root, theory[c].tip);
            double omega[BENDING_MOST];
            const int n = bending_frequencies(b, omega);
            if (!(b->fastest >= omega[n - 1] * (1 - 1e-9) && b->fastest <= 1.01 * omega[n - 1]))
                fail_msg("%d elements, ends %d %d: fastest %g, largest frequency %g", elements,
                         theory[c].root, theory[c].tip, b->fastest, omega[n - 1]);
            bending_free(&b);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(element_matrices_are_integrals_of_shape_functions),
        cmocka_unit_test(shapes_carry_nodes_and_slope_is_the_derivative),
        cmocka_unit_test(rigid_motions_cost_nothing),
        cmocka_unit_test(tip_load_is_exact_with_any_number_of_elements),
        cmocka_unit_test(ten_elements_have_three_frequencies_to_a_thousandth),
        cmocka_unit_test(fastest_is_a_bound_from_above_within_one_per_cent),
    };

    return cmocka_run_group_tests_name("bending", tests, NULL, NULL);
}
