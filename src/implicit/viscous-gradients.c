/* viscous-gradients.c -- (BV1) by the conjugate gradients of SUNDIALS, SUNLinSol_PCG.
 *
 * What they search in is kept from the directions of viscous-directions.c by their
 * preconditioner.  That is also where they are told to stop, which needs no product
 * more: a largest correction says how wrong velocities are, of the fluid and of beams
 * alike, while their own stop, a norm of residuals, knows nothing of beams, whose soft
 * modes are a millionth of a residual. */
#include "implicit/viscous.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sunlinsol/sunlinsol_pcg.h>

enum { PRODUCTS = 1000 }; /* of one solve at most */

static const double exact = 0.01; /* of tol: the largest correction left */

/* What the callbacks of one solve know. */
struct search {
    struct moment *moment;
    double gamma, floor, left;
    bool enough;
};

static int multiply(void *self, N_Vector v, N_Vector image)
{
    const struct search *s = self;

    viscous_apply(s->moment, s->gamma, vector_read(v), vector_overwrite(image));
    return 0;
}

/* Positive: stop here, what was found so far stands. */
static int precondition(void *self, N_Vector residual, N_Vector near, sunrealtype tol, int side)
{
    struct search *s = self;
    struct moment *m = s->moment;
    struct viscous *u = viscous_of(m);
    double *to = vector_overwrite(near), rz;

    (void)tol, (void)side;
    vector_copy(u->unknowns, vector_read(residual), u->residual);
    viscous_directions_clear(m, s->gamma, u->residual); /* of rounding */
    s->left = viscous_precondition(m, s->gamma, u->residual, to);
    rz = vector_dot(u->unknowns, u->residual, to, u->partial);
    if (!isfinite(rz))
        return -1;
    s->enough = s->left <= exact * u->tol || rz <= s->floor;
    viscous_directions_leave(m, s->gamma, to);
    return s->enough;
}

static int refuse(struct moment *m, double t, double left, int products)
{
    snprintf(m->refusal, sizeof m->refusal, "%s, taken implicitly, found no velocities at "
             "t = %g s: after %d products the largest correction is still %.3g of its scale (tol "
             "%g)", viscous_of(m)->part->path, t, products, left, viscous_of(m)->tol);
    return STATUS_FAILED;
}

/* What is left along the directions goes into x. */
static void project(struct moment *m, double gamma)
{
    struct viscous *u = viscous_of(m);
    const struct viscous_along along = viscous_directions_clear(m, gamma, u->residual);

    viscous_directions_add(u, &along, u->x);
}

/* The correction of x, and the residual that it leaves. */
static void take(struct moment *m, double gamma)
{
    struct viscous *u = viscous_of(m);
    const double *correction = vector_read(u->search.correction);

    for (int i = 0; i < u->unknowns; i++)
        u->x[i] += correction[i];
    vector_copy(u->unknowns, vector_read(SUNLinSolResid(u->search.gradients)), u->residual);
    project(m, gamma);
}

int viscous_iterate(struct moment *m, double t, double gamma)
{
    struct viscous *u = viscous_of(m);
    struct search s = { .moment = m, .gamma = gamma };
    int code;

    s.floor = 1e-30 * fabs(vector_dot(u->unknowns, u->right, u->x, u->partial));
    viscous_directions_set(m, gamma);
    project(m, gamma);
    vector_copy(u->unknowns, u->residual, vector_overwrite(u->search.b));
    N_VConst(0, u->search.correction);
    SUNLinSolSetATimes(u->search.gradients, &s, multiply);
    SUNLinSolSetPreconditioner(u->search.gradients, &s, NULL, precondition);
    SUNLinSolSetZeroGuess(u->search.gradients, 1);
    code = SUNLinSolSolve(u->search.gradients, NULL, u->search.correction, u->search.b, 0);
    if (code != 0 && !s.enough)
        return refuse(m, t, s.left, SUNLinSolNumIters(u->search.gradients));
    take(m, gamma);
    return STATUS_DONE;
}

int viscous_gradients_make(struct viscous *u)
{
    TRY(sundials_open(&u->search.context));
    u->search.b = vector_create(u->unknowns, VECTOR_NORM_MAX, u->search.context);
    if (!u->search.b)
        return STATUS_FAILED;
    u->search.correction = N_VClone(u->search.b);
    u->search.gradients = SUNLinSol_PCG(u->search.b, SUN_PREC_LEFT, PRODUCTS, u->search.context);
    if (!u->search.correction || !u->search.gradients)
        return status_fail(STATUS_FAILED, "no memory to solve for %d velocities", u->unknowns);
    return STATUS_DONE;
}

void viscous_gradients_free(struct viscous *u)
{
    if (u->search.gradients)
        SUNLinSolFree(u->search.gradients);
    if (u->search.correction)
        N_VDestroy(u->search.correction);
    if (u->search.b)
        N_VDestroy(u->search.b);
    sundials_close(&u->search.context);
}
