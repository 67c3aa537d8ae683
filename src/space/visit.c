/* visit.c -- how the traversal is cut: chunks of VISIT_CHUNK slots of one kind, in groups
 * of LANES owners, and the chunks that each thread takes. */
#include "space/visit.h"

#include "base/threads.h"

#include <stdatomic.h>
#include <string.h>

enum {
    WORTH_THREADS = 500, /* places from which threads repay waking                     */
    SHARES = 64,         /* at most; further threads help with the first of them       */
    CACHE_LINE = 64      /* [bytes]: counters in one line would wander between threads */
};

/* Chunks of a share that have been taken. */
struct taken {
    _Alignas(CACHE_LINE) atomic_int chunks;
};

static int groups_of(const struct list *list, unsigned kinds, int kind)
{
    return kinds & KIND_BIT(kind) ? list->group_from[kind + 1] - list->group_from[kind] : 0;
}

static int chunks_of(const struct list *list, unsigned kinds, int kind)
{
    return (groups_of(list, kinds, kind) + VISIT_GROUPS - 1) / VISIT_GROUPS;
}

int visit_count(const struct list *list, unsigned kinds)
{
    int n = 0;

    for (int kind = 0; kind < KINDS; kind++)
        n += chunks_of(list, kinds, kind);
    return n;
}

/* Rows before a chunk, and some for the work that each group is anyway, by what rows of
 * owners of a kind cost. */
static long work_before(const struct list *list, unsigned kinds, const int *cost, int chunk)
{
    long work = 0;

    for (int kind = 0; kind < KINDS && chunk > 0; kind++) {
        const int n = chunks_of(list, kinds, kind), from = list->group_from[kind];
        const int groups = chunk < n ? chunk * VISIT_GROUPS : groups_of(list, kinds, kind);

        work += (cost ? cost[kind] : 1)
                * (list->rows_before[from + groups] - list->rows_before[from] + 4L * groups);
        chunk -= n;
    }
    return work;
}

/* First chunk of thread t of `of`: as equal work as whole chunks allow, found by halving. */
static int share(const struct list *list, unsigned kinds, const int *cost, int t, int of)
{
    const int n = visit_count(list, kinds);
    const long want = work_before(list, kinds, cost, n) / of * t;
    int low = 0, high = n;

    if (t == of)
        return n;
    while (low < high) {
        const int middle = low + (high - low) / 2;

        if (work_before(list, kinds, cost, middle) < want)
            low = middle + 1;
        else
            high = middle;
    }
    if (low > 0 && want - work_before(list, kinds, cost, low - 1)
                       < work_before(list, kinds, cost, low) - want)
        low--;
    return low;
}

/* The groups of one chunk. */
static void run(const struct list *list, unsigned kinds, int chunk, visit_chunk *function,
                const void *job, struct block *b)
{
    int kind = 0, before = 0;

    while (chunk - before >= chunks_of(list, kinds, kind))
        before += chunks_of(list, kinds, kind++);
    const int from = list->group_from[kind] + (chunk - before) * VISIT_GROUPS;
    const int left = list->group_from[kind + 1] - from;

    function(job, chunk, from, from + (left < VISIT_GROUPS ? left : VISIT_GROUPS), b);
}

/* Each thread takes chunks of its own share, in their order, then of those of threads that are
 * still at theirs: cores of a machine that others use, too, are not equally fast. */
static void run_shares(const struct list *list, unsigned kinds, const int *cost,
                       visit_chunk *function, const void *job, int shares, struct taken *taken)
{
    const int me = threads_me();
    struct block b;

    for (int s = 0; s < shares; s++) {
        const int t = (me + s) % shares, from = share(list, kinds, cost, t, shares);
        const int n = share(list, kinds, cost, t + 1, shares) - from;

        for (int c; (c = atomic_fetch_add_explicit(&taken[t].chunks, 1, memory_order_relaxed)) < n;)
            run(list, kinds, from + c, function, job, &b);
    }
}

void visit_shares(const struct list *list, unsigned kinds, const int *cost,
                  visit_chunk *function, const void *job)
{
    const int threads = threads_most(), shares = threads < SHARES ? threads : SHARES;
    struct taken taken[SHARES];

    for (int t = 0; t < shares; t++)
        atomic_init(&taken[t].chunks, 0);
    THREADS(visit_count(list, kinds) > WORTH_THREADS / VISIT_CHUNK,
            run_shares(list, kinds, cost, function, job, shares, taken));
}

void visit_chunks(const struct list *list, unsigned kinds, visit_chunk *function,
                  const void *job)
{
    visit_shares(list, kinds, NULL, function, job);
}

void visit_clear(const struct list *list, unsigned kinds, int width, double *to)
{
    for (int kind = 0; kind < KINDS; kind++) {
        const size_t from = (size_t)list->start[kind];
        const size_t n = (size_t)list->start[kind + 1] - from;

        if ((kinds & KIND_BIT(kind)) && list->group_from[kind] == list->group_from[kind + 1])
            memset(to + from * (size_t)width, 0, n * (size_t)width * sizeof *to);
    }
}
