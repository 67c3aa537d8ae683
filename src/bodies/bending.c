/* bending.c -- M q'' + D q' + K q = F of a straight beam of equal elements.
 *
 *   (41), (43)  K assembled from elements, (42) the equation of motion,
 *   M consistent, or lumped: (44) as printed, or with half masses at the ends,
 *   D = alpha M + beta K (Rayleigh) + drag I.
 *
 * (44) gives whole masses to the end nodes, n + 1 in all: the first frequency of a
 * cantilever of 10 elements is 9 % too low.  (45) is drag I alone, one number for
 * forces and moments: damping grows with the number of elements.
 *
 * The implicit solve of z - gamma f_I(z) = r eliminates positions exactly:
 *
 *   z_q = r_q + gamma z_v
 *   (M + gamma D + gamma^2 K) z_v = M r_v - gamma K r_q                    (BE1)
 *
 * one banded solve; factorizations are kept for the last few gamma.  Seed: Toth
 * 2012, section 4.  Checked in tests/unit/bending.c and beam-balance.c. */
#include "bodies/bending.h"

#include "base/status.h"
#include "bodies/bending-rates.h"
#include "bodies/element.h"
#include <stdlib.h>

enum { BANDWIDTH = 3 };

static void assemble(struct bending *b)
{
    double k[4][4], m[4][4];

    element_stiffness(b->def.EI, b->l, k);
    if (b->def.inertia == BENDING_CONSISTENT)
        element_mass(b->def.mu, b->l, m);
    else
        element_lumped(b->def.mu, b->l, m);
    for (int e = 0; e < b->def.elements; e++) {
        band_add_block(b->stiffness, 2 * e, 4, &k[0][0]);
        band_add_block(b->mass, 2 * e, 4, &m[0][0]);
    }
    for (int i = 0; i < 2 && b->def.inertia == BENDING_LUMPED; i++) { /* ends, whole */
        band_add(b->mass, i, i, m[i][i]);
        band_add(b->mass, b->dofs - 2 + i, b->dofs - 2 + i, m[i][i]);
    }
    band_sum(b->stiffness_free, 1, b->stiffness, 0, b->mass);
    band_sum(b->mass_free, 1, b->mass, 0, b->stiffness);
    for (int i = 0; i < b->dofs; i++)
        if (bending_held(b, i)) {
            band_hold(b->stiffness_free, i, 0);
            band_hold(b->mass_free, i, 1);
        }
}

static int take_memory(struct bending *b)
{
    struct band **matrix[] = { &b->mass, &b->stiffness, &b->mass_free, &b->stiffness_free,
                               &b->sum };

    for (size_t i = 0; i < sizeof matrix / sizeof matrix[0]; i++)
        TRY(band_create(b->dofs, BANDWIDTH, matrix[i]));
    TRY(band_factor_create(b->dofs, BANDWIDTH, &b->mass_factor));
    for (int i = 0; i < BENDING_FACTORS; i++)
        TRY(band_factor_create(b->dofs, BANDWIDTH, &b->kept[i].factor));
    TRY(band_factor_create(b->dofs, BANDWIDTH, &b->joint));
    b->work = status_alloc((unsigned long)b->dofs * 2, sizeof *b->work);
    return b->work ? STATUS_DONE : STATUS_FAILED;
}

int bending_create(const struct bending_def *def, struct bending **out)
{
    struct bending *b = status_alloc(1, sizeof *b);
    int code = STATUS_FAILED;

    if (!b)
        return code;
    b->def = *def;
    b->dofs = 2 * (def->elements + 1);
    b->l = def->length / def->elements;
    code = take_memory(b);
    if (code == STATUS_DONE) {
        assemble(b);
        b->fastest = bending_rates_fastest(b);
        b->decay = bending_rates_decay(b);
        code = band_factor_set(b->mass_factor, b->mass_free);
    }
    if (code != STATUS_DONE)
        bending_free(&b);
    *out = b;
    return code;
}

void bending_free(struct bending **b)
{
    if (!*b)
        return;
    band_free(&(*b)->mass);
    band_free(&(*b)->stiffness);
    band_free(&(*b)->mass_free);
    band_free(&(*b)->stiffness_free);
    band_free(&(*b)->sum);
    band_factor_free(&(*b)->mass_factor);
    for (int i = 0; i < BENDING_FACTORS; i++)
        band_factor_free(&(*b)->kept[i].factor);
    band_factor_free(&(*b)->joint);
    free((*b)->work);
    free(*b);
    *b = NULL;
}

double bending_shift(const struct bending *b, double *to)
{
    double mass = 0;

    for (int i = 0; i < b->dofs; i++)
        b->work[i] = i % 2 == 0;
    band_multiply(b->mass, b->work, to);
    for (int i = 0; i < b->dofs; i += 2)
        mass += to[i];
    return mass;
}

/* K q + D v = K (q + beta v) + alpha M v + drag v. */
void bending_resist(const struct bending *b, const double *q, const double *v, double *to)
{
    double *bent = b->work, *push = b->work + b->dofs;

    for (int i = 0; i < b->dofs; i++)
        bent[i] = q[i] + b->def.beta * v[i];
    band_multiply(b->stiffness, bent, to);
    band_multiply(b->mass, v, push);
    for (int i = 0; i < b->dofs; i++)
        to[i] += b->def.alpha * push[i] + b->def.drag * v[i];
}

void bending_accelerate(const struct bending *b, double *f)
{
    for (int i = 0; i < b->dofs; i++)
        if (bending_held(b, i))
            f[i] = 0;
    band_factor_solve(b->mass_factor, f);
}

/* To the scratch matrix: M + gamma D + gamma^2 K. */
static void sum_up(struct bending *b, double gamma)
{
    band_sum(b->sum, 1 + gamma * b->def.alpha, b->mass_free,
             gamma * (b->def.beta + gamma), b->stiffness_free);
    bending_rates_drag(b, gamma * b->def.drag);
}

static void hold(struct bending *b)
{
    for (int i = 0; i < b->dofs; i++)
        if (bending_held(b, i))
            band_hold(b->sum, i, 1);
}

/* The factorization of M + gamma D + gamma^2 K: kept, or made anew over the oldest. */
static int factor_of(struct bending *b, double gamma, const struct band_factor **out)
{
    for (int i = 0; i < BENDING_FACTORS; i++)
        if (b->kept[i].set && b->kept[i].gamma == gamma) {
            *out = b->kept[i].factor;
            return STATUS_DONE;
        }
    struct bending_factor *f = &b->kept[b->oldest];

    b->oldest = (b->oldest + 1) % BENDING_FACTORS;
    sum_up(b, gamma);
    hold(b);
    f->set = false;
    TRY(band_factor_set(f->factor, b->sum));
    f->set = true;
    f->gamma = gamma;
    *out = f->factor;
    return STATUS_DONE;
}

void bending_right(struct bending *b, double gamma, const double *q, double *v)
{
    double *pull = b->work, *push = b->work + b->dofs;

    band_multiply(b->stiffness_free, q, pull);
    band_multiply(b->mass_free, v, push);
    for (int i = 0; i < b->dofs; i++)
        v[i] = push[i] - gamma * pull[i];
}

int bending_solve(struct bending *b, double gamma, double *q, double *v)
{
    const struct band_factor *f;

    TRY(factor_of(b, gamma, &f));
    bending_right(b, gamma, q, v);
    band_factor_solve(f, v);
    for (int i = 0; i < b->dofs; i++)
        if (!bending_held(b, i))
            q[i] += gamma * v[i];
    return STATUS_DONE;
}

void bending_inertia(struct bending *b, double gamma, const double *v, double *to)
{
    sum_up(b, gamma);
    hold(b);
    band_multiply(b->sum, v, to);
}

void bending_join(struct bending *b, double gamma)
{
    sum_up(b, gamma);
}

void bending_join_point(struct bending *b, int first, const double *shape, double c)
{
    double block[4][4];

    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            block[i][k] = c * shape[i] * shape[k];
    band_add_block(b->sum, first, 4, &block[0][0]);
}

int bending_joined(struct bending *b)
{
    hold(b);
    return band_factor_set(b->joint, b->sum);
}

void bending_join_solve(const struct bending *b, double *x)
{
    band_factor_solve(b->joint, x);
}

double bending_kinetic(const struct bending *b, const double *v)
{
    return 0.5 * band_form(b->mass, v);
}

double bending_elastic(const struct bending *b, const double *q)
{
    return 0.5 * band_form(b->stiffness, q);
}

double bending_damping(const struct bending *b, const double *v)
{
    double squares = 0;

    for (int i = 0; i < b->dofs; i++)
        squares += v[i] * v[i];
    return -b->def.alpha * band_form(b->mass, v) - b->def.beta * band_form(b->stiffness, v)
         - b->def.drag * squares;
}
