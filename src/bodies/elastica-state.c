/* elastica-state.c -- where the numbers of a beam that bends far stand in y. */
#include "bodies/elastica-state.h"

#include "bodies/vectors.h"

#include <string.h>

long elastica_state_place(const struct body *b, const struct layout *l, int i, bool rate)
{
    return layout_at(l, b->row[(rate ? ELASTICA_NODE : 0) + i % ELASTICA_NODE])
         + i / ELASTICA_NODE;
}

void elastica_state_read(const struct body *b, struct body_work *w, const struct layout *l,
                         const double *y)
{
    for (int i = 0; i < b->beam->dofs; i++) {
        const bool held = elastica_held(b->beam, i);
        w->q[i] = held ? 0 : y[elastica_state_place(b, l, i, false)];
        w->v[i] = held ? 0 : y[elastica_state_place(b, l, i, true)];
    }
}

static void give(const struct body *b, struct body_work *w, double t)
{
    const size_t size = (size_t)b->beam->dofs * sizeof *w->given;

    if (!(t < b->load_until)) {
        memset(w->given, 0, size);
        return;
    }
    memcpy(w->given, b->pushed, size);
    elastica_follow(b->beam, b->turning_load, b->turning_force, w->q, w->given);
}

void elastica_state_loads(const struct body *b, struct body_work *w, double t, double *f)
{
    give(b, w, t);
    for (int i = 0; i < b->beam->dofs; i++)
        f[i] = b->weight[i] + w->given[i];
}

void elastica_state_total(const struct body *b, const double *f, double *to)
{
    double sum[2] = { 0, 0 };

    for (int i = 0; i < b->beam->dofs; i += ELASTICA_NODE)
        for (int c = 0; c < 2; c++)
            sum[c] += f[i + c];
    for (int d = 0; d < DIM; d++)
        to[d] = sum[0] * b->along[d] + sum[1] * b->normal[d];
}

void elastica_state_report(const struct body *b, const struct body_work *w, struct body_load *out)
{
    double moved[DIM], loads[DIM];

    out->driven = vectors_dot(b->beam->dofs, w->given, w->v);
    elastica_state_total(b, w->inertia, moved);
    elastica_state_total(b, w->force, loads);
    elastica_state_total(b, w->given, out->applied);
    for (int d = 0; d < DIM; d++)
        out->support[d] = moved[d] - loads[d];
}
