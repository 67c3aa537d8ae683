/* elastica.c -- M q'' + D q' + dE/dq = F of a beam of equal elements that bends far; its
 * implicit solve is in elastica-solve.c.  Checked in tests/unit/elastica*.c. */
#include "bodies/elastica.h"

#include "base/status.h"
#include "bodies/elastica-friction.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BANDWIDTH = ELASTICA_ELEMENT - 1 };

bool elastica_held(const struct elastica *e, int dof)
{
    const int last = e->dofs - ELASTICA_NODE, entry = dof % ELASTICA_NODE;

    if (dof >= ELASTICA_NODE && dof < last)
        return false;
    const enum bending_end end = dof < last ? e->def.bending.root : e->def.bending.tip;
    return (end != BENDING_FREE && entry < 2) || (end == BENDING_CLAMPED && entry == 3);
}

/* Rows of the linear beam's mass, once for each component. */
static void spread_mass(struct elastica *e)
{
    const struct band *m = e->plane->mass;

    for (int i = 0; i < m->n; i++)
        for (int j = i; j <= i + m->half && j < m->n; j++)
            for (int c = 0; c < 2; c++)
                band_add(e->mass, 2 * i + c, 2 * j + c, band_at(m, i, j));
}

void elastica_hold(const struct elastica *e, struct elastica_work *w)
{
    for (int i = 0; i < e->dofs; i++)
        if (elastica_held(e, i)) {
            band_hold(w->sum, i, 1);
            if (w->skew)
                band_hold(w->skew, i, 0);
        }
}

static int take_work(const struct elastica *e, struct elastica_work *w)
{
    TRY(band_create(e->dofs, BANDWIDTH, &w->tangent));
    TRY(band_create(e->dofs, BANDWIDTH, &w->sum));
    if (e->def.bending.beta > 0)
        TRY(band_create(e->dofs, BANDWIDTH, &w->skew));
    TRY(band_factor_create(e->dofs, BANDWIDTH, &w->factor));
    w->vector = status_alloc((unsigned long)e->dofs * 3, sizeof *w->vector);
    return w->vector ? STATUS_DONE : STATUS_FAILED;
}

int elastica_work_create(const struct elastica *e, struct elastica_work **out)
{
    struct elastica_work *w = status_alloc(1, sizeof *w);

    *out = w;
    if (!w)
        return STATUS_FAILED;
    if (take_work(e, w) == STATUS_DONE)
        return STATUS_DONE;
    elastica_work_free(out);
    return STATUS_FAILED;
}

void elastica_work_free(struct elastica_work **w)
{
    if (!*w)
        return;
    band_free(&(*w)->tangent);
    band_free(&(*w)->sum);
    band_free(&(*w)->skew);
    band_factor_free(&(*w)->factor);
    free((*w)->vector);
    free(*w);
    *w = NULL;
}

/* Largest frequency at rest: the least lambda for which lambda M - d2E/dq2 is positive
 * definite.  None exceeds the largest of a free element: of one that bends see bending-rates.c,
 * one that stretches has lambda mu l^2/EA = 379 with its consistent mass, 9.47 with the
 * lumped ones, where its ends move apart while its middle shrinks. */
static double fastest(const struct elastica *e, struct elastica_work *w)
{
    const struct bending_def *b = &e->def.bending;
    const double stretch = b->inertia == BENDING_CONSISTENT ? 379 : 9.47;
    double high = fmax(pow(e->plane->fastest, 2), stretch * e->def.EA / (b->mu * e->l * e->l));
    double low = 0;

    memset(w->vector, 0, (size_t)e->dofs * sizeof *w->vector);
    elastica_tangent(e, w, w->vector);
    while (high - low > 0.01 * high) {
        const double middle = (low + high) / 2;
        band_sum(w->sum, middle, e->mass, -1, w->tangent);
        elastica_hold(e, w);
        *(band_factor_definite(w->factor, w->sum) ? &high : &low) = middle;
    }
    return sqrt(high);
}

/* The largest frequency and the mass without held degrees of freedom. */
static int prepare(struct elastica *e, struct elastica_work *w)
{
    e->fastest = fastest(e, w);
    band_sum(w->sum, 1, e->mass, 0, e->mass);
    elastica_hold(e, w);
    return band_factor_set(e->mass_factor, w->sum);
}

static int build(struct elastica *e)
{
    const struct bending_def *b = &e->def.bending;
    struct elastica_work *w;
    int code;

    TRY(bending_create(b, &e->plane));
    TRY(band_create(e->dofs, BANDWIDTH, &e->mass));
    TRY(band_factor_create(e->dofs, BANDWIDTH, &e->mass_factor));
    elastica_element_make(e->def.EA, b->EI, e->l, &e->element);
    e->decay = e->plane->decay;
    spread_mass(e);
    TRY(elastica_work_create(e, &w));
    code = prepare(e, w);
    elastica_work_free(&w);
    return code;
}

int elastica_create(const struct elastica_def *def, struct elastica **out)
{
    struct elastica *e = status_alloc(1, sizeof *e);
    int code;

    *out = e;
    if (!e)
        return STATUS_FAILED;
    e->def = *def;
    e->dofs = ELASTICA_NODE * (def->bending.elements + 1);
    e->l = def->bending.length / def->bending.elements;
    code = build(e);
    if (code != STATUS_DONE)
        elastica_free(out);
    return code;
}

void elastica_free(struct elastica **e)
{
    if (!*e)
        return;
    bending_free(&(*e)->plane);
    band_free(&(*e)->mass);
    band_factor_free(&(*e)->mass_factor);
    free(*e);
    *e = NULL;
}

/* --- forces --------------------------------------------------------------- */

static void bend(const struct elastica *e, const double *q, double *f)
{
    memset(f, 0, (size_t)e->dofs * sizeof *f);
    for (int i = 0; i < e->def.bending.elements; i++)
        elastica_element_force(&e->element, q + ELASTICA_NODE * i, f + ELASTICA_NODE * i);
}

void elastica_resist(const struct elastica *e, struct elastica_work *w, const double *q,
                     const double *v, double *to)
{
    const struct bending_def *b = &e->def.bending;

    bend(e, q, to);
    for (int i = 0; i < b->elements && b->beta > 0; i++)
        elastica_friction_force(&e->element, b->beta, q + ELASTICA_NODE * i, v + ELASTICA_NODE * i,
                                to + ELASTICA_NODE * i);
    band_multiply(e->mass, v, w->vector);
    for (int i = 0; i < e->dofs; i++)
        to[i] += b->alpha * w->vector[i] + b->drag * v[i];
}

void elastica_tangent(const struct elastica *e, struct elastica_work *w, const double *q)
{
    double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT];

    band_sum(w->tangent, 0, e->mass, 0, e->mass);
    for (int i = 0; i < e->def.bending.elements; i++) {
        elastica_element_tangent(&e->element, q + ELASTICA_NODE * i, k);
        band_add_block(w->tangent, ELASTICA_NODE * i, ELASTICA_ELEMENT, &k[0][0]);
    }
}

void elastica_accelerate(const struct elastica *e, double *f)
{
    for (int i = 0; i < e->dofs; i++)
        if (elastica_held(e, i))
            f[i] = 0;
    band_factor_solve(e->mass_factor, f);
}

/* Across is r' turned by +90 degrees, of unit length: what is given counts per rest length. */
void elastica_follow(const struct elastica *e, double load, double tip, const double *q,
                     double *f)
{
    const int last = e->dofs - ELASTICA_NODE;
    const double a[2] = { 1 + q[last + 2], q[last + 3] }, size = hypot(a[0], a[1]);

    f[last] -= tip * a[1] / size;
    f[last + 1] += tip * a[0] / size;
    for (int i = 0; i < e->def.bending.elements; i++)
        elastica_element_press(&e->element, load, q + ELASTICA_NODE * i, f + ELASTICA_NODE * i);
}

/* --- energies ------------------------------------------------------------- */

double elastica_kinetic(const struct elastica *e, const double *v)
{
    return 0.5 * band_form(e->mass, v);
}

double elastica_elastic(const struct elastica *e, const double *q)
{
    double sum = 0;

    for (int i = 0; i < e->def.bending.elements; i++)
        sum += elastica_element_energy(&e->element, q + ELASTICA_NODE * i);
    return sum;
}

double elastica_damping(const struct elastica *e, const double *q, const double *v)
{
    const struct bending_def *b = &e->def.bending;
    double squares = 0, bending = 0;

    for (int i = 0; i < e->dofs; i++)
        squares += v[i] * v[i];
    for (int i = 0; i < b->elements && b->beta > 0; i++)
        bending += elastica_friction_power(&e->element, b->beta, q + ELASTICA_NODE * i,
                                           v + ELASTICA_NODE * i);
    return bending - b->alpha * band_form(e->mass, v) - b->drag * squares;
}
