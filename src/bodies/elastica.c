/* elastica.c -- M q'' + D q' + dE/dq = F of a beam of equal elements that bends far.
 *
 * The implicit solve of z - gamma f_I(z) = r eliminates positions, z_q = r_q + gamma z_v;
 * what is left for v = z_v is
 *
 *   R(v) = M (v - r_v) + gamma [dE/dq(r_q + gamma v) + D v] = 0                   (BE5)
 *
 * and Newton's method solves it with dR/dv = M + gamma D + gamma^2 d2E/dq2: banded,
 * symmetric, by Cholesky, or by LU where a pressed beam makes it indefinite.
 * Checked in tests/unit/elastica*.c. */
#include "bodies/elastica.h"

#include "base/status.h"
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

/* Takes held degrees of freedom out of e->sum. */
static void hold(struct elastica *e)
{
    for (int i = 0; i < e->dofs; i++)
        if (elastica_held(e, i))
            band_hold(e->sum, i, 1);
}

static int take_memory(struct elastica *e)
{
    struct band **matrix[] = { &e->mass, &e->tangent, &e->sum };

    for (size_t i = 0; i < sizeof matrix / sizeof matrix[0]; i++)
        TRY(band_create(e->dofs, BANDWIDTH, matrix[i]));
    TRY(band_factor_create(e->dofs, BANDWIDTH, &e->mass_factor));
    TRY(band_factor_create(e->dofs, BANDWIDTH, &e->factor));
    e->work = status_alloc((unsigned long)e->dofs * 3, sizeof *e->work);
    return e->work ? STATUS_DONE : STATUS_FAILED;
}

/* Largest frequency at rest: the least lambda for which lambda M - d2E/dq2 is positive
 * definite.  None exceeds the largest of a free element: of one that bends see bending.c,
 * one that stretches has lambda mu l^2/EA = 379 with its consistent mass, 9.47 with the
 * lumped ones, where its ends move apart while its middle shrinks. */
static double fastest(struct elastica *e)
{
    const struct bending_def *b = &e->def.bending;
    const double stretch = b->inertia == BENDING_CONSISTENT ? 379 : 9.47;
    double high = fmax(pow(e->plane->fastest, 2), stretch * e->def.EA / (b->mu * e->l * e->l));
    double low = 0;

    memset(e->work, 0, (size_t)e->dofs * sizeof *e->work);
    elastica_tangent(e, e->work);
    while (high - low > 0.01 * high) {
        const double middle = (low + high) / 2;
        band_sum(e->sum, middle, e->mass, -1, e->tangent);
        hold(e);
        *(band_factor_definite(e->factor, e->sum) ? &high : &low) = middle;
    }
    return sqrt(high);
}

static int build(struct elastica *e)
{
    const struct bending_def *b = &e->def.bending;

    TRY(bending_create(b, &e->plane));
    TRY(take_memory(e));
    elastica_element_make(e->def.EA, b->EI, e->l, &e->element);
    e->decay = e->plane->decay;
    spread_mass(e);
    e->fastest = fastest(e);
    band_sum(e->sum, 1, e->mass, 0, e->mass);
    hold(e);
    return band_factor_set(e->mass_factor, e->sum);
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
    band_free(&(*e)->tangent);
    band_free(&(*e)->sum);
    band_factor_free(&(*e)->mass_factor);
    band_factor_free(&(*e)->factor);
    free((*e)->work);
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

void elastica_resist(const struct elastica *e, const double *q, const double *v, double *to)
{
    const struct bending_def *b = &e->def.bending;

    bend(e, q, to);
    band_multiply(e->mass, v, e->work);
    for (int i = 0; i < e->dofs; i++)
        to[i] += b->alpha * e->work[i] + b->drag * v[i];
}

void elastica_tangent(struct elastica *e, const double *q)
{
    double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT];

    band_sum(e->tangent, 0, e->mass, 0, e->mass);
    for (int i = 0; i < e->def.bending.elements; i++) {
        elastica_element_tangent(&e->element, q + ELASTICA_NODE * i, k);
        band_add_block(e->tangent, ELASTICA_NODE * i, ELASTICA_ELEMENT, &k[0][0]);
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

/* --- solves --------------------------------------------------------------- */

/* Size of a step of Newton's method in units of the scales: deflections and rates of a
 * node, slopes as the deflection over an element. */
static double size_of(const struct elastica *e, double gamma, const double *dv)
{
    double most = 0;

    for (int i = 0; i < e->dofs; i++) {
        const double length = i % ELASTICA_NODE < 2 ? 1 : e->l;
        const double s = length * fabs(dv[i])
                       * fmax(fabs(gamma) / e->def.thickness, 1 / e->def.speed);
        if (!(s <= most))
            most = s;
    }
    return most;
}

/* The last step was below what Newton's method will square, or, when rounding keeps it
 * from shrinking, small enough. */
static bool is_there(double size, double before)
{
    return size < 1e-8 || (size < 1e-5 && size > before / 3);
}

/* -R(v) into f. */
static void lack(const struct elastica *e, double gamma, const double *rv, const double *q,
                 const double *v, double *f)
{
    double *off = e->work + e->dofs, *push = e->work;

    elastica_resist(e, q, v, f);
    for (int i = 0; i < e->dofs; i++)
        off[i] = v[i] - rv[i];
    band_multiply(e->mass, off, push);
    for (int i = 0; i < e->dofs; i++)
        f[i] = elastica_held(e, i) ? 0 : -push[i] - gamma * f[i];
}

/* e->factor for M + gamma D + gamma^2 d2E/dq2 at q. */
static int factorize(struct elastica *e, double gamma, const double *q)
{
    const struct bending_def *b = &e->def.bending;

    elastica_tangent(e, q);
    band_sum(e->sum, 1 + gamma * b->alpha, e->mass, gamma * gamma, e->tangent);
    for (int i = 0; i < e->dofs; i++)
        band_add(e->sum, i, i, gamma * b->drag);
    hold(e);
    return band_factor_set(e->factor, e->sum);
}

/* Held entries get those of r, and v what makes q the guess. */
static void begin(const struct elastica *e, double gamma, const double *rq, const double *rv,
                  double *q, double *v)
{
    for (int i = 0; i < e->dofs; i++)
        if (elastica_held(e, i) || gamma == 0) {
            q[i] = rq[i];
            v[i] = rv[i];
        } else {
            v[i] = (q[i] - rq[i]) / gamma;
        }
}

/* One step of Newton's method; its size goes to *size. */
static int iterate(struct elastica *e, double gamma, const double *rq, const double *rv, double *q,
                   double *v, double *size)
{
    double *dv = e->work + 2 * e->dofs;

    lack(e, gamma, rv, q, v, dv);
    TRY(factorize(e, gamma, q));
    band_factor_solve(e->factor, dv);
    for (int i = 0; i < e->dofs; i++)
        if (!elastica_held(e, i)) {
            v[i] += dv[i];
            q[i] = rq[i] + gamma * v[i];
        }
    *size = size_of(e, gamma, dv);
    return STATUS_DONE;
}

int elastica_solve(struct elastica *e, double gamma, const double *rq, const double *rv,
                   double *q, double *v)
{
    double size = HUGE_VAL;

    begin(e, gamma, rq, rv, q, v);
    for (int k = 0; k < ELASTICA_ITERATIONS; k++) {
        const double before = size;
        TRY(iterate(e, gamma, rq, rv, q, v, &size));
        if (is_there(size, before))
            return STATUS_DONE;
    }
    return status_fail(STATUS_FAILED, "%s: Newton's method did not find how the beam bends within "
                       "%d iterations (gamma = %g s, its last step %g of the scales): the step "
                       "is too long for so large a turn, or the beam is crushed",
                       e->def.path, ELASTICA_ITERATIONS, gamma, size);
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

double elastica_damping(const struct elastica *e, const double *v)
{
    double squares = 0;

    for (int i = 0; i < e->dofs; i++)
        squares += v[i] * v[i];
    return -e->def.bending.alpha * band_form(e->mass, v) - e->def.bending.drag * squares;
}
