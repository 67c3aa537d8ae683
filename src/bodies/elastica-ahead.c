/* elastica-ahead.c -- a beam that bends far under a pressure that looks ahead:
 *
 *   (M + tau D + tau^2 K) a = S^T force + loads - dE/dq - (D + tau K) v         (E4)
 *
 * with S = dx/dq of (BE6) at q, and K of elastica-yield.c.  Points have S a + S' v. */
#include "bodies/elastica-ahead.h"

#include "base/status.h"
#include "bodies/elastica-state.h"

#include <string.h>

int elastica_ahead_set(const struct body *b, struct body_work *w, const struct layout *l, double t,
                       double tau, const double *y)
{
    elastica_state_read(b, w, l, y);
    elastica_resist(b->beam, w->beam, w->q, w->v, w->resist);
    TRY(elastica_yield_set(b->beam, w->beam, tau, w->q, w->v, w->resist));
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
