/* cvode-methods.c -- the methods that CVODE runs. */
#include "time/cvode.h"

#define SOURCE "Hindmarsh et al., ACM Trans. Math. Softw. 31 (2005) 363-396"

static const char *bdf_serves(const struct plan *plan)
{
    return plan_size(plan) == 0 ? "nothing in this scene moves" : method_bodies_alone(plan);
}

static const char *adams_serves(const struct plan *plan)
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
    return vector_data(((const struct cvode *)self)->y);
}

static const char *table(const void *self)
{
    const struct cvode *c = self;

    return c->row->table[plan_stiff(moment_plan(c->rates.moment))];
}

#define VARIES                                                                           \
    "CVODE chooses length and order of its steps together and has no constant ones; set " \
    "`tol` instead, or take gsl-rkf45, imex3 or dv with a step in seconds"

#define METHOD(NAME, ABOUT, SERVES)                                                      \
    .method = { .name = NAME, .told = { ABOUT, SOURCE }, .adaptive = true,               \
                .varies = VARIES,                                                        \
                .serves = SERVES, .create = cvode_create, .step = cvode_step,            \
                .at = cvode_at, .state = state, .restart = cvode_restart,                \
                .table = table, .free = cvode_free, .room = { cvode_vectors, cvode_vectors }, \
                .rearrange = cvode_rearrange }

const struct cvode_row cvode_adams = {
    METHOD("adams", "multistep, CVODE's Adams-Moulton of order up to 12, fixed-point iteration",
           adams_serves),
    .family = CV_ADAMS, .order = { 12 },
    .table = { "CVODE Adams, order <= 12, fixed point" },
};

/* Vibrations of beams have eigenvalues i omega, where BDF of order 3 and more are not
 * stable: errors of modes that no step resolves would grow until all steps do. */
const struct cvode_row cvode_bdf = {
    METHOD("bdf", "multistep, implicit in everything, CVODE's BDF of order up to 5 (2 with "
                  "beams), matrix-free Newton-Krylov", bdf_serves),
    .family = CV_BDF, .order = { 5, 2 }, .newton = true,
    .table = { "CVODE BDF, order <= 5, Newton, SPGMR",
               "CVODE BDF, order <= 2, Newton, SPGMR with beams as preconditioner" },
};
