/* bending-rates.c -- how fast a straight beam swings, and how fast it dies down. */
#include "bodies/bending-rates.h"

#include <math.h>

void bending_rates_drag(const struct bending *b, struct bending_work *w, double d)
{
    for (int i = 0; i < b->dofs; i++)
        if (!bending_held(b, i))
            band_add(w->sum, i, i, d);
}

/* Largest eigenvalue of k K + d I against M: `high`, which lies above it, is halved
 * towards the least lambda for which lambda M - k K - d I is positive definite. */
static double largest(const struct bending *b, struct bending_work *w, double k, double d,
                      double high)
{
    const double enough = 1e-9 * high;
    double low = 0;

    w->kept[0].set = false;
    while (high - low > 0.01 * high && high > enough) {
        const double middle = (low + high) / 2;
        band_sum(w->sum, middle, b->mass_free, -k, b->stiffness_free);
        bending_rates_drag(b, w, -d);
        if (band_factor_definite(w->kept[0].factor, w->sum))
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* No frequency of the beam exceeds the largest of a single free element: lambda =
 * 8400 EI/(mu l^4) with its consistent mass (Irons and Treharne 1971).  With the lumped
 * one an element that bends evenly, (0, t, 0, -t), has 2 EI/l t = lambda mu l^3/24 t, so
 * 48; bent like an S, (w, t, -w, t), it has 0 and 24 / (1/2) + 6 / (1/24) = 192. */
double bending_rates_fastest(const struct bending *b, struct bending_work *w)
{
    const double unit = b->def.EI / (b->def.mu * pow(b->l, 4));

    return sqrt(largest(b, w, 1, 0,
                        unit * (b->def.inertia == BENDING_CONSISTENT ? 8400 : 192)));
}

/* Drag alone lies below 94 d over the least entry of a lumped end: against its lumped
 * mass, the consistent mass of an element is 1/93.1 and more. */
double bending_rates_decay(const struct bending *b, struct bending_work *w)
{
    const double slow = b->def.beta * b->fastest * b->fastest;
    const double least = b->def.mu * b->l * fmin(1.0 / 2, b->l * b->l / 24);

    if (!(b->def.drag > 0))
        return b->def.alpha + slow;
    return b->def.alpha
         + largest(b, w, b->def.beta, b->def.drag, slow + 94 * b->def.drag / least);
}

/* A mode of frequency omega and damping 2 d = alpha + beta omega^2 has eigenvalues of
 * size omega while it swings, and d + sqrt(d^2 - omega^2) when it only creeps back.
 * Drag may damp a slow mode most, so that 2 d is what is safe to say of it: from
 * lambda^2 + lambda v.Dv + v.Kv = 0 at v.Mv = 1 no |lambda| exceeds both omega and 2 d. */
void bending_rates_limit(const struct bending_def *def, double fastest, double decay,
                         struct limit *out)
{
    const double d = 0.5 * decay, most_damped = def->drag > 0 ? 0 : fastest;
    const double creep = d > most_damped ? d + sqrt(d * d - most_damped * most_damped) : 0;

    out->decay = creep > fastest;
    out->rate = fmax(creep, fastest);
}

/* omega = (beta L)^2 / L^2 sqrt(EI/mu); beta L solves the frequency equation of the
 * two ends, for instance cos x cosh x = -1 for clamped and free.  Blevins, Formulas
 * for Natural Frequency and Mode Shape, 1979, table 8-1. */
double bending_first(const struct bending_def *def)
{
    static const double beta_L[3][3] = { /* [root][tip]: clamped, pinned, free */
        { 4.730040744862704, 3.926602312047919, 1.875104068711961 },
        { 3.926602312047919, 3.141592653589793, 3.926602312047919 },
        { 1.875104068711961, 3.926602312047919, 0 }
    };
    const double x = beta_L[def->root][def->tip] / def->length;

    return x * x * sqrt(def->EI / def->mu);
}

/* alpha and beta alone: drag is no mode's own. */
double bending_swing(const struct bending_def *def)
{
    const double omega = bending_first(def);

    return def->alpha + def->beta * omega * omega < 2 * omega ? omega : 0;
}
