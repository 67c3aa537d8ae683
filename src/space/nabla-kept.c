/* nabla-kept.c -- weights of pairs kept, and sums that read them; lanes are particles. */
#include "space/nabla-kept.h"

#include "space/visit.h"

#include <string.h>

/* --- what is kept ---------------------------------------------------------------- */

/* Rows of one group that are being written. */
struct rows {
    int *j;
    double *slope;
    int n[LANES]; /* of each lane */
};

/* Pairs of the rows at hand within the support go behind those of their lanes.  Others are
 * written there, too, and then over: without a branch that nobody can foresee. */
LANES_INLINE void keep_rows(const struct visit *v, const struct block *b, struct rows *to)
{
    for (int k = 0; k < b->n; k++) {
        lanes slope[DIM];

        for (int d = 0; d < DIM; d++)
            slope[d] = b->gw[k] * b->x[d][k];
        for (int l = 0; l < LANES; l++) {
            const size_t row = (size_t)to->n[l];
            to->j[row * LANES + (size_t)l] = v->j[k * LANES + l];
            for (int d = 0; d < DIM; d++)
                to->slope[(row * DIM + (size_t)d) * LANES + (size_t)l] = slope[d][l];
            to->n[l] += b->gw[k][l] != 0;
        }
    }
}

/* Lanes with fewer neighbours are filled up with the dummy, whose weight is 0. */
static int fill_up(struct rows *to, int dummy)
{
    int rows = 0;

    for (int l = 0; l < LANES; l++)
        rows = to->n[l] > rows ? to->n[l] : rows;
    for (int l = 0; l < LANES; l++)
        for (int k = to->n[l]; k < rows; k++) {
            to->j[k * LANES + l] = list_entry(dummy);
            for (int d = 0; d < DIM; d++)
                to->slope[(k * DIM + d) * LANES + l] = 0;
        }
    return rows;
}

struct keeping {
    const struct nabla_job *job;
    const struct nabla_kept *kept;
};

static void keep_group(const struct keeping *keeping, int g, struct block *b)
{
    const struct nabla_job *job = keeping->job;
    const struct nabla_kept *kept = keeping->kept;
    const size_t before = (size_t)job->list->rows_before[g] * LANES;
    struct visit v = visit_group(job->list, g);
    struct rows to = { .j = kept->j + before, .slope = kept->slope + before * DIM };
    struct side a;

    gather_side(job->record, v.first, v.end, job->list->listed, &a);
    while (visit_segment(&v, job->meets[v.kind]))
        while (visit_rows(&v, job->record, NEED_X | NEED_R2 | NEED_GRADW, job->kernel, &a, b))
            keep_rows(&v, b, &to);
    kept->rows[g] = fill_up(&to, job->list->listed);
}

static void keep_groups(const void *keeping, int chunk, int from, int to, struct block *b)
{
    (void)chunk;
    for (int g = from; g < to; g++)
        keep_group(keeping, g, b);
}

static void keep(const struct nabla_job *job, const struct nabla_kept *kept)
{
    visit_chunks(job->list, VISIT_ALL, keep_groups, &(struct keeping){ job, kept });
}

/* --- sums ------------------------------------------------------------------------ */

/* What a sum works with. */
struct pass {
    const struct nabla_kept *kept;
    const double *from; /* values by slot */
    double *to;
};

/* Adds what a pair gives; own: values of the owners, of: those of their neighbours. */
typedef void slope_term(const lanes *own, const lanes *of, const lanes *slope, lanes *sum);

LANES_INLINE void diverge(const lanes *own, const lanes *of, const lanes *slope, lanes *sum)
{
    lanes approach = (own[0] - of[0]) * slope[0];

    for (int d = 1; d < DIM; d++)
        approach += (own[d] - of[d]) * slope[d];
    *sum += approach;
}

LANES_INLINE void ascend(const lanes *own, const lanes *of, const lanes *slope, lanes *sum)
{
    const lanes both = *own + *of;

    for (int d = 0; d < DIM; d++)
        sum[d] += both * slope[d];
}

LANES_INLINE void square(const lanes *own, const lanes *of, const lanes *slope, lanes *sum)
{
    lanes all = slope[0] * slope[0];

    (void)own;
    for (int d = 1; d < DIM; d++)
        all += slope[d] * slope[d];
    *sum += *of * all;
}

/* Values have width `in`, sums `out`; all but pass and g are constants. */
LANES_INLINE void add_group(const struct pass *pass, int g, int in, int out, slope_term *term)
{
    const struct nabla_kept *kept = pass->kept;
    const size_t before = (size_t)kept->list->rows_before[g] * LANES;
    const int *j = kept->j + before;
    const double *slope = kept->slope + before * DIM;
    const struct visit v = visit_group(kept->list, g);
    const int rows = kept->rows[g];
    lanes own[DIM], of[DIM], sum[DIM] = { { 0 } };

    visit_own(&v, kept->list->listed, pass->from, in, own);
    for (int k = 0; k < rows; k++) {
        lanes at[DIM];

        memcpy(at, slope + (size_t)k * DIM * LANES, sizeof at);
        fetch_values(pass->from, j + (size_t)k * LANES, in, of);
        term(own, of, at, sum);
    }
    visit_write(&v, out, sum, pass->to);
}

#define GROUPS(name, in, out, term)                                                         \
    static void name(const void *pass, int chunk, int from, int to, struct block *b)        \
    {                                                                                       \
        (void)chunk, (void)b;                                                               \
        for (int g = from; g < to; g++)                                                     \
            add_group(pass, g, in, out, term);                                              \
    }

GROUPS(diverge_groups, DIM, 1, diverge)
GROUPS(ascend_groups, 1, DIM, ascend)
GROUPS(square_groups, 1, 1, square)

static void divergence(const struct nabla_kept *kept, unsigned kinds, const double *a, double *to)
{
    visit_clear(kept->list, kinds, 1, to);
    visit_chunks(kept->list, kinds, diverge_groups, &(struct pass){ kept, a, to });
    list_complete(kept->list, kinds, 1, to);
}

static void gradient(const struct nabla_kept *kept, unsigned kinds, const double *p, double *to)
{
    visit_clear(kept->list, kinds, DIM, to);
    visit_chunks(kept->list, kinds, ascend_groups, &(struct pass){ kept, p, to });
    list_complete(kept->list, kinds, DIM, to);
}

static void squares(const struct nabla_kept *kept, unsigned kinds, const double *q, double *to)
{
    visit_clear(kept->list, kinds, 1, to);
    visit_chunks(kept->list, kinds, square_groups, &(struct pass){ kept, q, to });
    list_complete(kept->list, kinds, 1, to);
}

const struct nabla_kept_engine LANE_NAME(nabla_kept_engine) = {
    .keep = keep, .divergence = divergence, .gradient = gradient, .squares = squares,
};
