/* beam-ahead.c -- a beam under a pressure that looks ahead:
 *
 *   (M + tau D + tau^2 K) a = S^T force + loads - K (q + tau v) - D v          (E4)
 *
 * S is that of (BE2), which does not depend on q: points have no acceleration but S a. */
#include "bodies/beam-ahead.h"

#include "base/status.h"
#include "bodies/beam-state.h"
#include "bodies/vectors.h"

#include <string.h>

int beam_ahead_set(const struct body *b, struct body_work *w, const struct layout *l, double t,
                   double tau, const double *y)
{
    const int n = b->bending->dofs;

    beam_state_read(b, w, l, y);
    for (int i = 0; i < n; i++)
        w->force[i] = w->q[i] + tau * w->v[i];
    bending_resist(b->bending, w->bending, w->force, w->v, w->resist);
    beam_state_loads(b, t, w->predicted);
    for (int i = 0; i < n; i++)
        w->predicted[i] -= w->resist[i];
    w->ahead = tau;
    memset(w->force, 0, (size_t)n * sizeof *w->force);
    return bending_yield(b->bending, w->bending, tau, w->force);
}

/* By what stands in w->force and the skin's forces. */
static void accelerate(const struct body *b, struct body_work *w, const double (*force)[DIM],
                       double (*a)[DIM])
{
    beam_skin_load(b->skin, force, w->force);
    bending_yield(b->bending, w->bending, w->ahead, w->force);
    beam_skin_drift(b->skin, w->force, a);
}

void beam_ahead_drive(const struct body *b, struct body_work *w, const double (*force)[DIM],
                      double (*a)[DIM])
{
    memcpy(w->force, w->predicted, (size_t)b->bending->dofs * sizeof *w->force);
    accelerate(b, w, force, a);
}

void beam_ahead_yield(const struct body *b, struct body_work *w, const double (*force)[DIM],
                      double (*a)[DIM])
{
    memset(w->force, 0, (size_t)b->bending->dofs * sizeof *w->force);
    accelerate(b, w, force, a);
}

double beam_ahead_balance(const struct body *b, struct body_work *w, const struct layout *l,
                          double t, const double *y, const double (*force)[DIM])
{
    const int n = b->bending->dofs;
    double axial;

    beam_ahead_set(b, w, l, t, w->ahead, y);
    memcpy(w->rate, w->predicted, (size_t)n * sizeof *w->rate);
    beam_skin_load(b->skin, force, w->rate);
    bending_yield(b->bending, w->bending, w->ahead, w->rate);
    beam_state_loads(b, t, w->force);
    axial = beam_skin_load(b->skin, force, w->force);
    for (int i = 0; i < n; i++) {
        w->given[i] = w->ahead * w->rate[i];
        w->predicted[i] = w->ahead * w->given[i];
    }
    bending_resist(b->bending, w->bending, w->predicted, w->given, w->inertia);
    for (int i = 0; i < n; i++)
        w->resist[i] += w->inertia[i];
    band_multiply(b->bending->mass, w->rate, w->inertia);
    return axial;
}

/* Damping is all that takes energy from the beam: v . (K q - (F - M v')). */
void beam_ahead_load(const struct body *b, struct body_work *w, const struct layout *l, double t,
                     const double *y, const double (*force)[DIM], double *ydot,
                     struct body_load *out)
{
    const int n = b->bending->dofs;
    const double axial = beam_ahead_balance(b, w, l, t, y, force);

    for (int i = 0; i < n; i++) {
        ydot[beam_state_place(b, l, i, false)] = w->v[i];
        ydot[beam_state_place(b, l, i, true)] = w->rate[i];
    }
    beam_state_report(b, w, t, axial, out);
    out->damping = -vectors_dot(n, w->v, w->resist);
    band_multiply(b->bending->stiffness, w->q, w->resist);
    out->damping += vectors_dot(n, w->v, w->resist);
}
