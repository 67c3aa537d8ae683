/* sundials.c -- contexts, and what SUNDIALS complains of, in every version. */
#include "algebra/sundials.h"

#include "base/status.h"
#include <cvode/cvode.h>
#include <stdio.h>

static char complaint[512];

const char *sundials_complaint(void)
{
    return complaint;
}

void sundials_forget(void)
{
    complaint[0] = '\0';
}

static void keep(const char *function, const char *message)
{
    snprintf(complaint, sizeof complaint, "%s: %s", function ? function : "SUNDIALS",
             message ? message : "no message");
}

#if SUNDIALS_AT_LEAST(7, 0)

static void heard(int line, const char *function, const char *file, const char *message,
                  SUNErrCode code, void *data, SUNContext context)
{
    (void)line, (void)file, (void)code, (void)data, (void)context;
    keep(function, message);
}

static int prepare(SUNContext *context)
{
    if (SUNContext_Create(SUN_COMM_NULL, context) != 0)
        return -1;
    SUNContext_ClearErrHandlers(*context);
    return SUNContext_PushErrHandler(*context, heard, NULL);
}

int sundials_listen(void *arkode)
{
    (void)arkode;
    return 0;
}

int sundials_listen_mri(void *mri)
{
    (void)mri;
    return 0;
}

int sundials_listen_cvode(void *cvode)
{
    (void)cvode;
    return 0;
}

#else

static void heard(int code, const char *module, const char *function, char *message, void *data)
{
    (void)code, (void)module, (void)data;
    keep(function, message);
}

static int prepare(SUNContext *context)
{
    return SUNContext_Create(NULL, context);
}

int sundials_listen(void *arkode)
{
    return ARKStepSetErrHandlerFn(arkode, heard, NULL);
}

int sundials_listen_mri(void *mri)
{
    return MRIStepSetErrHandlerFn(mri, heard, NULL);
}

int sundials_listen_cvode(void *cvode)
{
    return CVodeSetErrHandlerFn(cvode, heard, NULL);
}

#endif

int sundials_control(void *arkode, ARKAdaptFn adapt, void *data)
{
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
    return ARKStepSetAdaptivityFn(arkode, adapt, data);
#pragma GCC diagnostic pop
}

int sundials_open(SUNContext *out)
{
    *out = NULL;
    if (prepare(out) == 0)
        return STATUS_DONE;
    sundials_close(out);
    return status_fail(STATUS_FAILED, "SUNDIALS gives no context: probably there is no memory "
                                      "left; use fewer particles");
}

void sundials_close(SUNContext *context)
{
    if (*context)
        SUNContext_Free(context);
    *context = NULL;
}
