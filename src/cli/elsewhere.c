/* elsewhere.c -- what 3D says of its keys, for a page that is that of 2D. */
#include "cli/elsewhere.h"

#include "base/status.h"
#include "cli/roff.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { ROWS = 1000 };

static struct elsewhere {
    char name[ELSEWHERE_LINE]; /* TITLE KEY */
    char *facts, *about;
    bool seen;
} elsewhere[ROWS];

static struct elsewhere *find(const char *name)
{
    for (int i = 0; i < ROWS && *elsewhere[i].name; i++)
        if (strcmp(elsewhere[i].name, name) == 0)
            return &elsewhere[i];
    return NULL;
}

/* The default of `dimension' is that of whoever is asked, so it says nothing. */
static void show_difference(const struct param *r, const char *facts, struct elsewhere *other)
{
    const bool facts_differ = strcmp(other->facts, facts) != 0;
    const bool about_differs = strcmp(other->about, r->about) != 0;

    other->seen = true;
    if (!(facts_differ || about_differs) || strcmp(r->key, "dimension") == 0)
        return;
    fputs("In 3D: ", stdout);
    roff_text(stdout, facts_differ ? other->facts : "", -1);
    fputs(facts_differ && about_differs ? "; " : "", stdout);
    roff_paragraph(stdout, about_differs ? other->about : "");
}

void elsewhere_show(const char *name, const struct param *r, const char *facts)
{
    struct elsewhere *other = find(name);

    if (other)
        show_difference(r, facts, other);
    else
        puts("2D only.");
}

int elsewhere_read(const char *path)
{
    FILE *from = fopen(path, "r");
    int n = 0;

    if (!from)
        return status_fail(STATUS_IO, "%s cannot be read", path);
    while (n < ROWS - 1 && fgets(elsewhere[n].name, ELSEWHERE_LINE, from)) {
        struct elsewhere *e = &elsewhere[n++];
        e->name[strcspn(e->name, "\n")] = '\0';
        if (!(e->facts = strchr(e->name, '\t')) || !(e->about = strchr(e->facts + 1, '\t')))
            return status_fail(STATUS_IO, "%s: %s is no row", path, e->name);
        *e->facts++ = *e->about++ = '\0';
    }
    fclose(from);
    return STATUS_DONE;
}

int elsewhere_check(void)
{
    for (int i = 0; i < ROWS && *elsewhere[i].name; i++)
        if (!elsewhere[i].seen)
            return status_fail(STATUS_FAILED, "the page has no place for \"%s\", which is there "
                               "in 3D only", elsewhere[i].name);
    return STATUS_DONE;
}
