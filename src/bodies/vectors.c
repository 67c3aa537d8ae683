/* vectors.c -- vectors of a beam's degrees of freedom. */
#include "bodies/vectors.h"

#include "base/status.h"

int vectors_take(double **const *place, int n, int dofs, double **memory)
{
    *memory = status_alloc((unsigned long)(n * dofs), sizeof **memory);
    if (!*memory)
        return STATUS_FAILED;
    for (int i = 0; i < n; i++)
        *place[i] = *memory + i * dofs;
    return STATUS_DONE;
}

double vectors_dot(int n, const double *a, const double *b)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}
