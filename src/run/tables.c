/* tables.c -- the CSV tables of a run: their names and units, and a row of each. */
#include "run/tables.h"

#include "base/status.h"
#include "output/series.h"
#include "run/tables-bodies.h"
#include "run/tables-forces.h"
#include "run/tables-water.h"

#include <stdlib.h>

struct tables {
    struct series *book, *steps, *checkpoints;
    struct tables_bodies *bodies;
    struct tables_forces *forces;
    struct tables_water *water; /* front, pairing, probes */
    int book_columns;
    struct book_column book_column[BOOK_COLUMNS];
};

static int open_book(struct tables *o, const struct plan *plan, const char *dir, struct columns *h)
{
    o->book_columns = book_columns(plan, o->book_column);
    columns_start(h);
    for (int i = 0; i < o->book_columns; i++)
        columns_add(h, o->book_column[i].unit, "%s", o->book_column[i].name);
    return columns_open(h, &o->book, dir, "book.csv");
}

static int open_steps(struct tables *o, const char *dir, struct columns *h)
{
    columns_start(h);
    columns_add(h, "s", "h");
    columns_add(h, "", "limiter");
    columns_add(h, "", "where");
    columns_add(h, "", "rejected");
    return columns_open(h, &o->steps, dir, "steps.csv");
}

static int open_checkpoints(struct tables *o, const struct plan *plan, const char *dir,
                            struct columns *h)
{
    const struct settings_output *set = plan_output(plan);

    if (!(set->checkpoint > 0 || set->checkpoint_minutes > 0))
        return STATUS_DONE;
    columns_start(h);
    columns_add(h, "", "because");
    return columns_open(h, &o->checkpoints, dir, "checkpoints.csv");
}

static int open_all(struct tables *o, const struct plan *plan, const char *dir, struct columns *h,
                    struct running **means)
{
    TRY(open_book(o, plan, dir, h));
    TRY(tables_water_open(&o->water, plan, dir, h, means));
    TRY(tables_forces_open(&o->forces, plan, dir, h));
    TRY(tables_bodies_open(&o->bodies, plan, dir, h));
    TRY(open_checkpoints(o, plan, dir, h));
    return open_steps(o, dir, h);
}

int tables_open(struct tables **out, const struct plan *plan, const char *dir,
                struct running **means, bool again)
{
    struct columns *h = status_alloc(1, sizeof *h);
    int status;

    if (h)
        h->again = again;
    *out = status_alloc(1, sizeof **out);
    status = *out && h ? open_all(*out, plan, dir, h, means) : STATUS_FAILED;
    free(h);
    return status;
}

int tables_open_none(struct tables **out, const struct plan *plan, struct running **means)
{
    struct columns *h = status_alloc(1, sizeof *h);
    int status;

    if (h)
        h->tried = true;
    *out = status_alloc(1, sizeof **out);
    status = *out && h ? open_all(*out, plan, "", h, means) : STATUS_FAILED;
    free(h);
    return status;
}

int tables_agree(const struct plan *plan)
{
    struct running *means = NULL;
    struct tables *o;
    const int status = tables_open_none(&o, plan, &means), closed = tables_close(&o);

    running_free(&means);
    return status != STATUS_DONE ? status : closed;
}

int tables_keep(struct tables *o, struct archive *a)
{
    TRY(series_keep(o->book, a, "book.csv"));
    TRY(tables_water_keep(o->water, a));
    TRY(tables_forces_keep(o->forces, a));
    TRY(tables_bodies_keep(o->bodies, a));
    TRY(series_keep(o->checkpoints, a, "checkpoints.csv"));
    return series_keep(o->steps, a, "steps.csv");
}

static int row_book(struct tables *o, const struct book_sheet *s)
{
    double v[BOOK_COLUMNS + 1];

    v[0] = s->t;
    for (int i = 0; i < o->book_columns; i++)
        v[i + 1] = book_value(s, &o->book_column[i]);
    return series_row(o->book, v);
}

int tables_pairing(struct tables *o, struct moment *moment, double t, const double *y)
{
    return tables_water_pairing(o->water, moment, t, y);
}

int tables_profile(struct tables *o, struct moment *moment, double t, const double *y)
{
    return tables_water_profile(o->water, moment, t, y);
}

void tables_look(struct tables *o, struct moment *moment, double t, const double *y)
{
    tables_water_look(o->water, moment, t, y);
}

int tables_rows(struct tables *o, struct moment *moment, double t, const double *y,
                const struct book_sheet *sheet, int forces)
{
    TRY(row_book(o, sheet));
    TRY(forces);
    TRY(tables_forces_row(o->forces, moment, t, y));
    TRY(tables_bodies_row(o->bodies, moment, t, y));
    return tables_water_row(o->water, t);
}

int tables_readings(struct tables *o, struct moment *moment, double t, const double *y)
{
    return tables_water_step(o->water, moment, t, y);
}

int tables_step(struct tables *o, const struct method_step *step)
{
    static const char *const limiters[] = { "error", "stability", "output" };
    const double v[] = { step->t, step->h, 0, 0, (double)step->rejected };
    const char *text[] = { NULL, NULL, limiters[step->limiter], step->where, NULL };

    return series_text_row(o->steps, v, text);
}

int tables_checkpoint(struct tables *o, double t, const char *because)
{
    return series_text_row(o->checkpoints, &t, (const char *[]){ NULL, because });
}

int tables_close(struct tables **tables)
{
    struct tables *o = *tables;
    int status = STATUS_DONE;

    if (!o)
        return STATUS_DONE;
    columns_close(&o->book, &status);
    tables_water_close(&o->water, &status);
    tables_forces_close(&o->forces, &status);
    tables_bodies_close(&o->bodies, &status);
    columns_close(&o->checkpoints, &status);
    columns_close(&o->steps, &status);
    free(o);
    *tables = NULL;
    return status;
}
