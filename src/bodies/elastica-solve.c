/* elastica-solve.c -- the implicit solve of a beam that bends far.
 *
 * z - gamma f_I(z) = r: positions are eliminated, z_q = r_q + gamma z_v; what is left for
 * v = z_v is
 *
 *   R(v) = M (v - r_v) + gamma [dE/dq(r_q + gamma v) + D v] = 0                   (BE5)
 *
 * and Newton's method solves it with dR/dv = M + gamma D + gamma^2 d2E/dq2: banded,
 * symmetric, by Cholesky, or by LU where a pressed beam makes it indefinite, or where
 * damping by the rate of bending (BE7), which depends on q, makes it not symmetric.
 * Checked in tests/unit/elastica*.c. */
#include "bodies/elastica.h"

#include "base/status.h"
#include "bodies/elastica-friction.h"
#include <math.h>

/* Size of a step of Newton's method in units of the scales: deflections and rates of a
 * node, slopes as the deflection over an element. */
static double size_of(const struct elastica *e, double gamma, const double *dv)
{
    double most = 0;

    for (int i = 0; i < e->dofs; i++) {
        const double length = i % ELASTICA_NODE < 2 ? 1 : e->l;
        const double s = length * fabs(dv[i])
                       * fmax(fabs(gamma) / e->def.thickness, 1 / e->def.speed);
        if (!(s <= most))
            most = s;
    }
    return most;
}

/* The last step was below what Newton's method will square, or, when rounding keeps it
 * from shrinking, small enough. */
static bool is_there(double size, double before)
{
    return size < 1e-8 || (size < 1e-5 && size > before / 3);
}

/* -R(v) into f. */
static void lack(const struct elastica *e, struct elastica_work *w, double gamma,
                 const double *rv, const double *q, const double *v, double *f)
{
    double *off = w->vector + e->dofs, *push = w->vector;

    elastica_resist(e, w, q, v, f);
    for (int i = 0; i < e->dofs; i++)
        off[i] = v[i] - rv[i];
    band_multiply(e->mass, off, push);
    for (int i = 0; i < e->dofs; i++)
        f[i] = elastica_held(e, i) ? 0 : -push[i] - gamma * f[i];
}

/* Adds what beta gives, its half that is skew to w->skew. */
static void add_friction(const struct elastica *e, struct elastica_work *w, double gamma,
                         const double *q, const double *v)
{
    double even[ELASTICA_ELEMENT][ELASTICA_ELEMENT], odd[ELASTICA_ELEMENT][ELASTICA_ELEMENT];

    band_sum(w->skew, 0, e->mass, 0, e->mass);
    for (int n = 0; n < e->def.bending.elements; n++) {
        double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT] = { { 0 } };
        elastica_friction_tangent(&e->element, e->def.bending.beta, gamma, q + ELASTICA_NODE * n,
                                  v + ELASTICA_NODE * n, k);
        for (int i = 0; i < ELASTICA_ELEMENT; i++)
            for (int j = 0; j < ELASTICA_ELEMENT; j++) {
                even[i][j] = (k[i][j] + k[j][i]) / 2;
                odd[i][j] = (k[i][j] - k[j][i]) / 2;
            }
        band_add_block(w->sum, ELASTICA_NODE * n, ELASTICA_ELEMENT, &even[0][0]);
        band_add_block(w->skew, ELASTICA_NODE * n, ELASTICA_ELEMENT, &odd[0][0]);
    }
}

/* w->factor for M + gamma D + gamma^2 d2E/dq2 at (q, v). */
static int factorize(const struct elastica *e, struct elastica_work *w, double gamma,
                     const double *q, const double *v)
{
    const struct bending_def *b = &e->def.bending;

    elastica_tangent(e, w, q);
    band_sum(w->sum, 1 + gamma * b->alpha, e->mass, gamma * gamma, w->tangent);
    for (int i = 0; i < e->dofs; i++)
        band_add(w->sum, i, i, gamma * b->drag);
    if (w->skew)
        add_friction(e, w, gamma, q, v);
    elastica_hold(e, w);
    return w->skew ? band_factor_set_skew(w->factor, w->sum, w->skew)
                   : band_factor_set(w->factor, w->sum);
}

/* Held entries get those of r, and v what makes q the guess. */
static void begin(const struct elastica *e, double gamma, const double *rq, const double *rv,
                  double *q, double *v)
{
    for (int i = 0; i < e->dofs; i++)
        if (elastica_held(e, i) || gamma == 0) {
            q[i] = rq[i];
            v[i] = rv[i];
        } else {
            v[i] = (q[i] - rq[i]) / gamma;
        }
}

/* One step of Newton's method; its size goes to *size. */
static int iterate(const struct elastica *e, struct elastica_work *w, double gamma,
                   const double *rq, const double *rv, double *q, double *v, double *size)
{
    double *dv = w->vector + 2 * e->dofs;

    lack(e, w, gamma, rv, q, v, dv);
    TRY(factorize(e, w, gamma, q, v));
    band_factor_solve(w->factor, dv);
    for (int i = 0; i < e->dofs; i++)
        if (!elastica_held(e, i)) {
            v[i] += dv[i];
            q[i] = rq[i] + gamma * v[i];
        }
    *size = size_of(e, gamma, dv);
    return STATUS_DONE;
}

int elastica_solve(const struct elastica *e, struct elastica_work *w, double gamma,
                   const double *rq, const double *rv, double *q, double *v)
{
    double size = HUGE_VAL;

    begin(e, gamma, rq, rv, q, v);
    for (int k = 0; k < ELASTICA_ITERATIONS; k++) {
        const double before = size;
        TRY(iterate(e, w, gamma, rq, rv, q, v, &size));
        if (is_there(size, before))
            return STATUS_DONE;
    }
    return status_fail(STATUS_FAILED, "%s: Newton's method did not find how the beam bends within "
                       "%d iterations (gamma = %g s, its last step %g of the scales): the step "
                       "is too long for so large a turn, or the beam is crushed",
                       e->def.path, ELASTICA_ITERATIONS, gamma, size);
}
