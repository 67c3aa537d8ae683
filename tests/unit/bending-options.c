/* bending-options.c -- tests of src/bodies/bending: mass as (44) prints it and with halves at
 * the ends, damping as (45) prints it, and what both do to the modes of a cantilever. */
#include "bending.h"

static const struct bending_def plain = { .length = 0.8, .EI = 2.7, .mu = 3.1,
                                          .tip = BENDING_FREE };

static struct bending *made(int elements, enum bending_inertia inertia, double drag)
{
    struct bending_def def = plain;

    def.elements = elements;
    def.inertia = inertia;
    def.drag = drag;
    return bending_of(def);
}

/* m and m l^2/12 at all nodes, nothing beside the diagonal; ends by `end`. */
static void check_diagonal(enum bending_inertia inertia, double end)
{
    struct bending *b = made(5, inertia, 0);
    const double l = 0.16, m = 3.1 * l;

    for (int i = 0; i < b->dofs; i++)
        for (int j = 0; j < b->dofs; j++) {
            const double here = i % 2 ? m * l * l / 12 : m;
            const double part = i < 2 || i >= b->dofs - 2 ? end : 1;
            check_close(band_at(b->mass, i, j), i == j ? part * here : 0, 1e-15, "(44)");
        }
    bending_free(&b);
}

static void lumped_mass_is_44_and_its_half_ends(void **state)
{
    (void)state;
    check_diagonal(BENDING_LUMPED, 1);
    check_diagonal(BENDING_LUMPED_ENDS, 0.5);
}

/* All nodes have (n + 1) m with (44), n m otherwise; M 1 is a uniform load of mu when M is
 * consistent. */
static void a_shift_weighs_the_mass(void **state)
{
    double part[4], f[BENDING_MOST] = {0};
    struct bending *b = made(7, BENDING_LUMPED, 0);

    (void)state;
    check_close(bending_mass(b), 3.1 * 0.8 * 8 / 7, 1e-14, "mass as printed");
    check_close(b->shift[15], 0, 0, "no moment");
    bending_free(&b);
    b = made(7, BENDING_LUMPED_ENDS, 0);
    check_close(bending_mass(b), 3.1 * 0.8, 1e-14, "mass with half ends");
    bending_free(&b);
    b = made(7, BENDING_CONSISTENT, 0);
    check_close(bending_mass(b), 3.1 * 0.8, 1e-14, "consistent mass");
    element_uniform(3.1, b->l, part);
    for (int e = 0; e < 7; e++)
        for (int k = 0; k < 4; k++)
            f[2 * e + k] += part[k];
    for (int i = 0; i < b->dofs; i++)
        check_close(b->shift[i], f[i], 1e-15, "uniform load");
    bending_free(&b);
}

/* Frequency / theory, modes 1 to 4 of a cantilever: computed outside of this program (dense
 * generalized eigenproblem), rounded there to three digits. */
static const struct {
    int elements;
    double lumped[4], ends[4], consistent[4];
} known[] = {
    { 5, { .827, .811, .777, .725 }, { .975, .899, .829, .762 }, { 1, 1.001, 1.004, 1.012 } },
    { 10, { .907, .902, .892, .874 }, { .994, .972, .946, .916 }, { 1, 1, 1, 1.001 } },
    { 30, { .968, .967, .966, .963 }, { .999, .997, .994, .989 }, { 1, 1, 1, 1 } },
    { 100, { .990, .990, .990, .990 }, { 1, 1, .999, .999 }, { 1, 1, 1, 1 } },
};

static void check_modes(int elements, enum bending_inertia inertia, const double ratio[4])
{
    static const double beta_L[4] = { 1.875104069, 4.694091133, 7.854757438, 10.995540735 };
    struct bending *b = made(elements, inertia, 0);
    double omega[BENDING_MOST];

    bending_frequencies(b, omega);
    for (int i = 0; i < 4; i++)
        check_close(omega[i] / (pow(beta_L[i] / 0.8, 2) * sqrt(2.7 / 3.1)), ratio[i], 6e-4,
                    "frequency / theory");
    bending_free(&b);
}

static void whole_end_masses_make_a_cantilever_slow(void **state)
{
    static const double twenty[2] = { .952, .998 };
    double omega[BENDING_MOST];

    (void)state;
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++) {
        check_modes(known[k].elements, BENDING_LUMPED, known[k].lumped);
        check_modes(known[k].elements, BENDING_LUMPED_ENDS, known[k].ends);
        check_modes(known[k].elements, BENDING_CONSISTENT, known[k].consistent);
    }
    for (int k = 0; k < 2; k++) {
        struct bending *b = made(20, k ? BENDING_LUMPED_ENDS : BENDING_LUMPED, 0);
        bending_frequencies(b, omega);
        check_close(omega[0] / bending_first(&plain), twenty[k], 6e-4, "20 elements");
        bending_free(&b);
    }
}

/* Missing mass at the ends is of order 1/n, lumping itself of order 1/n^2. */
static void half_ends_converge_twice_as_fast(void **state)
{
    (void)state;
    for (int order = 1; order <= 2; order++) {
        double omega[BENDING_MOST], off[2];
        for (int k = 0; k < 2; k++) {
            struct bending *b = made(40 << k, order == 1 ? BENDING_LUMPED : BENDING_LUMPED_ENDS, 0);
            bending_frequencies(b, omega);
            off[k] = 1 - omega[0] / bending_first(&plain);
            bending_free(&b);
        }
        check_close(log2(off[0] / off[1]), order, 0.05, "order in elements");
    }
}

static void fastest_bounds_lumped_beams_too(void **state)
{
    (void)state;
    for (enum bending_inertia inertia = BENDING_LUMPED; inertia <= BENDING_LUMPED_ENDS; inertia++)
        for (int ends = 0; ends < 8; ends++) /* but both free */
            for (int n = ends == 0 ? 2 : 1; n <= 20; n += 3) {
                struct bending_def def = plain;
                double omega[BENDING_MOST];
                def.elements = n;
                def.inertia = inertia;
                def.root = (enum bending_end)(ends / 3);
                def.tip = (enum bending_end)(ends % 3);
                struct bending *b = bending_of(def);
                const double most = omega[bending_frequencies(b, omega) - 1];
                if (!(b->fastest >= most * (1 - 1e-9) && b->fastest <= 1.01 * most))
                    fail_msg("inertia %d, ends %d, %d elements: fastest %g, largest frequency %g",
                             inertia, ends, n, b->fastest, most);
                bending_free(&b);
            }
}

/* decay is the largest v . D v / v . M v: D = 2 C I with M makes it an eigenvalue, which
 * bending_frequencies() finds as that of a K that is D. */
static void decay_bounds_what_damping_takes(void **state)
{
    static const double drag[] = { 1e-6, 1e-3, 1, 1e3 };

    (void)state;
    for (enum bending_inertia inertia = BENDING_CONSISTENT; inertia <= BENDING_LUMPED_ENDS;
         inertia++)
        for (int n = 1; n <= 19; n += 6)
            for (int k = 0; k < 4; k++) {
                struct bending_def def = plain;
                double rate[BENDING_MOST];
                def.elements = n;
                def.inertia = inertia;
                def.drag = drag[k];
                def.alpha = 2;
                def.beta = 1e-6;
                struct bending *b = bending_of(def);
                band_sum(b->stiffness, def.beta, b->stiffness, def.alpha, b->mass);
                for (int i = 0; i < b->dofs; i++)
                    band_add(b->stiffness, i, i, def.drag);
                const double most = pow(rate[bending_frequencies(b, rate) - 1], 2);
                if (!(b->decay >= most * (1 - 1e-9) && b->decay <= 1.011 * most))
                    fail_msg("inertia %d, %d elements, drag %g: decay %g, largest rate %g",
                             inertia, n, drag[k], b->decay, most);
                bending_free(&b);
            }
}

/* The beam of Toth (2012) with d of its table 2. */
static struct bending *of_seed(int elements, enum bending_inertia inertia)
{
    return bending_of((struct bending_def){ .elements = elements, .length = 0.08,
        .EI = 0.5e9 * 6.4e-8 / 12, .mu = 0.165 / 0.08, .drag = 0.01, .inertia = inertia,
        .tip = BENDING_FREE });
}

static gsl_complex slowest(const struct bending *b)
{
    gsl_vector_complex *lambda = bending_eigenvalues(b);
    gsl_complex least = gsl_vector_complex_get(lambda, 0);

    for (size_t i = 1; i < lambda->size; i++)
        if (gsl_complex_abs(gsl_vector_complex_get(lambda, i)) < gsl_complex_abs(least))
            least = gsl_vector_complex_get(lambda, i);
    gsl_vector_complex_free(lambda);
    return least;
}

static void drag_of_every_node_depends_on_the_mesh(void **state)
{
    (void)state;
    for (enum bending_inertia inertia = BENDING_CONSISTENT; inertia <= BENDING_LUMPED_ENDS;
         inertia++) {
        struct bending *b = of_seed(10, inertia);
        gsl_complex first = slowest(b);
        assert_true(GSL_REAL(first) < 0 && GSL_IMAG(first) != 0);
        const double ratio = -GSL_REAL(first) / gsl_complex_abs(first);
        check_close(ratio, inertia == BENDING_LUMPED ? 0.357 : 0.388, 2e-3, "10 elements swing");
        bending_free(&b);
        b = of_seed(100, inertia);
        first = slowest(b);
        assert_true(GSL_REAL(first) < 0);
        check_close(GSL_IMAG(first), 0, 0, "100 elements creep");
        bending_free(&b);
    }
}

/* With small d the first mode x has the ratio d x.x/(2 omega x.Mx); from its continuous shape
 * phi, n/L nodes per length: d n (1 + slope)/(2 omega mu L), slope = int phi'^2/int phi^2. */
static void drag_acts_on_rotations_most(void **state)
{
    const double slope = 4.647777 / (0.08 * 0.08); /* of a cantilever's first mode */
    struct bending *b = of_seed(10, BENDING_CONSISTENT);
    const double omega = bending_first(&b->def);
    struct bending_def def = b->def;

    (void)state;
    bending_free(&b);
    def.drag = 1e-5;
    def.elements = 60;
    b = bending_of(def);
    const gsl_complex first = slowest(b);
    check_close(-GSL_REAL(first) / gsl_complex_abs(first)
                    / (def.drag * 60 * (1 + slope) / (2 * omega * def.mu * def.length)),
                1, 0.02, "ratio of the first mode");
    bending_free(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lumped_mass_is_44_and_its_half_ends),
        cmocka_unit_test(a_shift_weighs_the_mass),
        cmocka_unit_test(whole_end_masses_make_a_cantilever_slow),
        cmocka_unit_test(half_ends_converge_twice_as_fast),
        cmocka_unit_test(fastest_bounds_lumped_beams_too),
        cmocka_unit_test(decay_bounds_what_damping_takes),
        cmocka_unit_test(drag_of_every_node_depends_on_the_mesh),
        cmocka_unit_test(drag_acts_on_rotations_most),
    };

    return cmocka_run_group_tests_name("bending-options", tests, NULL, NULL);
}
