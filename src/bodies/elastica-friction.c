/* elastica-friction.c -- damping of a beam that bends far, by the rate at which it bends.
 *
 *   moment = EI (kappa + beta dkappa/dt),  power = -int beta EI (dkappa/dt)^2 ds  (BE7)
 *
 * the solid of Kelvin and Voigt in bending (Lord Kelvin 1865, Voigt 1892).  kappa is that
 * of (BE4), so what only turns or moves has no rate of it: nothing is taken from a beam
 * that spins or swings as a whole.  Of small deflections D = beta K, and a mode of
 * frequency omega dies down with the ratio beta omega/2.  Stretch is not damped.
 * Points are those where the element looks at kappa.  Checked in
 * tests/unit/elastica-friction.c. */
#include "bodies/elastica-friction.h"

#include "bodies/elastica-turn.h"

/* Rates of z = (r', r'') at a point; returns dkappa/dt. */
static double rate_of(const struct elastica_point *p, const struct elastica_turn *t,
                      const double *v, double *rate)
{
    double sum = 0;

    elastica_turn_derive(p, v, rate, rate + 2);
    for (int i = 0; i < 4; i++)
        sum += t->by[i] * rate[i];
    return sum;
}

void elastica_friction_force(const struct elastica_element *e, double beta, const double *q,
                             const double *v, double *f)
{
    double rate[4];

    for (int i = 0; i < ELASTICA_BENDS; i++) {
        const struct elastica_point *p = &e->bend[i];
        const struct elastica_turn t = elastica_turn_at(p, q);
        elastica_turn_spread(p, t.by, p->weight * beta * e->EI * rate_of(p, &t, v, rate), f);
    }
}

/* d/dv of (b . v) b, where b = dkappa/dq moves with q = r + gamma v. */
void elastica_friction_tangent(const struct elastica_element *e, double beta, double gamma,
                               const double *q, const double *v,
                               double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT])
{
    for (int n = 0; n < ELASTICA_BENDS; n++) {
        const struct elastica_point *p = &e->bend[n];
        const struct elastica_turn t = elastica_turn_at(p, q);
        double rate[4], h[4][4];
        const double bends = rate_of(p, &t, v, rate);

        for (int j = 0; j < 4; j++) {
            double turned = t.by[j];
            for (int i = 0; i < 4; i++)
                turned += gamma * t.twice[j][i] * rate[i];
            for (int i = 0; i < 4; i++)
                h[i][j] = gamma * beta * e->EI * p->weight
                        * (t.by[i] * turned + gamma * bends * t.twice[i][j]);
        }
        elastica_turn_spread_twice(p, h, k);
    }
}

double elastica_friction_power(const struct elastica_element *e, double beta, const double *q,
                               const double *v)
{
    double sum = 0, rate[4];

    for (int i = 0; i < ELASTICA_BENDS; i++) {
        const struct elastica_turn t = elastica_turn_at(&e->bend[i], q);
        const double bends = rate_of(&e->bend[i], &t, v, rate);
        sum -= e->bend[i].weight * beta * e->EI * bends * bends;
    }
    return sum;
}
