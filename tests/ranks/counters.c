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
    allreduces++;
    return PMPI_Allreduce(from, to, n, type, op, comm);
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

int MPI_Gatherv(const void *from, int n, MPI_Datatype type, void *to, const int count[],
                const int first[], MPI_Datatype to_type, int root, MPI_Comm comm)
{
    count_gather(count, to_type, comm);
    return PMPI_Gatherv(from, n, type, to, count, first, to_type, root, comm);
}

int MPI_Allgatherv(const void *from, int n, MPI_Datatype type, void *to, const int count[],
                   const int first[], MPI_Datatype to_type, MPI_Comm comm)
{
    count_gather(count, to_type, comm);
    return PMPI_Allgatherv(from, n, type, to, count, first, to_type, comm);
}

int MPI_Neighbor_alltoallv(const void *from, const int count[], const int first[],
                           MPI_Datatype type, void *to, const int to_count[], const int to_first[],
                           MPI_Datatype to_type, MPI_Comm comm)
{
    int in, out, weighted, size;

    MPI_Dist_graph_neighbors_count(comm, &in, &out, &weighted);
    MPI_Type_size(type, &size);
    exchanges++;
    messages += out;
    for (int i = 0; i < out; i++)
        bytes += (long)count[i] * size;
    return PMPI_Neighbor_alltoallv(from, count, first, type, to, to_count, to_first, to_type, comm);
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
