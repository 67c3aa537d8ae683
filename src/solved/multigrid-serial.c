/* multigrid-serial.c -- no multigrid: its library wants MPI, which the serial programs have not.
 * Those with MPI find multigrid-hypre.c before this. */
#include "solved/precondition.h"

const struct precondition precondition_multigrid = {
    .name = "multigrid",
    .lacks = "mps.preconditioner = \"multigrid\" is HYPRE's, which wants MPI, and this is a program "
             "without; add --ranks 1 to `stiffwater run', or take stiffwater-2d-mpi (in 3D "
             "stiffwater-3d-mpi) for stiffwater with any command, or leave the key out: \"ic0\" "
             "finds the same pressure",
};
