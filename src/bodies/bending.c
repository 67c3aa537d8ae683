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
 * The implicit solve is in bending-solve.c.  Source: Toth (2012), section 4.
 * Checked in tests/unit/bending.c and beam-balance.c. */
#include "bodies/bending.h"

#include "base/status.h"
#include "bodies/bending-rates.h"
#include "bodies/element.h"
#include <stdlib.h>

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
    struct band **matrix[] = { &b->mass, &b->stiffness, &b->mass_free, &b->stiffness_free };

    for (size_t i = 0; i < sizeof matrix / sizeof matrix[0]; i++)
        TRY(band_create(b->dofs, BENDING_WIDTH, matrix[i]));
    TRY(band_factor_create(b->dofs, BENDING_WIDTH, &b->mass_factor));
    b->shift = status_alloc((unsigned long)b->dofs, sizeof *b->shift);
    return b->shift ? STATUS_DONE : STATUS_FAILED;
}

/* With scratch that is not needed later. */
static void derive(struct bending *b, struct bending_work *w)
{
    for (int i = 0; i < b->dofs; i++)
        w->vector[i] = i % 2 == 0;
    band_multiply(b->mass, w->vector, b->shift);
    b->fastest = bending_rates_fastest(b, w);
    b->decay = bending_rates_decay(b, w);
}

static int build(struct bending *b)
{
    struct bending_work *w;

    TRY(take_memory(b));
    assemble(b);
    TRY(bending_work_create(b, &w));
    derive(b, w);
    bending_work_free(&w);
    return band_factor_set(b->mass_factor, b->mass_free);
}

int bending_create(const struct bending_def *def, struct bending **out)
{
    struct bending *b = status_alloc(1, sizeof *b);
    int code;

    if (!b)
        return STATUS_FAILED;
    b->def = *def;
    b->dofs = 2 * (def->elements + 1);
    b->l = def->length / def->elements;
    code = build(b);
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
    band_factor_free(&(*b)->mass_factor);
    free((*b)->shift);
    free(*b);
    *b = NULL;
}

double bending_mass(const struct bending *b)
{
    double mass = 0;

    for (int i = 0; i < b->dofs; i += 2)
        mass += b->shift[i];
    return mass;
}

void bending_accelerate(const struct bending *b, double *f)
{
    for (int i = 0; i < b->dofs; i++)
        if (bending_held(b, i))
            f[i] = 0;
    band_factor_solve(b->mass_factor, f);
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
