/* beam-table.c -- the beam of Toth (2012) against its number of elements: what the
 * mass matrix does to its first frequency, and what the two kinds of damping do to its first mode.
 *
 * Writes CSV to stdout; plots/figures-beam.sh draws it.  The beam is that of
 * data/scenes/toth-beam.scene, with d = 0.01 of the paper's table 2.  A damping ratio is that
 * of lambda^2 + 2 ratio omega lambda + omega^2 = 0, omega the frequency without damping:
 * above 1 the mode only creeps back. */
#include "base/status.h"
#include "bodies/bending.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const struct bending_def seed = { .length = 0.08, .EI = 0.5e9 * 6.4e-8 / 12,
                                         .mu = 0.165 / 0.08, .tip = BENDING_FREE };
static const double printed_drag = 0.01, named_ratio = 0.02;

enum { HELD = 2, MOST = 2 * 100, /* degrees of freedom: of the clamped root, all others */ };

static struct bending *made(int elements, enum bending_inertia inertia, double drag, double alpha)
{
    struct bending_def def = seed;
    struct bending *b;

    def.elements = elements;
    def.inertia = inertia;
    def.drag = drag;
    def.alpha = alpha;
    if (bending_create(&def, &b)) {
        fprintf(stderr, "%s\n", status_message());
        exit(1);
    }
    return b;
}

/* Least omega of K x = omega^2 M x. */
static double first_frequency(const struct bending *b)
{
    const size_t n = (size_t)b->dofs - HELD;
    gsl_matrix *k = gsl_matrix_alloc(n, n), *m = gsl_matrix_alloc(n, n);
    gsl_vector *square = gsl_vector_alloc(n);
    gsl_eigen_gensymm_workspace *work = gsl_eigen_gensymm_alloc(n);

    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            gsl_matrix_set(k, i, j, band_at(b->stiffness, HELD + (int)i, HELD + (int)j));
            gsl_matrix_set(m, i, j, band_at(b->mass, HELD + (int)i, HELD + (int)j));
        }
    gsl_eigen_gensymm(k, m, square, work);
    const double least = gsl_vector_min(square);
    gsl_eigen_gensymm_free(work);
    gsl_vector_free(square);
    gsl_matrix_free(m);
    gsl_matrix_free(k);
    return sqrt(least);
}

/* z' = A z with z = (unit q, v), column by column from the rates that a run takes; unit [1/s]
 * makes the entries of alike size. */
static gsl_matrix *rates(const struct bending *b, double unit)
{
    const int n = b->dofs - HELD;
    gsl_matrix *a = gsl_matrix_calloc(2 * (size_t)n, 2 * (size_t)n);
    struct bending_work *work;

    if (bending_work_create(b, &work) != STATUS_DONE)
        exit(1);
    for (int j = 0; j < 2 * n; j++) {
        double q[HELD + MOST] = {0}, v[HELD + MOST] = {0}, f[HELD + MOST];
        *(j < n ? &q[HELD + j] : &v[HELD + j - n]) = j < n ? 1 / unit : 1;
        bending_resist(b, work, q, v, f);
        bending_accelerate(b, f);
        for (int i = 0; i < n; i++) {
            gsl_matrix_set(a, (size_t)i, (size_t)j, unit * v[HELD + i]);
            gsl_matrix_set(a, (size_t)(n + i), (size_t)j, -f[HELD + i]);
        }
    }
    bending_work_free(&work);
    return a;
}

/* Of the slowest mode, least |lambda|; omega [rad/s]: its frequency without damping. */
static double damping_ratio(const struct bending *b, double omega)
{
    gsl_matrix *a = rates(b, b->fastest);
    gsl_vector_complex *lambda = gsl_vector_complex_alloc(a->size1);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(a->size1);
    gsl_complex first = { { HUGE_VAL, 0 } };

    gsl_eigen_nonsymm(a, lambda, work);
    for (size_t i = 0; i < lambda->size; i++) {
        const gsl_complex one = gsl_vector_complex_get(lambda, i);
        if (gsl_complex_abs(one) < gsl_complex_abs(first))
            first = one;
    }
    gsl_eigen_nonsymm_free(work);
    gsl_vector_complex_free(lambda);
    gsl_matrix_free(a);
    const double size = gsl_complex_abs(first);
    return GSL_IMAG(first) != 0 ? -GSL_REAL(first) / size
                                : (size * size + omega * omega) / (2 * size * omega);
}

static void print_row(int elements)
{
    const double theory = bending_first(&seed);

    printf("%d", elements);
    for (enum bending_inertia inertia = BENDING_CONSISTENT; inertia <= BENDING_LUMPED_ENDS;
         inertia++) {
        struct bending *b = made(elements, inertia, printed_drag, 0);
        struct bending *named = made(elements, inertia, 0, 2 * named_ratio * theory);
        const double omega = first_frequency(b);
        printf(",%.6f,%.6f,%.6f", omega / theory, damping_ratio(b, omega),
               damping_ratio(named, omega));
        bending_free(&named);
        bending_free(&b);
    }
    putchar('\n');
}

int main(void)
{
    static const int elements[] = { 2, 3, 4, 5, 7, 10, 14, 20, 30, 40, 50, 60, 70, 80, 100 };

    puts("# units: 1\n"
         "elements,consistent,consistent_drag,consistent_ratio,lumped,lumped_drag,"
         "lumped_ratio,lumped_ends,lumped_ends_drag,lumped_ends_ratio");
    for (size_t i = 0; i < sizeof elements / sizeof elements[0]; i++)
        print_row(elements[i]);
    return 0;
}
