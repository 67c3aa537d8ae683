/* rigid-axes.c -- axes of inertia: eigenvectors of the inertia tensor, Goldstein 1980, 5-4. */
#include "bodies/rigid-axes.h"

#include "base/status.h"

#include <gsl/gsl_eigen.h>

#include <math.h>
#include <string.h>

static void stay(double R[DIM][DIM], double *frame)
{
    memset(R, 0, sizeof(double[DIM][DIM]));
    for (int d = 0; d < DIM; d++)
        R[d][d] = 1;
    memset(frame, 0, 4 * sizeof *frame);
    frame[0] = 1;
}

#if DIM == 2

int rigid_axes(const struct polytope_moments *m, double *gyration, double *frame,
               double R[DIM][DIM])
{
    stay(R, frame);
    *gyration = (m->second[0][0] + m->second[1][1]) / m->volume;
    return STATUS_DONE;
}

#else

static const double even = 1e-9; /* of the trace: products of inertia so small are none */

/* A quaternion of length 1 by the largest of its numbers: Shepperd, J. Guidance and Control 1
 * (1978) 223-224. */
static void quaternion_of(double (*const R)[DIM], double *q)
{
    const double trace = R[0][0] + R[1][1] + R[2][2];
    const double square[4] = { 1 + trace, 1 - trace + 2 * R[0][0], 1 - trace + 2 * R[1][1],
                               1 - trace + 2 * R[2][2] };
    int best = 0;

    for (int i = 1; i < 4; i++)
        best = square[i] > square[best] ? i : best;
    const double big = 0.5 * sqrt(square[best]), scale = 0.25 / big;
    q[best] = big;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (best == 0)
            q[1 + i] = scale * (R[k][j] - R[j][k]);
        else if (best == 1 + i)
            q[0] = scale * (R[k][j] - R[j][k]);
        else
            q[1 + i] = scale * (R[i][best - 1] + R[best - 1][i]);
    }
}

/* Eigenvectors as a right-handed frame. */
static int solve(const double tensor[3][3], double *gyration, double R[DIM][DIM])
{
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(3);
    double a[9], values[3], vectors[9];
    gsl_matrix_view A = gsl_matrix_view_array(a, 3, 3);
    gsl_matrix_view E = gsl_matrix_view_array(vectors, 3, 3);
    gsl_vector_view e = gsl_vector_view_array(values, 3);
    int code;

    memcpy(a, tensor, sizeof a);
    if (!work)
        return status_starved("axes of inertia");
    code = gsl_eigen_symmv(&A.matrix, &e.vector, &E.matrix, work);
    gsl_eigen_symmv_free(work);
    if (code != 0)
        return status_fail(STATUS_FAILED, "GSL finds no axes of inertia (code %d)", code);
    gsl_eigen_symmv_sort(&e.vector, &E.matrix, GSL_EIGEN_SORT_VAL_ASC);
    for (int k = 0; k < 3; k++) {
        gyration[k] = values[k];
        for (int d = 0; d < 3; d++)
            R[d][k] = vectors[3 * d + k];
    }
    for (int d = 0; d < 3; d++) {
        const int i = (d + 1) % 3, j = (d + 2) % 3;
        R[d][2] = R[i][0] * R[j][1] - R[j][0] * R[i][1];
    }
    return STATUS_DONE;
}

int rigid_axes(const struct polytope_moments *m, double *gyration, double *frame,
               double R[DIM][DIM])
{
    double tensor[3][3], trace = 0, aside = 0;

    for (int d = 0; d < 3; d++)
        trace += m->second[d][d] / m->volume;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            tensor[i][j] = (i == j) * trace - m->second[i][j] / m->volume;
            aside = i == j ? aside : fmax(aside, fabs(tensor[i][j]));
        }
    stay(R, frame);
    for (int i = 0; i < 3; i++)
        gyration[i] = tensor[i][i];
    if (aside <= even * trace)
        return STATUS_DONE;
    TRY(solve((const double (*)[3])tensor, gyration, R));
    quaternion_of(R, frame);
    return STATUS_DONE;
}

#endif
