/* mark.c -- whose a directory of results is, and who may write there. */
#include "output/mark.h"

#include "base/status.h"
#include "output/aside.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

static const char mark[] = ".stiffwater";

bool mark_is_in(const char *const *list, const char *name, unsigned long n)
{
    for (; list && *list; list++)
        if (strlen(*list) == n && strncmp(*list, name, n) == 0)
            return true;
    return false;
}

/* --- links --------------------------------------------------------------------------- */

int mark_refuse_link(const struct mark_owner *o, const char *dir, const char *name)
{
    char path[ASIDE_PATH];
    struct stat about;

    TRY(aside_join(path, dir, name));
    if (lstat(path, &about) != 0 || !S_ISLNK(about.st_mode))
        return STATUS_DONE;
    return status_fail_with(STATUS_IO,
                            (struct status_advice){ .remedy = "remove the link, or choose another "
                                                              "directory (-o)" },
                            "%s is a symbolic link; a %s writes files of its own there and "
                            "follows no links", path, o->name);
}

int mark_refuse_links(const struct mark_owner *o, const char *dir)
{
    for (const char *const *name = o->files; *name; name++)
        TRY(mark_refuse_link(o, dir, *name));
    for (const char *const *name = o->folders; *name; name++)
        TRY(mark_refuse_link(o, dir, *name));
    return STATUS_DONE;
}

/* --- the mark ------------------------------------------------------------------------ */

/* Of which kind the directory is, "": it has no mark. */
static void read_mark(const char *dir, char *kind, size_t room)
{
    char path[ASIDE_PATH], line[256];
    struct stat about;
    FILE *from;

    *kind = '\0';
    if (aside_join(path, dir, mark) != STATUS_DONE || lstat(path, &about) != 0
        || !S_ISREG(about.st_mode))
        return;
    from = fopen(path, "r");
    if (!from)
        return;
    snprintf(kind, room, "run"); /* early versions marked those alone, and did not say so */
    while (fgets(line, sizeof line, from))
        if (strncmp(line, "kind ", 5) == 0)
            snprintf(kind, room, "%.*s", (int)strcspn(line + 5, "\n"), line + 5);
    fclose(from);
    status_plain(kind);
}

static int leave_mark(const struct mark_owner *o, const char *dir, const char *scene)
{
    const char *slash = strrchr(scene, '/');
    char path[ASIDE_PATH];
    struct aside a;

    TRY(aside_join(path, dir, mark));
    TRY(aside_open(&a, path));
    fprintf(a.to, "This directory is that of a %s of stiffwater, which may replace its files.\n"
                  "version %s\nscene %s\nkind %s\n", o->name, PACKAGE_VERSION,
            slash ? slash + 1 : scene, o->name);
    return aside_close(&a);
}

/* --- who may write ------------------------------------------------------------------- */

/* The first file of a directory by name [room], "": there is none. */
static int find_foreign(const struct mark_owner *o, const char *dir, char *to, size_t room)
{
    struct dirent **entry;
    const int n = scandir(dir, &entry, NULL, alphasort);

    *to = '\0';
    if (n < 0)
        return status_fail(STATUS_IO, "%s: this directory cannot be read: %s", dir,
                           strerror(errno));
    for (int i = 0; i < n; i++) {
        const char *name = entry[i]->d_name;
        if (!*to && strcmp(name, ".") != 0 && strcmp(name, "..") != 0
            && !mark_is_in(o->before, name, strlen(name)))
            snprintf(to, room, "%s", name);
        free(entry[i]);
    }
    free(entry);
    return STATUS_DONE;
}

static int refuse_foreign(const struct mark_owner *o, const char *dir)
{
    char name[256], remedy[400];

    TRY(find_foreign(o, dir, name, sizeof name));
    if (!*name)
        return STATUS_DONE;
    snprintf(remedy, sizeof remedy, "choose another directory (-o); with --force a %s takes "
             "this one, replaces files that bear the names of its own, and leaves the others",
             o->name);
    return status_fail_with(STATUS_IO, (struct status_advice){ .remedy = remedy },
                            "%s: there are files in this directory, %s for one, and no %s "
                            "has left its mark (%s)", dir, name, o->name, mark);
}

static int refuse_kind(const struct mark_owner *o, const char *dir, const char *kind)
{
    return status_fail_with(STATUS_IO,
                            (struct status_advice){ .remedy = "choose another directory (-o), or "
                                                              "take this one with --force" },
                            "%s: this directory is that of a %s, and its files would stand "
                            "between those of a %s", dir, kind, o->name);
}

int mark_claim(const struct mark_owner *o, const char *dir, const char *scene, bool force)
{
    char kind[64];

    TRY(mark_refuse_links(o, dir));
    read_mark(dir, kind, sizeof kind);
    if (!*kind && !force)
        TRY(refuse_foreign(o, dir));
    if (*kind && !force && strcmp(kind, o->name) != 0)
        return refuse_kind(o, dir, kind);
    return leave_mark(o, dir, scene);
}
