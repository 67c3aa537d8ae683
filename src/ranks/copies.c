/* copies.c -- launchers tell processes in their environment how many they are: Open MPI in
 * OMPI_COMM_WORLD_SIZE, MPICH and its kin in PMI_SIZE.  Copies that do not know of each other
 * would all write the same files. */
#include "ranks/copies.h"

#include <stddef.h>
#include <stdlib.h>

static int told(const char *name)
{
    const char *text = getenv(name);

    return text ? atoi(text) : 0;
}

int ranks_copy(void)
{
    const int by_open = told("OMPI_COMM_WORLD_RANK");

    return by_open > 0 ? by_open : told("PMI_RANK");
}

int ranks_refuse_copies(struct status_advice advice)
{
    const int by_open = told("OMPI_COMM_WORLD_SIZE"), n = by_open > 1 ? by_open : told("PMI_SIZE");

    if (n < 2)
        return STATUS_DONE;
    return status_fail_with(STATUS_BAD_SCENE, advice, "there are %d copies of this program, each of "
                            "which believes that it is alone", n);
}
