/* band.c -- symmetric banded matrices and their solves, on GSL.
 *
 * Storage of Cholesky is GSL's own for symmetric bands (see band.h).  Storage
 * of LU is GSL's for general bands: row j of [n][3 half + 1] holds column j of
 * the matrix, entry (i, j) at 2 half + i - j; the first `half` columns are room
 * for what pivoting fills in. */
#include "algebra/band.h"
#include "base/status.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct band_factor {
    int n, half;
    bool cholesky;        /* which of the two holds                          */
    double *llt, *lu;     /* [n][half + 1], [n][3 half + 1]                  */
    gsl_vector_uint *row; /* [n] row exchanges of LU, NULL if n = 0          */
};

static int width(int n, int half)
{
    return half < n ? half : (n > 0 ? n - 1 : 0);
}

int band_create(int n, int half, struct band **out)
{
    struct band *b = status_alloc(1, sizeof *b);

    if (!b)
        return STATUS_FAILED;
    b->n = n;
    b->half = width(n, half);
    b->a = status_alloc((unsigned long)n * (unsigned long)(b->half + 1), sizeof *b->a);
    if (!b->a) {
        band_free(&b);
        return STATUS_FAILED;
    }
    *out = b;
    return STATUS_DONE;
}

void band_free(struct band **b)
{
    if (!*b)
        return;
    free((*b)->a);
    free(*b);
    *b = NULL;
}

/* Where the entry (i, j) is kept, NULL outside the band. */
static double *entry(const struct band *b, int i, int j)
{
    const int low = i > j ? i : j, high = i > j ? j : i;

    return low - high > b->half ? NULL : b->a + high * (b->half + 1) + (low - high);
}

void band_add(struct band *b, int i, int j, double value)
{
    double *a = entry(b, i, j);

    if (a)
        *a += value;
}

double band_at(const struct band *b, int i, int j)
{
    const double *a = entry(b, i, j);

    return a ? *a : 0;
}

void band_add_block(struct band *b, int first, int m, const double *e)
{
    for (int i = 0; i < m; i++)
        for (int j = 0; j <= i; j++)
            band_add(b, first + i, first + j, e[i * m + j]);
}

void band_hold(struct band *b, int i, double diagonal)
{
    for (int j = i - b->half; j <= i + b->half; j++)
        if (j >= 0 && j < b->n)
            *entry(b, i, j) = j == i ? diagonal : 0;
}

void band_sum(struct band *to, double ca, const struct band *a, double cb,
              const struct band *b)
{
    for (int i = 0; i < to->n * (to->half + 1); i++)
        to->a[i] = ca * a->a[i] + cb * b->a[i];
}

void band_multiply(const struct band *b, const double *x, double *y)
{
    for (int i = 0; i < b->n; i++)
        y[i] = b->a[i * (b->half + 1)] * x[i];
    for (int j = 0; j < b->n; j++)
        for (int k = 1; k <= b->half && j + k < b->n; k++) {
            const double a = b->a[j * (b->half + 1) + k];
            y[j + k] += a * x[j];
            y[j] += a * x[j + k];
        }
}

double band_form(const struct band *b, const double *x)
{
    double sum = 0;

    for (int j = 0; j < b->n; j++) {
        double row = 0.5 * b->a[j * (b->half + 1)] * x[j];
        for (int k = 1; k <= b->half && j + k < b->n; k++)
            row += b->a[j * (b->half + 1) + k] * x[j + k];
        sum += 2 * x[j] * row;
    }
    return sum;
}

int band_factor_create(int n, int half, struct band_factor **out)
{
    struct band_factor *f = status_alloc(1, sizeof *f);

    if (!f)
        return STATUS_FAILED;
    f->n = n;
    f->half = width(n, half);
    f->llt = status_alloc((unsigned long)n * (unsigned long)(f->half + 1), sizeof *f->llt);
    f->lu = status_alloc((unsigned long)n * (unsigned long)(3 * f->half + 1), sizeof *f->lu);
    if (n > 0)
        f->row = gsl_vector_uint_calloc((size_t)n);
    if (n > 0 && !f->row)
        status_starved("%d places of a banded matrix cannot be had", n);
    if (!f->llt || !f->lu || (n > 0 && !f->row)) {
        band_factor_free(&f);
        return STATUS_FAILED;
    }
    *out = f;
    return STATUS_DONE;
}

void band_factor_free(struct band_factor **f)
{
    if (!*f)
        return;
    if ((*f)->row)
        gsl_vector_uint_free((*f)->row);
    free((*f)->llt);
    free((*f)->lu);
    free(*f);
    *f = NULL;
}

static gsl_matrix_view llt(const struct band_factor *f)
{
    return gsl_matrix_view_array(f->llt, (size_t)f->n, (size_t)f->half + 1);
}

static gsl_matrix_view lu(const struct band_factor *f)
{
    return gsl_matrix_view_array(f->lu, (size_t)f->n, (size_t)(3 * f->half + 1));
}

bool band_factor_definite(struct band_factor *f, const struct band *b)
{
    f->cholesky = true;
    if (f->n == 0)
        return true;
    memcpy(f->llt, b->a, (size_t)(f->n * (f->half + 1)) * sizeof *f->llt);

    gsl_error_handler_t *const before = gsl_set_error_handler_off();
    gsl_matrix_view a = llt(f);
    f->cholesky = gsl_linalg_cholesky_band_decomp(&a.matrix) == GSL_SUCCESS;
    gsl_set_error_handler(before);

    for (int i = 0; i < f->n && f->cholesky; i++) /* GSL lets NaN pass */
        f->cholesky = f->llt[i * (f->half + 1)] > 0;
    return f->cholesky;
}

/* Room for LU holds b. */
static void unfold(struct band_factor *f, const struct band *b)
{
    const int p = f->half, columns = 3 * p + 1;

    for (int j = 0; j < f->n; j++)
        for (int k = -2 * p; k <= p; k++)
            f->lu[j * columns + 2 * p + k] =
                k < -p || j + k < 0 || j + k >= f->n ? 0 : band_at(b, j + k, j);
}

/* Adds the skew matrix of s. */
static void twist(struct band_factor *f, const struct band *s)
{
    const int p = f->half, columns = 3 * p + 1;

    for (int j = 0; j < f->n; j++)
        for (int k = 1; k <= p && j + k < f->n; k++) {
            const double below = band_at(s, j + k, j);
            f->lu[j * columns + 2 * p + k] += below;
            f->lu[(j + k) * columns + 2 * p - k] -= below;
        }
}

/* LU with row exchanges; GSL says nothing of a zero or NaN on the diagonal. */
static bool eliminate(struct band_factor *f)
{
    const int p = f->half, columns = 3 * p + 1;

    f->cholesky = false;
    if (f->n == 0)
        return true;
    gsl_error_handler_t *const before = gsl_set_error_handler_off();
    gsl_matrix_view a = lu(f);
    const int failed = gsl_linalg_LU_band_decomp((size_t)f->n, (size_t)p, (size_t)p, &a.matrix,
                                                 f->row);
    gsl_set_error_handler(before);

    for (int j = 0; j < f->n; j++) {
        const double pivot = fabs(f->lu[j * columns + 2 * p]);
        if (!(pivot > 0 && isfinite(pivot)))
            return false;
    }
    return !failed;
}

static int refuse(const struct band_factor *f)
{
    return status_fail(STATUS_FAILED, "a banded matrix of %d rows is singular or not finite: "
                       "there is an unknown that nothing holds, or a NaN came in", f->n);
}

int band_factor_set(struct band_factor *f, const struct band *b)
{
    if (band_factor_definite(f, b))
        return STATUS_DONE;
    unfold(f, b);
    return eliminate(f) ? STATUS_DONE : refuse(f);
}

int band_factor_set_skew(struct band_factor *f, const struct band *b, const struct band *s)
{
    unfold(f, b);
    twist(f, s);
    return eliminate(f) ? STATUS_DONE : refuse(f);
}

void band_factor_solve(const struct band_factor *f, double *x)
{
    if (f->n == 0)
        return;
    gsl_error_handler_t *const before = gsl_set_error_handler_off();
    gsl_vector_view v = gsl_vector_view_array(x, (size_t)f->n);

    if (f->cholesky) {
        const gsl_matrix_view a = llt(f);
        gsl_linalg_cholesky_band_svx(&a.matrix, &v.vector);
    } else {
        const gsl_matrix_view a = lu(f);
        gsl_linalg_LU_band_svx((size_t)f->half, (size_t)f->half, &a.matrix, f->row, &v.vector);
    }
    gsl_set_error_handler(before);
}
