/* mpi-wait.c -- ranks that sleep while they wait: each machine has a word for each of its ranks, in memory
 * that they share, on which that one sleeps and the others wake it (futex(2)). */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* syscall() */
#endif
#include "ranks/mpi-wait.h"

#include <linux/futex.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <strings.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum {
    PATIENCE = 300000, /* ns of CPU that asking takes before a rank sleeps: most waits end within */
    SHORTEST = 100000, /* ns of a sleep that no other ends; to be woken takes some 20,000 to 50,000 */
    LONGEST = 10000000,
    PART = 4           /* between them a sleep is this part of what was waited                    */
};

typedef _Atomic uint32_t sleeper; /* 1: asleep */

static MPI_Comm machine = MPI_COMM_NULL;
static MPI_Win shared = MPI_WIN_NULL;
static sleeper alone, *sleepers = &alone; /* [ranks of the machine] */
static int there = 1, mine;
static bool may_sleep;

MPI_Comm ranks_neighbours(void)
{
    return machine;
}

/* Words of all, none asleep.  Where no memory that they share can be had, each sleeps for itself. */
static void share_words(void)
{
    void *words = NULL;
    MPI_Aint size = 0;
    int unit, ranks, got;

    MPI_Comm_size(machine, &ranks);
    MPI_Comm_set_errhandler(machine, MPI_ERRORS_RETURN);
    got = MPI_Win_allocate_shared((MPI_Aint)sizeof *sleepers, 1, MPI_INFO_NULL, machine, &words, &shared)
            == MPI_SUCCESS
        && MPI_Win_shared_query(shared, MPI_PROC_NULL, &size, &unit, &words) == MPI_SUCCESS;
    MPI_Comm_set_errhandler(machine, MPI_ERRORS_ARE_FATAL);
    MPI_Allreduce(MPI_IN_PLACE, &got, 1, MPI_INT, MPI_MIN, machine);
    if (!got)
        return;
    sleepers = words;
    there = ranks;
    MPI_Comm_rank(machine, &mine);
    atomic_store(&sleepers[mine], 0);
    MPI_Barrier(machine);
}

void ranks_wait_begin(void)
{
    const char *policy = getenv("OMP_WAIT_POLICY");

    may_sleep = !policy || strcasecmp(policy, "active") != 0;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    share_words();
}

void ranks_wait_end(void)
{
    if (sleepers != &alone)
        MPI_Win_free(&shared);
    sleepers = &alone;
    there = 1;
    MPI_Comm_free(&machine);
}

void ranks_wake(void)
{
    atomic_thread_fence(memory_order_seq_cst); /* a word that is 0 now has its rank look for what was sent */
    for (int r = 0; r < there; r++)
        if (r != mine && atomic_load_explicit(&sleepers[r], memory_order_relaxed) != 0
            && atomic_exchange(&sleepers[r], 0) != 0)
            syscall(SYS_futex, &sleepers[r], FUTEX_WAKE, 1, NULL, NULL, 0);
}

static long now(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return t.tv_sec * 1000000000L + t.tv_nsec;
}

/* How long to sleep [ns], unless another rank ends it. */
static long nap(long waited)
{
    const long part = waited / PART;

    return part < SHORTEST ? SHORTEST : part > LONGEST ? LONGEST : part;
}

/* Says that it will sleep, looks once more, and sleeps: what comes in between finds the word changed. */
static bool sleep_unless_done(int n, MPI_Request *request, long waited)
{
    const struct timespec most = { .tv_nsec = nap(waited) };
    int done;

    atomic_store(&sleepers[mine], 1);
    MPI_Testall(n, request, &done, MPI_STATUSES_IGNORE);
    if (!done)
        syscall(SYS_futex, &sleepers[mine], FUTEX_WAIT, 1, &most, NULL, 0);
    atomic_store(&sleepers[mine], 0);
    return done;
}

void ranks_wait(int n, MPI_Request *request)
{
    const long begun = now(CLOCK_MONOTONIC), spent = now(CLOCK_THREAD_CPUTIME_ID);
    int done = 0;

    ranks_wake();
    for (MPI_Testall(n, request, &done, MPI_STATUSES_IGNORE); !done;
         MPI_Testall(n, request, &done, MPI_STATUSES_IGNORE)) {
        if (may_sleep && now(CLOCK_THREAD_CPUTIME_ID) - spent > PATIENCE
            && sleep_unless_done(n, request, now(CLOCK_MONOTONIC) - begun))
            break;
    }
    ranks_wake(); /* what one hears it may send on: collectives go by several */
}
