/* sweep-table.c -- what a sweep found, a row a run. */
#include "study/sweep-table.h"

#include "base/status.h"
#include "output/table.h"

#include <math.h>
#include <string.h>

enum { SHOWN = 6 }; /* outputs on the screen */

static void head(FILE *to, const struct sweep *s)
{
    const struct study *study = &s->study;

    fputs("# units: ", to);
    for (int k = 0; k < study->sweeps; k++)
        fprintf(to, "%s,", study->unit[k]);
    fprintf(to, ",s,,,,,,%s,s", study->point[0].facts.dimension == 2 ? "J/m" : "J");
    for (int first = 1; first >= 0; first--)
        for (int k = 0; k < s->outputs.n; k++)
            if (s->outputs.output[k].main == first)
                fprintf(to, ",%s", s->outputs.output[k].unit);
    fputs(",,\n", to);
    for (int k = 0; k < study->sweeps; k++)
        fprintf(to, "%s,", study->key[k]);
    fputs("status,cpu_s,steps,rejected,rhs_explicit,rhs_implicit,pair_passes,energy_defect,t_end", to);
    for (int first = 1; first >= 0; first--)
        for (int k = 0; k < s->outputs.n; k++)
            if (s->outputs.output[k].main == first)
                fprintf(to, ",%s", s->outputs.output[k].name);
    fputs(",run,message\n", to);
}

static void row(FILE *to, const struct sweep *s, int i)
{
    const struct study *study = &s->study;
    const struct result *r = &s->result[i];
    const double cost[] = { r->cpu, r->steps, r->rejected, r->rhs_explicit, r->rhs_implicit,
                            r->passes, r->energy_defect, r->t_end };

    for (int k = 0; k < study->sweeps; k++) {
        if (k > 0)
            fputc(',', to);
        table_put_first(to, study->point[i].value[k]);
    }
    fprintf(to, ",%s", member_status(&s->run[i]));
    for (size_t k = 0; k < sizeof cost / sizeof cost[0]; k++)
        table_put(to, cost[k]);
    for (int first = 1; first >= 0; first--)
        for (int k = 0; k < s->outputs.n; k++)
            if (s->outputs.output[k].main == first)
                table_put(to, s->outputs.output[k].value[i]);
    table_put_word(to, s->run[i].name);
    table_put_text(to, s->run[i].message);
    fputc('\n', to);
}

int sweep_table_csv(const struct sweep *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    TRY(aside_join(path, s->study.home.directory, "sweep.csv"));
    TRY(aside_open(&a, path));
    head(a.to, s);
    for (int i = 0; i < s->study.points; i++)
        if (s->run[i].ended)
            row(a.to, s, i);
    return aside_close(&a);
}

/* The first main outputs. */
static int shown(const struct sweep *s, int *which)
{
    int n = 0;

    for (int k = 0; k < s->outputs.n && n < SHOWN; k++)
        if (s->outputs.output[k].main)
            which[n++] = k;
    return n;
}

static void words_head(FILE *to, const struct sweep *s, int n, const int *which)
{
    fprintf(to, "# %s\n\n|", s->study.point[0].facts.title);
    for (int k = 0; k < s->study.sweeps; k++)
        fprintf(to, *s->study.unit[k] ? " %s [%s] |" : " %s |", s->study.key[k], s->study.unit[k]);
    fprintf(to, " CPU s | pair passes | energy defect [%s] |",
            s->study.point[0].facts.dimension == 2 ? "J/m" : "J");
    for (int k = 0; k < n; k++)
        fprintf(to, " %s [%s] |", s->outputs.output[which[k]].name,
                s->outputs.output[which[k]].unit);
    fputs("\n|", to);
    for (int k = 0; k < s->study.sweeps + 3 + n; k++)
        fputs(" --- |", to);
    fputc('\n', to);
}

static void words_row(FILE *to, const struct sweep *s, int i, int n, const int *which)
{
    const struct point *p = &s->study.point[i];

    fputc('|', to);
    for (int k = 0; k < s->study.sweeps; k++)
        fprintf(to, " %s |", p->value[k]);
    if (s->run[i].code != STATUS_DONE) {
        fprintf(to, " %s: %s |\n", member_status(&s->run[i]), s->run[i].message);
        return;
    }
    fprintf(to, " %.3g | %.0f | %.2g |", s->result[i].cpu, s->result[i].passes,
            s->result[i].energy_defect);
    for (int k = 0; k < n; k++)
        fprintf(to, " %.5g |", s->outputs.output[which[k]].value[i]);
    fputc('\n', to);
}

static void words(FILE *to, const struct sweep *s)
{
    int which[SHOWN];
    const int n = shown(s, which);

    words_head(to, s, n, which);
    for (int i = 0; i < s->study.points; i++)
        if (s->run[i].ended)
            words_row(to, s, i, n, which);
    fputs("\nforce.peak: the largest force on an object as a mean over a fiftieth of the time; "
          "sweep.csv has more.\n", to);
}

int sweep_table_words(const struct sweep *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    if (!s->study.order->quiet) {
        words(stdout, s);
        fflush(stdout);
    }
    TRY(aside_join(path, s->study.home.directory, "sweep.md"));
    TRY(aside_open(&a, path));
    words(a.to, s);
    return aside_close(&a);
}
