/* items.c -- what memory a rank has of each array: preloaded by tests/ranks-items.sh.
 *
 * When a rank has asked all others for the ITEMS_AT-th time, it writes to the file ITEMS.N, N its number, of
 * each array of 4 kB or more
 *
 *     BYTES LIBRARY OFFSET OFFSET ...
 *
 * how much of it is there, which library has asked for it, `-` where it is the program, and from where in
 * the program, the innermost call first.  A page that was only read is not there: it is that of zeros,
 * which no process has for itself. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <malloc.h>
#include <mpi.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { MOST = 1 << 15, DEPTH = 16, LEAST = 4096, PAGE = 4096 };

static struct array {
    const void *at; /* NULL: it was freed */
    size_t bytes;
    int depth;
    void *from[DEPTH];
} all[MOST];
static int arrays;
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER; /* MPI has threads of its own */
static __thread bool busy; /* what is asked for meanwhile is our own */

extern void *__libc_malloc(size_t bytes), *__libc_calloc(size_t n, size_t bytes);
extern void *__libc_realloc(void *old, size_t bytes), *__libc_memalign(size_t align, size_t bytes);
extern void __libc_free(void *old);

static void note(const void *at, size_t bytes)
{
    int i = 0;

    if (!at || bytes < LEAST || busy)
        return;
    busy = true;
    pthread_mutex_lock(&mutex);
    while (i < arrays && all[i].at)
        i++;
    if (i < MOST) {
        all[i].at = at;
        all[i].bytes = bytes;
        all[i].depth = backtrace(all[i].from, DEPTH);
        arrays += i == arrays;
    }
    pthread_mutex_unlock(&mutex);
    busy = false;
}

static void forget(const void *at)
{
    pthread_mutex_lock(&mutex);
    for (int i = 0; at && i < arrays; i++)
        if (all[i].at == at)
            all[i].at = NULL;
    pthread_mutex_unlock(&mutex);
}

void *malloc(size_t bytes)
{
    void *made = __libc_malloc(bytes);

    note(made, bytes);
    return made;
}

void *calloc(size_t n, size_t bytes)
{
    void *made = __libc_calloc(n, bytes);

    note(made, n * bytes);
    return made;
}

void *realloc(void *old, size_t bytes)
{
    void *made = __libc_realloc(old, bytes);

    if (made || bytes == 0)
        forget(old);
    note(made, bytes);
    return made;
}

void *aligned_alloc(size_t align, size_t bytes)
{
    void *made = __libc_memalign(align, bytes);

    note(made, bytes);
    return made;
}

int posix_memalign(void **to, size_t align, size_t bytes)
{
    return (*to = aligned_alloc(align, bytes)) ? 0 : ENOMEM;
}

void free(void *old)
{
    if (old && malloc_usable_size(old) >= LEAST)
        forget(old);
    __libc_free(old);
}

/* Pages that ranks of a machine share are counted, too: each then has its own. */
int memfd_create(const char *name, unsigned flags)
{
    int (*real)(const char *, unsigned) = (int (*)(const char *, unsigned))dlsym(RTLD_NEXT, "memfd_create");

    if (!(flags & MFD_ALLOW_SEALING))
        return real(name, flags);
    errno = ENOSYS;
    return -1;
}

/* As /proc/self/pagemap has it: bit 63 says that it is there, bit 56 that no other process has it. */
static bool is_own(int map, uintptr_t at)
{
    const uint64_t own = UINT64_C(1) << 63 | UINT64_C(1) << 56;
    uint64_t page = 0;

    return pread(map, &page, sizeof page, (off_t)(at / PAGE * sizeof page)) == sizeof page && (page & own) == own;
}

static size_t held(int map, const struct array *a)
{
    const uintptr_t from = (uintptr_t)a->at, to = from + a->bytes;
    size_t bytes = 0;

    for (uintptr_t at = from, end; at < to; at = end) {
        end = (at / PAGE + 1) * PAGE < to ? (at / PAGE + 1) * PAGE : to;
        bytes += is_own(map, at) ? end - at : 0;
    }
    return bytes;
}

static const char *name_of(const Dl_info *from)
{
    const char *slash = strrchr(from->dli_fname, '/');

    return slash ? slash + 1 : from->dli_fname;
}

/* The first calls are those of this library. */
static void write_array(FILE *to, size_t bytes, const struct array *a, const char *program)
{
    Dl_info own, from;
    bool named = false;

    if (!dladdr((void *)(uintptr_t)note, &own))
        return;
    fprintf(to, "%zu", bytes);
    for (int i = 0; i < a->depth; i++) {
        if (!dladdr(a->from[i], &from) || from.dli_fbase == own.dli_fbase)
            continue;
        const bool ours = strcmp(name_of(&from), program) == 0;
        if (!named)
            fprintf(to, " %s", ours ? "-" : name_of(&from));
        named = true;
        if (ours)
            fprintf(to, " %zx", (size_t)((char *)a->from[i] - (char *)from.dli_fbase) - 1);
    }
    fputc('\n', to);
}

static void write_all(const char *file)
{
    const int map = open("/proc/self/pagemap", O_RDONLY);
    FILE *to = fopen(file, "w");

    for (int i = 0; map >= 0 && to && i < arrays; i++)
        if (all[i].at)
            write_array(to, held(map, &all[i]), &all[i], program_invocation_short_name);
    if (to)
        fclose(to);
    if (map >= 0)
        close(map);
}

int MPI_Iallreduce(const void *from, void *to, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm, MPI_Request *wait)
{
    static long asked;
    const char *when = getenv("ITEMS_AT"), *where = getenv("ITEMS");
    char file[4096];
    int me;

    if (when && where && ++asked == atol(when)) {
        busy = true;
        MPI_Comm_rank(comm, &me);
        snprintf(file, sizeof file, "%s.%d", where, me);
        write_all(file);
        busy = false;
    }
    return PMPI_Iallreduce(from, to, n, type, op, comm, wait);
}
