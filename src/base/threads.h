/* threads.h -- OpenMP's counts, or one thread where the compiler has none. */
#ifndef BASE_THREADS_H
#define BASE_THREADS_H

#ifdef _OPENMP
#include <omp.h>
#endif

/* Threads that the next parallel region may have. */
static inline int threads_most(void)
{
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

/* This thread of its region, and how many they are. */
static inline int threads_me(void)
{
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

static inline int threads_all(void)
{
#ifdef _OPENMP
    return omp_get_num_threads();
#else
    return 1;
#endif
}

/* Things from .. to-1 of n that this thread of its region has. */
struct threads_part {
    int from, to;
};

static inline struct threads_part threads_part(int n)
{
    const long me = threads_me(), all = threads_all();

    return (struct threads_part){ (int)(n * me / all), (int)(n * (me + 1) / all) };
}

/* The threads of a region wait for each other; one that is alone need not: a barrier of the
 * library's would be a call of the system even then. */
static inline void threads_meet(void)
{
    if (threads_all() > 1) {
#pragma omp barrier
    }
}

/* `call` of one thread of a region after the other. */
#define THREADS_IN_TURN(call)                                                              \
    do {                                                                                   \
        if (threads_all() == 1) {                                                          \
            call;                                                                          \
        } else {                                                                           \
            _Pragma("omp critical")                                                        \
            call;                                                                          \
        }                                                                                  \
    } while (0)

/* `call` on all threads where the work is worth it, else at once: a region is a call of the library,
 * which makes a team even of one thread, and a right-hand side has a dozen.  Not for calls out of
 * a region, whose threads would share the call's loops. */
#define THREADS(worth, call)                                                               \
    do {                                                                                   \
        if (threads_most() == 1 || !(worth)) {                                             \
            call;                                                                          \
        } else {                                                                           \
            _Pragma("omp parallel")                                                        \
            call;                                                                          \
        }                                                                                  \
    } while (0)

#endif
