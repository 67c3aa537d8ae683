/* waits.c -- the last rank comes late to each kind of call; the others take little CPU until it does. */
#include "waits.h"

#include "claims.h"
#include "ranks/ranks.h"

#include "base/status.h"

#include <stdlib.h>
#include <time.h>

enum {
    LATE = 100000000, /* ns */
    PART = 10,        /* of that is the most that a wait may take of CPU */
    NUMBERS = 1 << 16 /* enough of them for ranks_alike()                */
};

static void sum(void)
{
    int64_t one = 1;

    ranks_add(1, &one);
}

static void most(void)
{
    double x = 0;

    ranks_most(1, &x);
}

static void hear_all(void (*gather)(const int *, size_t, const void *, void *))
{
    const size_t ranks = (size_t)ranks_count();
    int *rows = calloc(ranks, sizeof *rows);
    double mine = 0, *all = calloc(ranks, sizeof *all);

    for (size_t r = 0; r < ranks; r++)
        rows[r] = 1;
    gather(rows, sizeof mine, &mine, all);
    free(rows);
    free(all);
}

static void gather(void)
{
    hear_all(ranks_gather);
}

static void bring(void)
{
    hear_all(ranks_bring);
}

static void agree(void)
{
    ranks_agree(STATUS_DONE);
}

static void alike(void)
{
    double *block = calloc(NUMBERS, sizeof *block);

    ranks_alike(block, NUMBERS * sizeof *block);
    free(block);
}

static struct ranks_route *route; /* a number to the next rank */

static void make_route(void)
{
    const int to = (ranks_me() + 1) % ranks_count(), row = 0;

    ranks_route_create(&route, STATUS_DONE, sizeof(double), ranks_count() > 1, &to, &row);
}

static void use_route(void)
{
    const double out = 1;
    double in = 0;

    ranks_route_go(route, sizeof out, &out, &in);
}

static double cpu(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static void waits(void (*call)(void), const char *what)
{
    double before, taken;

    most(); /* all begin together */
    if (ranks_me() == ranks_count() - 1)
        nanosleep(&(struct timespec){ .tv_nsec = LATE }, NULL);
    before = cpu();
    call();
    taken = cpu() - before;
    claim(taken < LATE / PART, "a rank that waits for %g s in %s takes little CPU", 1e-9 * LATE, what);
}

void waits_claims(void)
{
    waits(sum, "a sum");
    waits(most, "a maximum");
    waits(gather, "a gather");
    waits(bring, "rows for the first rank");
    waits(agree, "an agreement");
    waits(alike, "what is alike");
    waits(make_route, "a route that is made");
    waits(use_route, "a route");
    ranks_route_free(&route);
}
