/* beam-state.c -- where a beam's numbers stand in y. */
#include "bodies/beam-state.h"

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
