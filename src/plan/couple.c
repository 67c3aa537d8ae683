/* couple.c -- a law that is linear in velocities, as a matrix in the order of the
 * pair list; lanes are particles. */
#include "plan/couple.h"

#include "effects/effects.h"
#include "space/gather.h"

#include <string.h>

enum { WORTH_THREADS = 500 }; /* slots whose sums repay waking the threads */

typedef double two __attribute__((vector_size(16)));

static bool acts(const struct couple_job *job, int owner, int partner)
{
    return job->acts[owner] & KIND_BIT(partner);
}

/* Two numbers of each of the LANES velocities `of`. */
LANES_INLINE void pair_of_numbers(const double *const of[LANES], int at, lanes *first,
                                  lanes *second)
{
#if LANES == 8
    lanes p = { 0 }, q = { 0 };

    for (int l = 0; l < LANES; l++) {
        p[l] = of[l][at];
        q[l] = of[l][at + 1];
    }
    *first = p;
    *second = q;
#elif LANES == 4
    const two a = *(const two *)(of[0] + at), b = *(const two *)(of[1] + at);
    const two c = *(const two *)(of[2] + at), d = *(const two *)(of[3] + at);
    const lanes ac = __builtin_shufflevector(a, c, 0, 1, 2, 3);
    const lanes bd = __builtin_shufflevector(b, d, 0, 1, 2, 3);

    *first = __builtin_shufflevector(ac, bd, 0, 4, 2, 6);
    *second = __builtin_shufflevector(ac, bd, 1, 5, 3, 7);
#else
    const two a = *(const two *)(of[0] + at), b = *(const two *)(of[1] + at);

    *first = __builtin_shufflevector(a, b, 0, 2);
    *second = __builtin_shufflevector(a, b, 1, 3);
#endif
}

LANES_INLINE void velocities(const double *velocity, const int *j, lanes *v)
{
    const double *of[LANES];

    for (int l = 0; l < LANES; l++)
        of[l] = velocity + (size_t)(unsigned)j[l] * COUPLE_STRIDE;
    pair_of_numbers(of, 0, &v[0], &v[1]);
#if DIM == 3
    lanes none;

    pair_of_numbers(of, 2, &v[2], &none);
#endif
}

static void multiply_segment(const struct list_segment *segment, const double *velocity,
                             const double *c, const lanes *v, lanes *f)
{
    lanes sum[DIM], of[DIM], row;

    memcpy(sum, f, sizeof sum); /* registers, not memory */
    for (int k = 0; k < segment->rows; k++) {
        velocities(velocity, segment->j + (size_t)k * LANES, of);
        memcpy(&row, c + (size_t)k * LANES, sizeof row);
        for (int d = 0; d < DIM; d++)
            sum[d] += row * (of[d] - v[d]);
    }
    memcpy(f, sum, sizeof sum);
}

/* Of the owners of group g. */
static void own_velocities(const struct couple_job *job, int g, const double *velocity, lanes *v)
{
    const struct list *list = job->list;
    const int first = list->group_slot[g], end = list->start[list->group_kind[g] + 1];
    int own[LANES];

    for (int l = 0; l < LANES; l++)
        own[l] = first + l < end ? first + l : list->listed;
    velocities(velocity, own, v);
}

/* c of the rows of one segment; returns each owner's sum. */
static lanes couple_segment(const struct couple_job *job, const double *record,
                            const struct list_segment *segment, const struct side *a,
                            struct block *b, double *c)
{
    gather_rows *const gather = gather_choose(job->needs);
    lanes sum = { 0 };
    struct coupling to;

    for (int row = 0; row < segment->rows; row += PAIRS_ROWS) {
        const int left = segment->rows - row;

        b->n = left < PAIRS_ROWS ? left : PAIRS_ROWS;
        gather(record, segment->j + (size_t)row * LANES, b->n, a, b);
        gather_kernel(job->needs, job->kernel, b);
        job->couple(job->self, a, b, &to);
        for (int k = 0; k < b->n; k++)
            sum += to.c[k];
        memcpy(c + (size_t)row * LANES, to.c, (size_t)b->n * sizeof *to.c);
    }
    return sum;
}

static void couple_group(const struct couple_job *job, const double *record,
                         const double *velocity, int g, struct block *b, double *f)
{
    const struct list *list = job->list;
    const int first = list->group_slot[g], kind = list->group_kind[g];
    const int end = list->start[kind + 1];
    double *c = job->c + (size_t)list->rows_before[g] * LANES;
    lanes sum = { 0 }, firm = { 0 }, v[DIM], force[DIM] = { { 0 } };
    struct side a;

    gather_side(record, first, end, list->listed, &a);
    own_velocities(job, g, velocity, v);
    for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++) {
        const struct list_segment *segment = &list->segment[s];

        if (acts(job, kind, segment->partner)) {
            const lanes part = couple_segment(job, record, segment, &a, b, c);
            multiply_segment(segment, velocity, c, v, force);
            sum += part;
            if (kind != KIND_FLUID || segment->partner != KIND_FLUID)
                firm += part;
        }
        c += (size_t)segment->rows * LANES;
    }
    for (int l = 0; l < LANES && first + l < end; l++) {
        job->diagonal[first + l] = sum[l];
        job->firm[first + l] = firm[l];
        for (int d = 0; d < DIM; d++)
            f[(size_t)(first + l) * DIM + (size_t)d] = force[d][l];
    }
}

static void assemble(const struct couple_job *job, const double *record, const double *velocity,
                     double *f)
{
    const struct list *list = job->list;
    const size_t n = (size_t)list->start[KINDS];

    memset(job->diagonal, 0, n * sizeof *job->diagonal);
    memset(job->firm, 0, n * sizeof *job->firm);
    memset(f, 0, n * DIM * sizeof *f);
#pragma omp parallel if (list->listed > WORTH_THREADS)
    {
        struct block b;

#pragma omp for schedule(static)
        for (int g = 0; g < list->groups; g++)
            couple_group(job, record, velocity, g, &b, f);
    }
}

static void multiply_group(const struct couple_job *job, const double *velocity, int g, double *f)
{
    const struct list *list = job->list;
    const int first = list->group_slot[g], kind = list->group_kind[g];
    const int end = list->start[kind + 1];
    const double *c = job->c + (size_t)list->rows_before[g] * LANES;
    lanes v[DIM], sum[DIM] = { { 0 } };

    own_velocities(job, g, velocity, v);
    for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++) {
        const struct list_segment *segment = &list->segment[s];

        if (acts(job, kind, segment->partner))
            multiply_segment(segment, velocity, c, v, sum);
        c += (size_t)segment->rows * LANES;
    }
    for (int l = 0; l < LANES && first + l < end; l++)
        for (int d = 0; d < DIM; d++)
            f[(size_t)(first + l) * DIM + (size_t)d] = sum[d][l];
}

static void clear(const struct list *list, int kind, double *f)
{
    const size_t from = (size_t)list->start[kind], n = (size_t)list->start[kind + 1] - from;

    memset(f + from * DIM, 0, n * DIM * sizeof *f);
}

static void multiply(const struct couple_job *job, unsigned kinds, const double *velocity,
                     double *f)
{
    const struct list *list = job->list;

    for (int kind = 0; kind < KINDS; kind++) {
        const int from = list->group_from[kind], to = list->group_from[kind + 1];

        if (!(kinds & KIND_BIT(kind)))
            continue;
        if (from == to)
            clear(list, kind, f);
#pragma omp parallel for schedule(static) if (to - from > WORTH_THREADS / LANES)
        for (int g = from; g < to; g++)
            multiply_group(job, velocity, g, f);
    }
}

const struct couple_engine LANE_NAME(couple_engine) = {
    .assemble = assemble, .multiply = multiply,
};
