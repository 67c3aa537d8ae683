/* ranks-same.c -- do all ranks run the same scene?  Each reads it for itself, on a machine that may have
 * another file; what would come of that has no meaning. */
#include "run/ranks.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

enum {
    PIECE = 4096, /* bytes of the first rank's text that all hear at once */
    SHOWN = 120,  /* of a line in a message                               */
    HALF = SHOWN / 2,
    NUMBER = 24   /* letters of one, at most                              */
};

/* Of a rank: what it has read. */
struct text {
    char *all;
    size_t bytes;
};

/* Where a rank differs from the first one, and its line there. */
struct other {
    int64_t where;
    char line[SHOWN];
};

static int write_text(const struct run *r, struct text *own)
{
    FILE *to = open_memstream(&own->all, &own->bytes);

    if (!to)
        return status_starved("ranks cannot compare what they have read");
    fprintf(to, "version = %s\n", PACKAGE_VERSION);
    scene_write_given(r->scene, to);
    return fclose(to) == 0 ? STATUS_DONE : status_starved("ranks cannot compare what they have read");
}

/* What the first rank says, to all. */
static void hear_first(void *said, size_t bytes)
{
    ranks_first(ranks_me() == 0 ? 0 : HUGE_VAL, 0, said, bytes);
}

/* The first byte that the first rank has otherwise; -1: there is none. */
static int64_t compare(const struct text *own)
{
    int64_t whole = (int64_t)own->bytes, where = -1;
    char piece[PIECE];

    hear_first(&whole, sizeof whole);
    for (int64_t from = 0; from < whole; from += PIECE) {
        const int64_t n = whole - from < PIECE ? whole - from : PIECE;
        if (ranks_me() == 0)
            memcpy(piece, own->all + from, (size_t)n);
        hear_first(piece, (size_t)n);
        for (int64_t i = 0; i < n && where < 0; i++)
            if (from + i >= (int64_t)own->bytes || own->all[from + i] != piece[i])
                where = from + i;
    }
    return where < 0 && whole < (int64_t)own->bytes ? whole : where;
}

/* The line with byte `where`; of one that is long its beginning and what stands there. */
static void show(const struct text *own, size_t where, char line[SHOWN])
{
    const char *const text = own->all;
    size_t first = where, end = where;

    while (first > 0 && text[first - 1] != '\n')
        first--;
    while (end < own->bytes && text[end] != '\n')
        end++;
    if (first == own->bytes) {
        snprintf(line, SHOWN, "no more settings");
    } else if (where - first < HALF) {
        snprintf(line, SHOWN, "%.*s", (int)(end - first), text + first);
    } else {
        for (int back = 0; back < NUMBER && text[where - 1] != ' '; back++)
            where--;
        snprintf(line, SHOWN, "%.*s ... %.*s", HALF - 20, text + first, (int)(end - where), text + where);
    }
}

static int refuse(const struct text *own, int rank, const struct other *other)
{
    char line[SHOWN];

    show(own, (size_t)other->where < own->bytes ? (size_t)other->where : own->bytes, line);
    hear_first(line, sizeof line);
    return status_fail_with(STATUS_BAD_SCENE, (struct status_advice){
        .cause = "They have read different files, or have different keys",
        .remedy = "let all read one file, with the same keys" },
        "ranks do not have the same scene: the first one's says `%s` where that of rank %d says `%s`",
        line, rank, other->line);
}

static int agree(const struct text *own)
{
    struct other other = { .where = compare(own) };
    int rank;

    if (other.where >= 0)
        show(own, (size_t)other.where, other.line);
    rank = ranks_first(other.where >= 0 ? 0 : HUGE_VAL, ranks_me(), &other, sizeof other);
    return rank < 0 ? STATUS_DONE : refuse(own, rank, &other);
}

int run_ranks_same(const struct run *r, int status)
{
    struct text own = { 0 };

    if (ranks_count() == 1)
        return status;
    if (status == STATUS_DONE)
        status = write_text(r, &own);
    if (status_is_starved()) /* keys that could not be kept are not those of another scene */
        status = STATUS_FAILED;
    status = ranks_agree_within(status);
    if (status == STATUS_DONE)
        status = agree(&own);
    free(own.all);
    return status;
}
