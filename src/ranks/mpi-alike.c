/* mpi-alike.c -- what ranks of one machine have alike takes memory once.
 *
 * The first rank of a machine lends a copy of its pages in a file that has no name.  Each of the others
 * compares, and where its own pages have the same bytes it takes those of the file in their stead, at the
 * same place.  Who writes to one afterwards gets a copy of its own: so nothing can be seen of it but in
 * what the machine has left, and whoever cannot take part keeps what it has. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* memfd_create() */
#endif
#include "ranks/mpi-wait.h"
#include "ranks/ranks.h"

#include <fcntl.h>
#include <mpi.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    WINDOW = 1 << 18, /* bytes that are compared, and replaced, together */
    SEALS = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE
};

/* Whole pages of a block. */
struct pages {
    char *first;
    size_t bytes;
};

/* What the first rank of a machine says. */
struct loan {
    int64_t process, file;   /* file below 0: there is none */
    uint64_t skipped, bytes; /* of the block before its pages, of these */
};

static struct pages pages_of(const void *block, size_t bytes)
{
    const uintptr_t page = (uintptr_t)sysconf(_SC_PAGESIZE), at = (uintptr_t)block;
    const uintptr_t from = (at + page - 1) / page * page, to = (at + bytes) / page * page;

    return (struct pages){ .first = (char *)block + (from - at), .bytes = to > from ? to - from : 0 };
}

static bool may_be_written(size_t bytes)
{
    struct rlimit most;

    return getrlimit(RLIMIT_FSIZE, &most) != 0 || most.rlim_cur == RLIM_INFINITY || most.rlim_cur >= bytes;
}

static bool write_all(int file, struct pages p)
{
    ssize_t wrote = 1;

    for (size_t done = 0; wrote > 0 && done < p.bytes; done += wrote > 0 ? (size_t)wrote : 0)
        wrote = write(file, p.first + done, p.bytes - done);
    return wrote > 0 && fcntl(file, F_ADD_SEALS, SEALS) == 0;
}

/* A file with these pages, which nobody can change; -1: none can be had. */
static int lend(struct pages p)
{
    const int file = may_be_written(p.bytes) ? memfd_create("stiffwater", MFD_CLOEXEC | MFD_ALLOW_SEALING) : -1;

    if (file < 0 || write_all(file, p))
        return file;
    close(file);
    return -1;
}

static bool is_lent(int file, uint64_t bytes)
{
    const int seals = fcntl(file, F_GET_SEALS); /* -1: of another kind of file */
    struct stat is;

    return seals >= 0 && (seals & SEALS) == SEALS && fstat(file, &is) == 0 && (uint64_t)is.st_size == bytes;
}

/* That of another process, if it is one: where processes have other numbers in each other's view, what
 * has this name may be anything. */
static int borrow(const struct loan *of)
{
    char path[80];
    int file;

    snprintf(path, sizeof path, "/proc/%lld/fd/%lld", (long long)of->process, (long long)of->file);
    file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0 || is_lent(file, of->bytes))
        return file;
    close(file);
    return -1;
}

static bool are_equal(int file, size_t from, const char *own, size_t bytes)
{
    const void *there = mmap(NULL, bytes, PROT_READ, MAP_PRIVATE, file, (off_t)from);
    const bool equal = there != MAP_FAILED && memcmp(there, own, bytes) == 0;

    if (there != MAP_FAILED)
        munmap((void *)there, bytes);
    return equal;
}

static void take(int file, struct pages p)
{
    for (size_t at = 0; at < p.bytes; at += WINDOW) {
        const size_t n = p.bytes - at < WINDOW ? p.bytes - at : WINDOW;

        if (are_equal(file, at, p.first + at, n)
            && mmap(p.first + at, n, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_FIXED, file, (off_t)at)
                   == MAP_FAILED)
            return;
    }
}

void ranks_alike(const void *block, size_t bytes)
{
    const struct pages p = pages_of(block, bytes);
    const MPI_Comm machine = ranks_neighbours();
    struct loan loan = { .process = getpid(), .skipped = (uint64_t)(p.first - (const char *)block),
                         .bytes = p.bytes, .file = -1 };
    const struct loan mine = loan;
    int there, who, file = -1;
    MPI_Request done;

    MPI_Comm_size(machine, &there);
    MPI_Comm_rank(machine, &who);
    if (there == 1 || bytes < WINDOW)
        return;
    if (who == 0)
        loan.file = file = lend(p);
    MPI_Ibcast(&loan, (int)sizeof loan, MPI_BYTE, 0, machine, &done);
    ranks_wait(1, &done);
    if (who > 0 && loan.file >= 0 && loan.skipped == mine.skipped && loan.bytes == mine.bytes)
        file = borrow(&loan);
    if (file >= 0)
        take(file, p);
    MPI_Ibarrier(machine, &done); /* until then the file is open */
    ranks_wait(1, &done);
    if (file >= 0)
        close(file);
}
