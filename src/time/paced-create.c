/* paced-create.c -- memory of methods with error control. */
#include "time/paced.h"

#include "base/status.h"
#include <assert.h>
#include <stdlib.h>

int paced_numbers(struct paced *x, double **to)
{
    assert(x->arrays < PACED_ARRAYS);
    *to = status_alloc((unsigned long)x->n, sizeof(double));
    if (!*to)
        return STATUS_FAILED;
    x->array[x->arrays++] = *to;
    return STATUS_DONE;
}

static int take_memory(struct paced *x)
{
    const struct vector_own own = moment_own(x->moment);

    TRY(paced_numbers(x, &x->y));
    TRY(paced_numbers(x, &x->y_old));
    TRY(sundials_open(&x->context));
    x->error = vector_create_own(x->n, x->def.norm, x->context, &own);
    x->weight = x->error ? N_VClone(x->error) : NULL;
    if (!x->weight)
        return STATUS_FAILED;
    moment_weights(x->moment, x->def.tol, vector_data(x->weight));
    return x->kind->take_memory(x);
}

int paced_create(const struct method *m, const struct method_def *def, struct moment *moment,
                 double t, const double *y, void **out)
{
    const struct paced_kind *kind = (const struct paced_kind *)m; /* its first member */
    struct paced *x = status_alloc(1, kind->size);

    *out = x;
    if (!x)
        return STATUS_FAILED;
    x->kind = kind;
    x->def = *def;
    x->plan = moment_plan(moment);
    x->moment = moment;
    x->n = moment_size(moment);
    if (take_memory(x) != STATUS_DONE) {
        paced_free(out);
        return STATUS_FAILED;
    }
    return paced_restart(x, t, y, NULL);
}

int paced_restart(void *self, double t, const double *y, const struct method_pace *pace)
{
    struct paced *x = self;

    moment_take(x->moment, y, x->y);
    x->t = x->t_old = t;
    x->ready = x->stepped = false;
    x->carried = pace ? pace->h : 0;
    control_start(&x->control, &x->kind->control, x->kind->method.order, x->kind->method.order,
                  pace);
    return STATUS_DONE;
}

int paced_rearrange(void *self, int blocks, const struct vector_rows *block)
{
    struct paced *x = self;

    TRY(vector_rearrange(x->error, blocks, block));
    TRY(vector_rows_move(blocks, block, x->arrays, x->array));
    x->choice.entry = vector_rows_moved(blocks, block, x->choice.entry);
    return STATUS_DONE;
}

void paced_free(void **self)
{
    struct paced *x = *self;

    if (!x)
        return;
    x->kind->free_memory(x);
    free(x->y);
    free(x->y_old);
    if (x->weight)
        N_VDestroy(x->weight);
    if (x->error)
        N_VDestroy(x->error);
    sundials_close(&x->context);
    free(x);
    *self = NULL;
}
