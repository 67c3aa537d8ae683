/* archive.c -- named arrays, kept and handed out. */
#include "base/archive.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

struct archive {
    bool fills, tries;
    int n, room;
    struct archive_entry *entry; /* [room] */
};

int archive_create(struct archive **out)
{
    *out = status_alloc(1, sizeof **out);
    return *out ? STATUS_DONE : STATUS_FAILED;
}

void archive_free(struct archive **archive)
{
    struct archive *a = *archive;

    if (!a)
        return;
    for (int i = 0; i < a->n; i++)
        free(a->entry[i].data);
    free(a->entry);
    free(a);
    *archive = NULL;
}

void archive_turn(struct archive *a)
{
    a->fills = true;
}

bool archive_fills(const struct archive *a)
{
    return a->fills;
}

void archive_try(struct archive *a, bool tries)
{
    a->tries = tries;
}

bool archive_tries(const struct archive *a)
{
    return a->tries;
}

int archive_entries(const struct archive *a)
{
    return a->n;
}

const struct archive_entry *archive_entry(const struct archive *a, int i)
{
    return &a->entry[i];
}

static size_t size_of(enum archive_type type)
{
    static const size_t size[] = { sizeof(double), sizeof(long), 1 };

    return size[type];
}

size_t archive_bytes(const struct archive_entry *entry)
{
    return (size_t)entry->n * size_of(entry->type);
}

static struct archive_entry *find(const struct archive *a, const char *name)
{
    for (int i = 0; i < a->n; i++)
        if (strcmp(a->entry[i].name, name) == 0)
            return &a->entry[i];
    return NULL;
}

static int make_room(struct archive *a)
{
    const int room = 2 * a->room + 32;
    struct archive_entry *more;

    if (a->n < a->room)
        return STATUS_DONE;
    more = realloc(a->entry, (size_t)room * sizeof *more);
    if (!more)
        return status_starved("a checkpoint cannot be kept");
    a->entry = more;
    a->room = room;
    return STATUS_DONE;
}

int archive_add(struct archive *a, const char *name, enum archive_type type, long n,
                const void *data)
{
    struct archive_entry e = { .type = type, .n = n };

    if (strlen(name) >= sizeof e.name || find(a, name))
        return status_fail(STATUS_FAILED, "a checkpoint can have no two arrays %.80s, nor one "
                           "with a name that long", name);
    TRY(make_room(a));
    strcpy(e.name, name);
    if (data && !(e.data = status_alloc((unsigned long)n + 1, size_of(type))))
        return STATUS_FAILED;
    if (data && n > 0)
        memcpy(e.data, data, archive_bytes(&e));
    a->entry[a->n++] = e;
    return STATUS_DONE;
}

/* The entry with this name, which has to have this type and, if n is not below 0, length. */
static int take(struct archive *a, const char *name, enum archive_type type, long n,
                struct archive_entry **out)
{
    struct archive_entry *e = *out = find(a, name);

    if (!e)
        return status_fail(STATUS_IO, "the checkpoint has no %s: another build of this version "
                           "wrote it; go on with that one", name);
    if (e->type != type || (n >= 0 && e->n != n))
        return status_fail(STATUS_IO, "%s of the checkpoint has %ld values, %ld are expected: "
                           "another build of this version wrote it; go on with that one", name,
                           e->n, n);
    e->taken = true;
    return STATUS_DONE;
}

static int keep(struct archive *a, const char *name, enum archive_type type, void *data, long n)
{
    struct archive_entry *e;

    if (!a->fills)
        return archive_add(a, name, type, n, data);
    TRY(take(a, name, type, n, &e));
    if (n > 0)
        memcpy(data, e->data, archive_bytes(e));
    return STATUS_DONE;
}

int archive_numbers(struct archive *a, const char *name, double *value, long n)
{
    return keep(a, name, ARCHIVE_NUMBERS, value, n);
}

int archive_numbers_elsewhere(struct archive *a, const char *name, double *value, long n)
{
    return keep(a, name, ARCHIVE_NUMBERS, a->fills ? value : NULL, n);
}

int archive_integers(struct archive *a, const char *name, long *value, long n)
{
    return keep(a, name, ARCHIVE_INTEGERS, value, n);
}

int archive_integer(struct archive *a, const char *name, int *value)
{
    long wide = *value;

    TRY(keep(a, name, ARCHIVE_INTEGERS, &wide, 1));
    *value = (int)wide;
    return STATUS_DONE;
}

int archive_flag(struct archive *a, const char *name, bool *value)
{
    long wide = archive_fills(a) ? 0 : *value; /* what is filled may hold anything */

    TRY(keep(a, name, ARCHIVE_INTEGERS, &wide, 1));
    *value = wide != 0;
    return STATUS_DONE;
}

int archive_text(struct archive *a, const char *name, char *text, size_t room)
{
    struct archive_entry *e;

    if (!a->fills)
        return archive_add(a, name, ARCHIVE_TEXT, (long)strlen(text), text);
    TRY(take(a, name, ARCHIVE_TEXT, -1, &e));
    if ((size_t)e->n >= room)
        return status_fail(STATUS_IO, "%s of the checkpoint has %ld letters, more than there is "
                           "room for", name, e->n);
    memcpy(text, e->data, (size_t)e->n);
    text[e->n] = '\0';
    return STATUS_DONE;
}

int archive_spent(const struct archive *a)
{
    for (int i = 0; i < a->n; i++)
        if (!a->entry[i].taken)
            return status_fail(STATUS_IO, "the checkpoint has %s, of which this program knows "
                               "nothing: another build of this version wrote it; go on with "
                               "that one", a->entry[i].name);
    return STATUS_DONE;
}
