/* cli.h -- the command line: what was asked for. */
#ifndef CLI_CLI_H
#define CLI_CLI_H

#include "study/compare.h"

#include <stdbool.h>
#include <stdio.h>

enum cli_command { CLI_RUN, CLI_RESUME, CLI_CHECK, CLI_COMPARE, CLI_SWEEP, CLI_SPREAD,
                   CLI_PLOT, CLI_REPORT, CLI_MOVIE, CLI_HULL, CLI_LIST, CLI_EXPLAIN };

enum { CLI_OVERRIDES = 128 };

struct cli {
    enum cli_command command;
    const char *subject;                  /* scene, directory, table or name  */
    int overrides;
    const char *override[CLI_OVERRIDES];  /* "KEY=VALUE", those of options last */
    const char *directory;                /* -o; NULL: chosen from the scene  */
    int threads;                          /* 0: as the environment says       */
    int ranks;                            /* processes; 0: this one           */
    bool quiet, force;

    const char *methods, *tols, *reference; /* of compare, as struct compare_order has them */
    int sweeps;
    const char *sweep[COMPARE_SWEEPS];
    int repeat, jobs;
    double budget, early;
    bool growth;

    struct cli_spread { /* of spread, as struct spread_order has them */
        int runs, seed;
        double size, share, window[2];
    } spread;
    struct cli_stl { /* of hull */
        double scale; /* metres in one of the file's units             */
        double merge; /* corners nearer than this are one [m]          */
    } hull;
};

/* Fills c from the arguments.  --help and --version print and end the program;
 * a wrong command line prints what is wrong and ends it with status 2. */
void cli_parse(int argc, char **argv, struct cli *c);

/* Prints what a scene says of the hull of the STL file c->subject. */
int cli_hull(const struct cli *c);

/* Program, libraries and their versions, as --version prints them. */
void cli_version(FILE *to);

/* Replaces this process by the program for `dimension` (2 or 3), found beside
 * this one or in the directory where it was installed.  Returns only when that
 * failed: STATUS_IO. */
int cli_exec(int dimension, char **argv);

/* The path of the program for a dimension, and of a kind ("-mpi"), beside this one. */
void cli_beside(char *path, size_t size, int dimension, const char *kind);

/* The same on c->ranks ranks, by mpirun: argv is what each of them gets.  STATUS_BAD_SCENE: a scene
 * that is no file, which only one of them could read. */
int cli_exec_ranks(const struct cli *c, int dimension, char **argv);

/* The program that is started next has its memory in large pages, if the system has them and
 * GLIBC_TUNABLES does not say otherwise (glibc.malloc.hugetlb=0). */
void cli_huge_pages(void);

/* Directory with data/ and plots/: beside this program in a build tree, else where
 * it was installed.  Static. */
const char *cli_data(void);

/* Makes a scene whose path is a pipe (/dev/stdin, /dev/fd/N) one that can be read again and
 * again, by the programs of cli_exec() too.  Refuses pipes with a name (mkfifo), leaves
 * other paths alone. */
int cli_keep_pipe(const char *path);

/* The dimension that a scene asks for (2 when it does not say). */
int cli_dimension(const struct cli *c, int *dimension);

#endif
