/* couple.c -- a law that is linear in velocities, as a matrix in the order of the
 * pair list; lanes are particles. */
#include "plan/couple.h"

#include "effects/effects.h"
#include "space/fetch.h"
#include "space/visit.h"

#include <string.h>

/* c of the segment at hand times velocities, those v of the owners taken off. */
static void multiply_segment(const struct visit *at, const double *velocity, const double *c,
                             const lanes *v, lanes *f)
{
    lanes sum[DIM], of[DIM], row;

    memcpy(sum, f, sizeof sum); /* registers, not memory */
    for (int k = 0; k < at->segment->rows; k++) {
        fetch_values(velocity, at->segment->j + (size_t)k * LANES, DIM, of);
        memcpy(&row, c + (size_t)k * LANES, sizeof row);
        for (int d = 0; d < DIM; d++)
            sum[d] += row * (of[d] - v[d]);
    }
    memcpy(f, sum, sizeof sum);
}

/* c of the rows of the segment at hand; returns each owner's sum. */
static lanes couple_segment(const struct couple_job *job, const double *record, struct visit *at,
                            const struct side *a, struct block *b)
{
    lanes sum = { 0 };
    struct coupling to;

    while (visit_rows(at, record, job->needs, job->kernel, a, b)) {
        job->couple(job->self, a, b, &to);
        for (int k = 0; k < b->n; k++)
            sum += to.c[k];
        memcpy(job->c + visit_row(at) * LANES, to.c, (size_t)b->n * sizeof *to.c);
    }
    return sum;
}

/* What a pass over pairs works with. */
struct pass {
    const struct couple_job *job;
    const double *record, *velocity;
    double *f;
};

static void couple_group(const struct pass *pass, int g, struct block *b)
{
    const struct couple_job *job = pass->job;
    const struct list *list = job->list;
    struct visit at = visit_group(list, g);
    lanes sum = { 0 }, firm = { 0 }, v[DIM], force[DIM] = { { 0 } };
    struct side a;

    gather_side(pass->record, at.first, at.end, list->listed, &a);
    visit_own(&at, list->listed, pass->velocity, DIM, v);
    while (visit_segment(&at, job->acts[at.kind])) {
        const lanes part = couple_segment(job, pass->record, &at, &a, b);

        multiply_segment(&at, pass->velocity, job->c + at.row * LANES, v, force);
        sum += part;
        if (at.kind != KIND_FLUID || at.segment->partner != KIND_FLUID)
            firm += part;
    }
    visit_write(&at, 1, &sum, job->diagonal);
    visit_write(&at, 1, &firm, job->firm);
    visit_write(&at, DIM, force, pass->f);
}

static void couple_groups(const void *pass, int chunk, int from, int to, struct block *b)
{
    (void)chunk;
    for (int g = from; g < to; g++)
        couple_group(pass, g, b);
}

static void assemble(const struct couple_job *job, const double *record, const double *velocity,
                     double *f)
{
    const struct pass pass = { job, record, velocity, f };

    visit_clear(job->list, VISIT_ALL, 1, job->diagonal);
    visit_clear(job->list, VISIT_ALL, 1, job->firm);
    visit_clear(job->list, VISIT_ALL, DIM, f);
    visit_chunks(job->list, VISIT_ALL, couple_groups, &pass);
    list_complete(job->list, VISIT_ALL, 1, job->diagonal);
    list_complete(job->list, VISIT_ALL, 1, job->firm);
    list_complete(job->list, VISIT_ALL, DIM, f);
}

static void multiply_group(const struct pass *pass, int g)
{
    const struct couple_job *job = pass->job;
    struct visit at = visit_group(job->list, g);
    lanes v[DIM], sum[DIM] = { { 0 } };

    visit_own(&at, job->list->listed, pass->velocity, DIM, v);
    while (visit_segment(&at, job->acts[at.kind]))
        multiply_segment(&at, pass->velocity, job->c + at.row * LANES, v, sum);
    visit_write(&at, DIM, sum, pass->f);
}

static void multiply_groups(const void *pass, int chunk, int from, int to, struct block *b)
{
    (void)chunk, (void)b;
    for (int g = from; g < to; g++)
        multiply_group(pass, g);
}

static void multiply(const struct couple_job *job, unsigned kinds, const double *velocity,
                     double *f)
{
    const struct pass pass = { job, NULL, velocity, f };

    visit_clear(job->list, kinds, DIM, f);
    visit_chunks(job->list, kinds, multiply_groups, &pass);
    list_complete(job->list, kinds, DIM, f);
}

const struct couple_engine LANE_NAME(couple_engine) = {
    .assemble = assemble, .multiply = multiply,
};
