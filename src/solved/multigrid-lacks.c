/* multigrid-lacks.c -- no multigrid: configure found MPI and no HYPRE. */
#include "solved/precondition.h"

const struct precondition precondition_multigrid = {
    .name = "multigrid",
    .lacks = "mps.preconditioner = \"multigrid\" is HYPRE's, which configure did not find; install it "
             "(on Debian: apt-get install libhypre-dev) and build again, or leave the key out: "
             "\"ic0\" finds the same pressure",
};
