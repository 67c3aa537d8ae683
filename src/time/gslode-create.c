/* gslode-create.c -- the methods that GSL's odeiv2 steps, and how they begin. */
#include "time/gslode.h"

#include "base/status.h"
#include "time/failure.h"
#include <gsl/gsl_errno.h>
#include <stdlib.h>

/* --- what GSL asks for ------------------------------------------------------ */

static int rates(double t, const double y[], double f[], void *self)
{
    struct gslode *x = self;

    return rates_ask(&x->rates, t, y, f) == STATUS_DONE ? GSL_SUCCESS : GSL_FAILURE;
}

/* The error of entry i that may be made. */
static int level(void *self, double y, double f, double h, size_t i, double *out)
{
    const struct gslode *x = self;

    (void)y, (void)f, (void)h;
    *out = 1 / vector_data(x->weight)[i];
    return GSL_SUCCESS;
}

static const gsl_odeiv2_control_type levels = { .name = "weights of a plan", .errlevel = level };

/* --- memory ------------------------------------------------------------------- */

static int take_vectors(struct gslode *x)
{
    const struct vector_own own = moment_own(x->rates.moment);

    TRY(sundials_open(&x->context));
    x->weight = vector_create_own(x->n, x->def.norm, x->context, &own);
    if (!x->weight)
        return STATUS_FAILED;
    x->error = N_VClone(x->weight);
    if (!x->error)
        return failure_memory(x->row->method.name, x->n);
    moment_weights(x->rates.moment, x->def.tol, vector_data(x->weight));
    for (int k = 0; k < GSLODE_NODES; k++) {
        x->node[k].y = status_alloc((unsigned long)x->n, sizeof(double));
        x->node[k].f = status_alloc((unsigned long)x->n, sizeof(double));
        if (!x->node[k].y || !x->node[k].f)
            return STATUS_FAILED;
    }
    return STATUS_DONE;
}

/* GSL's default handler would end the program where memory runs out. */
static int take_stepper(struct gslode *x)
{
    gsl_error_handler_t *const before = gsl_set_error_handler_off();

    x->stepper = gsl_odeiv2_step_alloc(*x->row->type, (size_t)x->n);
    gsl_set_error_handler(before);
    if (!x->stepper)
        return failure_memory(x->row->method.name, x->n);
    x->system = (gsl_odeiv2_system){ .function = rates, .dimension = (size_t)x->n, .params = x };
    x->levels = (gsl_odeiv2_control){ .type = &levels, .state = x };
    x->driver = (gsl_odeiv2_driver){ .sys = &x->system, .s = x->stepper, .c = &x->levels };
    gsl_odeiv2_step_set_driver(x->stepper, &x->driver);
    return STATUS_DONE;
}

static int build(struct gslode *x, double t, const double *y)
{
    TRY(take_vectors(x));
    TRY(take_stepper(x));
    return gslode_restart(x, t, y, NULL);
}

int gslode_create(const struct method *m, const struct method_def *def, struct moment *moment,
                  double t, const double *y, void **out)
{
    struct gslode *x = status_alloc(1, sizeof *x);
    int code;

    *out = x;
    if (!x)
        return STATUS_FAILED;
    x->row = (const struct gslode_row *)m; /* its first member */
    x->def = *def;
    x->rates.moment = moment;
    x->n = moment_size(moment);
    code = build(x, t, y);
    if (code != STATUS_DONE)
        gslode_free(out);
    return code;
}

void gslode_free(void **self)
{
    struct gslode *x = *self;

    if (!x)
        return;
    if (x->stepper)
        gsl_odeiv2_step_free(x->stepper);
    for (int k = 0; k < GSLODE_NODES; k++) {
        free(x->node[k].y);
        free(x->node[k].f);
    }
    if (x->weight)
        N_VDestroy(x->weight);
    if (x->error)
        N_VDestroy(x->error);
    sundials_close(&x->context);
    free(x);
    *self = NULL;
}

/* --- the methods --------------------------------------------------------------- */

static const struct control_row runge_kutta = { { 0.60, -0.20, 0 }, 0.5, 1, 2.5 };
static const struct control_row multistep = { { 0.60, -0.20, 0 }, 0.5, 1, 2.5 };

static const char *serves(const struct plan *plan)
{
    if (plan_size(plan) == 0)
        return "nothing in this scene moves";
    if (plan_viscous(plan))
        return method_bodies_alone(plan);
    return plan_stiff(plan) ? "it takes beams explicitly with no bound of stability, and their "
                              "vibrations would feed energy in; imex3, dv and bdf serve beams"
                            : NULL;
}

static const double *state(const void *self)
{
    return ((const struct gslode *)self)->node[0].y;
}

static const char *table(const void *self)
{
    return ((const struct gslode *)self)->row->table;
}

static int vectors(const struct method *m, const struct plan *plan)
{
    (void)plan;
    return ((const struct gslode_row *)m)->vectors + 2 * GSLODE_NODES + 2; /* weights, errors */
}

/* Rates at nodes, and what SUNDIALS' vectors of runs have. */
static int own(const struct method *m, const struct plan *plan)
{
    (void)m, (void)plan;
    return GSLODE_NODES + 1;
}

#define METHOD(NAME, ORDER, ABOUT, SOURCE)                                               \
    .method = { .name = NAME, .told = { ABOUT, SOURCE }, .adaptive = true,               \
                .order = ORDER, .serves = serves, .create = gslode_create,               \
                .step = gslode_step,                                                     \
                .at = gslode_at, .state = state, .restart = gslode_restart,              \
                .table = table, .free = gslode_free, .room = { vectors, own },           \
                .rearrange = NULL }

const struct gslode_row gslode_rkf45 = {
    METHOD("gsl-rkf45", 5, "explicit, 6 stages, order 5(4), GSL's Runge-Kutta-Fehlberg",
           "Fehlberg, NASA TR R-315 (1969)"),
    .type = &gsl_odeiv2_step_rkf45, .order = 5, .embedded = 4, .first = 0.5, .stable = 3.4,
    .control = &runge_kutta, .table = "GSL rkf45, order 5(4)", .vectors = 8,
};

const struct gslode_row gslode_rk8pd = {
    METHOD("gsl-rk8pd", 8, "explicit, 13 stages, order 8(7), GSL's Prince-Dormand",
           "Prince, Dormand, J. Comput. Appl. Math. 7 (1981) 67-75"),
    .type = &gsl_odeiv2_step_rk8pd, .order = 8, .embedded = 7, .first = 0.5, .stable = 5.1,
    .control = &runge_kutta, .table = "GSL rk8pd, order 8(7)", .vectors = 15,
};

const struct gslode_row gslode_msadams = {
    METHOD("gsl-msadams", 0, "multistep, GSL's Adams of order up to 12, fixed-point iteration",
           "Byrne, Hindmarsh, ACM Trans. Math. Softw. 1 (1975) 71-96"),
    .type = &gsl_odeiv2_step_msadams, .first = 0.1, .stable = 1,
    .control = &multistep, .table = "GSL msadams, order <= 12", .vectors = 33,
};
