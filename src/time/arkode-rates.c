/* arkode-rates.c -- f for ARKStep, and the implicit solve of a stage.
 *
 * ARKStep must not hear that f has no answer: a positive return from an explicit
 * right-hand side ends the run in 6.4.1.  It gets NaN instead, whose norm no error
 * test lets pass, and so tries a shorter step. */
#include "time/arkode.h"

#include "base/status.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

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
             said ? status_message() : plan_refusal(a->plan));
    status_clear();
}

static int ask(struct arkode *a, double t, const double *y, double *f)
{
    const int code = plan_rhs(a->plan, a->imex ? PLAN_EXPLICIT : PLAN_ALL, t, y, f);

    if (code != STATUS_DONE)
        keep_refusal(a);
    return code;
}

int arkode_rates(struct arkode *a)
{
    struct arkode_node *now = &a->node[0];

    if (now->has_f)
        return STATUS_DONE;
    TRY(ask(a, now->t, vector_data(now->y), now->f));
    now->has_f = true;
    return STATUS_DONE;
}

static bool same(long n, const double *x, const double *y)
{
    return memcmp(x, y, (size_t)n * sizeof *x) == 0;
}

/* Is this the first stage, at the state that the last step reached?  Then f may
 * be known from dense output or from an attempt that was rejected. */
static bool at_start(const struct arkode *a, double t, const double *y)
{
    return t == a->node[0].t && same(a->n, y, vector_data(a->node[0].y));
}

static int stage_rates(struct arkode *a, double t, const double *y, double *f)
{
    if (at_start(a, t, y)) {
        a->stage = 0;
        TRY(arkode_rates(a));
        vector_copy(a->n, a->node[0].f, f);
        return STATUS_DONE;
    }
    TRY(ask(a, t, y, f));
    if (++a->stage == a->table.stages - 1 && a->last_y) {
        vector_copy(a->n, y, a->last_y);
        a->last_t = t;
        a->last_f = f;
    }
    return STATUS_DONE;
}

int arkode_explicit(sunrealtype t, N_Vector y, N_Vector ydot, void *self)
{
    if (stage_rates(self, t, vector_data(y), vector_data(ydot)) != STATUS_DONE)
        N_VConst(NAN, ydot);
    return 0;
}

int arkode_implicit(sunrealtype t, N_Vector y, N_Vector ydot, void *self)
{
    struct arkode *a = self;

    if (plan_rhs(a->plan, PLAN_IMPLICIT, t, vector_data(y), vector_data(ydot)) != STATUS_DONE) {
        keep_refusal(a);
        N_VConst(NAN, ydot);
    }
    return 0;
}

/* First same as last: bit by bit the same state, so the same rates. */
void arkode_reuse_last_stage(struct arkode *a)
{
    struct arkode_node *now = &a->node[0];

    if (a->last_f && fabs(a->last_t - now->t) <= 1e-12 * fabs(now->t)
        && same(a->n, a->last_y, vector_data(now->y))) {
        vector_copy(a->n, a->last_f, now->f);
        now->has_f = true;
    }
    a->last_f = NULL;
}

/* --- the implicit side --------------------------------------------------- */

/* One stage: z - gamma f_I(t, z) = r with r = zpred + sdata, and zcor = z - zpred.
 * Where f_I is zero that is zcor = sdata; the rest is the plan's to solve. */
static int solve(SUNNonlinearSolver solver, N_Vector zpred, N_Vector zcor, N_Vector w,
                 sunrealtype tolerance, sunbooleantype setup, void *ark)
{
    struct arkode *a = solver->content;
    N_Vector same_zpred, z, fi, sdata;
    sunrealtype t, gamma;
    void *user;
    int code;

    (void)w, (void)tolerance, (void)setup;
    if (ARKodeGetNonlinearSystemData(ark, &t, &same_zpred, &z, &fi, &gamma, &sdata, &user) != 0)
        return -1;
    vector_copy(a->n, vector_data(sdata), vector_data(zcor));
    if (plan_viscous(a->plan)) /* wants all of r */
        vector_combine(2, (double[]){ 1, 1 },
                       (const double *[]){ vector_data(zpred), vector_data(sdata) }, a->n,
                       a->right);
    for (int k = 0; k < a->ranges; k++)
        for (long i = a->range[k][0]; i < a->range[k][1]; i++) {
            a->z[i] = vector_data(zpred)[i];
            a->right[i] = a->z[i] + vector_data(sdata)[i];
        }
    code = plan_solve(a->plan, t, gamma, a->right, a->z);
    if (code != STATUS_DONE)
        keep_refusal(a);
    for (int k = 0; k < a->ranges; k++)
        for (long i = a->range[k][0]; i < a->range[k][1]; i++)
            vector_data(zcor)[i] = code == STATUS_DONE ? a->z[i] - vector_data(zpred)[i] : NAN;
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
