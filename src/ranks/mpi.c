/* mpi.c -- ranks by Open MPI: beginning, end, and what all know. */
#include "ranks/copies.h"
#include "ranks/mpi-wait.h"
#include "ranks/ranks.h"
#include "ranks/traffic.h"

#include "base/status.h"

#include <malloc.h>
#include <math.h>
#include <mpi.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static int count = 1, me;

/* A library of Open MPI does not see who launched it where that is of another MPI, and finds
 * itself alone. */
static int refuse_copies(void)
{
    return count > 1 ? STATUS_DONE : ranks_refuse_copies((struct status_advice){
        .cause = "The mpirun that started them is not that of Open MPI",
        .remedy = "take `mpirun.openmpi -n N', or a launcher of the batch system that knows "
                  "PMIx (Slurm: srun --mpi=pmix)" });
}

/* Arrays of all particles of which a rank writes its own rows take memory for these alone, as long as
 * they come from the system, zeroed, and not from what was freed before: so the system is asked for smaller
 * arrays, too, as many that are freed next to each other leave room for a large one.  SuperLU_DIST, which comes
 * with HYPRE, has the C library ask the system for no array by itself, and give nothing back. */
static void keep_untouched(void)
{
#if defined M_MMAP_THRESHOLD && defined M_MMAP_MAX && defined M_TRIM_THRESHOLD
    enum { FROM = 1 << 15, MOST = 1 << 16, KEPT = 1 << 17 }; /* bytes; arrays; bytes */

    if (count > 1) {
        mallopt(M_MMAP_MAX, MOST);
        mallopt(M_TRIM_THRESHOLD, KEPT);
        mallopt(M_MMAP_THRESHOLD, FROM); /* and stays so */
    }
#endif
}

int ranks_begin(int *argc, char ***argv)
{
    int level;

    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &level);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    status_hush(me > 0);
    keep_untouched();
    ranks_wait_begin();
    return refuse_copies();
}

/* mpirun ends all ranks as soon as one has ended with a status: there is nothing left to say. */
void ranks_end(void)
{
    signal(SIGTERM, SIG_IGN);
    ranks_wait_end();
    MPI_Finalize();
}

int ranks_count(void)
{
    return count;
}

int ranks_me(void)
{
    return me;
}

bool ranks_by_mpi(void)
{
    return true;
}

void ranks_leave(void)
{
    count = 1;
    me = 0;
}

/* The message of another rank becomes that of this one, whatever it had. */
static void take_over(int status, const char *message)
{
    status_forgive();
    if (message[0])
        status_fail(status, "%s", message);
}

/* What a rank brings; as many bytes of it travel as are said. */
struct bid {
    double key;
    int64_t order, rank;
    char said[RANKS_SAID];
};

static bool before(const struct bid *a, const struct bid *b)
{
    if (a->key != b->key)
        return a->key < b->key;
    return a->order != b->order ? a->order < b->order : a->rank < b->rank;
}

/* Of two bids the first, whichever comes from where. */
static void keep_first(void *in, void *kept, int *n, MPI_Datatype *type)
{
    int bytes;

    MPI_Type_size(*type, &bytes);
    for (int i = 0; i < *n; i++) {
        char *a = (char *)in + (size_t)i * (size_t)bytes, *b = (char *)kept + (size_t)i * (size_t)bytes;
        if (before((struct bid *)a, (struct bid *)b))
            memcpy(b, a, (size_t)bytes);
    }
}

static void all_reduce(int n, void *x, MPI_Datatype type, MPI_Op op)
{
    MPI_Request done;

    MPI_Iallreduce(MPI_IN_PLACE, x, n, type, op, MPI_COMM_WORLD, &done);
    ranks_wait(1, &done);
}

/* Bids of all ranks, `size` bytes each, become the first ones. */
static void bid(int n, void *mine, size_t size)
{
    MPI_Datatype type;
    MPI_Op op;

    if (count == 1)
        return;
    ranks_traffic_ask(n * (int)size);
    MPI_Type_contiguous((int)size, MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Op_create(keep_first, 1, &op);
    all_reduce(n, mine, type, op);
    MPI_Op_free(&op);
    MPI_Type_free(&type);
}

void ranks_firsts(int n, const double *key, const long *order, void *said, size_t bytes, int *rank)
{
    const size_t size = offsetof(struct bid, said) + (bytes + 7) / 8 * 8;
    struct bid room[RANKS_FIRSTS];

    for (int i = 0; i < n; i++) {
        struct bid *one = (struct bid *)((char *)room + (size_t)i * size);
        one->key = key[i];
        one->order = order[i];
        one->rank = me;
        memcpy(one->said, (const char *)said + (size_t)i * bytes, bytes);
    }
    bid(n, room, size);
    for (int i = 0; i < n; i++) {
        const struct bid *one = (const struct bid *)((const char *)room + (size_t)i * size);
        rank[i] = one->key < HUGE_VAL ? (int)one->rank : -1;
        if (rank[i] >= 0)
            memcpy((char *)said + (size_t)i * bytes, one->said, bytes);
    }
}

int ranks_first(double key, long order, void *said, size_t bytes)
{
    int rank;

    ranks_firsts(1, &key, &order, said, bytes, &rank);
    return rank;
}

int ranks_agree(int status)
{
    struct {
        int status;
        char message[STATUS_LINE];
    } said = { .status = status != STATUS_DONE && status_is_starved() ? STATUS_FAILED : status };
    int first;

    if (status != STATUS_DONE) /* no memory to read a scene: the scene is not to blame */
        snprintf(said.message, sizeof said.message, "%s", status_message());
    first = ranks_first(status == STATUS_DONE ? HUGE_VAL : 0, me, &said, sizeof said);
    if (first >= 0 && first != me)
        take_over(said.status, said.message);
    return first < 0 ? STATUS_DONE : said.status;
}

static bool told; /* of a failure within what is made */

int ranks_agree_within(int status)
{
    status = ranks_agree(status);
    told = status != STATUS_DONE;
    return status;
}

int ranks_agree_after(int status)
{
    const bool knows = told;

    told = false;
    return knows ? status : ranks_agree(status);
}

void ranks_most(int n, double *x)
{
    if (count == 1)
        return;
    ranks_traffic_ask(n * (double)sizeof *x);
    all_reduce(n, x, MPI_DOUBLE, MPI_MAX);
}

void ranks_add(int n, int64_t *x)
{
    if (count == 1)
        return;
    ranks_traffic_ask(n * (double)sizeof *x);
    all_reduce(n, x, MPI_INT64_T, MPI_SUM);
}

/* From all to `root`, or to all where that is below 0: then mine may be NULL, as ranks_gather() says. */
static void gather(int root, const int *rows, size_t bytes, const void *mine, void *all)
{
    int first[count];
    MPI_Datatype row;
    MPI_Request done;

    if (count == 1) {
        if (mine)
            memcpy(all, mine, (size_t)rows[0] * bytes);
        return;
    }
    first[0] = 0;
    for (int r = 1; r < count; r++)
        first[r] = first[r - 1] + rows[r - 1];
    ranks_traffic_gather(rows[me] * (double)bytes);
    MPI_Type_contiguous((int)bytes, MPI_BYTE, &row);
    MPI_Type_commit(&row);
    if (root < 0)
        MPI_Iallgatherv(mine ? mine : MPI_IN_PLACE, rows[me], row, all, rows, first, row, MPI_COMM_WORLD,
                        &done);
    else
        MPI_Igatherv(mine, rows[me], row, all, rows, first, row, root, MPI_COMM_WORLD, &done);
    ranks_wait(1, &done);
    MPI_Type_free(&row);
}

void ranks_gather(const int *rows, size_t bytes, const void *mine, void *all)
{
    gather(-1, rows, bytes, mine, all);
}

void ranks_bring(const int *rows, size_t bytes, const void *mine, void *all)
{
    gather(0, rows, bytes, mine, all);
}
