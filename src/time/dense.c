/* dense.c -- Hermite and Lagrange interpolation with few nodes.
 *
 * With L_k the Lagrange polynomials: y(t) = sum_k L_k^2 ((1 - 2 L_k'(t_k)(t - t_k)) y_k
 * + (t - t_k) f_k). */
#include "time/dense.h"

#include <math.h>

static double basis(int nodes, const double *t, int k, double at)
{
    double l = 1;

    for (int j = 0; j < nodes; j++)
        if (j != k)
            l *= (at - t[j]) / (t[k] - t[j]);
    return l;
}

static double slope_at_own_node(int nodes, const double *t, int k)
{
    double slope = 0;

    for (int j = 0; j < nodes; j++)
        if (j != k)
            slope += 1 / (t[k] - t[j]);
    return slope;
}

void dense_hermite(int nodes, const double *t, double at, double *of_y, double *of_f)
{
    for (int k = 0; k < nodes; k++) {
        const double l = basis(nodes, t, k, at), l2 = l * l;
        of_y[k] = l2 * (1 - 2 * slope_at_own_node(nodes, t, k) * (at - t[k]));
        of_f[k] = l2 * (at - t[k]);
    }
}

void dense_lagrange(int nodes, const double *t, double at, double *of_y)
{
    for (int k = 0; k < nodes; k++)
        of_y[k] = basis(nodes, t, k, at);
}

int dense_nodes(int known, const double *t)
{
    int nodes = known < 2 ? known : 2;

    while (nodes < known && t[nodes - 1] - t[nodes] >= (t[0] - t[1]) / 3)
        nodes++;
    return nodes;
}
