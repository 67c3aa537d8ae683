/* passes-order.c -- passes in the order in which each finds what it reads. */
#include "plan/passes.h"

#include "base/status.h"

#include <stdio.h>
#include <string.h>

enum { ROOM = 800 };

/* All that must be there before it runs. */
static unsigned reads(const struct plan_pass *p)
{
    return p->needs | p->neighbours;
}

/* Does `late` wait for `early`? */
static bool waits(const struct plan_pass *late, const struct plan_pass *early)
{
    return (reads(late) & (early->provides | early->adds)) || (late->adds & early->provides);
}

/* Fields that are provided, each by one. */
static int check_providers(const struct plan_pass *pass, int n, unsigned given)
{
    unsigned there = given, asked = 0;
    char text[ROOM];

    for (int i = 0; i < n; i++) {
        passes_names(there & pass[i].provides, text, sizeof text);
        if (text[0])
            return status_fail(STATUS_FAILED, "the pass \"%s\" provides %s, which is there already",
                               pass[i].name, text);
        there |= pass[i].provides;
    }
    for (int i = 0; i < n; i++) {
        asked = (reads(&pass[i]) | pass[i].adds) & ~there;
        passes_names(asked, text, sizeof text);
        if (text[0])
            return status_fail(STATUS_FAILED, "no pass provides %s, which \"%s\" needs", text,
                               pass[i].name);
    }
    return STATUS_DONE;
}

/* Passes that serve a wanted field, by what they give or for others that do. */
static int leave_out(struct plan_pass *pass, int n, unsigned wanted)
{
    int left = 0;

    for (unsigned before = 0; before != wanted;) {
        before = wanted;
        for (int i = 0; i < n; i++)
            if ((pass[i].provides | pass[i].adds) & wanted)
                wanted |= reads(&pass[i]) | pass[i].adds;
    }
    for (int i = 0; i < n; i++)
        if ((pass[i].provides | pass[i].adds) & wanted)
            pass[left++] = pass[i];
    return left;
}

/* One of pass[from..n-1] that number i waits for, -1: none.  Those that add to one field do
 * so in the order that they came in. */
static int held_by(const struct plan_pass *pass, int from, int n, int i)
{
    for (int j = from; j < n; j++)
        if (j != i && (waits(&pass[i], &pass[j]) || (j < i && (pass[i].adds & pass[j].adds))))
            return j;
    return -1;
}

/* From a pass that is held up to the one that holds it, until one comes twice. */
static int refuse_circle(const struct plan_pass *pass, int from, int n)
{
    char text[ROOM], names[ROOM];
    int at = from, used = 0;

    for (int i = from; i < n; i++) /* so far it is in the circle for certain */
        at = held_by(pass, from, n, at);
    for (int first = at, begun = 0; !begun || at != first; begun = 1) {
        const int by = held_by(pass, from, n, at);
        const struct plan_pass *late = &pass[at], *early = &pass[by];
        passes_names((reads(late) & (early->provides | early->adds))
                         | (late->adds & (early->provides | early->adds)), names,
                     sizeof names);
        used += snprintf(text + used, sizeof text - (size_t)used, "%s\"%s\" waits for %s of \"%s\"",
                         begun ? ", " : "", late->name, names, early->name);
        used = used < ROOM ? used : ROOM - 1;
        at = by;
    }
    return status_fail(STATUS_FAILED, "passes wait for each other in a circle: %s", text);
}

static void move_to(struct plan_pass *pass, int from, int to)
{
    const struct plan_pass one = pass[from];

    memmove(&pass[to + 1], &pass[to], (size_t)(from - to) * sizeof *pass);
    pass[to] = one;
}

int passes_order(struct plan_pass *pass, int n, unsigned given, unsigned wanted)
{
    n = leave_out(pass, n, wanted);
    if (check_providers(pass, n, given) != STATUS_DONE)
        return -1;
    for (int done = 0; done < n; done++) {
        int next = done;
        while (next < n && held_by(pass, done, n, next) >= 0)
            next++;
        if (next == n) {
            refuse_circle(pass, done, n);
            return -1;
        }
        move_to(pass, next, done);
    }
    return n;
}
