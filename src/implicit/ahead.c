/* ahead.c -- the solve for a pressure that looks ahead. */
#include "implicit/ahead.h"

#include "base/status.h"
#include "plan/solver.h"
#include "space/record.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PRODUCTS = 2000 };

static void ahead_free(void **self)
{
    struct ahead *a = *self;

    if (!a)
        return;
    double *const memory[] = { a->P, a->residual, a->b, a->term, a->rate, a->left.still,
                               a->left.diagonal, a->scalar, a->vector, a->kept.slope, a->past.P[0], a->past.P[1] };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        free(memory[i]);
    free(a->kept.rows);
    free(a->kept.j);
    free(a->push);
    free(a->walls.from);
    free(a->walls.to);
    free(a->walls.least);
    operator_solver_free(&a->solver);
    bounded_solver_free(&a->bounded);
    free(a);
    *self = NULL;
}

static void set_kinds(struct ahead *a, const struct plan *p)
{
    for (int k = 0; k < KINDS; k++)
        if (particles_count(p->particles, k) > 0 && p->row.density[k] >= 0) {
            a->kinds |= KIND_BIT(k);
            a->moving |= KIND_BIT(k) & ~(KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP));
            a->meets[k] |= KIND_BIT(KIND_FLUID);
            a->meets[KIND_FLUID] |= KIND_BIT(k);
        }
    a->job = (struct nabla_job){ .meets = a->meets, .kernel = p->kernel[PART_PRESSURE] };
}

static int take(struct ahead *a, const struct eos *eos)
{
    double **const vector[] = { &a->P, &a->residual, &a->b, &a->term, &a->rate, &a->left.still,
                               &a->left.diagonal, &a->past.P[0], &a->past.P[1] };

    for (size_t i = 0; i < sizeof vector / sizeof vector[0]; i++)
        if (!(*vector[i] = workspace_lines((size_t)a->n)))
            return STATUS_FAILED;
    TRY(ahead_bodies_create(a->m->plan, &a->push));
    TRY(ahead_walls_create(a, !eos->clamped));
    if (eos->clamped || a->walls.least)
        return bounded_solver_create(a->n, PRODUCTS, &a->bounded);
    return operator_solver_create(a->n, PRODUCTS, &a->solver);
}

static int ahead_create(struct moment *m, void **out)
{
    const struct plan *p = m->plan;
    struct ahead *a = *out = status_alloc(1, sizeof *a);

    if (!a)
        return STATUS_FAILED;
    a->m = m;
    a->n = p->particles->n;
    a->tau = p->pressure->part->as.pressure->ahead(p->pressure->self, &a->residual_share);
    a->residual_share = fmin(a->residual_share, p->in.set.tol);
    set_kinds(a, p);
    return take(a, p->pressure->self);
}

static int fit_groups(struct ahead *a, const struct list *l)
{
    const size_t want = (size_t)l->groups;

    if (want <= a->room.groups)
        return STATUS_DONE;
    free(a->kept.rows);
    a->room.groups = 0;
    a->kept.rows = status_alloc(want + want / 8, sizeof *a->kept.rows);
    if (!a->kept.rows)
        return STATUS_FAILED;
    a->room.groups = want + want / 8;
    return STATUS_DONE;
}

static int fit_pairs(struct ahead *a, const struct list *l)
{
    const size_t want = nabla_kept_pairs(l);

    if (want <= a->room.pairs)
        return STATUS_DONE;
    free(a->kept.j);
    free(a->kept.slope);
    a->room.pairs = 0;
    a->kept.j = status_alloc(want + want / 4, sizeof *a->kept.j);
    a->kept.slope = workspace_lines((want + want / 4) * DIM);
    if (!a->kept.j || !a->kept.slope)
        return STATUS_FAILED;
    a->room.pairs = want + want / 4;
    return STATUS_DONE;
}

/* After a rebuild there may be more groups, pairs and images. */
static int fit(struct ahead *a, const struct list *l)
{
    const size_t want = (size_t)l->listed + 1;

    TRY(fit_groups(a, l));
    TRY(fit_pairs(a, l));
    if (want <= a->room.places)
        return STATUS_DONE;
    free(a->scalar);
    free(a->vector);
    a->room.places = 0;
    a->scalar = workspace_lines(want + want / 8);
    a->vector = workspace_lines((want + want / 8) * NABLA_STRIDE);
    if (!a->scalar || !a->vector)
        return STATUS_FAILED;
    a->room.places = want + want / 8;
    return STATUS_DONE;
}

static int refuse(struct ahead *a, const struct operator_report *report, double t)
{
    const struct particles *all = a->m->particles;
    int worst = 0;
    char why[120];

    for (int s = 1; s < a->listed; s++)
        if (!(fabs(a->residual[s] / a->left.diagonal[s])
              <= fabs(a->residual[worst] / a->left.diagonal[worst])))
            worst = s;
    const int c = a->m->list->order[worst];
    operator_refusal(report, why, sizeof why);
    snprintf(a->m->refusal, sizeof a->m->refusal,
             "the pressure that looks ahead is not found at t = %g s: %s; worst near particle %d "
             "(%s); a lower eos.c0 or eos.tau, or a larger eos.residual, needs fewer products", t, why,
             particles_id_of(all, c), all->object[all->object_of[c]].name);
    return STATUS_FAILED;
}

/* The guess, and what is missing there; the norm of b.  What solids that press by means lack
 * until water comes drives nothing. */
static double begin(struct ahead *a)
{
    const int fluid = a->m->list->start[KIND_FLUID + 1];
    double square = 0;

    operator_apply(&a->operator, a->P, a->residual);
    for (int s = 0; s < a->n; s++) {
        const double drives = s < fluid || !a->m->work->mean ? a->b[s] : fmax(0, a->b[s]);
        a->residual[s] = a->b[s] - a->residual[s];
        square += drives * drives;
    }
    return sqrt(square);
}

static int solve(struct ahead *a, struct operator_report *report)
{
    if (a->bounded)
        return bounded_solve(a->bounded, &a->operator, a->walls.least, a->P, a->residual, report);
    return operator_solve(a->solver, &a->operator, a->P, a->residual, report);
}

/* Images have what their originals have. */
static void write_records(struct ahead *a)
{
    const struct list *l = a->m->list;

    memcpy(a->scalar, a->P, (size_t)a->listed * sizeof *a->P);
    ahead_walls_spread(a, a->scalar);
    for (int s = 0; s < l->listed; s++)
        a->m->work->record[(size_t)s * RECORD + RECORD_P2] = a->scalar[l->slot[l->order[s]]];
}

static int find(void *self, struct moment *m, double t, const double *y, const double *udot)
{
    struct ahead *a = self;
    const struct list *l = m->list;
    struct operator_report report;
    int status = STATUS_DONE;

    a->m = m;
    if (moment_agree(m, fit(a, l)) != STATUS_DONE) {
        snprintf(m->refusal, sizeof m->refusal, "no memory to solve for the pressure at t = %g s",
                 t);
        return status_starved("the pressure at t = %g s cannot be solved for", t);
    }
    TRY(ahead_bodies_set(a, t, y));
    ahead_assemble(a, udot);
    ahead_walls_bound(a);
    ahead_guess(a, t);
    a->operator.near = a->residual_share * begin(a);
    if (a->operator.near > 0)
        status = solve(a, &report);
    if (status != STATUS_DONE)
        return refuse(a, &report, t);
    if (a->operator.near > 0)
        m->counts.products += report.products;
    ahead_keep(a, t);
    write_records(a);
    return STATUS_DONE;
}

const struct plan_ahead_solver implicit_ahead = {
    .vectors = 16, /* those of struct ahead, seven of its solver */
    .create = ahead_create, .free = ahead_free, .find = find,
    .forget = ahead_forget, .power = ahead_power,
};
