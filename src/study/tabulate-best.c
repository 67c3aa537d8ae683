/* tabulate-best.c -- the cheapest runs for each decade of error, as Markdown. */
#include "study/tabulate.h"

#include "base/status.h"
#include "study/trial.h"

#include <math.h>

enum { COARSE = 0, FINE = -9 }; /* decades of the table, 10^COARSE and below */

/* The done case at this point with the least CPU time among those with error <= most; -1:
 * there is none. */
static int cheapest(const struct study *s, const struct point *p, int quantity, double most)
{
    int best = -1;

    for (int i = 0; i < s->points * s->cases; i++) {
        const struct trial *t = &s->trial[i];
        if (t->ended && t->point == p && t->code == STATUS_DONE
            && t->result.error[quantity] <= most
            && (best < 0 || tabulate_cpu(s, i) < tabulate_cpu(s, best)))
            best = i;
    }
    return best;
}

static bool has(const struct study *s, const struct point *p, int quantity)
{
    return cheapest(s, p, quantity, HUGE_VAL) >= 0;
}

/* Neither what nobody reaches nor what everybody does. */
static bool tells(const struct study *s, const struct point *p, int decade)
{
    bool here = false, finer = false;

    for (int q = 0; q < RESULT_ERRORS; q++) {
        const int found = cheapest(s, p, q, pow(10, decade));
        here |= found >= 0;
        finer |= found >= 0 && found != cheapest(s, p, q, pow(10, decade - 1));
    }
    return here && finer;
}

static void cell(FILE *to, const struct study *s, int c)
{
    const struct trial *t = &s->trial[c];

    if (c >= 0)
        fprintf(to, " %s%s%s, %.3g s |", t->method, *t->tol ? " " : "", t->tol,
                tabulate_cpu(s, c));
    else
        fputs(" - |", to);
}

static void point_best(FILE *to, const struct study *s, const struct point *p)
{
    if (*p->label)
        fprintf(to, "\n%s\n", p->label);
    fputs("\n| error at most |", to);
    for (int q = 0; q < RESULT_ERRORS; q++)
        if (has(s, p, q))
            fprintf(to, " %s |", result_errors[q]);
    fputs("\n| --- |", to);
    for (int q = 0; q < RESULT_ERRORS; q++)
        fputs(has(s, p, q) ? " --- |" : "", to);
    fputc('\n', to);
    for (int decade = COARSE; decade >= FINE; decade--) {
        if (!tells(s, p, decade))
            continue;
        fprintf(to, "| 1e%+d |", decade);
        for (int q = 0; q < RESULT_ERRORS; q++)
            if (has(s, p, q))
                cell(to, s, cheapest(s, p, q, pow(10, decade)));
        fputc('\n', to);
    }
}

static void count(FILE *to, const struct study *s)
{
    int n = 0, done = 0;

    for (int i = 0; i < s->points * s->cases; i++) {
        n += s->trial[i].ended;
        done += s->trial[i].ended && s->trial[i].code == STATUS_DONE;
    }
    fprintf(to, "\n%d of %d runs came to their end; positions in spacings, the others in parts of "
            "the largest change.\n", done, n);
}

static void best(FILE *to, const struct study *s)
{
    fprintf(to, "# %s: the cheapest run for each accuracy (CPU time)\n", s->point[0].title);
    for (int i = 0; i < s->points; i++)
        point_best(to, s, &s->point[i]);
    count(to, s);
}

int tabulate_best(const struct study *s)
{
    char path[INSIDE_PATH];
    struct aside a;

    if (!s->order->quiet) {
        best(stdout, s);
        fflush(stdout);
    }
    TRY(aside_join(path, s->directory, "compare.md"));
    TRY(aside_open(&a, path));
    best(a.to, s);
    return aside_close(&a);
}
