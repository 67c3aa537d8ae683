/* arkode-rates.c -- f for ARKStep, and the implicit solve of a stage.
 *
 * ARKStep must not hear that f has no answer: a positive return from an explicit
 * right-hand side ends the run in 6.4.1.  It gets NaN instead, whose norm no error
 * test lets pass, and so tries a shorter step. */
#include "time/arkode.h"

#include "base/status.h"
#include <math.h>
#include <stdio.h>

/* The first reason of an attempt: the NaN that stands for it makes later stages
 * refuse as well. */
static void keep_refusal(struct arkode *a)
{
    const bool said = status_message()[0] != '\0'; /* of memory, or of a solve */

    if (a->refusal[0]) {
        status_clear();
        return;
    }
    snprintf(a->refusal, sizeof a->refusal, "%.319s",
             said ? status_message() : moment_refusal(a->moment));
    status_clear();
}

static int ask(struct arkode *a, double t, const double *y, double *f)
{
    const int code = moment_eval(a->moment, a->imex ? ASK_EXPLICIT_SIDE : ASK_ALL, t, y, f);

    if (code != STATUS_DONE)
        keep_refusal(a);
    return code;
}

/* A pass over pairs gives both sides. */
static int ask_both(struct arkode *a, double t, const double *y, double *f)
{
    struct ask both = ASK_ALL;
    int code;

    both.apart = vector_overwrite(a->stiff.start);
    code = moment_eval(a->moment, both, t, y, f);
    if (code != STATUS_DONE)
        keep_refusal(a);
    else
        vector_only_inside(a->stiff.start);
    a->stiff.has_start = code == STATUS_DONE;
    return code;
}

int arkode_rates(struct arkode *a)
{
    struct arkode_node *now = &a->node[0];
    const double *y;

    if (now->has_f)
        return STATUS_DONE;
    y = vector_read(now->y);
    TRY((a->stiff.start ? ask_both : ask)(a, now->t, y, vector_overwrite(now->f)));
    now->has_f = true;
    return STATUS_DONE;
}

/* Is this the first stage, at the state that the last step reached?  Then f may
 * be known from dense output or from an attempt that was rejected. */
static bool at_start(const struct arkode *a, double t, N_Vector y)
{
    return t == a->node[0].t && vector_same(y, a->node[0].y);
}

/* The solve of the last stage is over: no sum need be kept for it. */
static void forget_solve(struct arkode *a)
{
    if (!a->stiff.correction)
        return;
    N_VConst(0, a->stiff.correction);
    N_VConst(0, a->stiff.right);
    a->stiff.correction = NULL;
}

static int stage_rates(struct arkode *a, double t, N_Vector y, N_Vector f)
{
    if (at_start(a, t, y)) {
        a->stage = 0;
        forget_solve(a);
        TRY(arkode_rates(a));
        N_VScale(1, a->node[0].f, f);
        return STATUS_DONE;
    }
    TRY(ask(a, t, vector_read(y), vector_overwrite(f)));
    if (++a->stage == a->table.stages - 1 && a->last.y) {
        N_VScale(1, y, a->last.y);
        N_VScale(1, f, a->last.f);
        a->last.t = t;
        a->last.known = true;
    }
    return STATUS_DONE;
}

int arkode_explicit(sunrealtype t, N_Vector y, N_Vector ydot, void *self)
{
    if (stage_rates(self, t, y, ydot) != STATUS_DONE)
        N_VConst(NAN, ydot);
    return 0;
}

/* Once: an attempt after a rejected one is to ask, so that the plan hears that solves
 * begin anew. */
static bool take_start(struct arkode *a, double t, N_Vector y, N_Vector ydot)
{
    if (!a->stiff.start || !at_start(a, t, y) || arkode_rates(a) != STATUS_DONE
        || !a->stiff.has_start)
        return false;
    N_VScale(1, a->stiff.start, ydot);
    a->stiff.has_start = false;
    return true;
}

int arkode_implicit(sunrealtype t, N_Vector y, N_Vector ydot, void *self)
{
    struct arkode *a = self;

    if (take_start(a, t, y, ydot))
        return 0;
    if (moment_eval(a->moment, ASK_IMPLICIT_SIDE, t, vector_read(y), vector_overwrite(ydot))
        == STATUS_DONE) {
        vector_only_inside(ydot);
        return 0;
    }
    keep_refusal(a);
    N_VConst(NAN, ydot);
    return 0;
}

/* First same as last: bit by bit the same state, so the same rates. */
void arkode_reuse_last_stage(struct arkode *a)
{
    struct arkode_node *now = &a->node[0];

    if (a->last.known && fabs(a->last.t - now->t) <= 1e-12 * fabs(now->t)
        && vector_same(a->last.y, now->y)) {
        N_VScale(1, a->last.f, now->f);
        now->has_f = true;
    }
    a->last.known = false;
}

/* --- the implicit side --------------------------------------------------- */

/* One stage: z - gamma f_I(t, z) = r with r = zpred + sdata, and zcor = z - zpred.
 * Where f_I is zero that is zcor = sdata; the rest is the plan's to solve. */
static int solve(SUNNonlinearSolver solver, N_Vector zpred, N_Vector zcor, N_Vector w,
                 sunrealtype tolerance, sunbooleantype setup, void *ark)
{
    struct arkode *a = solver->content;
    N_Vector same_zpred, z, fi, sdata;
    const double *guess, *right;
    double *correction;
    sunrealtype t, gamma;
    void *user;
    int code;

    (void)w, (void)tolerance, (void)setup;
    if (ARKodeGetNonlinearSystemData(ark, &t, &same_zpred, &z, &fi, &gamma, &sdata, &user) != 0)
        return -1;
    N_VLinearSum(1, zpred, 1, sdata, a->stiff.right);
    right = plan_viscous(a->plan) ? vector_read(a->stiff.right) : vector_inside(a->stiff.right);
    guess = vector_inside(zpred);
    for (int k = 0; k < a->stiff.ranges; k++)
        for (long i = a->stiff.range[k][0]; i < a->stiff.range[k][1]; i++)
            a->stiff.z[i] = guess[i];
    code = moment_solve(a->moment, t, gamma, right, a->stiff.z);
    if (code != STATUS_DONE)
        keep_refusal(a);
    a->stiff.correction = zcor;
    correction = vector_like(sdata, zcor);
    guess = vector_inside(zpred);
    for (int k = 0; k < a->stiff.ranges; k++)
        for (long i = a->stiff.range[k][0]; i < a->stiff.range[k][1]; i++)
            correction[i] = code == STATUS_DONE ? a->stiff.z[i] - guess[i] : NAN;
    return 0;
}

static SUNNonlinearSolver_Type type(SUNNonlinearSolver solver)
{
    (void)solver;
    return SUNNONLINEARSOLVER_ROOTFIND;
}

static int initialize(SUNNonlinearSolver solver)
{
    (void)solver;
    return 0;
}

static int ignore_system(SUNNonlinearSolver solver, SUNNonlinSolSysFn function)
{
    (void)solver, (void)function;
    return 0;
}

static int ignore_linear(SUNNonlinearSolver solver, SUNNonlinSolLSolveFn function)
{
    (void)solver, (void)function;
    return 0;
}

static int count_none(SUNNonlinearSolver solver, long *iterations)
{
    (void)solver;
    *iterations = 0;
    return 0;
}

static int free_solver(SUNNonlinearSolver solver)
{
    SUNNonlinSolFreeEmpty(solver);
    return 0;
}

SUNNonlinearSolver arkode_solver(struct arkode *a)
{
    SUNNonlinearSolver solver = SUNNonlinSolNewEmpty(a->context);

    if (!solver)
        return NULL;
    solver->content = a;
    solver->ops->gettype = type;
    solver->ops->initialize = initialize;
    solver->ops->solve = solve;
    solver->ops->setsysfn = ignore_system;
    solver->ops->setlsolvefn = ignore_linear;
    solver->ops->getnumiters = count_none;
    solver->ops->getnumconvfails = count_none;
    solver->ops->free = free_solver;
    return solver;
}
