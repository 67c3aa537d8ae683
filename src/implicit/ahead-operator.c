/* ahead-operator.c -- both sides of the system of a pressure that looks ahead. */
#include "implicit/ahead.h"

#include "space/record.h"

#include <string.h>

/* Images have what their originals have, the dummy nothing. */
static void complete(const struct ahead *a, int width, double *v)
{
    const struct list *l = a->m->list;

    for (int s = a->listed; s < l->listed; s++)
        memcpy(v + (size_t)s * (size_t)width, v + (size_t)l->slot[l->order[s]] * (size_t)width,
               (size_t)width * sizeof *v);
    memset(v + (size_t)l->listed * (size_t)width, 0, (size_t)width * sizeof *v);
}

static double mass(const struct ahead *a, int s)
{
    return a->m->particles->m[a->m->list->order[s]];
}

static const double *record(const struct ahead *a, int s)
{
    return a->m->work->record + (size_t)s * RECORD;
}

/* Of which the pressure is one. */
static double density(const struct ahead *a, int s)
{
    const struct particles *all = a->m->particles;
    const int i = a->m->list->order[s] - all->from[KIND_WALL];

    return a->m->work->mean && i >= 0 ? a->m->work->mean[i] : record(a, s)[RECORD_RHO];
}

/* to = (E + tau^2 D M^-1 G) x; what is in no list stays. */
static void apply(void *self, const double *x, double *to)
{
    struct ahead *a = self;
    const struct nabla_kept_engine *nabla = a->m->plan->engine->nabla_kept;
    const int fluid = a->m->list->start[KIND_FLUID + 1];
    const double *f = a->m->work->f, tau2 = a->tau * a->tau;

    memcpy(a->scalar, x, (size_t)a->listed * sizeof *x);
    ahead_walls_spread(a, a->scalar);
    complete(a, 1, a->scalar);
    nabla->gradient(&a->kept, a->moving, a->scalar, a->m->work->f);
    memset(a->vector, 0, (size_t)a->listed * NABLA_STRIDE * sizeof *a->vector);
    for (int s = 0; s < fluid; s++)
        for (int d = 0; d < DIM; d++)
            a->vector[s * NABLA_STRIDE + d] = f[s * DIM + d] / mass(a, s);
    ahead_bodies_yield(a);
    complete(a, NABLA_STRIDE, a->vector);
    nabla->divergence(&a->kept, a->kinds, a->vector, to);
    ahead_walls_mean(a, to);
    for (int s = 0; s < a->listed; s++)
        to[s] = a->left.still[s] * x[s] + tau2 * to[s];
    for (int s = a->listed; s < a->n; s++)
        to[s] = x[s];
}

static void read_velocities(struct ahead *a)
{
    memset(a->vector, 0, (size_t)a->listed * NABLA_STRIDE * sizeof *a->vector);
    for (int s = 0; s < a->listed; s++) {
        double *to = a->vector + (size_t)s * NABLA_STRIDE;
        to[0] = record(a, s)[RECORD_V];
        to[1] = record(a, s)[RECORD_V + 1];
#if DIM == 3
        to[2] = record(a, s)[RECORD_VZ];
#endif
    }
    complete(a, NABLA_STRIDE, a->vector);
}

static void read_accelerations(struct ahead *a, const double *udot)
{
    const struct particles *all = a->m->particles;
    const struct list *l = a->m->list;

    memset(a->vector, 0, (size_t)a->listed * NABLA_STRIDE * sizeof *a->vector);
    for (int s = 0; s < a->listed; s++) {
        const int c = l->order[s];
        double *to = a->vector + (size_t)s * NABLA_STRIDE;
        if (s < l->start[KIND_FLUID + 1])
            memcpy(to, udot + (size_t)c * DIM, DIM * sizeof *to);
        else
            object_acceleration(&all->object[all->object_of[c]], all->x[c], to);
    }
    ahead_bodies_drive(a);
    complete(a, NABLA_STRIDE, a->vector);
}

/* b += factor * term, of solids that press by means the mean of it. */
static void add(struct ahead *a, double factor)
{
    ahead_walls_mean(a, a->term);
    for (int s = 0; s < a->listed; s++)
        a->b[s] += factor * a->term[s];
}

static void set_right_side(struct ahead *a, const struct eos *eos, const double *udot)
{
    const struct nabla_kept_engine *nabla = a->m->plan->engine->nabla_kept;

    memset(a->b, 0, (size_t)a->n * sizeof *a->b);
    for (int s = 0; s < a->listed; s++)
        a->b[s] = mass(a, s) * (density(a, s) - eos->rho0);
    read_velocities(a);
    nabla->divergence(&a->kept, a->kinds, a->vector, a->term);
    add(a, a->tau);
    memcpy(a->rate, a->term, (size_t)a->listed * sizeof *a->rate);
    a->m->plan->engine->nabla->bend(&a->job, a->kinds, a->vector, a->term);
    add(a, a->tau * a->tau);
    read_accelerations(a, udot);
    nabla->divergence(&a->kept, a->kinds, a->vector, a->term);
    add(a, a->tau * a->tau);
}

/* That of D M^-1 G: see space/nabla.h.  Of solids that press by means it is more: the mean of
 * what each of them would have, as the square of a mean is not above that of squares. */
static void set_diagonal(struct ahead *a)
{
    const struct nabla_kept_engine *nabla = a->m->plan->engine->nabla_kept;
    const int fluid = a->m->list->start[KIND_FLUID + 1];
    const double *sum = a->m->work->f;

    for (int s = 0; s < a->listed; s++)
        a->scalar[s] = 0.5;
    complete(a, 1, a->scalar);
    nabla->gradient(&a->kept, KIND_BIT(KIND_FLUID), a->scalar, a->m->work->f);
    for (int s = 0; s < a->listed; s++)
        a->scalar[s] = s < fluid ? 1 / mass(a, s) : 0;
    complete(a, 1, a->scalar);
    nabla->squares(&a->kept, a->kinds, a->scalar, a->term);
    ahead_walls_mean(a, a->term);
    for (int s = 0; s < a->listed; s++) {
        double square = 0;
        for (int d = 0; d < DIM && s < fluid; d++)
            square += sum[s * DIM + d] * sum[s * DIM + d];
        a->left.diagonal[s] = a->left.still[s] + a->tau * a->tau * (a->scalar[s] * square + a->term[s]);
    }
    for (int s = a->listed; s < a->n; s++)
        a->left.diagonal[s] = 1;
}

void ahead_assemble(struct ahead *a, const double *udot)
{
    const struct eos *eos = a->m->plan->pressure->self;

    a->listed = a->m->list->start[KINDS];
    a->job.list = a->m->list;
    a->job.record = a->m->work->record;
    a->kept.list = a->m->list;
    a->m->plan->engine->nabla_kept->keep(&a->job, &a->kept);
    for (int s = 0; s < a->listed; s++) {
        const double e = record(a, s)[RECORD_RHO] / eos->c0;
        a->left.still[s] = mass(a, s) * e * e;
    }
    set_right_side(a, eos, udot);
    set_diagonal(a);
    a->operator = (struct operator){ .self = a, .n = a->n, .width = 1, .diagonal = a->left.diagonal,
                                     .apply = apply };
}
