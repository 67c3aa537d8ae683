/* bending-solve.c -- the implicit solve of a straight beam, and what it works in.
 *
 * z - gamma f_I(z) = r: positions are eliminated exactly,
 *
 *   z_q = r_q + gamma z_v
 *   (M + gamma D + gamma^2 K) z_v = M r_v - gamma K r_q                    (BE1)
 *
 * one banded solve; factorizations are kept for the last few gamma.
 * Checked in tests/unit/bending-options.c and beam-balance.c. */
#include "bodies/bending.h"

#include "base/status.h"
#include "bodies/bending-rates.h"
#include <stdlib.h>

static int take_memory(const struct bending *b, struct bending_work *w)
{
    TRY(band_create(b->dofs, BENDING_WIDTH, &w->sum));
    for (int i = 0; i < BENDING_FACTORS; i++)
        TRY(band_factor_create(b->dofs, BENDING_WIDTH, &w->kept[i].factor));
    TRY(band_factor_create(b->dofs, BENDING_WIDTH, &w->joint));
    w->vector = status_alloc((unsigned long)b->dofs * 2, sizeof *w->vector);
    return w->vector ? STATUS_DONE : STATUS_FAILED;
}

int bending_work_create(const struct bending *b, struct bending_work **out)
{
    struct bending_work *w = status_alloc(1, sizeof *w);

    *out = w;
    if (!w)
        return STATUS_FAILED;
    if (take_memory(b, w) == STATUS_DONE)
        return STATUS_DONE;
    bending_work_free(out);
    return STATUS_FAILED;
}

void bending_work_free(struct bending_work **w)
{
    if (!*w)
        return;
    band_free(&(*w)->sum);
    for (int i = 0; i < BENDING_FACTORS; i++)
        band_factor_free(&(*w)->kept[i].factor);
    band_factor_free(&(*w)->joint);
    free((*w)->vector);
    free(*w);
    *w = NULL;
}

/* K q + D v = K (q + beta v) + alpha M v + drag v. */
void bending_resist(const struct bending *b, struct bending_work *w, const double *q,
                    const double *v, double *to)
{
    double *bent = w->vector, *push = w->vector + b->dofs;

    for (int i = 0; i < b->dofs; i++)
        bent[i] = q[i] + b->def.beta * v[i];
    band_multiply(b->stiffness, bent, to);
    band_multiply(b->mass, v, push);
    for (int i = 0; i < b->dofs; i++)
        to[i] += b->def.alpha * push[i] + b->def.drag * v[i];
}

/* To the scratch matrix: M + gamma D + gamma^2 K. */
static void sum_up(const struct bending *b, struct bending_work *w, double gamma)
{
    band_sum(w->sum, 1 + gamma * b->def.alpha, b->mass_free,
             gamma * (b->def.beta + gamma), b->stiffness_free);
    bending_rates_drag(b, w, gamma * b->def.drag);
}

static void hold(const struct bending *b, struct bending_work *w)
{
    for (int i = 0; i < b->dofs; i++)
        if (bending_held(b, i))
            band_hold(w->sum, i, 1);
}

/* The factorization of M + gamma D + gamma^2 K: kept, or made anew over the oldest. */
static int factor_of(const struct bending *b, struct bending_work *w, double gamma,
                     const struct band_factor **out)
{
    for (int i = 0; i < BENDING_FACTORS; i++)
        if (w->kept[i].set && w->kept[i].gamma == gamma) {
            *out = w->kept[i].factor;
            return STATUS_DONE;
        }
    struct bending_factor *f = &w->kept[w->oldest];

    w->oldest = (w->oldest + 1) % BENDING_FACTORS;
    sum_up(b, w, gamma);
    hold(b, w);
    f->set = false;
    TRY(band_factor_set(f->factor, w->sum));
    f->set = true;
    f->gamma = gamma;
    *out = f->factor;
    return STATUS_DONE;
}

void bending_right(const struct bending *b, struct bending_work *w, double gamma,
                   const double *q, double *v)
{
    double *pull = w->vector, *push = w->vector + b->dofs;

    band_multiply(b->stiffness_free, q, pull);
    band_multiply(b->mass_free, v, push);
    for (int i = 0; i < b->dofs; i++)
        v[i] = push[i] - gamma * pull[i];
}

int bending_solve(const struct bending *b, struct bending_work *w, double gamma, double *q,
                  double *v)
{
    const struct band_factor *f;

    TRY(factor_of(b, w, gamma, &f));
    bending_right(b, w, gamma, q, v);
    band_factor_solve(f, v);
    for (int i = 0; i < b->dofs; i++)
        if (!bending_held(b, i))
            q[i] += gamma * v[i];
    return STATUS_DONE;
}

int bending_yield(const struct bending *b, struct bending_work *w, double gamma, double *f)
{
    const struct band_factor *factor;

    TRY(factor_of(b, w, gamma, &factor));
    for (int i = 0; i < b->dofs; i++)
        if (bending_held(b, i))
            f[i] = 0;
    band_factor_solve(factor, f);
    return STATUS_DONE;
}

void bending_inertia(const struct bending *b, struct bending_work *w, double gamma,
                     const double *v, double *to)
{
    sum_up(b, w, gamma);
    hold(b, w);
    band_multiply(w->sum, v, to);
}

void bending_join(const struct bending *b, struct bending_work *w, double gamma)
{
    sum_up(b, w, gamma);
}

void bending_join_point(struct bending_work *w, int first, const double *shape, double c)
{
    double block[4][4];

    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            block[i][k] = c * shape[i] * shape[k];
    band_add_block(w->sum, first, 4, &block[0][0]);
}

int bending_joined(const struct bending *b, struct bending_work *w)
{
    hold(b, w);
    return band_factor_set(w->joint, w->sum);
}

void bending_join_solve(const struct bending_work *w, double *x)
{
    band_factor_solve(w->joint, x);
}
