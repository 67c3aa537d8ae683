/* waiting.c -- whether threads spin while they wait: looks for cores that are free. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* sched_getaffinity() */
#endif
#include "base/waiting.h"

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum {
    TURNS = 5000, /* 50 to 200 microseconds: longer than what is between two loops */
    LOOKS = 5,    /* at the machine                                               */
    WORTH_WAKING = 12000, /* particles of waiting_worth(), where threads sleep     */
    WORTH_CALLING = 1500  /* and where they spin                                   */
};

int waiting_spins(int threads, int processors, int all, int busy)
{
    const int left = all - busy, ours = left < processors ? left : processors;

    return busy >= 0 && threads > 1 && threads <= ours ? TURNS : 0;
}

/* Threads that run or wait for a processor, but for this one; -1: not known. */
static int busy_now(void)
{
    FILE *f = fopen("/proc/stat", "r");
    char line[256];
    int running = 0;

    while (f && running == 0 && fgets(line, sizeof line, f))
        if (sscanf(line, "procs_running %d", &running) != 1)
            running = 0;
    if (f)
        fclose(f);
    return running - 1;
}

static int ascending(const void *a, const void *b)
{
    const int x = *(const int *)a, y = *(const int *)b;

    return (x > y) - (x < y);
}

/* The middle one of some looks, as threads come and go. */
static int busy_usually(void)
{
    const struct timespec nap = { .tv_nsec = 1000000 };
    int seen[LOOKS];

    for (int i = 0; i < LOOKS; i++) {
        seen[i] = busy_now();
        nanosleep(&nap, NULL);
    }
    qsort(seen, LOOKS, sizeof *seen, ascending);
    return seen[LOOKS / 2];
}

/* Processors' worth of time that a container may use at most; `none`: as many as there are. */
static int quota(int none)
{
    FILE *f = fopen("/sys/fs/cgroup/cpu.max", "r");
    double most, period;
    const int read = f ? fscanf(f, "%lf %lf", &most, &period) : 0; /* or "max" */

    if (f)
        fclose(f);
    return read == 2 && period > 0 && most / period < none ? (int)(most / period) : none;
}

static int processors_ours(int all)
{
    cpu_set_t set;

    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : all;
}

void waiting_sleep(void)
{
    setenv("OMP_WAIT_POLICY", "passive", 0);
}

void waiting_choose(int threads)
{
    const int all = (int)sysconf(_SC_NPROCESSORS_ONLN), ours = processors_ours(all);
    const char *asked = getenv("OMP_NUM_THREADS");
    char turns[16];

    if (threads == 0)
        threads = asked ? atoi(asked) : ours;
    if (getenv("OMP_WAIT_POLICY")) /* the user knows better */
        return;
    waiting_sleep();
    const int spins = waiting_spins(threads, quota(ours), all, busy_usually());
    snprintf(turns, sizeof turns, "%d", spins);
    if (spins > 0)
        setenv("GOMP_SPINCOUNT", turns, 0);
}

long waiting_worth(const char *turns)
{
    return turns && atol(turns) > 0 ? WORTH_CALLING : WORTH_WAKING;
}

bool waiting_repays(long n)
{
    static long worth; /* the environment is searched once: a right-hand side asks several times */

    if (worth == 0)
        worth = waiting_worth(getenv("GOMP_SPINCOUNT"));
    return n > worth;
}
