/* cvode-create.c -- sets a CVODE up: everything is said, nothing is left to
 * defaults, which change from version to version. */
#include "time/cvode.h"

#include "base/status.h"
#include "time/failure.h"
#include <math.h>
#include <stdlib.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

enum { KRYLOV = 5 }; /* directions of a linear solve; it is not begun again with more */

/* --- what CVODE asks for -------------------------------------------------- */

/* 1: try a shorter step. */
static int rates(sunrealtype t, N_Vector y, N_Vector ydot, void *self)
{
    struct cvode *c = self;

    return rates_ask(&c->rates, t, vector_data(y), vector_data(ydot)) == STATUS_DONE ? 0 : 1;
}

/* Constant weights. */
static int weights(N_Vector y, N_Vector weight, void *self)
{
    struct cvode *c = self;

    (void)y;
    vector_take(weight, vector_read(c->weight));
    return 0;
}

/* The preconditioner, z - gamma f_I(z) = r: the stiff side is linear in z, and takes
 * all stiffness but that of sound out of what the Krylov solver has to find. */
static int precondition(sunrealtype t, N_Vector y, N_Vector f, N_Vector r, N_Vector z,
                        sunrealtype gamma, sunrealtype delta, int left, void *self)
{
    struct cvode *c = self;

    (void)y, (void)f, (void)delta, (void)left;
    vector_take(z, vector_read(r));
    if (moment_solve(c->rates.moment, t, gamma, vector_data(r), vector_data(z)) == STATUS_DONE)
        return 0;
    status_clear();
    return 1;
}

/* --- settings ------------------------------------------------------------- */

/* SPGMR measures what is left by its sum of squares.  Times this, a tolerance in the
 * norm of the error test is one for that sum, so that no single particle's equation
 * stays unsolved: with CVODE's own sqrt(n) the norm "max" lets steps collapse. */
static double squares_per_norm(const struct cvode *c)
{
    const double n = (double)c->n;

    switch (c->def.norm) {
    case VECTOR_NORM_P8:
        return pow(n, 0.125);
    case VECTOR_NORM_WRMS:
        return sqrt(n);
    default:
        return 1;
    }
}

static int set_newton(struct cvode *c)
{
    const bool stiff = plan_stiff(moment_plan(c->rates.moment));
    int bad = 0;

    c->solver = SUNNonlinSol_Newton(c->y, c->context);
    c->linear = SUNLinSol_SPGMR(c->y, stiff ? SUN_PREC_LEFT : SUN_PREC_NONE, KRYLOV, c->context);
    if (!c->solver || !c->linear)
        return cvode_refuse(c, "a Newton-Krylov solver");
    bad |= SUNLinSol_SPGMRSetMaxRestarts(c->linear, 0);
    bad |= CVodeSetNonlinearSolver(c->cvode, c->solver);
    bad |= CVodeSetLinearSolver(c->cvode, c->linear, NULL);
    bad |= CVodeSetEpsLin(c->cvode, 0.05);
    bad |= CVodeSetLSNormFactor(c->cvode, squares_per_norm(c));
    if (stiff)
        bad |= CVodeSetPreconditioner(c->cvode, NULL, precondition);
    return bad ? cvode_refuse(c, "a Newton-Krylov solver") : STATUS_DONE;
}

static int set_fixed_point(struct cvode *c)
{
    c->solver = SUNNonlinSol_FixedPoint(c->y, 0, c->context);
    if (!c->solver || CVodeSetNonlinearSolver(c->cvode, c->solver) != 0)
        return cvode_refuse(c, "a fixed-point solver");
    return STATUS_DONE;
}

static int set_control(struct cvode *c)
{
    int bad = CVodeSetMaxOrd(c->cvode, c->row->order[plan_stiff(moment_plan(c->rates.moment))]);

    bad |= CVodeSetMaxNonlinIters(c->cvode, 3);
    bad |= CVodeSetNonlinConvCoef(c->cvode, 0.1);
    bad |= CVodeSetMaxErrTestFails(c->cvode, 30); /* 7 are too few at impacts */
    bad |= CVodeSetMaxConvFails(c->cvode, 30);
    bad |= CVodeSetMaxNumSteps(c->cvode, 1000000);
    bad |= CVodeSetMaxHnilWarns(c->cvode, -1);
    return bad ? cvode_refuse(c, "the settings of its step control") : STATUS_DONE;
}

static int set_up(struct cvode *c)
{
    c->cvode = CVodeCreate(c->row->family, c->context);
    if (!c->cvode || sundials_listen_cvode(c->cvode) != 0
        || CVodeInit(c->cvode, rates, c->t, c->y) != 0 || CVodeSetUserData(c->cvode, c) != 0
        || CVodeWFtolerances(c->cvode, weights) != 0)
        return cvode_refuse(c, "to begin");
    TRY(set_control(c));
    return c->row->newton ? set_newton(c) : set_fixed_point(c);
}

/* --- memory ---------------------------------------------------------------- */

static int take_memory(struct cvode *c)
{
    const struct vector_own own = moment_own(c->rates.moment);

    c->y = vector_create_own(c->n, c->def.norm, c->context, &own);
    if (!c->y)
        return STATUS_FAILED;
    c->weight = N_VClone(c->y);
    c->spare = N_VClone(c->y);
    if (!c->weight || !c->spare)
        return failure_memory(c->row->method.name, c->n);
    moment_weights(c->rates.moment, c->def.tol, vector_data(c->weight));
    return STATUS_DONE;
}

static int build(struct cvode *c, double t, const double *y)
{
    TRY(sundials_open(&c->context));
    TRY(take_memory(c));
    TRY(cvode_restart(c, t, y, NULL));
    return set_up(c);
}

int cvode_create(const struct method *m, const struct method_def *def, struct moment *moment,
                 double t, const double *y, void **out)
{
    struct cvode *c = status_alloc(1, sizeof *c);
    int code;

    *out = c;
    if (!c)
        return STATUS_FAILED;
    c->row = (const struct cvode_row *)m; /* its first member */
    c->def = *def;
    c->rates.moment = moment;
    c->n = moment_size(moment);
    code = build(c, t, y);
    if (code != STATUS_DONE)
        cvode_free(out);
    return code;
}

void cvode_free(void **self)
{
    struct cvode *c = *self;

    if (!c)
        return;
    if (c->cvode)
        CVodeFree(&c->cvode);
    if (c->solver)
        SUNNonlinSolFree(c->solver);
    if (c->linear)
        SUNLinSolFree(c->linear);
    N_Vector const vector[] = { c->y, c->weight, c->spare };
    for (int i = 0; i < 3; i++)
        if (vector[i])
            N_VDestroy(vector[i]);
    sundials_close(&c->context);
    free(c);
    *self = NULL;
}

/* Of SUNDIALS' own, counted in 6.4.1: weights, correction, rates, four to work in; with
 * Newton its correction, the Krylov basis and four more, else three of the iteration. */
enum { OF_CVODE = 7, OF_NEWTON = 1 + (KRYLOV + 1) + 4, OF_FIXED_POINT = 3, OURS = 3 };

int cvode_vectors(const struct method *m, const struct plan *plan)
{
    const struct cvode_row *row = (const struct cvode_row *)m;

    (void)plan; /* CVODE takes room for its highest order before it hears of a lower one */
    return OURS + OF_CVODE + row->order[0] + 1 + (row->newton ? OF_NEWTON : OF_FIXED_POINT);
}
