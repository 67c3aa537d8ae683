/* pieces.c -- files to which all ranks write. */
#include "output/pieces.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ROWS = 1 << 12 }; /* of one write */

/* What the first rank tells the others. */
struct place {
    char path[ASIDE_PATH];
    long at[IMAGE_ARRAYS]; /* where each array begins in the file */
};

static_assert(sizeof(struct place) <= RANKS_SAID, "it can be said");

void pieces_numbers(const void *self, long first, long n, void *to)
{
    memcpy(to, (const double *)self + first, (size_t)n * sizeof(double));
}

static int failed(const char *path, int error)
{
    const bool elsewhere = error == ENOENT && ranks_me() > 0; /* the first has just made it */

    return status_fail_with(STATUS_IO, (struct status_advice){
        .remedy = elsewhere ? "all ranks write such files together, so all must see the directory of "
                              "results under one path" : NULL },
        "%s: cannot be written%s: %s", path, elsewhere ? " by all ranks" : "",
        strerror(error ? error : EIO));
}

static bool write_range(int file, const char *bytes, size_t n, long at)
{
    while (n > 0) {
        const ssize_t done = pwrite(file, bytes, n, (off_t)at);
        if (done < 0 && errno == EINTR)
            continue;
        if (done <= 0)
            return false;
        bytes += done;
        at += done;
        n -= (size_t)done;
    }
    return true;
}

static bool write_piece(int file, const struct piece *p, long at, void *room)
{
    for (long first = 0; first < p->n; first += ROWS) {
        const long n = p->n - first < ROWS ? p->n - first : ROWS;
        p->fill(p->self, first, n, room);
        if (!write_range(file, room, (size_t)n * p->bytes, at + (p->from + first) * (long)p->bytes))
            return false;
    }
    return true;
}

static bool write_all(int file, const struct place *to, const struct pieces *p, void *room)
{
    for (int i = 0; i < p->n; i++)
        if (!write_piece(file, &p->piece[i], to->at[p->piece[i].array], room))
            return false;
    return true;
}

static size_t widest(const struct pieces *p)
{
    size_t bytes = 1;

    for (int i = 0; i < p->n; i++)
        bytes = p->piece[i].bytes > bytes ? p->piece[i].bytes : bytes;
    return bytes;
}

static int write_pieces(const struct place *to, const struct pieces *p, bool safely)
{
    struct aside other;
    void *room = status_alloc(ROWS, widest(p));
    int file, error = 0;

    if (!room)
        return STATUS_FAILED;
    aside_name(&other, to->path);
    file = open(other.temporary, O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0 || !write_all(file, to, p, room) || (safely && fsync(file) != 0))
        error = errno ? errno : EIO;
    free(room);
    if (file >= 0 && close(file) != 0 && !error)
        error = errno;
    return error ? failed(to->path, error) : STATUS_DONE;
}

static int tell(int status, struct aside *a, const struct image *image, long ahead, struct place *to)
{
    if (status != STATUS_DONE || !a)
        return status;
    if (fflush(a->to) != 0 || ferror(a->to))
        return failed(a->path, errno);
    strcpy(to->path, a->path);
    for (int i = 0; i < image->arrays; i++)
        to->at[i] = ahead + image->array[i].at;
    return STATUS_DONE;
}

int pieces_write(int status, struct aside *a, const struct image *image, long ahead,
                 const struct pieces *pieces, bool safely)
{
    struct place to = { .path = "" };

    status = tell(status, a, image, ahead, &to);
    if (pieces->shared)
        status = ranks_agree(status);
    TRY(status);
    if (pieces->shared)
        ranks_first(a ? 0 : HUGE_VAL, 0, &to, sizeof to);
    status = write_pieces(&to, pieces, safely || ranks_me() > 0); /* the first can bring its own to the disk later */
    return pieces->shared ? ranks_agree(status) : status;
}
