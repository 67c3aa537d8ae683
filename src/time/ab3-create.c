/* ab3-create.c -- memory of "ab3". */
#include "time/ab3.h"

#include "base/status.h"
#include <stdlib.h>

/* Low gain, as Runge-Kutta pairs have it at their stability limit.  Half of tol: at 1e-2
 * a dam break then loses a fifth less energy, for 1 % more steps. */
static const struct control_row low_gain = { { 0.28, -0.23, 0 }, 0.5, 2, 1.3 };

/* y and y_old; the error and its weights. */
enum { STATES = 2, OF_ERRORS = 2 };

static int numbers(long n, double **to)
{
    *to = status_alloc((unsigned long)n, sizeof(double));
    return *to ? STATUS_DONE : STATUS_FAILED;
}

static int take_memory(struct ab3 *x)
{
    static const enum vector_norm norms[] = { [METHOD_NORM_MAX] = VECTOR_NORM_MAX,
                                              [METHOD_NORM_P8] = VECTOR_NORM_P8,
                                              [METHOD_NORM_WRMS] = VECTOR_NORM_WRMS };

    TRY(numbers(x->n, &x->y));
    TRY(numbers(x->n, &x->y_old));
    for (int k = 0; k <= AB3_POINTS; k++)
        TRY(numbers(x->n, &x->f[k]));
    TRY(sundials_open(&x->context));
    x->error = vector_create(x->n, norms[x->def.norm], x->context);
    x->weight = x->error ? N_VClone(x->error) : NULL;
    return x->weight ? STATUS_DONE : STATUS_FAILED;
}

int ab3_vectors(const struct method *m, const struct plan *plan)
{
    (void)m, (void)plan;
    return STATES + AB3_POINTS + 1 + OF_ERRORS;
}

int ab3_create(const struct method *m, const struct method_def *def, struct plan *plan, double t,
               const double *y, void **out)
{
    struct ab3 *x = status_alloc(1, sizeof *x);

    (void)m;
    *out = x;
    if (!x)
        return STATUS_FAILED;
    x->def = *def;
    x->rates.plan = plan;
    x->n = plan_size(plan);
    if (take_memory(x) != STATUS_DONE) {
        ab3_free(out);
        return STATUS_FAILED;
    }
    plan_weights(plan, def->tol, vector_data(x->weight));
    return ab3_restart(x, t, y);
}

int ab3_restart(void *self, double t, const double *y)
{
    struct ab3 *x = self;

    vector_copy(x->n, y, x->y);
    x->t = x->t_old = t;
    x->ready = x->stepped = false;
    x->rates.refusal[0] = '\0';
    control_start(&x->control, &low_gain, AB3_POINTS, AB3_POINTS);
    return STATUS_DONE;
}

void ab3_free(void **self)
{
    struct ab3 *x = *self;

    if (!x)
        return;
    free(x->y);
    free(x->y_old);
    for (int k = 0; k <= AB3_POINTS; k++)
        free(x->f[k]);
    if (x->weight)
        N_VDestroy(x->weight);
    if (x->error)
        N_VDestroy(x->error);
    sundials_close(&x->context);
    free(x);
    *self = NULL;
}
