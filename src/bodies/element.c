/* element.c -- the plane beam element with four degrees of freedom.
 *
 * Cubic (Hermite) shape functions: bending of a beam without loads between its
 * ends is exactly cubic, so deflections under loads at nodes are exact with any
 * number of elements.  Przemieniecki, Theory of Matrix Structural Analysis,
 * 1968, chapters 5 and 11.  The consistent mass, with the same bandwidth as the
 * stiffness, has the first frequency of 10 elements to five digits, the lumped one
 * of (44) to 0.6 %.
 * Checked in tests/unit/bending.c. */
#include "bodies/element.h"

void element_stiffness(double EI, double l, double k[4][4])
{
    const double pattern[4][4] = { { 12, 6 * l, -12, 6 * l },
                                   { 6 * l, 4 * l * l, -6 * l, 2 * l * l },
                                   { -12, -6 * l, 12, -6 * l },
                                   { 6 * l, 2 * l * l, -6 * l, 4 * l * l } };

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            k[i][j] = EI / (l * l * l) * pattern[i][j];
}

void element_mass(double mu, double l, double m[4][4])
{
    const double pattern[4][4] = { { 156, 22 * l, 54, -13 * l },
                                   { 22 * l, 4 * l * l, 13 * l, -3 * l * l },
                                   { 54, 13 * l, 156, -22 * l },
                                   { -13 * l, -3 * l * l, -22 * l, 4 * l * l } };

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            m[i][j] = mu * l / 420 * pattern[i][j];
}

/* Summed over elements: (44) of Toth (2012), m and m l^2/12 at a node, but half of both at
 * the two ends of the beam. */
void element_lumped(double mu, double l, double m[4][4])
{
    const double diagonal[4] = { 0.5, l * l / 24, 0.5, l * l / 24 };

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            m[i][j] = i == j ? mu * l * diagonal[i] : 0;
}

void element_shape(double xi, double l, double shape[4], double slope[4])
{
    shape[0] = 1 - xi * xi * (3 - 2 * xi);
    shape[1] = l * xi * (1 - xi) * (1 - xi);
    shape[2] = xi * xi * (3 - 2 * xi);
    shape[3] = l * xi * xi * (xi - 1);
    slope[0] = 6 * xi * (xi - 1) / l;
    slope[1] = (1 - xi) * (1 - 3 * xi);
    slope[2] = 6 * xi * (1 - xi) / l;
    slope[3] = xi * (3 * xi - 2);
}

void element_uniform(double q, double l, double f[4])
{
    f[0] = f[2] = q * l / 2;
    f[1] = q * l * l / 12;
    f[3] = -f[1];
}
