/* vectors.h -- vectors of a beam's degrees of freedom. */
#ifndef BODIES_VECTORS_H
#define BODIES_VECTORS_H

/* Takes *place[n], each [dofs] and 0, in one piece of memory: free(*memory). */
int vectors_take(double **const *place, int n, int dofs, double **memory);

double vectors_dot(int n, const double *a, const double *b);

#endif
