/* poisson.c -- the matrix and the solve. */
#include "solved/poisson.h"

#include "base/status.h"
#include "base/threads.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WORTH_THREADS = 4096 };

/* --- memory ---------------------------------------------------------------------- */

int poisson_create(int size, int iterations, const struct precondition *how, struct poisson *s)
{
    const size_t n = (size_t)size + 1;

    *s = (struct poisson){ .how = how, .size = size, .iterations = iterations };
    s->diagonal = status_alloc(n, sizeof(double));
    s->residual = status_alloc(n, sizeof(double));
    s->from = status_alloc(n, sizeof *s->from);
    s->queue = status_alloc(n, sizeof *s->queue);
    s->tied = status_alloc(n, sizeof *s->tied);
    if (!s->diagonal || !s->residual || !s->from || !s->queue || !s->tied)
        return STATUS_FAILED;
    TRY(how->create(size, &s->own));
    return operator_solver_create(size, iterations, &s->solver);
}

void poisson_free(struct poisson *s)
{
    free(s->diagonal), free(s->residual), free(s->from), free(s->column), free(s->value);
    free(s->queue), free(s->tied);
    if (s->how)
        s->how->free(&s->own);
    operator_solver_free(&s->solver);
    *s = (struct poisson){ 0 };
}

static int take_entries(struct poisson *s, size_t entries)
{
    if (entries <= s->room && s->column)
        return STATUS_DONE;
    free(s->column), free(s->value);
    s->room = entries + entries / 8 + 64;
    s->column = status_alloc(s->room, sizeof *s->column);
    s->value = status_alloc(s->room, sizeof *s->value);
    return s->column && s->value ? STATUS_DONE : STATUS_FAILED;
}

/* --- the matrix ------------------------------------------------------------------ */

/* What a row is made of. */
struct rows {
    const struct near *near;
    const char *role;
    poisson_weight *weight;
    const void *self;
    double e;
};

/* Puts an entry where columns ascend; the row has had `n` so far. */
static void insert(int *column, double *value, int n, int j, double a)
{
    int k = n;

    for (; k > 0 && column[k - 1] > j; k--) {
        column[k] = column[k - 1];
        value[k] = value[k - 1];
    }
    column[k] = j;
    value[k] = a;
}

/* Row i: its entries off the diagonal go to column, value [their number, returned]. */
static int make_row(const struct rows *of, int i, int *column, double *value,
                       double *diagonal)
{
    const struct near *near = of->near;
    int n = 0;
    double step[DIM];

    *diagonal = 1;
    if (of->role[i] != POISSON_UNKNOWN)
        return 0;
    *diagonal = of->e;
    for (size_t k = near->from[i]; k < near->from[i + 1]; k++) {
        const int j = near->origin[near->place[k]];
        if (of->role[j] == POISSON_DUMMY)
            continue;
        const double a = of->weight(of->self, sqrt(near_step(near, i, near->place[k], step)));
        *diagonal += a;
        if (of->role[j] == POISSON_UNKNOWN && a > 0)
            insert(column, value, n++, j, -a);
    }
    return n;
}

/* Rows of unknowns have room for all their neighbours, others none. */
static void find_room(struct poisson *s, const struct near *near, const char *role)
{
    size_t at = 0;

    for (int i = 0; i < s->n; i++) {
        s->from[i] = at;
        at += role[i] == POISSON_UNKNOWN ? near->from[i + 1] - near->from[i] : 0;
    }
    s->from[s->n] = at;
}

/* Then they stand side by side. */
static void close_gaps(struct poisson *s, const int *length)
{
    size_t at = 0;

    for (int i = 0; i < s->n; i++) {
        const size_t first = s->from[i], n = (size_t)length[i];
        memmove(s->column + at, s->column + first, n * sizeof *s->column);
        memmove(s->value + at, s->value + first, n * sizeof *s->value);
        s->from[i] = at;
        at += n;
    }
    s->from[s->n] = at;
}

int poisson_assemble(struct poisson *s, const struct near *near, const char *role,
                     poisson_weight *weight, const void *self, double e)
{
    const struct rows of = { near, role, weight, self, e };

    s->n = near->n;
    find_room(s, near, role);
    TRY(take_entries(s, s->from[s->n]));
#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->n; i++)
        s->queue[i] = make_row(&of, i, s->column + s->from[i], s->value + s->from[i], &s->diagonal[i]);
    close_gaps(s, s->queue);
    for (int i = s->n; i < s->size; i++)
        s->diagonal[i] = 1;
    return STATUS_DONE;
}

/* --- is it definite? ------------------------------------------------------------- */

/* Goes on from `first` along entries; returns how many were reached. */
static int reach(struct poisson *s, int first)
{
    int at = 0, n = 0;

    s->queue[n++] = first;
    s->tied[first] = true;
    while (at < n) {
        const int i = s->queue[at++];
        for (size_t k = s->from[i]; k < s->from[i + 1]; k++)
            if (!s->tied[s->column[k]]) {
                s->tied[s->column[k]] = true;
                s->queue[n++] = s->column[k];
            }
    }
    return n;
}

static bool beside_surface(const struct poisson *s, int i)
{
    double others = 0;

    for (size_t k = s->from[i]; k < s->from[i + 1]; k++)
        others -= s->value[k];
    return s->diagonal[i] > others * (1 + 1e-12);
}

int poisson_loose(struct poisson *s, const char *role, int *joined)
{
    memset(s->tied, 0, (size_t)s->n * sizeof *s->tied);
    for (int i = 0; i < s->n; i++)
        if (role[i] == POISSON_UNKNOWN && !s->tied[i] && beside_surface(s, i))
            reach(s, i);
    for (int i = 0; i < s->n; i++)
        if (role[i] == POISSON_UNKNOWN && !s->tied[i]) {
            *joined = reach(s, i);
            return i;
        }
    return -1;
}

/* --- the solve ------------------------------------------------------------------- */

/* Rows of this thread. */
static void multiply_part(const struct poisson *s, const double *x, double *to)
{
    const struct threads_part part = threads_part(s->n);

    for (int i = part.from; i < part.to; i++) {
        double sum = s->diagonal[i] * x[i];
        for (size_t k = s->from[i]; k < s->from[i + 1]; k++)
            sum += s->value[k] * x[s->column[k]];
        to[i] = sum;
    }
}

static void multiply(void *self, const double *x, double *to)
{
    const struct poisson *s = self;

    THREADS(s->n > WORTH_THREADS, multiply_part(s, x, to));
    for (int i = s->n; i < s->size; i++)
        to[i] = x[i];
}

static void precondition(void *self, const double *residual, double *near)
{
    const struct poisson *s = self;

    s->how->solve(s->own, residual, near);
    for (int i = s->n; i < s->size; i++)
        near[i] = residual[i];
}

/* Residual b - A p, and how large b is [2-norm]. */
static double begin(struct poisson *s, const double *b, const double *p)
{
    double square = 0;

    multiply(s, p, s->residual);
    for (int i = 0; i < s->size; i++) {
        const double source = i < s->n ? b[i] : 0;
        s->residual[i] = i < s->n ? source - s->residual[i] : 0;
        square += source * source;
    }
    return sqrt(square);
}

int poisson_solve(struct poisson *s, const double *b, double exact, double *p,
                  struct operator_report *report)
{
    struct operator a = { .self = s, .n = s->size, .width = 1, .diagonal = s->diagonal,
                          .apply = multiply, .precondition = precondition };
    const struct precondition_matrix matrix = { s->n, s->diagonal, s->from, s->column, s->value };
    const double size = begin(s, b, p);

    *report = (struct operator_report){ 0 };
    if (!(size > 0)) {
        memset(p, 0, (size_t)s->n * sizeof *p);
        return STATUS_DONE;
    }
    TRY(s->how->make(s->own, &matrix, s->why, sizeof s->why));
    a.near = exact * size;
    if (operator_solve(s->solver, &a, p, s->residual, report) == STATUS_DONE)
        return STATUS_DONE;
    operator_refusal(report, s->why, sizeof s->why);
    return STATUS_FAILED;
}
