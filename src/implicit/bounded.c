/* bounded.c -- MPRGP with the scaled unknowns y = D^(1/2) x, D the diagonal.
 *
 * The length of an expansion step is to be below 2/|D^(-1/2) A D^(-1/2)|.  That norm is not
 * known: it is taken as a number that pressures of fluid and walls stay below as a rule, and
 * doubled whenever a step would raise what is to become smallest, which no step below that
 * length does. */
#include "implicit/bounded.h"

#include "algebra/vector.h"
#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double first_norm = 7, share_of_length = 1.9;

enum { VECTORS = 7 };

struct bounded_solver {
    int n, most, products;
    double norm;                    /* of the scaled operator, as far as known   */
    double *y, *g, *p, *image;      /* [n] unknowns, gradient, direction, A times it */
    double *scale, *scratch, *step; /* [n] D^(-1/2)                              */
    double *partial;
    const double *least;            /* [n] 0, -INFINITY; NULL: 0                  */
    const struct operator *a;
    enum operator_cause cause;
};

static double dot(const struct bounded_solver *s, const double *v, const double *w)
{
    return vector_dot(s->n, v, w, s->partial);
}

/* to = D^(-1/2) A D^(-1/2) v; v times that, which is to be positive unless v is 0. */
static double product(struct bounded_solver *s, const double *v, double *to)
{
    double work;

    for (int i = 0; i < s->n; i++)
        s->scratch[i] = s->scale[i] * v[i];
    s->a->apply(s->a->self, s->scratch, to);
    for (int i = 0; i < s->n; i++)
        to[i] *= s->scale[i];
    s->products++;
    work = dot(s, v, to);
    if (!isfinite(work))
        s->cause = OPERATOR_NOT_FINITE;
    else if (work <= 0)
        s->cause = OPERATOR_NOT_POSITIVE;
    return work;
}

/* The bound of y, which has no scale. */
static double least_of(const struct bounded_solver *s, int i)
{
    return s->least ? s->least[i] : 0;
}

static double free_part(const struct bounded_solver *s, int i)
{
    return s->y[i] > least_of(s, i) ? s->g[i] : 0;
}

static double chopped_part(const struct bounded_solver *s, int i)
{
    return s->y[i] > least_of(s, i) ? 0 : fmin(s->g[i], 0);
}

static double length(const struct bounded_solver *s)
{
    return share_of_length / s->norm;
}

/* to = the gradient where y > 0. */
static void set_free(const struct bounded_solver *s, double *to)
{
    for (int i = 0; i < s->n; i++)
        to[i] = free_part(s, i);
}

/* 2-norm of what is missing, without the scale. */
static double missing(struct bounded_solver *s)
{
    for (int i = 0; i < s->n; i++)
        s->scratch[i] = (free_part(s, i) + chopped_part(s, i)) / s->scale[i];
    return sqrt(dot(s, s->scratch, s->scratch));
}

/* Is what wants to leave zero small beside what is wrong elsewhere? */
static bool proportional(struct bounded_solver *s)
{
    double chopped;

    for (int i = 0; i < s->n; i++)
        s->scratch[i] = chopped_part(s, i);
    chopped = dot(s, s->scratch, s->scratch);
    for (int i = 0; i < s->n; i++)
        s->scratch[i] = fmin((s->y[i] - least_of(s, i)) / length(s), free_part(s, i));
    set_free(s, s->step);
    return chopped <= dot(s, s->scratch, s->step);
}

/* y -= by p, which is not to leave the bounds. */
static void move(struct bounded_solver *s, double by, const double *p)
{
    for (int i = 0; i < s->n; i++) {
        s->y[i] = fmax(least_of(s, i), s->y[i] - by * p[i]);
        s->g[i] -= by * s->image[i];
    }
}

/* Along the reduced gradient, to bounds where it leads beyond. */
static void expand(struct bounded_solver *s)
{
    double change;

    do {
        for (int i = 0; i < s->n; i++)
            s->step[i] = fmax(least_of(s, i) - s->y[i], -length(s) * free_part(s, i));
        if (dot(s, s->step, s->step) == 0)
            return;
        change = product(s, s->step, s->image) / 2 + dot(s, s->g, s->step);
        if (s->cause != OPERATOR_SOLVED)
            return;
        if (change > 0)
            s->norm *= 2;
    } while (change > 0 && s->products < s->most);
    move(s, -1, s->step);
}

/* How far along p until the first unknown is at its bound. */
static double room(const struct bounded_solver *s)
{
    double most = INFINITY;

    for (int i = 0; i < s->n; i++)
        if (s->p[i] > 0 && s->y[i] - least_of(s, i) < most * s->p[i])
            most = (s->y[i] - least_of(s, i)) / s->p[i];
    return most;
}

/* On the face, as far as it goes. */
static void search(struct bounded_solver *s)
{
    const double work = product(s, s->p, s->image), most = room(s);
    const double by = dot(s, s->g, s->p) / work;

    if (s->cause != OPERATOR_SOLVED)
        return;
    if (by > most) {
        move(s, most, s->p);
        expand(s);
        set_free(s, s->p);
        return;
    }
    move(s, by, s->p);
    set_free(s, s->step);
    const double turn = dot(s, s->step, s->image) / work;
    for (int i = 0; i < s->n; i++)
        s->p[i] = s->step[i] - turn * s->p[i];
}

static void release(struct bounded_solver *s)
{
    double work;

    for (int i = 0; i < s->n; i++)
        s->step[i] = chopped_part(s, i);
    work = product(s, s->step, s->image);
    if (s->cause != OPERATOR_SOLVED)
        return;
    move(s, dot(s, s->g, s->step) / work, s->step);
    set_free(s, s->p);
}

static void begin(struct bounded_solver *s, const double *x, const double *residual)
{
    s->products = 0;
    s->norm = first_norm;
    s->cause = OPERATOR_SOLVED;
    for (int i = 0; i < s->n; i++) {
        s->scale[i] = 1 / sqrt(s->a->diagonal[i]);
        s->y[i] = x[i] / s->scale[i];
        s->g[i] = -residual[i] * s->scale[i];
    }
    set_free(s, s->p);
}

int bounded_solve(struct bounded_solver *s, const struct operator *a, const double *least,
                  double *x, double *residual, struct operator_report *report)
{
    double first, left;

    s->a = a;
    s->least = least;
    begin(s, x, residual);
    first = left = missing(s);
    while (left > a->near && s->products < s->most && s->cause == OPERATOR_SOLVED) {
        (proportional(s) ? search : release)(s);
        left = missing(s);
    }
    if (s->cause == OPERATOR_SOLVED && !(left <= a->near))
        s->cause = isfinite(left) ? OPERATOR_TOO_MANY : OPERATOR_NOT_FINITE;
    *report = (struct operator_report){ .cause = s->cause, .products = s->products,
                                        .residual = first > 0 ? left / first : 0 };
    for (int i = 0; i < s->n; i++)
        residual[i] = -(free_part(s, i) + chopped_part(s, i)) / s->scale[i];
    if (s->cause != OPERATOR_SOLVED)
        return STATUS_FAILED;
    for (int i = 0; i < s->n; i++)
        x[i] = s->y[i] * s->scale[i];
    return STATUS_DONE;
}

int bounded_solver_create(int n, int most, struct bounded_solver **out)
{
    struct bounded_solver *s = *out = status_alloc(1, sizeof *s);

    if (!s)
        return STATUS_FAILED;
    s->n = n;
    s->most = most;
    double **const vector[VECTORS] = { &s->y, &s->g, &s->p, &s->image, &s->scale, &s->scratch,
                                       &s->step };
    for (int i = 0; i < VECTORS; i++)
        if (!(*vector[i] = status_alloc((size_t)n, sizeof **vector[i])))
            return STATUS_FAILED;
    s->partial = status_alloc((size_t)n / 1024 + 1, sizeof *s->partial);
    return s->partial ? STATUS_DONE : STATUS_FAILED;
}

void bounded_solver_free(struct bounded_solver **solver)
{
    struct bounded_solver *s = *solver;

    if (!s)
        return;
    double *const memory[] = { s->y, s->g, s->p, s->image, s->scale, s->scratch, s->step,
                               s->partial };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        free(memory[i]);
    free(s);
    *solver = NULL;
}
