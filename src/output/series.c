/* series.c -- CSV: rows are gathered and written so that only whole lines reach the file.
 *
 * stdio would cut lines at the end of its buffer; a killed run would leave half a line. */
#include "output/series.h"

#include "base/status.h"
#include "output/aside.h"
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

enum { HOLD = 4096 }; /* bytes held back at most, if a line is not longer */

struct series {
    char path[ASIDE_PATH];
    int file, columns;
    off_t whole; /* length of the file up to its last whole line     */
    char *text;  /* lines held back                                  */
    size_t used, room;
    struct timespec old; /* when the file last grew                          */
};

static int trouble(const struct series *s)
{
    return status_fail(STATUS_IO, "%s: cannot be written: %s", s->path, strerror(errno));
}

/* `done` bytes were written, the rest was not: lines that are whole stay, half a
 * line is taken back. */
static int give_up(struct series *s, size_t done)
{
    const int error = errno;

    while (done > 0 && s->text[done - 1] != '\n')
        done--;
    if (ftruncate(s->file, s->whole + (off_t)done) == 0) { /* else it is no regular file */
        s->whole += (off_t)done;
        s->used -= done;
        memmove(s->text, s->text + done, s->used);
    }
    errno = error;
    return trouble(s);
}

int series_flush(struct series *s)
{
    size_t done = 0;

    clock_gettime(CLOCK_MONOTONIC, &s->old);
    while (done < s->used) {
        const ssize_t n = write(s->file, s->text + done, s->used - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return give_up(s, done);
        done += (size_t)n;
    }
    s->whole += (off_t)s->used;
    s->used = 0;
    return STATUS_DONE;
}

/* Makes room for n more bytes. */
static int reserve(struct series *s, size_t n)
{
    if (s->used + n > s->room) {
        const size_t room = 2 * (s->used + n);
        char *text = realloc(s->text, room);
        if (!text)
            return status_starved("%s: a row of %d columns cannot be kept", s->path, s->columns);
        s->text = text;
        s->room = room;
    }
    return STATUS_DONE;
}

static int add(struct series *s, const char *piece)
{
    const size_t n = strlen(piece);

    TRY(reserve(s, n));
    memcpy(s->text + s->used, piece, n);
    s->used += n;
    return STATUS_DONE;
}

static int add_number(struct series *s, int column, double value)
{
    char piece[40];

    if (isnan(value)) /* without a sign, so that every reader knows it */
        return add(s, "nan");
    snprintf(piece, sizeof piece, "%.*g", column == 0 ? 12 : 10, value + 0.0); /* no -0 */
    return add(s, piece);
}

/* Text with a comma or a quote in it is quoted, as RFC 4180 has it. */
static int add_text(struct series *s, const char *text)
{
    if (!text[strcspn(text, ",\"\n")])
        return add(s, text);
    TRY(add(s, "\""));
    for (; *text; text++) {
        const char one[3] = { *text == '\n' ? ' ' : *text, *text == '"' ? '"' : '\0', '\0' };
        TRY(add(s, one));
    }
    return add(s, "\"");
}

static bool is_due(const struct series *s)
{
    struct timespec now;

    if (s->used >= HOLD)
        return true;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - s->old.tv_sec) + 1e-9 * (double)(now.tv_nsec - s->old.tv_nsec)
           >= 1;
}

static int add_row(struct series *s, const double *value, const char *const *text)
{
    for (int i = 0; i < s->columns; i++) {
        if (i > 0)
            TRY(add(s, ","));
        TRY(text && text[i] ? add_text(s, text[i]) : add_number(s, i, value[i]));
    }
    return add(s, "\n");
}

int series_text_row(struct series *s, const double *value, const char *const *text)
{
    const size_t whole = s->used;
    const int status = add_row(s, value, text);

    if (status != STATUS_DONE)
        s->used = whole; /* without memory: no half a line */
    TRY(status);
    return is_due(s) ? series_flush(s) : STATUS_DONE;
}

int series_row(struct series *s, const double *value)
{
    return series_text_row(s, value, NULL);
}

static int head(struct series *s, const char *const *name, const char *const *unit)
{
    TRY(add(s, "# units: "));
    TRY(series_text_row(s, NULL, unit));
    TRY(series_text_row(s, NULL, name));
    return series_flush(s);
}

static int open_file(struct series **out, const char *path, int columns, int flags)
{
    struct series *s = *out = status_alloc(1, sizeof *s);

    if (!s)
        return STATUS_FAILED;
    s->columns = columns;
    snprintf(s->path, sizeof s->path, "%s", path);
    s->file = open(path, O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW | flags, 0666);
    return s->file < 0 ? trouble(s) : STATUS_DONE;
}

int series_open(struct series **out, const char *path, int columns, const char *const *name,
                const char *const *unit)
{
    int code = open_file(out, path, columns, O_CREAT | O_TRUNC);

    if (code == STATUS_DONE)
        code = head(*out, name, unit);
    if (code != STATUS_DONE && *out) {
        (*out)->used = 0;
        series_close(out);
    }
    return code;
}

int series_open_again(struct series **out, const char *path, int columns)
{
    const int code = open_file(out, path, columns, 0);

    if (code != STATUS_DONE)
        series_close(out);
    return code;
}

static int save(struct series *s)
{
    TRY(series_flush(s));
    if (fsync(s->file) != 0 && errno != EINVAL) /* EINVAL: no regular file */
        return trouble(s);
    return STATUS_DONE;
}

static int cut(struct series *s, bool tries)
{
    const off_t there = lseek(s->file, 0, SEEK_END);

    if (there < s->whole)
        return status_fail(STATUS_IO, "%s: has %lld bytes, but had %lld at the checkpoint; it was "
                           "changed since: put it back as it was, or run the scene anew", s->path,
                           (long long)there, (long long)s->whole);
    return tries || ftruncate(s->file, s->whole) == 0 ? STATUS_DONE : trouble(s);
}

int series_keep(struct series *s, struct archive *a, const char *name)
{
    long whole;

    if (!s)
        return STATUS_DONE;
    if (!archive_fills(a))
        TRY(save(s));
    whole = (long)s->whole;
    TRY(archive_integers(a, name, &whole, 1));
    s->whole = (off_t)whole;
    return archive_fills(a) ? cut(s, archive_tries(a)) : STATUS_DONE;
}

int series_close(struct series **series)
{
    struct series *s = *series;
    int code = STATUS_DONE;

    if (!s)
        return STATUS_DONE;
    if (s->used > 0)
        code = series_flush(s);
    if (s->file >= 0 && close(s->file) != 0 && code == STATUS_DONE)
        code = trouble(s);
    free(s->text);
    free(s);
    *series = NULL;
    return code;
}
