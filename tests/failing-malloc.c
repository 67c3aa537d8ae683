/* failing-malloc.c -- memory that is refused, for tests/memory-faults.sh: LD_PRELOAD it.
 *
 *     FAIL_ONCE=N    request number N is refused
 *     FAIL_FROM=N    that one and all after it
 *     FAIL_COUNT=1   nothing is refused; their number goes to standard error at the end
 *     FAIL_BUT=1     requests by HDF5 and SUNDIALS are not counted, nor refused
 *     FAIL_ONLY=NAME none but those of files whose path has this in it
 *
 * Requests are those of the program and of its libraries, from the first on.  Written for glibc,
 * whose own functions have a second name. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* dladdr */
#endif
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

static atomic_long requests;
static long once, from, counts;
static int but;
static const char *only;

__attribute__((constructor)) static void ask(void)
{
    const char *o = getenv("FAIL_ONCE"), *f = getenv("FAIL_FROM");

    once = o ? atol(o) : 0;
    from = f ? atol(f) : 0;
    counts = getenv("FAIL_COUNT") != NULL;
    but = getenv("FAIL_BUT") != NULL;
    only = getenv("FAIL_ONLY");
    atomic_store(&requests, 0);
}

__attribute__((destructor)) static void tell(void)
{
    char line[64];
    const int n = snprintf(line, sizeof line, "requests: %ld\n", atomic_load(&requests));

    if (counts && write(2, line, (size_t)n) < 0)
        counts = 0;
}

static int is_spared(const void *caller)
{
    Dl_info about;

    if ((!but && !only) || !dladdr(caller, &about) || !about.dli_fname)
        return 0;
    if (only)
        return !strstr(about.dli_fname, only);
    return strstr(about.dli_fname, "hdf5") || strstr(about.dli_fname, "sundials");
}

static int refused(const void *caller)
{
    long n;

    if (is_spared(caller))
        return 0;
    n = atomic_fetch_add(&requests, 1) + 1;
    if (n == once || (from > 0 && n >= from)) {
        errno = ENOMEM;
        return 1;
    }
    return 0;
}

void *malloc(size_t size)
{
    return refused(__builtin_return_address(0)) ? NULL : __libc_malloc(size);
}

/* Else libc would be the caller. */
char *strdup(const char *text)
{
    const size_t size = strlen(text) + 1;
    char *to = refused(__builtin_return_address(0)) ? NULL : __libc_malloc(size);

    return to ? memcpy(to, text, size) : NULL;
}

void *calloc(size_t count, size_t size)
{
    return refused(__builtin_return_address(0)) ? NULL : __libc_calloc(count, size);
}

void *realloc(void *old, size_t size)
{
    return refused(__builtin_return_address(0)) ? NULL : __libc_realloc(old, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return refused(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void **to, size_t alignment, size_t size)
{
    void *memory = refused(__builtin_return_address(0)) ? NULL : __libc_memalign(alignment, size);

    if (!memory)
        return ENOMEM;
    *to = memory;
    return 0;
}
