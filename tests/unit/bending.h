/* bending.h -- a bending beam and its eigenvalues, for tests. */
#ifndef TESTS_UNIT_BENDING_H
#define TESTS_UNIT_BENDING_H

#include "base/status.h"
#include "bodies/bending.h"
#include "bodies/element.h"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_sort_vector.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

enum { BENDING_MOST = 202 }; /* degrees of freedom */

static inline void check_close(double found, double expected, double tolerance, const char *what)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s: found %.17g, expected %.17g within %g", what, found, expected, tolerance);
}

static inline struct bending *bending_of(struct bending_def def)
{
    struct bending *b = NULL;

    assert_int_equal(bending_create(&def, &b), STATUS_DONE);
    assert_true(b->dofs <= BENDING_MOST);
    return b;
}

/* Degrees of freedom that move; their number. */
static inline int bending_moving(const struct bending *b, int *dof)
{
    int n = 0;

    for (int i = 0; i < b->dofs; i++)
        if (!bending_held(b, i))
            dof[n++] = i;
    return n;
}

/* Frequencies [rad/s] of K and M by GSL's dense solver, ascending; their number. */
static inline int bending_frequencies(const struct bending *b, double *omega)
{
    int free_dof[BENDING_MOST];
    const int n = bending_moving(b, free_dof);
    gsl_matrix *k = gsl_matrix_alloc((size_t)n, (size_t)n);
    gsl_matrix *m = gsl_matrix_alloc((size_t)n, (size_t)n);
    gsl_vector *value = gsl_vector_alloc((size_t)n);
    gsl_eigen_gensymm_workspace *work = gsl_eigen_gensymm_alloc((size_t)n);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const int r = free_dof[i], c = free_dof[j];
            gsl_matrix_set(k, (size_t)i, (size_t)j, band_at(b->stiffness, r, c));
            gsl_matrix_set(m, (size_t)i, (size_t)j, band_at(b->mass, r, c));
        }
    assert_int_equal(gsl_eigen_gensymm(k, m, value, work), 0);
    gsl_sort_vector(value);
    for (int i = 0; i < n; i++)
        omega[i] = sqrt(fmax(0, gsl_vector_get(value, (size_t)i)));
    gsl_eigen_gensymm_free(work);
    gsl_vector_free(value);
    gsl_matrix_free(k);
    gsl_matrix_free(m);
    return n;
}

/* Eigenvalues lambda of q'' M + q' D + q K = 0: of z' = A z, z = (unit q, v), column by
 * column from the rates of the implicit side; unit makes entries of alike size.  Free
 * with gsl_vector_complex_free(). */
static inline gsl_vector_complex *bending_eigenvalues(const struct bending *b)
{
    int dof[BENDING_MOST];
    const int n = bending_moving(b, dof);
    const double unit = b->fastest;
    gsl_matrix *a = gsl_matrix_calloc(2 * (size_t)n, 2 * (size_t)n);
    gsl_vector_complex *lambda = gsl_vector_complex_alloc(2 * (size_t)n);
    gsl_eigen_nonsymm_workspace *work = gsl_eigen_nonsymm_alloc(2 * (size_t)n);
    struct bending_work *scratch;

    assert_int_equal(bending_work_create(b, &scratch), STATUS_DONE);
    for (int j = 0; j < 2 * n; j++) {
        double q[BENDING_MOST] = {0}, v[BENDING_MOST] = {0}, f[BENDING_MOST];
        *(j < n ? &q[dof[j]] : &v[dof[j - n]]) = j < n ? 1 / unit : 1;
        bending_resist(b, scratch, q, v, f);
        bending_accelerate(b, f);
        for (int i = 0; i < n; i++) {
            gsl_matrix_set(a, (size_t)i, (size_t)j, unit * v[dof[i]]);
            gsl_matrix_set(a, (size_t)(n + i), (size_t)j, -f[dof[i]]);
        }
    }
    assert_int_equal(gsl_eigen_nonsymm(a, lambda, work), 0);
    gsl_eigen_nonsymm_free(work);
    bending_work_free(&scratch);
    gsl_matrix_free(a);
    return lambda;
}

#endif
