/* operator.c -- products with an operator, and its solve by SUNLinSol_PCG.
 *
 * The preconditioner is the diagonal, with what eliminated bodies add to it, and the solves
 * of other bodies.  That is also where the solve
 * is told to stop, which needs no product more: a largest correction says how wrong the
 * unknowns are, of the fluid and of bodies alike, while SUNDIALS' own stop, a norm of
 * residuals, knows nothing of bodies, whose soft modes are a millionth of a residual. */
#include "implicit/operator.h"

#include "algebra/vector.h"
#include "base/status.h"
#include "base/threads.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_pcg.h>

enum { WORTH_THREADS = 4096 };

struct operator_solver {
    SUNContext context;
    SUNLinearSolver gradients;
    N_Vector b, correction;
    int size, most;
    double *partial; /* sums of blocks */
};

/* What the callbacks of one solve know. */
struct search {
    const struct operator *a;
    struct operator_solver *solver;
    double *residual;
    struct operator_progress at;
    enum operator_cause cause;
    bool enough;
};

int operator_size(const struct operator *a)
{
    int size = a->n;

    for (int i = 0; i < a->bodies; i++)
        size += a->body[i].eliminated ? 0 : a->body[i].n;
    return size;
}

/* to += C B^-1 C^T x. */
static void add_eliminated(const struct operator_body *b, double *v, const double *x, double *to)
{
    memset(v, 0, (size_t)b->n * sizeof *v);
    b->gather(b->self, x, v);
    b->solve(b->self, v);
    b->spread(b->self, v, to);
}

void operator_apply(const struct operator *a, const double *x, double *to)
{
    int at = a->n;

    a->apply(a->self, x, to);
    for (int i = 0; i < a->bodies; i++) {
        const struct operator_body *b = &a->body[i];
        if (b->eliminated) {
            add_eliminated(b, a->modes, x, to);
            continue;
        }
        b->apply(b->self, x + at, to + at);
        if (b->spread) {
            b->spread(b->self, x + at, to);
            b->gather(b->self, x, to + at);
        }
        at += b->n;
    }
}

/* near -= D^-1 C (B + C^T D^-1 C)^-1 C^T near; its largest entry. */
static double temper(const struct operator *a, double *near)
{
    double most = 0, *v = a->modes;

    memset(a->image, 0, (size_t)a->n * sizeof *a->image);
    for (int i = 0; i < a->bodies; i++)
        if (a->body[i].eliminated) {
            memset(v, 0, (size_t)a->body[i].n * sizeof *v);
            a->body[i].gather(a->body[i].self, near, v);
            v += a->body[i].n;
        }
    a->temper(a->self, a->modes);
    v = a->modes;
    for (int i = 0; i < a->bodies; i++)
        if (a->body[i].eliminated) {
            a->body[i].spread(a->body[i].self, v, a->image);
            v += a->body[i].n;
        }
    for (int k = 0; k < a->n; k++) {
        near[k] -= a->image[k] / a->diagonal[k / a->width];
        most = fmax(most, fabs(near[k]));
    }
    return most;
}

/* The same by the operator's own M. */
static double precondition_own(const struct operator *a, const double *residual, double *near)
{
    double most = 0;

    a->precondition(a->self, residual, near);
    for (int k = 0; k < a->n; k++)
        most = fmax(most, fabs(near[k]));
    return most;
}

static void keep_larger(double *most, double mine)
{
    *most = fmax(*most, mine);
}

/* Rows of this thread. */
static void divide_part(const struct operator *a, const double *residual, double *near, double *most)
{
    const struct threads_part part = threads_part(a->n / a->width);
    const int width = a->width;
    double mine = 0;

    for (int i = part.from; i < part.to; i++)
        for (int k = i * width; k < (i + 1) * width; k++) {
            near[k] = residual[k] / a->diagonal[i];
            mine = fmax(mine, fabs(near[k]));
        }
    THREADS_IN_TURN(keep_larger(most, mine));
}

/* near = M^-1 residual; its largest entry. */
static double precondition(const struct operator *a, const double *residual, double *near)
{
    double most = 0;
    int at = a->n;

    THREADS(a->n / a->width > WORTH_THREADS, divide_part(a, residual, near, &most));
    if (a->temper)
        most = temper(a, near);
    for (int i = 0; i < a->bodies; i++) {
        const struct operator_body *b = &a->body[i];
        if (b->eliminated)
            continue;
        memcpy(near + at, residual + at, (size_t)b->n * sizeof *near);
        b->solve(b->self, near + at);
        most = fmax(most, b->largest(b->self, near + at));
        at += b->n;
    }
    return most;
}

/* Not 0: a refusal. */
static int sign(struct search *s, double square)
{
    if (square >= 0 && isfinite(square))
        return 0;
    s->cause = isfinite(square) ? OPERATOR_NOT_POSITIVE : OPERATOR_NOT_FINITE;
    return -1;
}

static int on_product(void *self, N_Vector v, N_Vector image)
{
    struct search *s = self;
    double *to = vector_overwrite(image);
    const double *x = vector_read(v);

    operator_apply(s->a, x, to);
    s->at.products++;
    return sign(s, vector_dot(s->solver->size, x, to, s->solver->partial));
}

/* Positive: stop here, what was found so far stands.  Negative: a refusal. */
static int on_precondition(void *self, N_Vector residual, N_Vector near, sunrealtype tol,
                           int side)
{
    struct search *s = self;
    const struct operator *a = s->a;
    double *to = vector_overwrite(near);

    (void)tol, (void)side;
    vector_copy(s->solver->size, vector_read(residual), s->residual);
    if (a->clear)
        a->clear(a->self, s->residual);
    s->at.correction = (a->precondition ? precondition_own : precondition)(a, s->residual, to);
    s->at.work = vector_dot(s->solver->size, s->residual, to, s->solver->partial);
    TRY(sign(s, s->at.work));
    s->enough = a->enough && a->enough(a->self, &s->at);
    if (a->leave)
        a->leave(a->self, to);
    return s->enough;
}

static void tell(const struct search *s, bool solved, struct operator_report *report)
{
    const struct operator_solver *o = s->solver;
    const double *b = vector_read(o->b);
    const double first = sqrt(vector_dot(o->size, b, b, o->partial));

    report->cause = s->cause;
    if (!solved && s->cause == OPERATOR_SOLVED)
        report->cause = s->at.products < o->most ? OPERATOR_BROKEN : OPERATOR_TOO_MANY;
    report->products = s->at.products;
    report->correction = s->at.correction;
    report->residual = first > 0 ? SUNLinSolResNorm(o->gradients) / first : 0;
}

int operator_solve(struct operator_solver *s, const struct operator *a, double *x,
                   double *residual, struct operator_report *report)
{
    struct search search = { .a = a, .solver = s, .residual = residual };
    const double *correction;
    int code;

    vector_copy(s->size, residual, vector_overwrite(s->b));
    N_VConst(0, s->correction);
    SUNLinSolSetATimes(s->gradients, &search, on_product);
    SUNLinSolSetPreconditioner(s->gradients, &search, NULL, on_precondition);
    SUNLinSolSetZeroGuess(s->gradients, 1);
    code = SUNLinSolSolve(s->gradients, NULL, s->correction, s->b, a->near);
    tell(&search, code == 0 || search.enough, report);
    if (report->cause != OPERATOR_SOLVED)
        return STATUS_FAILED;
    correction = vector_read(s->correction);
    for (int i = 0; i < s->size; i++)
        x[i] += correction[i];
    vector_copy(s->size, vector_read(SUNLinSolResid(s->gradients)), residual);
    return STATUS_DONE;
}

void operator_refusal(const struct operator_report *report, char *text, size_t size)
{
    static const char *const why[] = {
        [OPERATOR_SOLVED] = "which is exact enough",
        [OPERATOR_TOO_MANY] = "it takes too many",
        [OPERATOR_NOT_FINITE] = "numbers are not finite any more",
        [OPERATOR_NOT_POSITIVE] = "the matrix is not positive definite",
        [OPERATOR_BROKEN] = "SUNDIALS gave up",
    };

    snprintf(text, size, "after %d products its residual is %.3g of the first: %s",
             report->products, report->residual, why[report->cause]);
}

int operator_solver_create(int size, int most, struct operator_solver **out)
{
    struct operator_solver *s = *out = status_alloc(1, sizeof *s);

    if (!s || !(s->partial = status_alloc((size_t)size / 1024 + 1, sizeof *s->partial)))
        return STATUS_FAILED;
    s->size = size;
    s->most = most;
    TRY(sundials_open(&s->context));
    s->b = vector_create(size, VECTOR_NORM_MAX, s->context);
    if (!s->b)
        return STATUS_FAILED;
    s->correction = N_VClone(s->b);
    s->gradients = SUNLinSol_PCG(s->b, SUN_PREC_LEFT, most, s->context);
    if (!s->correction || !s->gradients)
        return status_starved("%d unknowns cannot be solved for", size);
    return STATUS_DONE;
}

void operator_solver_free(struct operator_solver **solver)
{
    struct operator_solver *s = *solver;

    if (!s)
        return;
    if (s->gradients)
        SUNLinSolFree(s->gradients);
    if (s->correction)
        N_VDestroy(s->correction);
    if (s->b)
        N_VDestroy(s->b);
    sundials_close(&s->context);
    free(s->partial);
    free(s);
    *solver = NULL;
}
