/* elastica-yield.c -- how a beam that bends far yields to a force within a time tau:
 *
 *   (M + tau D + tau^2 K) a = f                                                (E4)
 *
 * K is d2E/dq2 without the part of forces that turn with the beam, but for tensions: that of a
 * pressed or bent beam is not definite.  A tension may be what holds a soft beam. */
#include "bodies/elastica.h"

#include "base/status.h"
#include "bodies/elastica-friction.h"

/* tau^2 K + tau times the part of D by (BE7), at rest rates: of those it is the matrix. */
static void add_element(const struct elastica *e, struct elastica_work *w, int n, double tau,
                        const double *q)
{
    static const double rest[ELASTICA_ELEMENT];
    double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT], d[ELASTICA_ELEMENT][ELASTICA_ELEMENT] = { { 0 } };

    elastica_element_stiffness(&e->element, q, k);
    band_add_block(w->tangent, ELASTICA_NODE * n, ELASTICA_ELEMENT, &k[0][0]);
    if (!(e->def.bending.beta > 0))
        return;
    elastica_friction_tangent(&e->element, e->def.bending.beta, tau, q, rest, d);
    band_add_block(w->sum, ELASTICA_NODE * n, ELASTICA_ELEMENT, &d[0][0]);
}

int elastica_yield_set(const struct elastica *e, struct elastica_work *w, double tau,
                       const double *q)
{
    const struct bending_def *b = &e->def.bending;

    band_sum(w->tangent, 0, e->mass, 0, e->mass);
    band_sum(w->sum, 0, e->mass, 0, e->mass);
    for (int i = 0; i < b->elements; i++)
        add_element(e, w, i, tau, q + ELASTICA_NODE * i);
    band_sum(w->sum, 1, w->sum, tau * tau, w->tangent);
    band_sum(w->sum, 1, w->sum, 1 + tau * b->alpha, e->mass);
    for (int i = 0; i < e->dofs; i++)
        band_add(w->sum, i, i, tau * b->drag);
    elastica_hold(e, w);
    return band_factor_set(w->factor, w->sum);
}

void elastica_yield_stretch(const struct elastica *e, struct elastica_work *w, double tau,
                            const double *v, double *to)
{
    band_multiply(w->tangent, v, w->vector);
    for (int i = 0; i < e->dofs; i++)
        to[i] += tau * w->vector[i];
}

void elastica_yield(const struct elastica *e, const struct elastica_work *w, double *f)
{
    for (int i = 0; i < e->dofs; i++)
        if (elastica_held(e, i))
            f[i] = 0;
    band_factor_solve(w->factor, f);
}
