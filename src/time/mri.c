/* mri.c -- the method "mri": water in long explicit steps, bodies in short implicit
 * ones, by SUNDIALS' MRIStep.
 *
 * The water's table is that of Knoth, Wolke, order 3 with 3 right-hand sides a step:
 * between two of its stages bodies move under its rates of the stages so far.
 * Knoth, Wolke, Appl. Numer. Math. 28 (1998) 327-341; Schlegel, Knoth, Arnold, Wolke,
 * J. Comput. Appl. Math. 226 (2009) 345-357. */
#include "time/mri.h"

#include "base/status.h"
#include "time/failure.h"
#include "state/scales.h"
#include "time/alone.h"
#include "time/failure.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { OF_MRISTEP = 12, OURS = 2, OWN = 9 }; /* vectors; the first counted in 6.4.1, in OWN of these
                                                rates are written */

static const char slow_table[] = "ARKODE_MIS_KW3";

static struct mri *of_frame(const struct fixed *x)
{
    return (struct mri *)x->kind; /* its first member, made by create() */
}

/* --- what MRIStep asks for ------------------------------------------------- */

/* At both ends of a step the frame has the rates, or is to have them. */
static int rates(struct mri *m, double t, const double *y, double *ydot)
{
    struct fixed *x = m->frame;
    const bool ends = t > x->t_old + m->h * (1 - 1e-9);
    double *f = ends ? x->f : ydot;

    if (t == x->t_old)
        vector_copy(x->n, x->f_old, ydot);
    else
        TRY(moment_eval(x->moment, ASK_EXPLICIT_SIDE, t, y, f));
    if (ends)
        vector_copy(x->n, f, ydot);
    x->has_f = ends;
    return STATUS_DONE;
}

/* Less what bodies book themselves. */
static int slow(sunrealtype t, N_Vector y, N_Vector ydot, void *self)
{
    struct mri *m = self;

    if (rates(m, t, vector_data(y), vector_data(ydot)) != STATUS_DONE)
        return -1;
    return m->side->less(m, t, vector_data(y), vector_data(ydot)) == STATUS_DONE ? 0 : -1;
}

/* Only MRIStep's interpolant wants it, which is not asked. */
static int no_rates(MRIStepInnerStepper inner, sunrealtype t, N_Vector y, N_Vector f, int mode)
{
    (void)inner, (void)t, (void)y, (void)mode;
    N_VConst(0, f);
    return 0;
}

/* There is no error test. */
static int weights(N_Vector y, N_Vector weight, void *self)
{
    (void)y, (void)self;
    N_VConst(1, weight);
    return 0;
}

/* --- the kind -------------------------------------------------------------- */

/* Order 3 is stable on the real axis down to -2.51. */
static double length(struct fixed *x)
{
    struct limit limit[2];
    double wave, decay;

    of_frame(x)->side->limit(x->moment, x->t, x->y, limit);
    wave = limit[0].rate > 0 ? x->number * SCALES_WAVE / limit[0].rate : HUGE_VAL;
    decay = limit[1].rate > 0 ? 2 / limit[1].rate : HUGE_VAL;
    x->limit = limit[decay < wave];
    return fmin(wave, decay);
}

static int refuse(const char *what)
{
    return status_fail_with(STATUS_FAILED, FAILURE_SETUP, "method mri: SUNDIALS %d.%d.%d refuses %s (%s)",
                       SUNDIALS_VERSION_MAJOR, SUNDIALS_VERSION_MINOR, SUNDIALS_VERSION_PATCH,
                       what, sundials_complaint());
}

/* MRIStep is started anew for each step: it takes no other length otherwise. */
static int advance(struct fixed *x, double h)
{
    struct mri *m = of_frame(x);
    sunrealtype t;

    sundials_forget();
    m->h = h;
    vector_take(m->start, x->y_old);
    if (MRIStepReInit(m->steps, slow, NULL, x->t_old, m->start) != 0
        || SUNDIALS_MRI(SetFixedStep)(m->steps, h) != 0)
        return refuse("to start");
    if (SUNDIALS_MRI(Evolve)(m->steps, x->t_old + h, m->end, &t, ARK_ONE_STEP) < 0)
        return STATUS_FAILED;
    vector_copy(x->n, vector_data(m->end), x->y);
    return STATUS_DONE;
}

/* --- the method ------------------------------------------------------------ */

static const char *serves(const struct plan *plan)
{
    if (plan_size(plan) > 0 && !plan_stiff(plan))
        return "it steps beams apart from the water, and this scene has no beam: use cks43";
    if (plan_size(plan) > 0 && alone_bodies(plan))
        return "its steps follow the sound in the water, and this scene has no water: use dirk4";
    const char *why = method_bodies_alone(plan);
    return why ? why : fixed_serves(plan);
}

/* Of all of f: positions may have other rates than velocities have numbers. */
static const char *serves_rigid(const struct plan *plan)
{
    const char *why = plan_size(plan) > 0 ? moment_rigid_lacks(plan) : "nothing in this scene moves";

    return why ? why : method_bodies_alone(plan);
}

static int set_up_steps(struct mri *m)
{
    const struct fixed *x = m->frame;
    MRIStepCoupling coupling;
    int bad = 0;

    m->steps = MRIStepCreate(slow, NULL, x->t, m->start, m->inner, m->context);
    if (!m->steps || sundials_listen_mri(m->steps) != 0)
        return refuse("to begin");
    coupling = MRIStepCoupling_LoadTableByName(slow_table);
    bad |= !coupling || MRIStepSetCoupling(m->steps, coupling) != 0;
    MRIStepCoupling_Free(coupling);
    bad |= SUNDIALS_MRI(SetUserData)(m->steps, m);
    bad |= SUNDIALS_MRI(SetInterpolantType)(m->steps, SUNDIALS_INTERPOLANT);
    bad |= SUNDIALS_MRI(SetInterpolantDegree)(m->steps, 0);
    bad |= SUNDIALS_MRI(WFtolerances)(m->steps, weights);
    return bad ? refuse("its settings") : STATUS_DONE;
}

static int set_up(struct mri *m, const struct method_def *def)
{
    const struct vector_own own = moment_own(m->frame->moment);

    TRY(sundials_open(&m->context));
    m->start = vector_create_own(m->frame->n, VECTOR_NORM_MAX, m->context, &own);
    m->end = m->start ? N_VClone(m->start) : NULL;
    if (!m->end)
        return STATUS_FAILED;
    if (MRIStepInnerStepper_Create(m->context, &m->inner) != 0
        || MRIStepInnerStepper_SetContent(m->inner, m) != 0
        || MRIStepInnerStepper_SetEvolveFn(m->inner, mri_bodies_evolve) != 0
        || MRIStepInnerStepper_SetFullRhsFn(m->inner, no_rates) != 0)
        return refuse("the bodies' own steps");
    TRY(mri_bodies_create(m, def));
    mri_bodies_restart(m, NULL);
    return set_up_steps(m);
}

static void release(void **self)
{
    struct mri *m = *self;

    if (!m)
        return;
    if (m->steps)
        SUNDIALS_MRI(Free)(&m->steps);
    if (m->inner)
        MRIStepInnerStepper_Free(&m->inner);
    if (m->start)
        N_VDestroy(m->start);
    if (m->end)
        N_VDestroy(m->end);
    sundials_close(&m->context);
    mri_bodies_free(m);
    fixed_free((void **)&m->frame);
    free(m);
    *self = NULL;
}

static int create(const struct method *method, const struct method_def *def, struct moment *moment,
                  double t, const double *y, void **out)
{
    struct mri *m = status_alloc(1, sizeof *m);
    void *frame = NULL;
    int code;

    *out = m;
    if (!m)
        return STATUS_FAILED;
    m->kind = ((const struct mri_method *)method)->kind; /* its first member */
    m->side = ((const struct mri_method *)method)->side;
    code = fixed_create(&m->kind.method, def, moment, t, y, &frame);
    m->frame = frame;
    if (code == STATUS_DONE)
        code = set_up(m, def);
    if (code != STATUS_DONE)
        release(out);
    else
        snprintf(m->table, sizeof m->table, "%s + %s, %s", slow_table, m->side->table,
                 fixed_table(frame));
    return code;
}

static int step(void *self, double t_stop, struct method_step *out)
{
    struct mri *m = self;

    TRY(fixed_step(m->frame, t_stop, out));
    out->pace = control_pace(&m->bodies.control, m->bodies.longest);
    return STATUS_DONE;
}

static int at(void *self, double t, double *y)
{
    const struct mri *m = self;
    const struct fixed *x = m->frame;

    TRY(fixed_at((void *)x, t, y));
    if (x->stepped && t > x->t_old && t < x->t)
        m->side->between(x, t, y);
    return STATUS_DONE;
}

static const double *state(const void *self)
{
    return fixed_state(((const struct mri *)self)->frame);
}

static int restart(void *self, double t, const double *y, const struct method_pace *pace)
{
    struct mri *m = self;

    mri_bodies_restart(m, pace);
    return fixed_restart(m->frame, t, y, NULL);
}

/* Nothing is kept by MRIStep, which is started anew for each step. */
static int rearrange(void *self, int blocks, const struct vector_rows *block)
{
    const struct mri *m = self;

    TRY(vector_rearrange(m->start, blocks, block));
    return fixed_rearrange(m->frame, blocks, block);
}

static const char *table(const void *self)
{
    return ((const struct mri *)self)->table;
}

static int vectors(const struct method *m, const struct plan *plan)
{
    return fixed_vectors(m, plan) + OF_MRISTEP + OURS;
}

static int own(const struct method *m, const struct plan *plan)
{
    return fixed_own(m, plan) + OWN;
}

#define MRI_METHOD(NAME, SERVES, ABOUT)                                                    \
    { .method = { .name = NAME,                                                           \
                  .told = { ABOUT, "Knoth, Wolke, Appl. Numer. Math. 28 (1998) 327-341" }, \
                  .adaptive = false, .order = 3, .serves = SERVES, .create = create,       \
                  .step = step, .at = at, .room = { vectors, own }, .state = state,        \
                  .restart = restart, .rearrange = rearrange, .table = table,              \
                  .free = release },                                                       \
      .number = 0.2, .sides = ASK_EXPLICIT, .spared = 2, .length = length, .advance = advance }

const struct mri_method mri_method = {
    MRI_METHOD("mri", serves, "water in explicit steps of order 3, beams in implicit ones of their "
               "own within"),
    &mri_beams_side,
};

const struct mri_method mri_rigid_method = {
    MRI_METHOD("mri-rigid", serves_rigid, "water in explicit steps of order 3, rigid bodies and "
               "their contacts in shorter ones within"),
    &mri_rigid_side,
};
