/* figures-room.c -- a directory of our own in which figures are drawn. */
#include "output/figures-room.h"

#include "base/status.h"
#include "output/figures-data.h"
#include "output/figures-record.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int figures_room_make(struct figures_room *r, const char *run)
{
    TRY(aside_join(r->figures, run, "figures"));
    TRY(aside_directory(r->figures));
    TRY(aside_join(r->at, run, ".figures-XXXXXX"));
    if (!mkdtemp(r->at))
        return status_fail(STATUS_IO, "%s: no directory can be made in there, so no figures are "
                           "drawn: %s", run, strerror(errno));
    return STATUS_DONE;
}

static int copy(const char *from, const char *path)
{
    FILE *in = fopen(from, "r");
    struct aside a;
    char bytes[4096];
    size_t n;

    if (!in)
        return status_fail(STATUS_IO, "%s: cannot be read: %s", from, strerror(errno));
    if (aside_open(&a, path) != STATUS_DONE) {
        fclose(in);
        return STATUS_IO;
    }
    while ((n = fread(bytes, 1, sizeof bytes, in)) > 0)
        fwrite(bytes, 1, n, a.to);
    fclose(in);
    return aside_close(&a);
}

int figures_room_bring(const struct figures_room *r, const char *dir, const char *name)
{
    char from[ASIDE_PATH], to[ASIDE_PATH];

    TRY(aside_join(from, dir, name));
    TRY(aside_join(to, r->at, name));
    return copy(from, to);
}

int figures_room_bring_data(const struct figures_room *r, const char *name)
{
    char from[ASIDE_PATH], to[ASIDE_PATH];

    TRY(aside_join(from, r->figures, name));
    TRY(aside_join(to, r->at, name));
    return figures_data_copy(from, to);
}

/* --- back to RUN/figures ------------------------------------------------------------ */

static bool ends_in(const char *name, const char *end)
{
    const size_t n = strlen(name), k = strlen(end);

    return n > k && strcmp(name + n - k, end) == 0;
}

/* Under the first of its names that is free. */
static int keep_aside(const struct figures_room *r, const char *name)
{
    char from[ASIDE_PATH], to[ASIDE_PATH], other[300];

    TRY(aside_join(from, r->figures, name));
    for (int i = 1; i < 1000; i++) {
        if (i == 1)
            snprintf(other, sizeof other, "%.250s.mine", name);
        else
            snprintf(other, sizeof other, "%.250s.mine-%d", name, i);
        TRY(aside_join(to, r->figures, other));
        if (access(to, F_OK) != 0)
            return rename(from, to) == 0 ? STATUS_DONE
                 : status_fail(STATUS_IO, "%s: cannot be kept as %s: %s", from, other,
                               strerror(errno));
    }
    return status_fail(STATUS_IO, "%s: there are a thousand older ones of it; take some away", from);
}

static int hang(const struct figures_room *r, const char *name, const struct figures_record *old,
                struct figures_record *now)
{
    char from[ASIDE_PATH], to[ASIDE_PATH];

    TRY(aside_join(from, r->at, name));
    TRY(aside_join(to, r->figures, name));
    if (figures_record_foreign(old, r->figures, name))
        TRY(keep_aside(r, name));
    if (rename(from, to) != 0)
        return status_fail(STATUS_IO, "%s: cannot be written: %s", to, strerror(errno));
    figures_record_add(now, r->figures, name);
    if (ends_in(name, ".png"))
        printf("%s\n", to);
    return STATUS_DONE;
}

/* Those of RUN/figures stay as they are. */
static bool is_data(const char *name)
{
    return strcmp(name, "constants.gp") == 0 || strcmp(name, "runs.gp") == 0;
}

static int is_file(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

static void take_away(const char *dir, const char *name)
{
    char path[ASIDE_PATH];

    if (aside_join(path, dir, name) == STATUS_DONE)
        remove(path);
}

/* Figures and complaints of before, if they are as they were. */
static void take_old(const struct figures_room *r, const struct figures_record *old,
                     const struct figures_record *now)
{
    for (int i = 0; i < old->n; i++) {
        const char *name = old->file[i].name;
        if ((ends_in(name, ".png") || ends_in(name, ".log")) && !figures_record_has(now, name)
            && !figures_record_foreign(old, r->figures, name))
            take_away(r->figures, name);
    }
}

void figures_room_clear(const char *run)
{
    static const struct figures_record none;
    struct figures_record *old = status_alloc(1, sizeof *old);
    struct figures_room r = { .at = "" };

    if (old && aside_join(r.figures, run, "figures") == STATUS_DONE) {
        figures_record_read(old, r.figures);
        take_old(&r, old, &none);
    }
    free(old);
}

static int hang_all(const struct figures_room *r, struct dirent **entry, int n,
                    struct figures_record *old, struct figures_record *now)
{
    int status = STATUS_DONE;

    figures_record_read(old, r->figures);
    now->n = 0;
    for (int i = 0; i < n; i++) {
        const char *name = entry[i]->d_name;
        if (status == STATUS_DONE && !is_data(name))
            status = hang(r, name, old, now);
        take_away(r->at, name);
    }
    if (status != STATUS_DONE)
        return status;
    take_old(r, old, now);
    return figures_record_write(now, r->figures);
}

int figures_room_hang(const struct figures_room *r)
{
    struct figures_record *record = status_alloc(2, sizeof *record);
    struct dirent **entry = NULL;
    const int n = scandir(r->at, &entry, is_file, alphasort);
    int status = record ? STATUS_DONE : STATUS_FAILED;

    if (status == STATUS_DONE)
        status = hang_all(r, entry, n, &record[0], &record[1]);
    for (int i = 0; i < n; i++)
        free(entry[i]);
    free(entry);
    free(record);
    rmdir(r->at);
    return status;
}
