/* counters.c -- what the first rank says by MPI, counted by the profiling names of MPI (MPI 4.0,
 * chapter 15): preloaded by tests/ranks.sh.  MPI_Finalize() prints
 *
 *     allreduces N gathers N gathered N exchanges N messages N bytes N
 *
 * of the first rank, and the most memory that one of the others had: others N kB.  An exchange is one use
 * of a route, messages and bytes are what it sends; gathered are the bytes of all ranks that it has heard
 * in gathers. */
#include <mpi.h>
#include <stdio.h>
#include <sys/resource.h>

static long allreduces, gathers, gathered, exchanges, messages, bytes;

int MPI_Allreduce(const void *from, void *to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm)
{
    allreduces++; /* of libraries */
    return PMPI_Allreduce(from, to, n, type, op, comm);
}

int MPI_Iallreduce(const void *from, void *to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm,
                   MPI_Request *wait)
{
    allreduces++;
    return PMPI_Iallreduce(from, to, n, type, op, comm, wait);
}

static void count_gather(const int count[], MPI_Datatype type, MPI_Comm comm)
{
    int size, ranks;

    MPI_Type_size(type, &size);
    MPI_Comm_size(comm, &ranks);
    gathers++;
    for (int r = 0; r < ranks; r++)
        gathered += (long)count[r] * size;
}

int MPI_Igatherv(const void *from, int n, MPI_Datatype type, void *to, const int count[],
                 const int first[], MPI_Datatype to_type, int root, MPI_Comm comm, MPI_Request *wait)
{
    count_gather(count, to_type, comm);
    return PMPI_Igatherv(from, n, type, to, count, first, to_type, root, comm, wait);
}

int MPI_Iallgatherv(const void *from, int n, MPI_Datatype type, void *to, const int count[],
                    const int first[], MPI_Datatype to_type, MPI_Comm comm, MPI_Request *wait)
{
    count_gather(count, to_type, comm);
    return PMPI_Iallgatherv(from, n, type, to, count, first, to_type, comm, wait);
}

/* Messages of routes have this tag: src/ranks/mpi-route.c.  Those of one use have their requests one after
 * the other, and are waited for together. */
enum { ROUTE_TAG = 4117, UNDER_WAY = 64 };
static MPI_Request *first[UNDER_WAY], *last; /* first ones of what is under way */

static void note_use(MPI_Request *wait)
{
    int slot = 0;

    if (wait != last + 1) {
        while (slot < UNDER_WAY - 1 && first[slot])
            slot++;
        first[slot] = wait;
    }
    last = wait;
}

int MPI_Isend(const void *from, int n, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request *wait)
{
    int size;

    if (tag == ROUTE_TAG) {
        MPI_Type_size(type, &size);
        messages++;
        bytes += (long)n * size;
        note_use(wait);
    }
    return PMPI_Isend(from, n, type, to, tag, comm, wait);
}

int MPI_Irecv(void *to, int n, MPI_Datatype type, int from, int tag, MPI_Comm comm, MPI_Request *wait)
{
    if (tag == ROUTE_TAG)
        note_use(wait);
    return PMPI_Irecv(to, n, type, from, tag, comm, wait);
}

int MPI_Testall(int n, MPI_Request wait[], int *done, MPI_Status status[])
{
    const int result = PMPI_Testall(n, wait, done, status);

    for (int slot = 0; *done && n > 0 && slot < UNDER_WAY; slot++)
        if (first[slot] == wait) {
            exchanges++;
            first[slot] = NULL;
        }
    return result;
}

int MPI_Finalize(void)
{
    struct rusage used;
    long others;
    int me;

    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    getrusage(RUSAGE_SELF, &used);
    others = me > 0 ? used.ru_maxrss : 0;
    PMPI_Reduce(me > 0 ? &others : MPI_IN_PLACE, &others, 1, MPI_LONG, MPI_MAX, 0, MPI_COMM_WORLD);
    if (me == 0)
        fprintf(stderr, "allreduces %ld gathers %ld gathered %ld exchanges %ld messages %ld bytes %ld\n"
                "others %ld kB\n", allreduces, gathers, gathered, exchanges, messages, bytes, others);
    return PMPI_Finalize();
}
