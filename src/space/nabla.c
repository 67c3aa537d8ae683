/* nabla.c -- divergence and gradient over pairs; lanes are particles. */
#include "space/nabla.h"

#include "space/visit.h"

/* What a pass over pairs works with. */
struct pass {
    const struct nabla_job *job;
    const double *from; /* values by slot  */
    double *to;
};

/* Adds what row k of b gives; own: values of the owners, of: those of their neighbours. */
typedef void row_term(const lanes *own, const lanes *of, const struct block *b, int k,
                      lanes *sum);

LANES_INLINE void diverge(const lanes *own, const lanes *of, const struct block *b, int k,
                          lanes *sum)
{
    lanes approach = (own[0] - of[0]) * b->x[0][k];

    for (int d = 1; d < DIM; d++)
        approach += (own[d] - of[d]) * b->x[d][k];
    *sum += b->gw[k] * approach;
}

/* v . (grad grad W) v = W'' (e.v)^2 + (W'/r)(v^2 - (e.v)^2); W'' = lap W - (D - 1) W'/r. */
LANES_INLINE void curve(const lanes *own, const lanes *of, const struct block *b, int k,
                        lanes *sum)
{
    lanes along = (own[0] - of[0]) * b->x[0][k];
    lanes all = (own[0] - of[0]) * (own[0] - of[0]);

    for (int d = 1; d < DIM; d++) {
        along += (own[d] - of[d]) * b->x[d][k];
        all += (own[d] - of[d]) * (own[d] - of[d]);
    }
    along = along * along / (b->r2[k] + 1e-300); /* coincident particles: 0 */
    *sum += (b->lw[k] - DIM * b->gw[k]) * along + b->gw[k] * all;
}

LANES_INLINE void ascend(const lanes *own, const lanes *of, const struct block *b, int k,
                         lanes *sum)
{
    const lanes both = b->gw[k] * (*own + *of);

    for (int d = 0; d < DIM; d++)
        sum[d] += both * b->x[d][k];
}

LANES_INLINE void square(const lanes *own, const lanes *of, const struct block *b, int k,
                         lanes *sum)
{
    (void)own;
    *sum += *of * (b->gw[k] * b->gw[k] * b->r2[k]);
}

LANES_INLINE void weigh(const lanes *own, const lanes *of, const struct block *b, int k,
                        lanes *sum)
{
    (void)own;
    *sum += *of * b->w[k];
}

enum { SLOPES = NEED_X | NEED_R2 | NEED_GRADW };

/* Values have width `in`; all but pass, v and b are constants. */
LANES_INLINE void add_rows(const struct pass *pass, struct visit *v, struct block *b, int in, unsigned needs,
                           row_term *term, lanes *sum)
{
    const struct nabla_job *job = pass->job;
    const int dummy = job->list->listed;
    lanes own[DIM], of[DIM];
    struct side a;

    gather_side(job->record, v->first, v->end, dummy, &a);
    visit_own(v, dummy, pass->from, in, own);
    while (visit_segment(v, job->meets[v->kind]))
        while (visit_rows(v, job->record, needs, job->kernel, &a, b))
            for (int k = 0; k < b->n; k++) {
                fetch_values(pass->from, v->j + (size_t)k * LANES, in, of);
                term(own, of, b, k, sum);
            }
}

/* Sums have width `out`. */
LANES_INLINE void add_group(const struct pass *pass, int g, struct block *b, int in, int out,
                            unsigned needs, row_term *term)
{
    struct visit v = visit_group(pass->job->list, g);
    lanes sum[DIM] = { { 0 } };

    if (!visit_is_idle(&v))
        add_rows(pass, &v, b, in, needs, term, sum);
    visit_write(&v, out, sum, pass->to);
}

#define GROUPS(name, in, out, needs, term)                                                  \
    static void name(const void *pass, int chunk, int from, int to, struct block *b)        \
    {                                                                                       \
        (void)chunk;                                                                        \
        for (int g = from; g < to; g++)                                                     \
            add_group(pass, g, b, in, out, needs, term);                                    \
    }

GROUPS(diverge_groups, DIM, 1, SLOPES, diverge)
GROUPS(curve_groups, DIM, 1, SLOPES | NEED_LAPW, curve)
GROUPS(ascend_groups, 1, DIM, SLOPES, ascend)
GROUPS(square_groups, 1, 1, SLOPES, square)
GROUPS(weigh_groups, 1, 1, NEED_W, weigh)

static void divergence(const struct nabla_job *job, unsigned kinds, const double *a, double *to)
{
    visit_clear(job->list, kinds, 1, to);
    visit_chunks(job->list, kinds, diverge_groups, &(struct pass){ job, a, to });
    list_complete(job->list, kinds, 1, to);
}

static void bend(const struct nabla_job *job, unsigned kinds, const double *v, double *to)
{
    visit_clear(job->list, kinds, 1, to);
    visit_chunks(job->list, kinds, curve_groups, &(struct pass){ job, v, to });
    list_complete(job->list, kinds, 1, to);
}

static void gradient(const struct nabla_job *job, unsigned kinds, const double *p, double *to)
{
    visit_clear(job->list, kinds, DIM, to);
    visit_chunks(job->list, kinds, ascend_groups, &(struct pass){ job, p, to });
    list_complete(job->list, kinds, DIM, to);
}

static void squares(const struct nabla_job *job, unsigned kinds, const double *q, double *to)
{
    visit_clear(job->list, kinds, 1, to);
    visit_chunks(job->list, kinds, square_groups, &(struct pass){ job, q, to });
    list_complete(job->list, kinds, 1, to);
}

static void weights(const struct nabla_job *job, unsigned kinds, const double *q, double *to)
{
    visit_clear(job->list, kinds, 1, to);
    visit_chunks(job->list, kinds, weigh_groups, &(struct pass){ job, q, to });
    list_complete(job->list, kinds, 1, to);
}

const struct nabla_engine LANE_NAME(nabla_engine) = {
    .divergence = divergence, .bend = bend, .gradient = gradient, .squares = squares,
    .weights = weights,
};
