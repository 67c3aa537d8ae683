/* tabulate.c -- the table of a comparison, a row for each case. */
#include "study/tabulate.h"

#include "base/status.h"
#include "output/table.h"
#include "study/trial.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void tabulate_spread(double *value, int n, double *median, double *range)
{
    *median = *range = NAN;
    if (n == 0)
        return;
    gsl_sort(value, 1, n);
    *median = gsl_stats_median_from_sorted_data(value, 1, n);
    if (n > 1)
        *range = value[n - 1] - value[0];
}

/* CPU or clock times of a case and its repeats that ended like it. */
static int times(const struct study *s, int c, bool cpu, double *to)
{
    const int cases = s->points * s->cases;
    int n = 0;

    for (int i = c; i < s->trials; i += cases) {
        const struct trial *t = &s->trial[i];
        const double took = cpu ? t->result.cpu : t->result.wall;
        if (t->run.ended && t->run.code == s->trial[c].run.code && !isnan(took))
            to[n++] = took;
    }
    return n;
}

/* Median and range of what a case took. */
static void spent(const struct study *s, int c, bool cpu, double *median, double *range)
{
    double *value = malloc((s->trials + 1) * sizeof *value);

    *median = *range = NAN;
    if (value)
        tabulate_spread(value, times(s, c, cpu, value), median, range);
    free(value);
}

double tabulate_cpu(const struct study *s, int c)
{
    double median, range;

    spent(s, c, true, &median, &range);
    return median;
}

static void row_costs(FILE *to, const struct study *s, int c)
{
    const struct result *r = &s->trial[c].result;
    double median, range;

    spent(s, c, true, &median, &range);
    table_put(to, median);
    table_put(to, range);
    spent(s, c, false, &median, &range);
    table_put(to, median);
    table_put(to, r->steps);
    table_put(to, r->rejected);
    table_put(to, r->rhs_explicit);
    table_put(to, r->rhs_implicit);
    table_put(to, r->passes);
    table_put(to, r->mean_step);
}

static void row(FILE *to, const struct study *s, int c)
{
    const struct trial *t = &s->trial[c];

    fprintf(to, "%s,%s,%s", t->method, *t->tol ? t->tol : "nan", member_status(&t->run));
    row_costs(to, s, c);
    for (int i = 0; i < RESULT_ERRORS; i++)
        table_put(to, t->result.error[i]);
    table_put(to, t->result.energy_defect);
    for (int k = 0; k < s->sweeps; k++)
        table_put_word(to, t->point->value[k]);
    table_put(to, t->result.t_end);
    table_put_word(to, t->run.name);
    table_put_word(to, t->reference->run.name);
    table_put_text(to, t->run.message);
    fputc('\n', to);
}

static void head(FILE *to, const struct study *s)
{
    const char *energy = s->point[0].facts.dimension == 2 ? "J/m" : "J";

    fprintf(to, "# units: ,,,s,s,s,,,,,,s,spacings,,,,,,,%s", energy);
    for (int k = 0; k < s->sweeps; k++)
        fprintf(to, ",%s", s->unit[k]);
    fputs(",s,,,\nmethod,tol,status,cpu_s,cpu_spread,wall_s,steps,rejected,rhs_explicit,rhs_implicit,"
          "pair_passes,h_mean,error_position,error_front,error_tip,error_body,error_impulse,error_force,"
          "error_probe,energy_defect",
          to);
    for (int k = 0; k < s->sweeps; k++)
        fprintf(to, ",%s", s->key[k]);
    fputs(",t_end,run,reference,message\n", to);
}

int tabulate_csv(const struct study *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    TRY(aside_join(path, s->home.directory, "compare.csv"));
    TRY(aside_open(&a, path));
    head(a.to, s);
    for (int i = 0; i < s->points * s->cases; i++)
        if (s->trial[i].run.ended)
            row(a.to, s, i);
    return aside_close(&a);
}
