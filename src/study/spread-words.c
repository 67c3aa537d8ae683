/* spread-words.c -- what to make of a spread: single numbers with their bands, and until when
 * a single run means something. */
#include "study/spread-inside.h"

#include "base/status.h"
#include "study/quantity.h"

#include <math.h>
#include <string.h>

static const double least_share = 1e-2; /* of the largest of its unit: less is not told */

/* The largest size among the columns of a table with the same unit and kind. */
static double largest(const struct bundle *b, int table, int column)
{
    const struct quantity *q = quantity_find(table, b->table[0].name[column]);
    char unit[64], other[64];
    double most = 0;

    table_unit(&b->table[0], column, unit, sizeof unit);
    for (int c = 1; c < b->columns; c++) {
        const struct quantity *of = quantity_find(table, b->table[0].name[c]);
        table_unit(&b->table[0], c, other, sizeof other);
        if (of->tells == q->tells && strcmp(unit, other) == 0)
            most = fmax(most, bundle_size(b, c, q->change, true));
    }
    return most;
}

static bool is_told(const struct bundle *b, int table, int column)
{
    const struct quantity *q = quantity_find(table, b->table[0].name[column]);
    const double size = q->tells ? bundle_size(b, column, q->change, false) : 0;

    return size > 0 && size >= least_share * largest(b, table, column);
}

static void cell(FILE *to, int digits, double value)
{
    if (isfinite(value))
        fprintf(to, " %.*g |", digits, value);
    else
        fputs(" - |", to);
}

static const char *const told_as[BUNDLE_SCALARS] = {
    "peak", "time of the peak [s]", "mean over time", "at the end"
};

static void write_column(FILE *to, const struct spread *s, int table, int column)
{
    const struct bundle *b = &s->bundle[table];
    const struct quantity *q = quantity_find(table, b->table[0].name[column]);
    char unit[64];

    table_unit(&b->table[0], column, unit, sizeof unit);
    for (enum bundle_scalar k = 0; k < BUNDLE_SCALARS; k++) {
        struct sample sample;
        if (!(q->tells >> k & 1))
            continue;
        bundle_scalar(b, column, k, s->window, &sample);
        fprintf(to, "| %s %s [%s] | %s |", quantity_tables[table], b->table[0].name[column], unit,
                told_as[k]);
        cell(to, 5, sample.mean);
        cell(to, 2, sample.half);
        cell(to, 2, sample.sd);
        cell(to, 5, sample.low);
        cell(to, 5, sample.high);
        fputc('\n', to);
    }
}

static void write_table(FILE *to, const struct spread *s)
{
    int n = 0;

    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++)
        for (int c = 1; c < s->bundle[i].columns; c++) {
            if (!is_told(&s->bundle[i], i, c))
                continue;
            if (n++ == 0)
                fputs("\n| quantity | what | mean | +- 95 % | sd | least | most |\n"
                      "| --- | --- | --- | --- | --- | --- | --- |\n", to);
            write_column(to, s, i, c);
        }
    if (n > 0)
        fprintf(to, "\nPeaks, their times and means are those from %.4g to %.4g s, ends those at "
                "%.4g s.\n", s->window[0], s->window[1], s->facts.until);
}

static void write_failures(FILE *to, const struct spread *s)
{
    fprintf(to, "\n%d of %d runs came to their end%s\n", s->done, s->order->runs,
            s->done < s->order->runs ? "; these are left out of all numbers:" : ".");
    for (int i = 0; i < s->order->runs; i++) {
        const struct member *m = &s->member[i];
        if (!m->ended)
            fprintf(to, "- %s: not run\n", m->name);
        else if (m->code != STATUS_DONE)
            fprintf(to, "- %s: %s: %s\n", m->name, member_status(m), m->message);
    }
}

/* What few runs can say. */
static void write_certainty(FILE *to, const struct spread *s)
{
    fprintf(to, "\nLeast and most of %d runs: of further runs like these %.0f %% fall between "
            "them, in the mean, so a band of few runs is too narrow. +- 95 %%: with that certainty "
            "the mean of ever more runs is so near, if chance is normal. The standard deviation "
            "(sd) of %d runs is itself uncertain by %.0f %%.\n", s->done,
            100 * sample_inside(s->done), s->done, 100 * sample_doubt(s->done));
}

/* The columns that are told, with the time at which their bands became wide. */
static int write_lost(FILE *to, const struct spread *s)
{
    int n = 0;

    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++)
        for (int c = 1; c < s->bundle[i].columns; c++) {
            const double lost = is_told(&s->bundle[i], i, c) ? spread_lost(s, i, c) : NAN;
            if (isnan(lost))
                continue;
            n++;
            fprintf(to, "- %s %s: band wider than %g %% of its largest mean, first at %.4g s\n",
                    quantity_tables[i], s->bundle[i].table[0].name[c], 100 * s->order->share,
                    lost);
        }
    return n;
}

static void write_apart(FILE *to, const struct spread *s)
{
    if (isfinite(s->apart.lost))
        fprintf(to, "- particles: %g spacings apart (root mean square) first at %.4g s\n",
                s->order->share, s->apart.lost);
    else if (s->apart.n > 0)
        fprintf(to, "- particles: %.2g spacings apart (root mean square) at the end\n",
                s->apart.rms[s->apart.n - 1]);
}

static void write_predictable(FILE *to, const struct spread *s)
{
    int n;

    fputs("\nUntil when one run tells what all would:\n\n", to);
    n = write_lost(to, s);
    write_apart(to, s);
    if (n > 0)
        fputs("\nFrom these times on a single run is one of many that are as right: only "
              "statistics mean anything. Compare bands with bands; a value or a peak of one run, "
              "or its difference from another run or an experiment, is chance where it is within "
              "the band.\n", to);
    else if (isfinite(s->apart.lost))
        fprintf(to, "\nWhere each particle is became chance, but no band above is wider than %g %% "
                "of its largest mean: these numbers are those of all runs.\n",
                100 * s->order->share);
    else
        fprintf(to, "\nNo band became wider than %g %% of its largest mean: up to %.4g s chance "
                "decides nothing here, and one run tells what all would.\n",
                100 * s->order->share, s->facts.until);
    fputs("\nA band holds what chance does and nothing else: not the error of spacing, tolerance, "
          "wall model or sound speed.\n", to);
}

static void write_all(FILE *to, const struct spread *s)
{
    fprintf(to, "# %s: %d runs that differ by %g spacings at the start\n", s->facts.title, s->done,
            s->order->size);
    write_table(to, s);
    write_failures(to, s);
    write_certainty(to, s);
    write_predictable(to, s);
}

int spread_words_write(const struct spread *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    if (!s->order->quiet) {
        write_all(stdout, s);
        fflush(stdout);
    }
    TRY(aside_join(path, s->home.directory, "spread.md"));
    TRY(aside_open(&a, path));
    write_all(a.to, s);
    return aside_close(&a);
}
