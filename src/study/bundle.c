/* bundle.c -- the same table of several runs, and the band that they make. */
#include "study/bundle.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 }; /* runs */

/* A table of particles has no times. */
static bool alike(const struct table *a, const struct table *b)
{
    return table_alike(a, b) && (table_column(a, "t") != 0 || table_same_times(a, b));
}

bool bundle_read(struct bundle *b, const struct member_home *h, const struct member *m, int n,
                 const char *file)
{
    char path[MEMBER_PATH];
    bool fine = true;

    *b = (struct bundle){ .table = calloc(n + 1, sizeof *b->table) };
    for (int i = 0; i < n && b->table && fine && b->runs < MOST; i++) {
        if (!m[i].ended || m[i].code != STATUS_DONE)
            continue;
        member_path(h, &m[i], file, path);
        fine = table_read(&b->table[b->runs], path);
        b->runs += fine;
        fine = fine && alike(&b->table[b->runs - 1], &b->table[0]);
    }
    if (!fine || b->runs == 0) {
        bundle_free(b);
        return false;
    }
    b->rows = b->table[0].rows;
    b->columns = b->table[0].columns;
    return true;
}

void bundle_free(struct bundle *b)
{
    for (int i = 0; i < b->runs; i++)
        table_free(&b->table[i]);
    free(b->table);
    *b = (struct bundle){0};
}

double bundle_time(const struct bundle *b, int row)
{
    return table_at(&b->table[0], row, 0);
}

static void take_row(const struct bundle *b, int row, int column, double *value)
{
    for (int i = 0; i < b->runs; i++)
        value[i] = table_at(&b->table[i], row, column);
}

void bundle_sample(const struct bundle *b, int row, int column, struct sample *s)
{
    double value[MOST];

    take_row(b, row, column, value);
    sample_make(s, b->runs, value);
}

static double mean(const struct bundle *b, int row, int column)
{
    double value[MOST];

    take_row(b, row, column, value);
    return sample_mean(b->runs, value);
}

static bool is_axis(char c)
{
    return c == 'x' || c == 'y' || c == 'z';
}

/* "right.fx" and "right.fz" are of one vector. */
static bool one_vector(const char *a, const char *b)
{
    const size_t n = strlen(a);

    return n > 0 && strlen(b) == n && strncmp(a, b, n - 1) == 0 && is_axis(a[n - 1])
           && is_axis(b[n - 1]);
}

double bundle_size(const struct bundle *b, int column, bool change, bool vector)
{
    double most = 0;

    for (int row = 0; row < b->rows; row++) {
        double sum = 0;
        for (int c = 1; c < b->columns; c++)
            if (c == column
                || (vector && one_vector(b->table[0].name[c], b->table[0].name[column]))) {
                const double v = mean(b, row, c) - (change ? mean(b, 0, c) : 0);
                sum += isfinite(v) ? v * v : 0;
            }
        most = fmax(most, sqrt(sum));
    }
    return most;
}

double bundle_lost(const struct bundle *b, int column, double width)
{
    for (int row = 0; row < b->rows; row++) {
        struct sample s;
        bundle_sample(b, row, column, &s);
        if (s.high - s.low > width)
            return bundle_time(b, row);
    }
    return NAN;
}

static bool is_within(const struct table *t, int row, const double window[2])
{
    const double slack = 1e-9 * fabs(table_at(t, t->rows - 1, 0)), now = table_at(t, row, 0);

    return now >= window[0] - slack && now <= window[1] + slack;
}

/* The row of one run with the largest value times sign; -1: it has none. */
static int peak_row(const struct table *t, int column, const double window[2], double sign)
{
    int best = -1;

    for (int row = 0; row < t->rows; row++) {
        const double v = sign * table_at(t, row, column);
        if (is_within(t, row, window) && isfinite(v)
            && (best < 0 || v > sign * table_at(t, best, column)))
            best = row;
    }
    return best;
}

/* By the trapezoidal rule over the rows within the window; of one row its value. */
static double average(const struct table *t, int column, const double window[2])
{
    double sum = 0, span = 0, one = NAN;

    for (int row = 0, before = -1; row < t->rows; row++) {
        const double v = table_at(t, row, column);
        if (!is_within(t, row, window) || !isfinite(v))
            continue;
        if (before >= 0) {
            const double h = table_at(t, row, 0) - table_at(t, before, 0);
            sum += h * (v + table_at(t, before, column)) / 2;
            span += h;
        }
        one = v;
        before = row;
    }
    return span > 0 ? sum / span : one;
}

/* Where the mean goes furthest: up or down. */
static double direction(const struct bundle *b, int column, const double window[2])
{
    double low = 0, high = 0;

    for (int row = 0; row < b->rows; row++) {
        const double v = mean(b, row, column);
        if (!is_within(&b->table[0], row, window))
            continue;
        low = fmin(low, v);
        high = fmax(high, v);
    }
    return -low > high ? -1 : 1;
}

static double of_run(const struct table *t, int column, enum bundle_scalar what,
                     const double window[2], double sign)
{
    const int peak = peak_row(t, column, window, sign);

    switch (what) {
    case BUNDLE_PEAK: return peak < 0 ? NAN : table_at(t, peak, column);
    case BUNDLE_WHEN: return peak < 0 ? NAN : table_at(t, peak, 0);
    case BUNDLE_AVERAGE: return average(t, column, window);
    default: return table_at(t, t->rows - 1, column);
    }
}

void bundle_scalar(const struct bundle *b, int column, enum bundle_scalar what,
                   const double window[2], struct sample *s)
{
    const double sign = direction(b, column, window);
    double value[MOST];

    for (int i = 0; i < b->runs; i++)
        value[i] = of_run(&b->table[i], column, what, window, sign);
    sample_make(s, b->runs, value);
}
