/* tools.c -- what the benchmarks share. */
#include "tools.h"

#include "base/status.h"
#include "base/waiting.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#ifdef _OPENMP
#include <omp.h>
#endif

static double seconds(clockid_t clock)
{
    struct timespec t;

    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_cpu(void)
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

double bench_wall(void)
{
    return seconds(CLOCK_MONOTONIC);
}

static int ascending(const void *l, const void *r)
{
    const double *a = l, *b = r;

    return (*a > *b) - (*a < *b);
}

struct bench_times bench_sort(double *values, int n)
{
    qsort(values, (size_t)n, sizeof *values, ascending);
    return (struct bench_times){ values[n / 2], values[0], values[n - 1] };
}

struct bench_times bench_time(void (*call)(void *of), void *of, double each, int round)
{
    double ns[BENCH_REPEATS], start = bench_cpu();

    call(of);
    call(of);
    const double once = 0.5 * (bench_cpu() - start) + 1e-6;
    const int calls = round * (1 + (int)(0.03 / (once * round)));
    for (int r = 0; r < BENCH_REPEATS; r++) {
        start = bench_cpu();
        for (int i = 0; i < calls; i++)
            call(of);
        ns[r] = 1e9 * (bench_cpu() - start) / calls / each;
    }
    return bench_sort(ns, BENCH_REPEATS);
}

uint64_t bench_hash(uint64_t hash, const void *bytes, size_t n)
{
    for (const unsigned char *p = bytes; n--; p++)
        hash = (hash ^ *p) * UINT64_C(1099511628211);
    return hash;
}

void bench_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

#ifdef _OPENMP
/* This thread says 1, 3, ..; the other answers with 2, 4, .. */
static void say(atomic_int *last, int turns)
{
    const int me = omp_get_thread_num();

    for (int i = 0; i < turns; i++) {
        while (atomic_load(last) != 2 * i + me)
            ;
        atomic_store(last, 2 * i + me + 1);
    }
}

double bench_apart(void)
{
    enum { TURNS = 500, TIMES = 5 };
    double least = HUGE_VAL;

    for (int k = 0; k < TIMES; k++) {
        _Alignas(64) atomic_int last = 0;
        double took = 0;

#pragma omp parallel num_threads(2) reduction(max : took)
        if (omp_get_num_threads() == 2) {
            const double start = bench_wall();
            say(&last, TURNS);
            took = bench_wall() - start;
        }
        least = fmin(least, took / TURNS);
    }
    return least;
}
#else
double bench_apart(void)
{
    return 0;
}
#endif

void bench_start(char **argv)
{
    if (!getenv("OMP_WAIT_POLICY")) {
        waiting_choose(2); /* read when a program is loaded */
        execv(argv[0], argv);
    }
    bench_threads(1);
}

/* Of a chain of additions, one a cycle [GHz]; the fastest of many short ones. */
static double clock_rate(void)
{
    enum { CHAIN = 100000 };
    double best = 0;

    for (int r = 0; r < 200; r++) {
        const double start = bench_wall();
        for (long i = 0; i < CHAIN; i++)
            __asm__ volatile("" : "+r"(i));
        const double rate = 1e-9 * CHAIN / (bench_wall() - start);
        best = rate > best ? rate : best;
    }
    return best;
}

static void processor(char *name, size_t size)
{
    FILE *f = fopen("/proc/cpuinfo", "r");
    char line[256];

    snprintf(name, size, "unknown processor");
    while (f && fgets(line, sizeof line, f))
        if (strncmp(line, "model name", 10) == 0 && strchr(line, ':')) {
            snprintf(name, size, "%s", strchr(line, ':') + 2);
            name[strcspn(name, "\n")] = '\0';
            break;
        }
    if (f)
        fclose(f);
}

void bench_head(const char *what, int lanes)
{
    char name[128];
    double load = 0;

    processor(name, sizeof name);
    if (getloadavg(&load, 1) != 1)
        load = 0;
    printf("\n%s\nmachine: %s at %.2f GHz, %d lanes, gcc %s, load %.1f\n", what, name,
           clock_rate(), lanes, __VERSION__, load);
    printf("threads that wait %s\n", getenv("GOMP_SPINCOUNT") ? "spin" : "sleep");
    if (load > 0.5)
        printf("WARNING: others are at work (load %.1f): times are too long\n", load);
}

FILE *bench_csv(const char *program, const char *columns)
{
    char path[512];
    FILE *f;

    snprintf(path, sizeof path, "%s.csv", program);
    f = fopen(path, "w");
    if (!f) {
        fprintf(stderr, "%s cannot be written\n", path);
        exit(1);
    }
    fprintf(f, "%s\n", columns);
    return f;
}

void *bench_room(size_t bytes)
{
    void *memory = aligned_alloc(64, (bytes + 127) / 64 * 64);

    if (!memory) {
        fprintf(stderr, "no memory for the benchmark\n");
        exit(1);
    }
    memset(memory, 0, bytes);
    return memory;
}

void bench_must(int status)
{
    if (status == STATUS_DONE)
        return;
    fprintf(stderr, "%s\n", status_message());
    exit(1);
}
