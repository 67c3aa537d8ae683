/* failure.h -- how runs end that cannot go on: what the families of methods say alike. */
#ifndef TIME_FAILURE_H
#define TIME_FAILURE_H

/* The remedy after steps became too short; a family may add more. */
#define FAILURE_REMEDY                                                                    \
    "Things to try: a smaller tol, the norm \"max\", more viscosity or density diffusion, " \
    "a smaller spacing, a higher sound speed"
#define FAILURE_REMEDY_METHODS FAILURE_REMEDY ", or another method (imex3, cks43)"

/* The settings that SUNDIALS gets are always the same: it takes them, if it has memory. */
#define FAILURE_SETUP \
    ((struct status_advice){ .cause = "That is most likely for want of memory" })

/* Each keeps a failure and returns STATUS_FAILED.  No right-hand side where steps begin; */
int failure_start(const char *name, double t, const char *refusal);

/* a step was accepted that is no number there; */
int failure_not_finite(const char *name, double t, const char *entry);

/* no memory for vectors of n numbers. */
int failure_memory(const char *name, long n);

#endif
