/* dense.h -- the state between two steps, from states and rates at their ends. */
#ifndef TIME_DENSE_H
#define TIME_DENSE_H

/* Weights of y and f at the times t[nodes], so that sum_k of_y[k] y_k + of_f[k] f_k
 * is the Hermite interpolant at `at`: its error is of order h^(2 nodes). */
void dense_hermite(int nodes, const double *t, double at, double *of_y, double *of_f);

/* The same with y alone: its error is of order h^nodes. */
void dense_lagrange(int nodes, const double *t, double at, double *of_y);

/* How many of the times t[0] > t[1] > ... are fit to interpolate between the
 * first two: an earlier one counts while no step was less than a third of the
 * newest one, else it would be extrapolated from afar. */
int dense_nodes(int known, const double *t);

#endif
