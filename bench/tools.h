/* tools.h -- what the benchmarks share: clocks, repeats, hashes, threads. */
#ifndef BENCH_TOOLS_H
#define BENCH_TOOLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { BENCH_REPEATS = 15 };

/* Of BENCH_REPEATS repeats. */
struct bench_times {
    double median, least, most;
};

double bench_cpu(void);  /* of this process, all threads [s] */
double bench_wall(void); /* [s]                              */

/* CPU time of one call(of), in ns over `each`; a repeat lasts 30 ms at least and
 * has a multiple of `round` calls. */
struct bench_times bench_time(void (*call)(void *of), void *of, double each, int round);

struct bench_times bench_sort(double *values, int n);

/* FNV-1a; start from BENCH_HASH. */
#define BENCH_HASH UINT64_C(14695981039346656037)
uint64_t bench_hash(uint64_t hash, const void *bytes, size_t n);

void bench_threads(int n);

/* What one thread writes, seen by another that answers, seen by the first [s], the least mean of
 * some: some 0.1 microseconds where their cores have a cache in common, several times that where
 * not.  0 without OpenMP. */
double bench_apart(void);

/* First of all: one thread, and threads that wait as in the real program, which looks for
 * free cores (base/waiting.h).  Means starting once more. */
void bench_start(char **argv);

/* Loops for several threads, so far: how many, and, while regions are alone, the time that their
 * calling thread was in them [s].  Needs bench/regions.c and the linker's --wrap=GOMP_parallel; a
 * loop that its `if` denies threads is none.  0 with other compilers than gcc.  Half of the two
 * looks at the clock that each of them takes is inside, half outside. */
struct bench_regions {
    long n;
    double inside;
    double clock; /* one look at it [s] */
};
struct bench_regions bench_regions(void);

/* Regions get one thread though the program has several: a program with one has no regions. */
void bench_regions_alone(bool on);

/* Processor, clock, lanes, compiler, load; a warning when others are at work. */
void bench_head(const char *what, int lanes);

/* The file that goes with the program, "bench/rhs2.csv" for bench/rhs2. */
FILE *bench_csv(const char *program, const char *columns);

/* Zeroed, on cache lines; ends the program when there is none. */
void *bench_room(size_t bytes);

/* Ends the program with the message that status_fail() kept. */
void bench_must(int status);

#endif
