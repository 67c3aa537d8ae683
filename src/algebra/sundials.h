/* sundials.h -- the one place that knows which SUNDIALS this is: 6.4.1 and 7.1.1 are
 * tested, what lies between and later 7.x should do.
 *
 * The rest of the program is written against the common names of 7.1 and later
 * (ARKodeEvolve ...); for older ones they are mapped to ARKStep's here.  SUNDIALS
 * never prints: what it complains of is kept for our own message. */
#ifndef ALGEBRA_SUNDIALS_H
#define ALGEBRA_SUNDIALS_H

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_mristep.h>
#include <sundials/sundials_config.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#define SUNDIALS_AT_LEAST(major, minor) \
    (SUNDIALS_VERSION_MAJOR > (major) || \
     (SUNDIALS_VERSION_MAJOR == (major) && SUNDIALS_VERSION_MINOR >= (minor)))

#if !SUNDIALS_AT_LEAST(7, 1)
#define ARKodeEvolve                  ARKStepEvolve
#define ARKodeFree                    ARKStepFree
#define ARKodeGetLastStep             ARKStepGetLastStep
#define ARKodeGetNonlinearSystemData  ARKStepGetNonlinearSystemData
#define ARKodeGetNumStepAttempts      ARKStepGetNumStepAttempts
#define ARKodeSetCFLFraction          ARKStepSetCFLFraction
#define ARKodeSetDeduceImplicitRhs    ARKStepSetDeduceImplicitRhs
#define ARKodeSetErrorBias            ARKStepSetErrorBias
#define ARKodeSetFixedStep            ARKStepSetFixedStep
#define ARKodeSetFixedStepBounds      ARKStepSetFixedStepBounds
#define ARKodeSetInitStep             ARKStepSetInitStep
#define ARKodeSetInterpolantDegree    ARKStepSetInterpolantDegree
#define ARKodeSetInterpolantType      ARKStepSetInterpolantType
#define ARKodeSetMaxEFailGrowth       ARKStepSetMaxEFailGrowth
#define ARKodeSetMaxErrTestFails      ARKStepSetMaxErrTestFails
#define ARKodeSetMaxFirstGrowth       ARKStepSetMaxFirstGrowth
#define ARKodeSetMaxGrowth            ARKStepSetMaxGrowth
#define ARKodeSetMaxHnilWarns         ARKStepSetMaxHnilWarns
#define ARKodeSetMaxNumSteps          ARKStepSetMaxNumSteps
#define ARKodeSetMinReduction         ARKStepSetMinReduction
#define ARKodeSetMinStep              ARKStepSetMinStep
#define ARKodeSetNonlinearSolver      ARKStepSetNonlinearSolver
#define ARKodeSetPredictorMethod      ARKStepSetPredictorMethod
#define ARKodeSetSafetyFactor         ARKStepSetSafetyFactor
#define ARKodeSetSmallNumEFails       ARKStepSetSmallNumEFails
#define ARKodeSetStabilityFn          ARKStepSetStabilityFn
#define ARKodeSetStopTime             ARKStepSetStopTime
#define ARKodeSetUserData             ARKStepSetUserData
#define ARKodeWFtolerances            ARKStepWFtolerances
#endif

/* What both steppers have, for MRIStep: SUNDIALS_MRI(Evolve)(...). */
#if SUNDIALS_AT_LEAST(7, 1)
#define SUNDIALS_MRI(name) ARKode##name
#else
#define SUNDIALS_MRI(name) MRIStep##name
#endif

/* We interpolate ourselves: the least that this version can be asked to keep. */
#ifdef ARK_INTERP_NONE
#define SUNDIALS_INTERPOLANT ARK_INTERP_NONE
#else
#define SUNDIALS_INTERPOLANT ARK_INTERP_LAGRANGE
#endif

/* A context of its own for each integrator; STATUS_FAILED when there is none. */
int sundials_open(SUNContext *out);
void sundials_close(SUNContext *context); /* NULL is welcome */

/* Redirects what an integrator complains of (6.x: to be called for each; 7.x
 * has it from its context, and this does nothing). */
int sundials_listen(void *arkode);
int sundials_listen_mri(void *mri);
int sundials_listen_cvode(void *cvode);

/* The controller of an ARKStep.  7.x calls the function deprecated, but what takes its place
 * hears of an error's size alone, not of the state. */
int sundials_control(void *arkode, ARKAdaptFn adapt, void *data);

/* The last complaint of any integrator since sundials_forget(), "" if none. */
const char *sundials_complaint(void);
void sundials_forget(void);

#endif
