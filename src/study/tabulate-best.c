/* tabulate-best.c -- the cheapest runs for each decade of error, and those that failed, as
 * Markdown. */
#include "study/tabulate.h"

#include "base/status.h"
#include "study/trial.h"

#include <math.h>

enum { COARSE = 1, FINE = -9 };                      /* decades, 10^COARSE and below      */
enum { ENERGY = RESULT_ERRORS, COLUMNS };            /* energy stands beside the errors   */
enum price { CPU, PASSES, PRICES };

static double price(const struct study *s, int c, enum price what)
{
    return what == CPU ? tabulate_cpu(s, c) : s->trial[c].result.passes;
}

static double error(const struct trial *t, int column)
{
    return column == ENERGY ? fabs(t->result.energy_defect) : t->result.error[column];
}

/* Is a run told of with those at p?  Errors against the finest are of space, too. */
static bool is_at(const struct study *s, const struct trial *t, const struct point *p)
{
    return s->finest ? t->point->finest == p : t->point == p;
}

/* The done case at this point with the least price among those with error <= most; -1:
 * there is none. */
static int cheapest(const struct study *s, const struct point *p, int column, double most,
                    enum price what)
{
    int best = -1;

    for (int i = 0; i < s->points * s->cases; i++) {
        const struct trial *t = &s->trial[i];
        if (t->run.ended && is_at(s, t, p) && t->run.code == STATUS_DONE && error(t, column) <= most
            && (best < 0 || price(s, i, what) < price(s, best, what)))
            best = i;
    }
    return best;
}

static bool has(const struct study *s, const struct point *p, int column)
{
    return cheapest(s, p, column, HUGE_VAL, CPU) >= 0;
}

/* Neither what no method reaches nor what all do. */
static bool tells(const struct study *s, const struct point *p, int decade, enum price what)
{
    for (int q = 0; q < COLUMNS; q++) {
        const int found = cheapest(s, p, q, pow(10, decade), what);
        if (found >= 0 && found != cheapest(s, p, q, pow(10, decade - 1), what))
            return true;
    }
    return false;
}

static void cell(FILE *to, const struct study *s, int c, enum price what)
{
    const struct trial *t = &s->trial[c];

    if (c < 0) {
        fputs(" - |", to);
        return;
    }
    fprintf(to, " %s%s%s,", t->method, *t->tol ? " " : "", t->tol);
    if (s->finest)
        fprintf(to, " %g m,", t->point->facts.dx);
    fprintf(to, what == CPU ? " %.3g s |" : " %.0f |", price(s, c, what));
}

static void head(FILE *to, const struct study *s, const struct point *p, enum price what)
{
    fprintf(to, "\n| %s; error at most |", what == CPU ? "CPU time" : "pair passes");
    for (int q = 0; q < RESULT_ERRORS; q++)
        if (has(s, p, q))
            fprintf(to, " %s |", result_errors[q]);
    if (has(s, p, ENERGY))
        fprintf(to, " energy [%s] |", p->facts.dimension == 2 ? "J/m" : "J");
    fputs("\n| --- |", to);
    for (int q = 0; q < COLUMNS; q++)
        fputs(has(s, p, q) ? " --- |" : "", to);
    fputc('\n', to);
}

static void point_best(FILE *to, const struct study *s, const struct point *p, enum price what)
{
    head(to, s, p, what);
    for (int decade = COARSE; decade >= FINE; decade--) {
        if (!tells(s, p, decade, what))
            continue;
        fprintf(to, "| 1e%+d |", decade);
        for (int q = 0; q < COLUMNS; q++)
            if (has(s, p, q))
                cell(to, s, cheapest(s, p, q, pow(10, decade), what), what);
        fputc('\n', to);
    }
}

/* A word of a table: what would end its cell stands aside. */
static void word(FILE *to, const char *what)
{
    for (; *what; what++)
        fputc(*what == '|' ? '/' : *what == '\n' ? ' ' : *what, to);
}

static void missed(FILE *to, const struct study *s)
{
    int n = 0;

    for (int i = 0; i < s->points * s->cases; i++) {
        const struct trial *t = &s->trial[i];
        if (!t->run.ended || t->run.code == STATUS_DONE)
            continue;
        if (n++ == 0)
            fputs("\n| not done | how | why |\n| --- | --- | --- |\n", to);
        fprintf(to, "| %s%s%s%s%s | %s | ", t->method, *t->tol ? " " : "", t->tol,
                *t->point->label ? ", " : "", t->point->label, member_status(&t->run));
        word(to, t->run.message);
        fputs(" |\n", to);
    }
}

static void count(FILE *to, const struct study *s)
{
    int n = 0, done = 0;

    for (int i = 0; i < s->points * s->cases; i++) {
        n += s->trial[i].run.ended;
        done += s->trial[i].run.ended && s->trial[i].run.code == STATUS_DONE;
    }
    fprintf(to, "\n%d of %d runs came to their end; positions in spacings, energy at the end, the "
            "others in parts of the largest change, probe and force of the largest value.%s\n", done,
            n, s->finest ? "  Each run stands against that of its method with the least spacing."
                         : "");
}

static void best(FILE *to, const struct study *s)
{
    fprintf(to, "# %s: the cheapest run for each accuracy\n", s->point[0].facts.title);
    for (int i = 0; i < s->points; i++) {
        const struct point *p = &s->point[i];
        const char *place = s->finest ? p->place : p->label;
        if (s->finest && p->finest != p)
            continue;
        if (*place)
            fprintf(to, "\n%s\n", place);
        for (enum price what = CPU; what < PRICES; what++)
            point_best(to, s, p, what);
    }
    count(to, s);
    missed(to, s);
}

int tabulate_best(const struct study *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    if (!s->order->quiet) {
        best(stdout, s);
        fflush(stdout);
    }
    TRY(aside_join(path, s->home.directory, "compare.md"));
    TRY(aside_open(&a, path));
    best(a.to, s);
    return aside_close(&a);
}
