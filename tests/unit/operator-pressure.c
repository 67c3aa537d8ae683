/* operator-pressure.c -- the operator of a pressure that is solved for, as a client of
 * implicit/operator.h. */
#include "operator-pressure.h"

#include "../physics/tank.h"
#include "kernels/kernel.h"
#include "space/record.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

void pressure_gradient(const struct pressure *p, int i, int j, double g[DIM])
{
    const double *a = p->moment->work->record + (size_t)i * RECORD;
    const double *b = p->moment->work->record + (size_t)j * RECORD;
    double r = 0;

    for (int d = 0; d < DIM; d++) {
        g[d] = a[d] - b[d];
        r += g[d] * g[d];
    }
    r = sqrt(r);
    for (int d = 0; d < DIM; d++)
        g[d] *= kernel_gradient(p->moment->plan->kernel[0], r) / r;
}

/* What an owner adds up over its neighbours, of x [][1] or a [][DIM]. */
typedef void pass_pair(const double *own, const double *other, const double g[DIM], double *sum);

static void add_down(const double *own, const double *other, const double g[DIM], double *sum)
{
    for (int d = 0; d < DIM; d++)
        sum[d] += (*own + *other) * g[d];
}

static void add_up(const double *own, const double *other, const double g[DIM], double *sum)
{
    for (int d = 0; d < DIM; d++)
        *sum += (own[d] - other[d]) * g[d];
}

/* Sums of the owner in lane l of group k, in the order of the list. */
static void sum_owner(const struct pressure *p, int k, int l, int width, const double *value,
                      pass_pair *pair, double *sum)
{
    const struct list *list = p->list;
    const int i = list->group_slot[k] + l;
    double g[DIM];

    for (int q = list->segment_from[k]; q < list->segment_from[k + 1]; q++)
        for (int row = 0; row < list->segment[q].rows; row++) {
            const int j = list_place(list->segment[q].j[row * list->lanes + l]);
            if (j == list->listed)
                continue;
            pressure_gradient(p, i, j, g);
            pair(value + (size_t)i * (size_t)width, value + (size_t)j * (size_t)width, g, sum);
        }
}

static bool owns(const struct list *list, int k, int l)
{
    return list->group_slot[k] + l < list->start[list->group_kind[k] + 1];
}

void pressure_down(const struct pressure *p, unsigned kinds, const double *x, double *f)
{
    const struct list *list = p->list;

    memset(f, 0, (size_t)p->n * DIM * sizeof *f);
#pragma omp parallel for schedule(static)
    for (int k = 0; k < list->groups; k++)
        for (int l = 0; l < list->lanes && owns(list, k, l); l++) {
            double *to = f + (size_t)(list->group_slot[k] + l) * DIM;
            if (!(kinds & KIND_BIT(list->group_kind[k])))
                continue;
            sum_owner(p, k, l, 1, x, add_down, to);
            for (int d = 0; d < DIM; d++)
                to[d] *= p->volume;
        }
}

void pressure_up(const struct pressure *p, double c, const double *a, double *to)
{
    const struct list *list = p->list;

#pragma omp parallel for schedule(static)
    for (int k = 0; k < list->groups; k++)
        for (int l = 0; l < list->lanes && owns(list, k, l); l++) {
            double sum = 0;
            sum_owner(p, k, l, DIM, a, add_up, &sum);
            to[list->group_slot[k] + l] += c * p->volume * sum;
        }
}

static void apply(void *self, const double *x, double *to)
{
    struct pressure *p = self;

    for (int i = 0; i < p->n; i++)
        to[i] = p->least * x[i];
    pressure_down(p, KIND_BIT(KIND_FLUID), x, p->a);
    pressure_up(p, p->tau * p->tau / p->rho0, p->a, to);
}

/* Slot of a point of the beam's skin, -1: it is not listed. */
static int slot_of(const struct pressure *p, int j)
{
    const struct moment_body *b = &p->moment->body[0];

    return p->list->slot[p->moment->particles->object[b->object].from + j];
}

/* C = tau sqrt(V) J_s S. */
static void spread(void *self, const double *v, double *to)
{
    struct pressure *p = self;
    const struct moment_body *b = &p->moment->body[0];

    memset(p->a, 0, (size_t)p->n * DIM * sizeof *p->a);
    b->kind->role.coupled->drift(b->body, v, p->points);
    for (int j = 0; j < b->skin; j++)
        if (slot_of(p, j) >= 0)
            memcpy(p->a + (size_t)slot_of(p, j) * DIM, p->points[j], sizeof p->points[j]);
    pressure_up(p, p->tau * sqrt(p->volume), p->a, to);
}

static void gather(void *self, const double *x, double *v)
{
    struct pressure *p = self;
    const struct moment_body *b = &p->moment->body[0];

    pressure_down(p, KIND_BIT(KIND_SKIN), x, p->a);
    memset(p->points, 0, (size_t)b->skin * sizeof *p->points);
    for (int j = 0; j < b->skin; j++)
        if (slot_of(p, j) >= 0)
            memcpy(p->points[j], p->a + (size_t)slot_of(p, j) * DIM, sizeof p->points[j]);
    b->kind->role.coupled->pull(b->body, b->work, (const double (*)[DIM])p->points,
                           p->tau * sqrt(p->volume), v);
}

static void solve(void *self, double *v)
{
    const struct pressure *p = self;
    const struct moment_body *b = &p->moment->body[0];

    b->kind->role.coupled->joined(b->body, b->work, v);
}

/* Of the fluid's part; the beam's is left to the iterations. */
static void set_diagonal(struct pressure *p)
{
    const struct list *l = p->list;
    double g[DIM];

    for (int k = 0; k < l->groups; k++)
        for (int lane = 0; lane < l->lanes && owns(l, k, lane); lane++) {
            const int i = l->group_slot[k] + lane;
            double all[DIM] = { 0 }, sum = 0;
            for (int q = l->segment_from[k]; q < l->segment_from[k + 1]; q++)
                for (int row = 0; row < l->segment[q].rows; row++) {
                    const int j = list_place(l->segment[q].j[row * l->lanes + lane]);
                    if (j == l->listed)
                        continue;
                    pressure_gradient(p, i, j, g);
                    for (int d = 0; d < DIM; d++) {
                        sum += l->segment[q].partner == KIND_FLUID ? g[d] * g[d] : 0;
                        all[d] += g[d];
                    }
                }
            for (int d = 0; d < DIM && l->group_kind[k] == KIND_FLUID; d++)
                sum += all[d] * all[d];
            p->diagonal[i] += p->tau * p->tau / p->rho0 * p->volume * p->volume * sum;
        }
}

static void join_beam(struct pressure *p, double gamma)
{
    const struct moment_body *b = &p->moment->body[0];

    p->body = (struct operator_body){
        .self = p, .n = b->kind->role.coupled->unknowns(b->body), .eliminated = true,
        .spread = spread, .gather = gather, .solve = solve,
    };
    p->points = test_calloc((size_t)b->skin, sizeof *p->points);
    p->modes = test_calloc((size_t)p->body.n, sizeof *p->modes);
    p->image = test_calloc((size_t)p->n, sizeof *p->image);
    assert_int_equal(b->kind->role.coupled->join(b->body, b->work, gamma, p->points[0]), 0);
}

void pressure_make(struct pressure *p, struct moment *m, const double *y, double stiffness,
                   bool beam, double gamma)
{
    const struct scales *s = plan_scales(m->plan);
    const double c = 30 * sqrt(2 * 9.81 * 0.06);
    struct view v;

    assert_int_equal(rates_fields(m, 0, y, &v), 0);
    *p = (struct pressure){
        .moment = m, .list = m->list, .n = m->list->start[KINDS], .rho0 = s->rho0,
        .volume = pow(s->dx, DIM), .tau = stiffness * s->dx / c, .least = 1 / (s->rho0 * c * c),
    };
    p->diagonal = test_calloc((size_t)p->n, sizeof *p->diagonal);
    p->a = test_calloc((size_t)p->n * DIM, sizeof *p->a);
    for (int i = 0; i < p->n; i++)
        p->diagonal[i] = p->least;
    set_diagonal(p);
    if (beam)
        join_beam(p, gamma);
    p->operator = (struct operator){
        .self = p, .n = p->n, .width = 1, .diagonal = p->diagonal, .apply = apply,
        .bodies = beam, .body = &p->body, .modes = p->modes,
    };
}

static void temper(void *self, double *v)
{
    const struct pressure *p = self;
    gsl_vector_view at = gsl_vector_view_array(v, (size_t)p->body.n);

    gsl_linalg_cholesky_svx(p->tempered, &at.vector);
}

/* B + C^T D^-1 C, a column for each unknown. */
void pressure_temper(struct pressure *p, double gamma)
{
    const struct moment_body *b = &p->moment->body[0];
    const size_t n = (size_t)p->body.n;
    double *mode = test_calloc(n, sizeof *mode), *column = test_calloc(n, sizeof *column);

    p->tempered = gsl_matrix_alloc(n, n);
    for (size_t k = 0; k < n; k++) {
        memset(mode, 0, n * sizeof *mode);
        memset(p->image, 0, (size_t)p->n * sizeof *p->image);
        mode[k] = 1;
        b->kind->role.coupled->inertia(b->body, b->work, gamma, mode, column);
        spread(p, mode, p->image);
        for (int i = 0; i < p->n; i++)
            p->image[i] /= p->diagonal[i];
        gather(p, p->image, column);
        for (size_t i = 0; i < n; i++)
            gsl_matrix_set(p->tempered, i, k, column[i]);
    }
    assert_int_equal(gsl_linalg_cholesky_decomp1(p->tempered), 0);
    p->operator.temper = temper;
    p->operator.image = p->image;
    test_free(mode);
    test_free(column);
    memset(p->points, 0, (size_t)b->skin * sizeof *p->points); /* nothing is joined but B */
    assert_int_equal(b->kind->role.coupled->join(b->body, b->work, gamma, p->points[0]), 0);
}

void pressure_free(struct pressure *p)
{
    if (p->tempered)
        gsl_matrix_free(p->tempered);
    test_free(p->diagonal);
    test_free(p->a);
    if (p->modes) {
        test_free(p->points);
        test_free(p->modes);
        test_free(p->image);
    }
}
