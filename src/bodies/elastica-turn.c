/* elastica-turn.c -- how the tangent of an element turns along it. */
#include "bodies/elastica-turn.h"

void elastica_turn_derive(const struct elastica_point *p, const double *q, double *slope,
                          double *curve)
{
    for (int c = 0; c < 2; c++) {
        slope[c] = curve[c] = 0;
        for (int k = 0; k < 4; k++) {
            slope[c] += p->slope[k] * q[elastica_entry(k, c)];
            curve[c] += p->curve[k] * q[elastica_entry(k, c)];
        }
    }
}

struct elastica_turn elastica_turn_at(const struct elastica_point *p, const double *q)
{
    struct elastica_turn t = {0};
    double a[2], b[2];

    elastica_turn_derive(p, q, a, b);
    a[0] += 1;
    const double s = a[0] * a[0] + a[1] * a[1], cross = a[0] * b[1] - a[1] * b[0];
    const double cross_a[2] = { b[1], -b[0] }, cross_b[2] = { -a[1], a[0] };

    t.kappa = cross / s;
    for (int i = 0; i < 2; i++) {
        t.by[i] = (cross_a[i] - 2 * t.kappa * a[i]) / s;
        t.by[2 + i] = cross_b[i] / s;
    }
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            t.twice[i][j] = -2 * (t.by[i] * a[j] + t.by[j] * a[i] + (i == j) * t.kappa) / s;
            t.twice[i][2 + j] = t.twice[2 + j][i] = (j - i - 2 * a[i] * t.by[2 + j]) / s;
        }
    return t;
}

void elastica_turn_spread(const struct elastica_point *p, const double by[4], double c, double *f)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++)
            f[elastica_entry(k, i)] += c * (by[i] * p->slope[k] + by[2 + i] * p->curve[k]);
}

void elastica_turn_spread_twice(const struct elastica_point *p, double h[4][4],
                                double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT])
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int c = 0; c < 2; c++)
                for (int d = 0; d < 2; d++)
                    k[elastica_entry(i, c)][elastica_entry(j, d)] +=
                        p->slope[i] * (h[c][d] * p->slope[j] + h[c][2 + d] * p->curve[j])
                        + p->curve[i] * (h[2 + c][d] * p->slope[j] + h[2 + c][2 + d] * p->curve[j]);
}
