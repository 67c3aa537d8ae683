/* beam-couple.c -- a beam's part of a solve together with an implicit viscosity, (BV1). */
#include "bodies/beam-couple.h"

#include "bodies/beam-state.h"

#include <math.h>
#include <string.h>

int beam_couple_unknowns(const struct body *b)
{
    return b->bending->dofs;
}

void beam_couple_read(const struct body *b, const struct layout *l, const double *y, double *v)
{
    for (int i = 0; i < b->bending->dofs; i++)
        v[i] = y[beam_state_place(b, l, i, true)];
}

void beam_couple_write(const struct body *b, const struct layout *l, double gamma, const double *r,
                       const double *v, double *z)
{
    for (int i = 0; i < b->bending->dofs; i++) {
        const double moved = bending_held(b->bending, i) ? 0 : gamma * v[i];
        z[beam_state_place(b, l, i, false)] = r[beam_state_place(b, l, i, false)] + moved;
        z[beam_state_place(b, l, i, true)] = v[i];
    }
}

void beam_couple_right(const struct body *b, struct body_work *w, const struct layout *l,
                       double gamma, const double *r, double *to)
{
    for (int i = 0; i < b->bending->dofs; i++)
        w->q[i] = r[beam_state_place(b, l, i, false)];
    beam_couple_read(b, l, r, to);
    bending_right(b->bending, w->bending, gamma, w->q, to);
}

void beam_couple_inertia(const struct body *b, struct body_work *w, double gamma,
                         const double *v, double *to)
{
    bending_inertia(b->bending, w->bending, gamma, v, to);
}

void beam_couple_drift(const struct body *b, const double *v, double (*u)[DIM])
{
    beam_skin_drift(b->skin, v, u);
}

/* Held degrees of freedom feel nothing. */
void beam_couple_pull(const struct body *b, struct body_work *w, const double (*force)[DIM],
                      double c, double *to)
{
    double *f = w->force;

    memset(f, 0, (size_t)b->bending->dofs * sizeof *f);
    beam_skin_load(b->skin, force, f);
    for (int i = 0; i < b->bending->dofs; i++)
        to[i] += bending_held(b->bending, i) ? 0 : c * f[i];
}

int beam_couple_join(const struct body *b, struct body_work *w, double gamma, const double *c)
{
    bending_join(b->bending, w->bending, gamma);
    for (int i = 0; i < b->skin->points; i++)
        bending_join_point(w->bending, b->skin->point[i].first, b->skin->point[i].shape,
                           gamma * c[i]);
    return bending_joined(b->bending, w->bending);
}

void beam_couple_joined(const struct body *b, const struct body_work *w, double *v)
{
    (void)b;
    bending_join_solve(w->bending, v);
}

/* Of a node, or of what an element reaches by turning. */
double beam_couple_fastest(const struct body *b, const double *v)
{
    const double reach[2] = { 1, b->bending->l };
    double most = 0;

    for (int i = 0; i < b->bending->dofs; i++)
        most = fmax(most, reach[i % 2] * fabs(v[i]));
    return most;
}

/* Adds what the support gives: 1 . (M v' - S^T force) across, with v' in w->given. */
static void add_support(const struct body *b, struct body_work *w, const double (*force)[DIM],
                        double support[DIM])
{
    const int n = b->bending->dofs;
    double axial, across = 0;

    memset(w->force, 0, (size_t)n * sizeof *w->force);
    axial = beam_skin_load(b->skin, force, w->force);
    band_multiply(b->bending->mass, w->given, w->inertia);
    for (int i = 0; i < n; i += 2)
        across += w->inertia[i] - w->force[i];
    for (int d = 0; d < DIM; d++)
        support[d] += across * b->normal[d] - axial * b->along[d];
}

void beam_couple_yield(const struct body *b, struct body_work *w, const struct layout *l,
                       const double (*force)[DIM], double *ydot, double support[DIM])
{
    const int n = b->bending->dofs;

    memset(w->given, 0, (size_t)n * sizeof *w->given);
    beam_skin_load(b->skin, force, w->given);
    bending_accelerate(b->bending, w->given);
    for (int i = 0; i < n; i++)
        ydot[beam_state_place(b, l, i, true)] += w->given[i];
    add_support(b, w, force, support);
}

void beam_couple_settle(const struct body *b, struct body_work *w, const struct layout *l,
                        double gamma, const double *r, const double *z,
                        const double (*force)[DIM], double support[DIM])
{
    beam_state_read(b, w, l, z);
    bending_resist(b->bending, w->bending, w->q, w->v, w->resist);
    bending_accelerate(b->bending, w->resist);
    for (int i = 0; i < b->bending->dofs; i++) {
        const long k = beam_state_place(b, l, i, true);
        w->given[i] = (z[k] - r[k]) / gamma + w->resist[i];
    }
    add_support(b, w, force, support);
}
