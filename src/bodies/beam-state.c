/* beam-state.c -- where a beam's numbers stand in y. */
#include "bodies/beam-state.h"

#include "bodies/vectors.h"

long beam_state_place(const struct body *b, const struct layout *l, int i, bool rate)
{
    return layout_at(l, b->row[(rate ? BEAM_ROW_W_RATE : BEAM_ROW_W) + i % 2]) + i / 2;
}

void beam_state_read(const struct body *b, struct body_work *w, const struct layout *l,
                     const double *y)
{
    for (int i = 0; i < b->bending->dofs; i++) {
        const bool held = bending_held(b->bending, i);
        w->q[i] = held ? 0 : y[beam_state_place(b, l, i, false)];
        w->v[i] = held ? 0 : y[beam_state_place(b, l, i, true)];
    }
}

bool beam_state_pushed(const struct body *b, double t)
{
    return t < b->load_until;
}

void beam_state_loads(const struct body *b, double t, double *f)
{
    for (int i = 0; i < b->bending->dofs; i++)
        f[i] = b->weight[i] + (beam_state_pushed(b, t) ? b->pushed[i] : 0);
}

void beam_state_report(const struct body *b, const struct body_work *w, double t, double axial,
                       struct body_load *out)
{
    const int n = b->bending->dofs;
    const bool pushed = beam_state_pushed(b, t);
    double across = 0, applied = 0;

    for (int i = 0; i < n; i += 2) {
        across += w->inertia[i] - w->force[i];
        applied += pushed ? b->pushed[i] : 0;
    }
    out->driven = pushed ? vectors_dot(n, b->pushed, w->v) : 0;
    for (int d = 0; d < DIM; d++) {
        out->support[d] = across * b->normal[d] - (axial + b->gravity_along) * b->along[d];
        out->applied[d] = applied * b->normal[d];
    }
}
