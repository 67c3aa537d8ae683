/* arkode-vectors.c -- our vectors beside ARKStep's own, and how many there are in all. */
#include "time/arkode.h"

#include "base/status.h"
#include "time/failure.h"

/* Of SUNDIALS' own, counted in 6.4.1: y now and at the last step, weights of both
 * tests, the interpolant's, the stage's data, what is summed. */
enum { OF_ARKSTEP = 11 };

int arkode_vectors(const struct method *m, const struct plan *plan)
{
    const struct arkode_row *row = (const struct arkode_row *)m; /* its first member */
    const int sides = arkode_tables_implicit(row) && plan_stiff(plan) ? 2 : 1;
    const int nodes = row->order > 4 ? ARKODE_NODES : 2;

    /* nodes: y and f; our weights; the start of the implicit side */
    return OF_ARKSTEP + sides * arkode_tables_stages(row) + 2 * nodes + 1
           + (sides == 2 && plan_viscous(plan));
}

static int take(struct arkode *a, N_Vector *v)
{
    *v = N_VClone(a->node[0].y);
    return *v ? STATUS_DONE : failure_memory(a->row->method.name, a->n);
}

int arkode_take_vectors(struct arkode *a)
{
    const struct vector_own own = moment_own(a->moment);

    a->nodes = a->row->order > 4 ? ARKODE_NODES : 2;
    a->node[0].y = vector_create_own(a->n, a->def.norm, a->context, &own);
    if (!a->node[0].y)
        return STATUS_FAILED;
    TRY(vector_ranges(a->node[0].y, a->stiff.ranges, (const long (*)[2])a->stiff.range));
    for (int k = 0; k < a->nodes; k++) {
        if (k > 0)
            TRY(take(a, &a->node[k].y));
        TRY(take(a, &a->node[k].f));
    }
    if (a->imex && plan_viscous(a->plan))
        TRY(take(a, &a->stiff.start));
    return a->imex ? take(a, &a->stiff.right) : STATUS_DONE;
}

int arkode_take_last(struct arkode *a)
{
    TRY(take(a, &a->last.y));
    return take(a, &a->last.f);
}

static void give_back(N_Vector v)
{
    if (v)
        N_VDestroy(v);
}

void arkode_free_vectors(struct arkode *a)
{
    for (int k = 0; k < ARKODE_NODES; k++) {
        give_back(a->node[k].y);
        give_back(a->node[k].f);
    }
    give_back(a->stiff.start);
    give_back(a->stiff.right);
    give_back(a->last.y);
    give_back(a->last.f);
}

/* Where y's entry `offset` stands in the past of stiff entries; -1: nowhere. */
static long stiff_offset(const struct arkode *a, long offset)
{
    long before = 0;

    for (int k = 0; k < a->stiff.ranges; k++) {
        const long *range = a->stiff.range[k];

        if (offset >= range[0] && offset < range[1])
            return before + offset - range[0];
        before += range[1] - range[0];
    }
    return -1;
}

/* A block is stiff as a whole or not at all. */
static int rearrange_past(struct arkode *a, int blocks, const struct vector_rows *block)
{
    for (int k = 0; k < blocks; k++) {
        struct vector_rows past = block[k];

        past.offset = stiff_offset(a, block[k].offset);
        if (past.offset >= 0)
            TRY(vector_rows_move(1, &past, ARKODE_PAST, a->stiff.past));
    }
    return STATUS_DONE;
}

/* ARKStep's own are clones as ours are. */
int arkode_rearrange(void *self, int blocks, const struct vector_rows *block)
{
    struct arkode *a = self;

    TRY(vector_rearrange(a->node[0].y, blocks, block));
    TRY(vector_rows_move(blocks, block, 2, (double *[]){ a->error.weight, a->stiff.z }));
    for (int i = 0; i < 2; i++)
        a->choice[i].entry = vector_rows_moved(blocks, block, a->choice[i].entry);
    return a->stiff.entries > 0 ? rearrange_past(a, blocks, block) : STATUS_DONE;
}
