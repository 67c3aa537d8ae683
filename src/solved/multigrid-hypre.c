/* multigrid-hypre.c -- one V-cycle of an algebraic multigrid as a preconditioner: BoomerAMG of
 * HYPRE, on each rank for itself.
 *
 * Conjugate gradients want M symmetric: smoothing is Gauss-Seidel, forwards on the way down and
 * backwards on the way up, once each, and the coarsest matrix is solved for exactly.  V. E. Henson,
 * U. M. Yang, Appl. Numer. Math. 41 (2002) 155-177.
 *
 * A hierarchy serves one solve, so setting it up has to be cheap: HMIS coarsening, twice at once on
 * the finest level (H. De Sterck, U. M. Yang, J. J. Heys, SIAM J. Matrix Anal. Appl. 27 (2006)
 * 1019-1039).  Without that a solve takes half of the products, and more time, in 3D by half.
 *
 * Rows without neighbours are divided by their diagonal here; HYPRE sees the others alone. */
#include "solved/precondition.h"

#include "base/status.h"

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <HYPRE_utilities.h>

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

struct multigrid {
    const double *diagonal; /* lent, of the matrix that it was made of          */
    int *number;            /* [size] among rows with neighbours, -1: none      */
    HYPRE_BigInt *row;      /* [size] 0, 1, 2, ...                              */
    HYPRE_BigInt *column;   /* [size] scratch: those of a row                   */
    double *value;          /* [size] the same of its entries; of vectors       */
    int rows, n;            /* with neighbours; all                             */
    HYPRE_IJMatrix matrix;  /* NULL: none is made                               */
    HYPRE_IJVector b, x;
    HYPRE_Solver solver;
};

/* A cycle, by what HYPRE's reference manual calls these numbers. */
enum { COARSEN_HMIS = 10, TWICE_ON = 1, INTERPOLATE_EXT_I = 6, ENTRIES = 4, SMOOTH_FORWARDS = 13,
       SMOOTH_BACKWARDS = 14, SOLVE_DENSE = 9, DOWN = 1, UP = 2, COARSEST = 3 };
static const double strong = 0.5; /* an entry, of the largest in its row */

/* --- memory ---------------------------------------------------------------------- */

static void forget(struct multigrid *s)
{
    if (s->solver)
        HYPRE_BoomerAMGDestroy(s->solver);
    if (s->b)
        HYPRE_IJVectorDestroy(s->b);
    if (s->x)
        HYPRE_IJVectorDestroy(s->x);
    if (s->matrix)
        HYPRE_IJMatrixDestroy(s->matrix);
    s->solver = NULL;
    s->b = s->x = NULL;
    s->matrix = NULL;
}

static void drop(void **self)
{
    struct multigrid *s = *self;

    if (!s)
        return;
    forget(s);
    free(s->number), free(s->row), free(s->column), free(s->value);
    free(s);
    *self = NULL;
}

static int create(int size, void **out)
{
    struct multigrid *s = *out = status_alloc(1, sizeof *s);
    const size_t n = (size_t)size + 1;

    if (!s)
        return STATUS_FAILED;
    HYPRE_Init(); /* again does nothing */
    s->number = status_alloc(n, sizeof *s->number);
    s->row = status_alloc(n, sizeof *s->row);
    s->column = status_alloc(n, sizeof *s->column);
    s->value = status_alloc(n, sizeof *s->value);
    if (!s->number || !s->row || !s->column || !s->value)
        return STATUS_FAILED;
    for (int i = 0; i < size; i++)
        s->row[i] = i;
    return STATUS_DONE;
}

/* --- a matrix -------------------------------------------------------------------- */

static bool alone(const struct precondition_matrix *a, int i)
{
    return a->from[i] == a->from[i + 1];
}

static void number_rows(struct multigrid *s, const struct precondition_matrix *a)
{
    s->diagonal = a->diagonal;
    s->n = a->n;
    s->rows = 0;
    for (int i = 0; i < a->n; i++)
        s->number[i] = alone(a, i) ? -1 : s->rows++;
}

static void put_row(struct multigrid *s, const struct precondition_matrix *a, int i)
{
    HYPRE_Int n = 1;

    s->column[0] = s->number[i];
    s->value[0] = a->diagonal[i];
    for (size_t k = a->from[i]; k < a->from[i + 1]; k++, n++) {
        s->column[n] = s->number[a->column[k]];
        s->value[n] = a->value[k];
    }
    HYPRE_IJMatrixSetValues(s->matrix, 1, &n, &s->row[s->number[i]], s->column, s->value);
}

static void put_matrix(struct multigrid *s, const struct precondition_matrix *a, HYPRE_Int *length)
{
    const HYPRE_BigInt last = s->rows - 1;

    for (int i = 0; i < a->n; i++)
        if (s->number[i] >= 0)
            length[s->number[i]] = 1 + (HYPRE_Int)(a->from[i + 1] - a->from[i]);
    HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, last, 0, last, &s->matrix);
    HYPRE_IJMatrixSetObjectType(s->matrix, HYPRE_PARCSR);
    HYPRE_IJMatrixSetRowSizes(s->matrix, length);
    HYPRE_IJMatrixInitialize(s->matrix);
    for (int i = 0; i < a->n; i++)
        if (s->number[i] >= 0)
            put_row(s, a, i);
    HYPRE_IJMatrixAssemble(s->matrix);
}

static void make_vector(const struct multigrid *s, HYPRE_IJVector *out)
{
    HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, s->rows - 1, out);
    HYPRE_IJVectorSetObjectType(*out, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(*out);
    HYPRE_IJVectorAssemble(*out);
}

static void make_cycle(struct multigrid *s)
{
    HYPRE_BoomerAMGCreate(&s->solver);
    HYPRE_BoomerAMGSetPrintLevel(s->solver, 0);
    HYPRE_BoomerAMGSetTol(s->solver, 0);
    HYPRE_BoomerAMGSetMaxIter(s->solver, 1);
    HYPRE_BoomerAMGSetCoarsenType(s->solver, COARSEN_HMIS);
    HYPRE_BoomerAMGSetAggNumLevels(s->solver, TWICE_ON);
    HYPRE_BoomerAMGSetInterpType(s->solver, INTERPOLATE_EXT_I);
    HYPRE_BoomerAMGSetPMaxElmts(s->solver, ENTRIES);
    HYPRE_BoomerAMGSetStrongThreshold(s->solver, strong);
    HYPRE_BoomerAMGSetCycleRelaxType(s->solver, SMOOTH_FORWARDS, DOWN);
    HYPRE_BoomerAMGSetCycleRelaxType(s->solver, SMOOTH_BACKWARDS, UP);
    HYPRE_BoomerAMGSetCycleRelaxType(s->solver, SOLVE_DENSE, COARSEST);
    HYPRE_BoomerAMGSetNumSweeps(s->solver, 1);
}

static HYPRE_ParCSRMatrix matrix_of(const struct multigrid *s)
{
    void *object = NULL;

    HYPRE_IJMatrixGetObject(s->matrix, &object);
    return object;
}

static HYPRE_ParVector vector_of(HYPRE_IJVector v)
{
    void *object = NULL;

    HYPRE_IJVectorGetObject(v, &object);
    return object;
}

/* What HYPRE's calls since the last question have said; STATUS_FAILED: something. */
static int agree(char *why, size_t size)
{
    const HYPRE_Int error = HYPRE_GetError();
    char said[256] = "";

    if (!error)
        return STATUS_DONE;
    HYPRE_DescribeError(error, said);
    HYPRE_ClearAllErrors();
    snprintf(why, size, "HYPRE has no multigrid for its matrix: %.50s (error %d)", said, (int)error);
    return STATUS_FAILED;
}

static int make(void *self, const struct precondition_matrix *a, char *why, size_t size)
{
    struct multigrid *s = self;
    HYPRE_Int *length = status_alloc((size_t)a->n + 1, sizeof *length);

    forget(s);
    number_rows(s, a);
    HYPRE_ClearAllErrors();
    if (length && s->rows > 0) {
        put_matrix(s, a, length);
        make_vector(s, &s->b);
        make_vector(s, &s->x);
        make_cycle(s);
        HYPRE_BoomerAMGSetup(s->solver, matrix_of(s), vector_of(s->b), vector_of(s->x));
    }
    free(length);
    if (!length)
        snprintf(why, size, "no memory for the matrix of HYPRE");
    return length ? agree(why, size) : STATUS_FAILED;
}

/* --- a cycle --------------------------------------------------------------------- */

/* What HYPRE cannot answer comes out as NaN, and the solve refuses that. */
static void solve(void *self, const double *residual, double *near)
{
    struct multigrid *s = self;

    for (int i = 0; i < s->n; i++)
        if (s->number[i] >= 0)
            s->value[s->number[i]] = residual[i];
        else
            near[i] = residual[i] / s->diagonal[i];
    if (s->rows == 0)
        return;
    HYPRE_IJVectorSetValues(s->b, s->rows, s->row, s->value);
    HYPRE_ParVectorSetConstantValues(vector_of(s->x), 0);
    HYPRE_BoomerAMGSolve(s->solver, matrix_of(s), vector_of(s->b), vector_of(s->x));
    HYPRE_IJVectorGetValues(s->x, s->rows, s->row, s->value);
    const bool fails = HYPRE_GetError();
    HYPRE_ClearAllErrors();
    for (int i = 0; i < s->n; i++)
        if (s->number[i] >= 0)
            near[i] = fails ? NAN : s->value[s->number[i]];
}

const struct precondition precondition_multigrid = {
    .name = "multigrid", .row = 180, .entry = 20, .create = create, .free = drop, .make = make,
    .solve = solve,
};
