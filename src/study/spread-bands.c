/* spread-bands.c -- tables of a spread: bands over time, and those of single numbers. */
#include "study/spread-inside.h"

#include "base/status.h"
#include "study/quantity.h"

static const char *const scalars[BUNDLE_SCALARS] = { "peak", "time", "mean", "end" };

double spread_lost(const struct spread *s, int table, int column)
{
    const struct bundle *b = &s->bundle[table];
    const struct quantity *q = quantity_find(table, b->table[0].name[column]);

    return bundle_lost(b, column, s->order->share * bundle_size(b, column, q->change, true));
}

static void head(FILE *to, const struct bundle *b)
{
    static const char *const kinds[] = { "mean", "low", "high", "sd", "half" };
    const struct table *t = &b->table[0];
    char unit[64];

    fputs("# units: s", to);
    for (int c = 1; c < b->columns; c++)
        for (int k = 0; k < 5; k++) {
            table_unit(t, c, unit, sizeof unit);
            fprintf(to, ",%s", unit);
        }
    fputs("\nt", to);
    for (int c = 1; c < b->columns; c++)
        for (int k = 0; k < 5; k++)
            fprintf(to, ",%s.%s", t->name[c], kinds[k]);
    fputc('\n', to);
}

static void put_sample(FILE *to, const struct sample *s)
{
    table_put(to, s->mean);
    table_put(to, s->low);
    table_put(to, s->high);
    table_put(to, s->sd);
    table_put(to, s->half);
}

static int write_bands(const struct spread *s, int table)
{
    const struct bundle *b = &s->bundle[table];
    char name[64], path[MEMBER_PATH];
    struct sample sample;
    struct aside a;

    snprintf(name, sizeof name, "spread-%s.csv", quantity_tables[table]);
    TRY(aside_join(path, s->home.directory, name));
    if (b->runs == 0) { /* what an earlier spread left is not of this one */
        remove(path);
        return STATUS_DONE;
    }
    TRY(aside_open(&a, path));
    head(a.to, b);
    for (int row = 0; row < b->rows; row++) {
        fprintf(a.to, "%.10g", bundle_time(b, row));
        for (int c = 1; c < b->columns; c++) {
            bundle_sample(b, row, c, &sample);
            put_sample(a.to, &sample);
        }
        fputc('\n', a.to);
    }
    return aside_close(&a);
}

int spread_bands_write(const struct spread *s)
{
    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++)
        TRY(write_bands(s, i));
    return STATUS_DONE;
}

static void write_column(FILE *to, const struct spread *s, int table, int column)
{
    const struct bundle *b = &s->bundle[table];
    const double lost = spread_lost(s, table, column);
    char unit[64];

    table_unit(&b->table[0], column, unit, sizeof unit);
    for (enum bundle_scalar k = 0; k < BUNDLE_SCALARS; k++) {
        struct sample sample;
        bundle_scalar(b, column, k, s->window, &sample);
        fprintf(to, "%s,%s,%s,%s,%d", quantity_tables[table], b->table[0].name[column], scalars[k],
                k == BUNDLE_WHEN ? "s" : unit, sample.n);
        put_sample(to, &sample);
        table_put(to, lost);
        fputc('\n', to);
    }
}

int spread_scalars_write(const struct spread *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    TRY(aside_join(path, s->home.directory, "spread.csv"));
    TRY(aside_open(&a, path));
    fputs("# units: ,,,,,as unit says,as unit says,as unit says,as unit says,as unit says,s\n"
          "table,column,what,unit,runs,mean,low,high,sd,half,lost\n", a.to);
    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++)
        for (int c = 1; c < s->bundle[i].columns; c++)
            write_column(a.to, s, i, c);
    return aside_close(&a);
}
