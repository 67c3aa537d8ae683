/* release.c -- the pressure of fluid that is let go: the way to (R1).
 *
 *     (E/tau^2 + A) dP = S^T D a(P),  A = S^T D M^-1 G S
 *
 * again and again.  Each round is an implicit Euler step tau of linear sound, after which a
 * wave of wave number k has the part 1/(1 + (tau c0 k)^2) left: E = m rho0^2/c0^2 makes it
 * positive definite, and what no force depends on stays as it was.  tau is the time in which
 * sound goes through all fluid, and rounds end when forces hardly change any more, so what
 * forces hardly depend on stays, too.  Where P >= 0 holds, particles with P = 0 that part
 * from others wait for the next round. */
#include "implicit/release.h"

#include "base/status.h"
#include "implicit/release-inside.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 60, PRODUCTS = 20000 };
static const double enough = 3e-3; /* change of accelerations in the last round, of those by
                                      all but the pressure (rms)                       */
static const double exact = 0.1;   /* residual of a round, of that at its beginning    */

static bool is_asked(const struct plan *p)
{
    bool asked = false;

    for (int i = 0; i < p->in.fluids; i++)
        asked |= strcmp(p->in.fluid[i].set.initial, "released") == 0;
    return asked && p->pressure && p->row.density[KIND_FLUID] >= 0;
}

/* The longest side of the box around all fluid [m]. */
static double extent(const struct plan *p)
{
    double longest = p->scales.dx;

    for (int d = 0; d < DIM; d++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (int i = 0; i < particles_count(p->particles, KIND_FLUID); i++) {
            low = fmin(low, p->particles->x0[i][d]);
            high = fmax(high, p->particles->x0[i][d]);
        }
        longest = fmax(longest, high - low + p->scales.dx);
    }
    return longest;
}

/* --- memory ---------------------------------------------------------------------- */

static int take_memory(struct release *r)
{
    const size_t n = (size_t)r->n, places = (size_t)r->m->list->listed + 1;
    double **vector[] = { &r->P, &r->drive, &r->rate, &r->weight, &r->still, &r->diagonal,
                          &r->solve.x, &r->solve.residual, &r->solve.image, &r->solve.scratch };
    int unknowns = 0;

    for (size_t i = 0; i < sizeof vector / sizeof vector[0]; i++)
        if (!(*vector[i] = status_alloc(n + 1, sizeof **vector)))
            return STATUS_FAILED;
    for (int i = 0; i < r->m->plan->bodies; i++) {
        const struct moment_body *b = &r->m->body[i];
        if (b->kind->role.coupled && b->kind->role.coupled->unknowns(b->body) > unknowns)
            unknowns = b->kind->role.coupled->unknowns(b->body);
    }
    r->parts = status_alloc(n + 1, sizeof *r->parts);
    r->modes = status_alloc(2 * (size_t)unknowns + 1, sizeof *r->modes);
    r->ydot = status_alloc((size_t)moment_size(r->m) + 1, sizeof *r->ydot);
    r->scalar = workspace_lines(places);
    r->vector = workspace_lines(places * NABLA_STRIDE);
    if (!r->parts || !r->modes || !r->ydot || !r->scalar || !r->vector)
        return STATUS_FAILED;
    return operator_solver_create(r->fluid, PRODUCTS, &r->solve.solver);
}

static void free_memory(struct release *r)
{
    double *const memory[] = { r->P, r->drive, r->rate, r->weight, r->still, r->diagonal,
                               r->solve.x, r->solve.residual, r->solve.image, r->solve.scratch,
                               r->scalar, r->vector, r->ydot,
                               r->modes };

    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        free(memory[i]);
    free(r->parts);
    operator_solver_free(&r->solve.solver);
}

/* --- pressures and densities ------------------------------------------------------ */

/* p of P = p/rho^2, rho that of p: rho^2 hardly changes. */
static double pressure_of(const struct release *r, double P)
{
    double rho = r->eos->rho0;

    for (int i = 0; i < 12; i++)
        rho = eos_density(r->eos, P * rho * rho);
    return P * rho * rho;
}

/* Pressure that the particle in row c starts with, before it is solved for. */
static double first_pressure(const struct release *r, const double *y, int k, int c)
{
    const struct plan *p = r->m->plan;

    if (k != KIND_FLUID)
        return plan_start_pressure(p, p->particles->x0[c]);
    return eos_pressure(r->eos, y[layout_at(&p->layout, p->row.density[k]) + c]);
}

static void guess(struct release *r, const double *y)
{
    const struct list *l = r->m->list;

    for (int k = 0; k < KINDS; k++)
        for (int s = l->start[k]; s < l->start[k + 1]; s++) {
            const double p = first_pressure(r, y, k, l->order[s]);
            const double rho = eos_density(r->eos, p);
            r->P[s] = p / (rho * rho);
        }
}

static int write_densities(struct release *r, double *y)
{
    const struct plan *p = r->m->plan;
    const struct list *l = r->m->list;

    for (int k = 0; k < KINDS; k++)
        for (int s = l->start[k]; s < l->start[k + 1] && p->row.density[k] >= 0; s++) {
            const int c = l->order[s];
            double *rho = y + layout_at(&p->layout, p->row.density[k]) + c - p->particles->from[k];
            *rho = eos_density(r->eos, pressure_of(r, r->P[s]));
            if (!isfinite(*rho))
                return status_fail(STATUS_FAILED, "the start: no density has the pressure %g Pa "
                                   "of particle %d when the fluid is let go; a higher eos.c0 "
                                   "has one, or start with initial = \"hydrostatic\"",
                                   r->P[s] * r->eos->rho0 * r->eos->rho0, c);
        }
    plan_start_press(p, y);
    return STATUS_DONE;
}

/* --- the way ----------------------------------------------------------------------- */

/* S^T D a at P; fluid that parts where P = 0 is left out of the next round. */
static void look(struct release *r)
{
    release_multiply(r, r->P, r->rate);
    for (int s = 0; s < r->n; s++)
        r->rate[s] = r->drive[s] - r->rate[s];
    release_gather(r, r->rate);
    for (int s = 0; s < r->fluid; s++)
        r->parts[s] = r->eos->clamped && r->P[s] <= 0 && r->rate[s] <= 0;
}

/* x = dP of one round. */
static int solve_round(struct release *r)
{
    struct release_solve *const of = &r->solve;
    struct operator_report report;
    double square = 0;
    char why[200];

    for (int s = 0; s < r->fluid; s++) {
        of->residual[s] = r->parts[s] ? 0 : r->rate[s];
        of->x[s] = 0;
        square += of->residual[s] * of->residual[s];
    }
    if (square < DBL_MIN)
        return STATUS_DONE;
    of->operator.near = exact * sqrt(square);
    if (operator_solve(of->solver, &of->operator, of->x, of->residual, &report) == STATUS_DONE)
        return STATUS_DONE;
    operator_refusal(&report, why, sizeof why);
    return status_fail(STATUS_FAILED, "the start: no pressure is found for fluid that is let go: "
                       "%s; start with initial = \"hydrostatic\"", why);
}

/* Goes on by x, and looks.  What the change does, dP . A dP: the sum of m |da|^2. */
static double go_on(struct release *r)
{
    double change = 0;

    release_extend(r, r->solve.x);
    for (int s = 0; s < r->n; s++) {
        const double before = r->P[s];
        r->P[s] = r->eos->clamped ? fmax(before + r->solve.x[s], 0) : before + r->solve.x[s];
        r->solve.x[s] = r->P[s] - before;
        change += s < r->fluid ? r->solve.x[s] * r->rate[s] : 0;
    }
    look(r);
    for (int s = 0; s < r->fluid; s++)
        change -= r->solve.x[s] * r->rate[s];
    return change;
}

/* The sum of m a^2 of the fluid by all but the pressure. */
static double pushes(const struct release *r)
{
    const double *udot = r->ydot + layout_at(&r->m->layout, r->m->plan->row.u);
    double sum = 0;

    for (int i = 0; i < particles_count(r->m->particles, KIND_FLUID) * DIM; i++)
        sum += r->m->particles->m[i / DIM] * udot[i] * udot[i];
    return sum;
}

static int find(struct release *r)
{
    double change = 0, whole = pushes(r);

    free(r->ydot);
    r->ydot = NULL; /* before the solver writes its vectors */
    look(r);
    for (int i = 0; i < ROUNDS; i++) {
        TRY(solve_round(r));
        change = go_on(r);
        whole = whole > 0 ? whole : change; /* walls alone push */
        if (change <= enough * enough * whole)
            return STATUS_DONE;
    }
    return status_fail(STATUS_FAILED, "the start: no pressure is found for fluid that is let go: "
                       "after %d rounds its forces still change by %.3g of all; start with "
                       "initial = \"hydrostatic\"", ROUNDS, sqrt(change / whole));
}

static void set(struct release *r, struct moment *m)
{
    const struct plan *p = m->plan;
    const double sound = extent(p) / p->scales.c0;

    *r = (struct release){ .m = m, .nabla = p->engine->nabla, .eos = p->pressure->self,
                           .n = m->list->start[KINDS],
                           .fluid = m->list->start[KIND_FLUID + 1], .tau = sound };
    for (int k = 0; k < KINDS; k++)
        if (p->list_def.acts[k] & KIND_BIT(KIND_FLUID)) {
            r->kinds |= KIND_BIT(k);
            r->meets[k] |= KIND_BIT(KIND_FLUID);
            r->meets[KIND_FLUID] |= KIND_BIT(k);
        }
    r->job = (struct nabla_job){ .list = m->list, .record = m->work->record, .meets = r->meets,
                                 .kernel = p->kernel[PART_PRESSURE] };
    r->beside = r->job;
    r->beside.meets = r->meets_beside;
    memcpy(r->meets_beside, r->meets, sizeof r->meets);
    r->meets_beside[KIND_FLUID] &= KIND_SOLIDS;
}

static int solve(struct moment *m, double *y)
{
    struct release r;
    struct view v;
    int status;

    if (rates_fields(m, 0, y, &v) != STATUS_DONE)
        return status_fail(STATUS_FAILED, "the start: %s", moment_refusal(m));
    set(&r, m);
    status = moment_agree(m, take_memory(&r));
    if (status == STATUS_DONE)
        status = release_assemble(&r, y);
    if (status == STATUS_DONE) {
        guess(&r, y);
        status = find(&r);
    }
    if (status == STATUS_DONE)
        status = write_densities(&r, y);
    free_memory(&r);
    return status;
}

double release_memory(const struct plan *p)
{
    const double n = p->particles->n, fluid = particles_count(p->particles, KIND_FLUID);
    const double solver = 6; /* vectors that conjugate gradients have */

    return is_asked(p) ? sizeof(double) * (n * (8 + NABLA_STRIDE) + fluid * (3 + solver)) : 0;
}

int release_start(struct moment *m, double *y)
{
    int status;

    plan_start(m->plan, y);
    if (!is_asked(m->plan))
        return STATUS_DONE;
    TRY(moment_share(m, y, MOMENT_ALL)); /* sums over pairs, as they are nearly all of the work */
    status = solve(m, y);
    moment_unshare(m);
    moment_restart(m);
    return status;
}
