/* no-window.c -- ranks that have no memory together, as where /dev/shm is full: preloaded by tests/ranks.sh. */
#include <mpi.h>

int MPI_Win_allocate_shared(MPI_Aint size, int unit, MPI_Info info, MPI_Comm comm, void *block, MPI_Win *window)
{
    int me;

    MPI_Comm_rank(comm, &me);
    PMPI_Win_allocate_shared(size, unit, info, comm, block, window);
    return me == 1 ? MPI_ERR_NO_MEM : MPI_SUCCESS;
}
