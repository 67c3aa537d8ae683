/* fixed-create.c -- memory of methods without error control. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { VECTORS = 6 };

/* A rule gives each step anew: there is no pace to take up. */
int fixed_restart(void *self, double t, const double *y, const struct method_pace *pace)
{
    struct fixed *x = self;

    (void)pace;
    moment_take(x->moment, y, x->y);
    x->t = x->t_old = t;
    x->has_f = x->stepped = false;
    return STATUS_DONE;
}

int fixed_rearrange(void *self, int blocks, const struct vector_rows *block)
{
    const struct fixed *x = self;

    return vector_rows_move(blocks, block, VECTORS,
                            (double *[VECTORS]){ x->y, x->f, x->y_old, x->f_old, x->try,
                                                 x->rates });
}

int fixed_vectors(const struct method *m, const struct plan *plan)
{
    (void)plan;
    return VECTORS - ((const struct fixed_kind *)m)->spared; /* its first member */
}

/* f, f_old, and rates unless these are spared. */
int fixed_own(const struct method *m, const struct plan *plan)
{
    (void)plan;
    return 2 + (((const struct fixed_kind *)m)->spared == 0);
}

static int take_memory(struct fixed *x)
{
    double **place[] = { &x->y, &x->f, &x->y_old, &x->f_old, &x->try, &x->rates };

    for (int i = 0; i < VECTORS; i++)
        if (!(*place[i] = status_alloc((unsigned long)x->n, sizeof(double))))
            return STATUS_FAILED;
    return x->kind->take ? x->kind->take(x) : STATUS_DONE;
}

int fixed_create(const struct method *m, const struct method_def *def, struct moment *moment,
                 double t, const double *y, void **out)
{
    struct fixed *x = status_alloc(1, sizeof *x);

    *out = x;
    if (!x)
        return STATUS_FAILED;
    x->kind = (const struct fixed_kind *)m; /* its first member */
    x->plan = moment_plan(moment);
    x->moment = moment;
    x->n = moment_size(moment);
    for (int c = 0; c <= LAYOUT_CLASSES; c++)
        x->from[c] = moment_layout(moment)->from[c];
    x->number = def->step > 0 ? def->step : x->kind->number;
    x->seconds = def->seconds;
    x->substep = def->substep > 0 ? def->substep : HUGE_VAL;
    x->h_min = def->h_min;
    if (!(x->kind->sides & ASK_IMPLICIT))
        x->ranges = moment_stiff_ranges(moment, LAYOUT_ROWS, x->range);
    if (x->seconds > 0)
        snprintf(x->table, sizeof x->table, "%s", m->name);
    else
        snprintf(x->table, sizeof x->table, "%s@%g", m->name, x->number);
    if (take_memory(x) != STATUS_DONE) {
        fixed_free(out);
        return STATUS_FAILED;
    }
    return fixed_restart(x, t, y, NULL);
}

void fixed_free(void **self)
{
    struct fixed *x = *self;

    if (!x)
        return;
    if (x->own)
        x->kind->leave(x);
    free(x->y);
    free(x->f);
    free(x->y_old);
    free(x->f_old);
    free(x->try);
    free(x->rates);
    free(x);
    *self = NULL;
}
