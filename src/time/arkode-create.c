/* arkode-create.c -- sets an ARKStep up: everything is said, nothing is left to
 * defaults, which change from version to version. */
#include "time/arkode.h"

#include "base/status.h"
#include "time/failure.h"
#include "time/failure.h"
#include <stdlib.h>

static int refuse_setup(const struct arkode *a, const char *what)
{
    return status_fail_with(STATUS_FAILED, FAILURE_SETUP,
                       "method %s: SUNDIALS %d.%d.%d refuses %s (%s)",
                       a->row->method.name, SUNDIALS_VERSION_MAJOR, SUNDIALS_VERSION_MINOR,
                       SUNDIALS_VERSION_PATCH, what, sundials_complaint());
}

/* --- settings ------------------------------------------------------------ */

/* Constant weights: each vector is filled once. */
static int weights(N_Vector y, N_Vector weight, void *self)
{
    struct arkode *a = self;

    (void)y;
    if (a->error.weighted == weight)
        return 0;
    vector_take(weight, a->error.weight);
    a->error.weighted = weight;
    return 0;
}

/* The controller is ours, so ARKStep's own factors are put out of action; values
 * of 1 and more would bring its defaults back. */
static int set_control(struct arkode *a)
{
    const struct control_row *row = a->row->control;
    const double nearly = 1 - 1e-10;
    int bad = 0;

    bad |= sundials_control(a->ark, arkode_adapt, a);
    bad |= ARKodeSetStabilityFn(a->ark, arkode_stable, a);
    bad |= ARKodeSetCFLFraction(a->ark, nearly);
    bad |= ARKodeSetSafetyFactor(a->ark, nearly);
    bad |= ARKodeSetErrorBias(a->ark, 1);
    bad |= ARKodeSetFixedStepBounds(a->ark, 1, 1.00001);
    bad |= ARKodeSetMaxGrowth(a->ark, row->growth);
    bad |= ARKodeSetMaxFirstGrowth(a->ark, row->growth);
    bad |= ARKodeSetMinReduction(a->ark, 0.1);
    bad |= ARKodeSetMaxEFailGrowth(a->ark, 0.3);
    bad |= ARKodeSetSmallNumEFails(a->ark, 2);
    bad |= ARKodeSetMaxErrTestFails(a->ark, 30); /* 7 are too few at impacts */
    bad |= ARKodeSetMaxNumSteps(a->ark, 1000000);
    bad |= ARKodeSetMaxHnilWarns(a->ark, -1);
    if (a->def.seconds > 0) /* none of the above is asked */
        bad |= ARKodeSetFixedStep(a->ark, a->def.seconds);
    return bad ? refuse_setup(a, "the settings of its step control") : STATUS_DONE;
}

static int set_implicit(struct arkode *a)
{
    int bad = 0;

    a->solver = arkode_solver(a);
    if (!a->solver)
        return refuse_setup(a, "a nonlinear solver");
    bad |= ARKodeSetNonlinearSolver(a->ark, a->solver);
    bad |= ARKodeSetDeduceImplicitRhs(a->ark, 1);
    bad |= ARKodeSetPredictorMethod(a->ark, 0);
    return bad ? refuse_setup(a, "the implicit solve") : STATUS_DONE;
}

static int set_up(struct arkode *a)
{
    const struct arkode_node *now = &a->node[0];

    a->ark = ARKStepCreate(arkode_explicit, a->imex ? arkode_implicit : NULL, now->t, now->y,
                           a->context);
    if (!a->ark)
        return failure_memory(a->row->method.name, a->n);
    if ( sundials_listen(a->ark) != 0 || ARKodeSetUserData(a->ark, a) != 0
        || ARKodeSetInterpolantType(a->ark, SUNDIALS_INTERPOLANT) != 0
        || ARKodeSetInterpolantDegree(a->ark, 0) != 0
        || ARKodeWFtolerances(a->ark, weights) != 0)
        return refuse_setup(a, "to begin");
    if (!arkode_tables_set(a))
        return refuse_setup(a, "its tables, which are to have an error estimate");
    TRY(set_control(a));
    if (a->imex)
        TRY(set_implicit(a));
    return STATUS_DONE;
}

/* --- memory -------------------------------------------------------------- */

static double *numbers(long n)
{
    return status_alloc((unsigned long)n, sizeof(double));
}

static int take_stiff(struct arkode *a)
{
    if (!a->imex)
        return STATUS_DONE;
    a->stiff.ranges = moment_stiff_ranges(a->moment, ARKODE_RANGES, a->stiff.range);
    for (int k = 0; k < a->stiff.ranges; k++)
        a->stiff.entries += a->stiff.range[k][1] - a->stiff.range[k][0];
    a->stiff.z = numbers(a->n);
    if (!a->stiff.z)
        return STATUS_FAILED;
    for (int k = 0; k < ARKODE_PAST; k++)
        if (!(a->stiff.past[k] = numbers(a->stiff.entries)))
            return STATUS_FAILED;
    return STATUS_DONE;
}

static int take_memory(struct arkode *a)
{
    a->error.weight = numbers(a->n);
    if (!a->error.weight)
        return STATUS_FAILED;
    moment_weights(a->moment, a->def.tol * a->row->control->accept, a->error.weight);
    moment_solve_tolerance(a->moment, a->def.tol * a->row->control->accept);
    TRY(take_stiff(a));
    return arkode_take_vectors(a);
}

static int build(struct arkode *a, double t, const double *y)
{
    TRY(sundials_open(&a->context));
    TRY(take_memory(a));
    TRY(arkode_restart(a, t, y, NULL));
    TRY(set_up(a));
    if (tableau_first_same_as_last(&a->table))
        TRY(arkode_take_last(a));
    return arkode_restart(a, t, y, NULL); /* again: now its orders are known */
}

int arkode_create(const struct method *m, const struct method_def *def, struct moment *moment,
                  double t, const double *y, void **out)
{
    struct arkode *a = status_alloc(1, sizeof *a);
    int code;

    *out = a;
    if (!a)
        return STATUS_FAILED;
    a->row = (const struct arkode_row *)m; /* its first member */
    a->def = *def;
    a->plan = moment_plan(moment);
    a->moment = moment;
    a->n = moment_size(moment);
    a->imex = arkode_tables_implicit(a->row) && plan_stiff(a->plan);
    code = build(a, t, y);
    if (code != STATUS_DONE)
        arkode_free(out);
    return code;
}

void arkode_free(void **out)
{
    struct arkode *a = *out;

    if (!a)
        return;
    if (a->ark)
        ARKodeFree(&a->ark);
    if (a->solver)
        SUNNonlinSolFree(a->solver);
    arkode_free_vectors(a);
    for (int k = 0; k < ARKODE_PAST; k++)
        free(a->stiff.past[k]);
    free(a->stiff.z);
    free(a->error.weight);
    sundials_close(&a->context);
    free(a);
    *out = NULL;
}
