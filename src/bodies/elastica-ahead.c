/* elastica-ahead.c -- a beam that bends far under a pressure that looks ahead:
 *
 *   (M + tau D + tau^2 K) a = S^T force + loads - dE/dq - (D + tau K) v         (E4)
 *
 * with S = dx/dq of (BE6) at q, and K of elastica-yield.c.  Points have S a + S' v. */
#include "bodies/elastica-ahead.h"

#include "base/status.h"
#include "bodies/elastica-state.h"
#include "bodies/vectors.h"

#include <math.h>
#include <string.h>

int elastica_ahead_set(const struct body *b, struct body_work *w, const struct layout *l, double t,
                       double tau, const double *y)
{
    elastica_state_read(b, w, l, y);
    elastica_resist(b->beam, w->beam, w->q, w->v, w->resist);
    TRY(elastica_yield_set(b->beam, w->beam, tau, w->q));
    elastica_yield_stretch(b->beam, w->beam, tau, w->v, w->resist);
    w->ahead = tau;
    elastica_state_loads(b, w, t, w->predicted);
    for (int i = 0; i < b->beam->dofs; i++)
        w->predicted[i] -= w->resist[i];
    return STATUS_DONE;
}

/* By what stands in w->force and the skin's forces. */
static void accelerate(const struct body *b, struct body_work *w, const double (*force)[DIM],
                       double (*a)[DIM])
{
    follower_skin_load(b->skin, w->q, force, w->force);
    elastica_yield(b->beam, w->beam, w->force);
    follower_skin_drift(b->skin, w->q, w->force, a);
}

void elastica_ahead_drive(const struct body *b, struct body_work *w, const double (*force)[DIM],
                          double (*a)[DIM])
{
    memcpy(w->force, w->predicted, (size_t)b->beam->dofs * sizeof *w->force);
    accelerate(b, w, force, a);
    follower_skin_bend(b->skin, w->q, w->v, a);
}

void elastica_ahead_yield(const struct body *b, struct body_work *w, const double (*force)[DIM],
                          double (*a)[DIM])
{
    memset(w->force, 0, (size_t)b->beam->dofs * sizeof *w->force);
    accelerate(b, w, force, a);
}

/* The rest of the balance is what resists at the end of the step, v + tau a. */
void elastica_ahead_balance(const struct body *b, struct body_work *w, const struct layout *l,
                            double t, const double *y, const double (*force)[DIM])
{
    const int n = b->beam->dofs;
    const int status = elastica_ahead_set(b, w, l, t, w->ahead, y);

    status_clear();
    memcpy(w->rate, w->predicted, (size_t)n * sizeof *w->rate);
    follower_skin_load(b->skin, w->q, force, w->rate);
    if (status == STATUS_DONE)
        elastica_yield(b->beam, w->beam, w->rate);
    elastica_state_loads(b, w, t, w->force);
    follower_skin_load(b->skin, w->q, force, w->force);
    for (int i = 0; i < n; i++) {
        w->rate[i] = status == STATUS_DONE ? w->rate[i] : NAN;
        w->load[i] = w->v[i] + w->ahead * w->rate[i];
    }
    elastica_resist(b->beam, w->beam, w->q, w->load, w->resist);
    elastica_yield_stretch(b->beam, w->beam, w->ahead, w->load, w->resist);
    band_multiply(b->beam->mass, w->rate, w->inertia);
}

/* Damping is all that takes energy from the beam: v . (dE/dq - (F - M v')). */
void elastica_ahead_load(const struct body *b, struct body_work *w, const struct layout *l,
                         double t, const double *y, const double (*force)[DIM], double *ydot,
                         struct body_load *out)
{
    const int n = b->beam->dofs;
    double *rest = w->load;

    elastica_ahead_balance(b, w, l, t, y, force);
    for (int i = 0; i < n; i++) {
        ydot[elastica_state_place(b, l, i, false)] = w->v[i];
        ydot[elastica_state_place(b, l, i, true)] = w->rate[i];
    }
    elastica_state_report(b, w, out);
    out->damping = -vectors_dot(n, w->v, w->resist);
    memset(rest, 0, (size_t)n * sizeof *rest);
    elastica_resist(b->beam, w->beam, w->q, rest, w->resist);
    out->damping += vectors_dot(n, w->v, w->resist);
}
