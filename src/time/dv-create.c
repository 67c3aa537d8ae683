/* dv-create.c -- memory of "dv". */
#include "time/dv.h"

#include "base/status.h"
#include <stdlib.h>

/* Low gain, as Runge-Kutta pairs have it at their stability limit; at an error of
 * 10 tol it would ask for 0.81 of the step. */
static const struct control_row low_gain = { { 0.28, -0.23, 0 }, 1, 10, 1.3 };

/* y, y_old, half; what bodies need besides; the error and its weights. */
enum { STATES = 3, OF_BODIES = 3, OF_ERRORS = 2 };

static int numbers(long n, double **to)
{
    *to = status_alloc((unsigned long)n, sizeof(double));
    return *to ? STATUS_DONE : STATUS_FAILED;
}

static int take_memory(struct dv *x)
{
    static const enum vector_norm norms[] = { [METHOD_NORM_MAX] = VECTOR_NORM_MAX,
                                              [METHOD_NORM_P8] = VECTOR_NORM_P8,
                                              [METHOD_NORM_WRMS] = VECTOR_NORM_WRMS };
    double **place[] = { &x->y, &x->y_old, &x->half, &x->load, &x->load_old, &x->right };

    for (int i = 0; i < STATES + (x->ranges > 0 ? OF_BODIES : 0); i++)
        TRY(numbers(x->n, place[i]));
    for (int k = 0; k < DV_POINTS; k++) {
        TRY(numbers(x->n, &x->a.f[k]));
        TRY(numbers(x->n, &x->d.f[k]));
    }
    TRY(sundials_open(&x->context));
    x->error = vector_create(x->n, norms[x->def.norm], x->context);
    x->weight = x->error ? N_VClone(x->error) : NULL;
    return x->weight ? STATUS_DONE : STATUS_FAILED;
}

int dv_vectors(const struct method *m, const struct plan *plan)
{
    (void)m;
    return STATES + (plan_stiff(plan) ? OF_BODIES : 0) + OF_ERRORS + 2 * DV_POINTS;
}

static bool has_densities(const struct layout *l)
{
    for (int i = 0; i < l->rows; i++)
        if (l->row[i].what == LAYOUT_OTHER && l->row[i].scale > 0)
            return true;
    return false;
}

int dv_create(const struct method *m, const struct method_def *def, struct plan *plan, double t,
              const double *y, void **out)
{
    struct dv *x = status_alloc(1, sizeof *x);

    (void)m;
    *out = x;
    if (!x)
        return STATUS_FAILED;
    x->def = *def;
    x->plan = plan;
    x->n = plan_size(plan);
    for (int c = 0; c <= LAYOUT_CLASSES; c++)
        x->from[c] = plan_layout(plan)->from[c];
    x->flows = has_densities(plan_layout(plan));
    x->ranges = plan_stiff_ranges(plan, LAYOUT_ROWS, x->range);
    if (take_memory(x) != STATUS_DONE) {
        dv_free(out);
        return STATUS_FAILED;
    }
    plan_weights(plan, def->tol, vector_data(x->weight));
    return dv_restart(x, t, y);
}

int dv_restart(void *self, double t, const double *y)
{
    struct dv *x = self;

    vector_copy(x->n, y, x->y);
    x->t = x->t_old = t;
    x->ready = x->stepped = false;
    control_start(&x->control, &low_gain, 2, 2);
    return STATUS_DONE;
}

void dv_free(void **self)
{
    struct dv *x = *self;

    if (!x)
        return;
    double *const place[] = { x->y, x->y_old, x->half, x->load, x->load_old, x->right };
    for (int i = 0; i < STATES + OF_BODIES; i++)
        free(place[i]);
    for (int k = 0; k < DV_POINTS; k++) {
        free(x->a.f[k]);
        free(x->d.f[k]);
    }
    if (x->weight)
        N_VDestroy(x->weight);
    if (x->error)
        N_VDestroy(x->error);
    sundials_close(&x->context);
    free(x);
    *self = NULL;
}
