/* exec-ranks.c -- hands over to mpirun, which starts the program of the scene's dimension on many
 * ranks of this machine. */
#include "cli/cli.h"

#include "base/status.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WORDS = 8 }; /* of mpirun, before those of the program */

/* Cores are shared out, unless somebody has said how many threads there are to be. */
static void share_cores(const struct cli *c)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN), each = cores / c->ranks;
    char threads[24];

    snprintf(threads, sizeof threads, "%ld", each > 1 ? each : 1);
    setenv("OMP_NUM_THREADS", threads, 0);
    setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
}

static int refuse_program(int dimension, const char *path)
{
    return status_fail_with(STATUS_IO, (struct status_advice){
        .cause = "It is built where configure finds Open MPI and Zoltan",
        .remedy = "install both (on Debian: apt-get install libopenmpi-dev openmpi-bin "
                  "libtrilinos-zoltan-dev) and build again, or take --threads instead" },
        "%s: the program for many ranks, stiffwater-%dd-mpi, is not there", path, dimension);
}

/* mpirun gives its input to the first rank alone, whatever has been made of it here. */
static int agree_scene(const char *path)
{
    if (strncmp(path, "/dev/", 5) != 0 && strncmp(path, "/proc/", 6) != 0)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: with --ranks the scene must be a file, which all ranks "
                       "can read", path);
}

int cli_exec_ranks(const struct cli *c, int dimension, char **argv)
{
    char path[PATH_MAX], ranks[24], *word[WORDS + 1024];
    int n = 0;

    TRY(agree_scene(c->subject));
    cli_beside(path, sizeof path, dimension, "-mpi");
    if (access(path, X_OK) != 0)
        return refuse_program(dimension, path);
    share_cores(c);
    snprintf(ranks, sizeof ranks, "%d", c->ranks);
    char *const first[WORDS] = { "mpirun.openmpi", "-q", "--oversubscribe", "--bind-to", "none", "-n",
                                 ranks, path };
    memcpy(word, first, sizeof first);
    for (n = 1; argv[n] && n < 1024; n++)
        word[WORDS + n - 1] = argv[n];
    word[WORDS + n - 1] = NULL;
    execvp(word[0], word);
    word[0] = "mpirun"; /* where Open MPI is the only one */
    execvp(word[0], word);
    return status_fail(STATUS_IO, "mpirun: %s; it starts the ranks, on Debian: apt-get install "
                       "openmpi-bin", strerror(errno));
}
