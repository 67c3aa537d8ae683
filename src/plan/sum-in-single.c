/* sum-in-single.c -- sums over pairs in single precision: two groups side by side, then each
 * of them in double precision as ever. */
#include "plan/sum-pass.h"
#include "plan/sum-single.h"

#include "base/status.h"
#include "space/record.h"
#include "space/single-pack.h"

#if LANES > 2
#include <immintrin.h>
#endif
#include <stdlib.h>
#include <string.h>

static const struct sum_single *const single = &LANE_SINGLE_NAME(sum_single);

/* So many numbers of single precision in double. */
LANES_INLINE lanes widened(const float *from)
{
#if LANES == 8 /* the compiler goes by halves */
    return (lanes)_mm512_cvtps_pd(_mm256_loadu_ps(from));
#elif LANES == 4
    return (lanes)_mm256_cvtps_pd(_mm_loadu_ps(from));
#else
    typedef float half __attribute__((vector_size(LANES * sizeof(float))));
    half x;

    memcpy(&x, from, sizeof x);
    return __builtin_convertvector(x, lanes);
#endif
}

/* Of one of the two groups, as a law in double precision leaves them. */
LANES_INLINE struct sum sum_of(const void *sums, int s)
{
    const float *from = (const float *)sums + (size_t)s * (DIM + 1) * 2 * LANES;
    struct sum sum;

    for (int d = 0; d < DIM; d++)
        sum.f[d] = widened(from + 2 * d * LANES);
    sum.drho = widened(from + 2 * DIM * LANES);
    return sum;
}

/* What the ends of a group need of its owners, now and without what comes later. */
LANES_INLINE void own_now(const struct sum_job *job, const struct visit *v, struct side *a)
{
    const double *of[LANES];
    lanes none;

    for (int l = 0; l < LANES; l++)
        of[l] = job->record
                + (size_t)(v->first + l < v->end ? v->first + l : job->list->listed) * RECORD;
    fetch_two(of, RECORD_V, &a->v[0], &a->v[1]);
#if DIM == 2
    fetch_two(of, RECORD_RHO, &none, &a->p2);
#else
    fetch_two(of, RECORD_VZ, &a->v[2], &a->p2);
#endif
    a->m = lanes_all(job->mass);
    if (job->mass == 0)
        fetch_two(of, RECORD_M, &a->m, &none);
}

static void end_group(const struct sum_job *job, int g, const float *sum,
                      struct chunk_power *book)
{
    struct visit v = visit_group(job->list, g);
    const int owners = visit_owners(&v);
    struct side a;

    if (visit_is_idle(&v)) {
        clear_slots(job, v.kind, v.first, owners);
        return;
    }
    if (job->later != 0)
        gather_side(job->record, v.first, v.end, job->list->listed, &a);
    else
        own_now(job, &v, &a);
    finish_group(job, v.kind, v.first, owners, &a, sum_of, sum, book);
}

/* Asks for what the end of a group will read and write. */
LANES_INLINE void expect(const struct sum_job *job, int g)
{
    const struct visit v = visit_group(job->list, g);
    const double *r = job->record + (size_t)v.first * RECORD;
    const int owners = visit_owners(&v);

    for (int i = 0; i < owners * RECORD; i += 8)
        __builtin_prefetch(r + i);
    expect_rates(job, v.kind, v.first, owners);
}

static void sum_groups(const struct sum_pass *pass, int from, int to, struct block *b,
                       struct chunk_power *book)
{
    const struct sum_job *job = pass->job;
    const int *segments = job->list->segment_from;
    float sum[SUM_SLOTS * (DIM + 1) * 2 * LANES] __attribute__((aligned(64)));

    (void)b;
    for (int g = from; g < to; g += 2) {
        const int n = g + 1 < to ? 2 : 1;

        if (segments[g] < segments[g + n]) { /* else both have no neighbours */
            for (int h = 0; h < n; h++)
                expect(job, g + h);
            single->groups(job, pass->record, g, n == 2, sum);
        }
        for (int h = 0; h < n; h++)
            end_group(job, g + h, sum + h * LANES, book);
    }
}

static int make_records(const struct list *list, double mass, struct sum_scratch *scratch)
{
    enum { LINE = 64, SPARE = 1000 };

    const size_t floats = (size_t)single_floats(mass);

    if (list->listed < scratch->places)
        return STATUS_DONE;
    free(scratch->record);
    scratch->places = list->listed + 1 + list->listed / 8 + SPARE;
    scratch->record = aligned_alloc(LINE, ((size_t)scratch->places * floats
                                           * sizeof *scratch->record / LINE + 1) * LINE);
    if (scratch->record)
        return STATUS_DONE;
    scratch->places = 0;
    return status_starved("no records of %d particles in single precision", list->listed);
}

static int sum_pairs(const struct sum_job *job, struct sum_scratch *scratch)
{
    TRY(make_records(job->list, job->mass, scratch));
    single_pack(job->list, job->record, job->mass, scratch->record);
    return sum_pass_run(job, scratch, sum_groups);
}

static void arrange(struct pairs_table *table, bool fuse)
{
    single->arrange(table, fuse);
}

const struct sum_engine LANE_NAME(sum_engine_single) = {
    .lanes = LANES, .list = &LANE_NAME(list_engine), .pack = LANE_NAME(record_pack),
    .densities = LANE_NAME(record_densities),
    .arrange = arrange, .pairs = sum_pairs,
    .field = LANE_NAME(sum_field),
};
