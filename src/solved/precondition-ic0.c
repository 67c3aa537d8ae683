/* precondition-ic0.c -- the incomplete Cholesky factor without fill, as a preconditioner. */
#include "solved/precondition.h"

#include "base/status.h"
#include "solved/cholesky.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct ic0 {
    struct cholesky factor;
    size_t *from;  /* [size+1] of the entries below the diagonal */
    int *column;   /* [room] */
    size_t room;
};

static void drop(void **self)
{
    struct ic0 *s = *self;

    if (!s)
        return;
    free(s->from), free(s->column), free(s->factor.lower), free(s->factor.diagonal);
    free(s);
    *self = NULL;
}

static int create(int size, void **out)
{
    struct ic0 *s = *out = status_alloc(1, sizeof *s);
    const size_t n = (size_t)size + 1;

    if (!s)
        return STATUS_FAILED;
    s->from = status_alloc(n, sizeof *s->from);
    s->factor.diagonal = status_alloc(n, sizeof(double));
    return s->from && s->factor.diagonal ? STATUS_DONE : STATUS_FAILED;
}

static int take_entries(struct ic0 *s, size_t entries)
{
    if (entries <= s->room && s->column)
        return STATUS_DONE;
    free(s->column), free(s->factor.lower);
    s->room = entries + entries / 8 + 64;
    s->column = status_alloc(s->room, sizeof *s->column);
    s->factor.lower = status_alloc(s->room, sizeof(double));
    return s->column && s->factor.lower ? STATUS_DONE : STATUS_FAILED;
}

/* Half of what is off the diagonal stands below it. */
static int make(void *self, const struct precondition_matrix *a, char *why, size_t size)
{
    struct ic0 *s = self;
    size_t at = 0;
    int bad;

    if (take_entries(s, a->from[a->n] / 2) != STATUS_DONE) {
        snprintf(why, size, "no memory for the factor of IC(0)");
        return STATUS_FAILED;
    }
    for (int i = 0; i < a->n; i++) {
        s->from[i] = at;
        for (size_t k = a->from[i]; k < a->from[i + 1] && a->column[k] < i; k++) {
            s->column[at] = a->column[k];
            s->factor.lower[at++] = a->value[k];
        }
    }
    s->from[a->n] = at;
    memcpy(s->factor.diagonal, a->diagonal, (size_t)a->n * sizeof(double));
    s->factor.n = a->n;
    s->factor.from = s->from;
    s->factor.column = s->column;
    bad = cholesky_factor(&s->factor);
    if (bad != 0)
        snprintf(why, size, "the matrix is not positive definite, as row %d of IC(0) says", bad - 1);
    return bad == 0 ? STATUS_DONE : STATUS_FAILED;
}

static void solve(void *self, const double *residual, double *near)
{
    const struct ic0 *s = self;

    cholesky_solve(&s->factor, residual, near);
}

const struct precondition precondition_ic0 = {
    .name = "ic0", .row = 16, .entry = 6, .create = create, .free = drop, .make = make,
    .solve = solve,
};
