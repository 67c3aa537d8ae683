/* force.c -- forces that a table of impulses tells. */
#include "output/force.h"

#include <math.h>
#include <string.h>

static bool is_impulse(const char *name)
{
    const size_t n = strlen(name);

    return n > 3 && name[n - 3] == '.' && name[n - 2] == 'i' && strchr("xyz", name[n - 1]);
}

/* As the mean since row `from'. */
static double mean_force(const struct table *t, int from, int row, int column)
{
    const double time = table_at(t, row, 0) - table_at(t, from, 0);
    double sum = 0;

    for (int c = column; c < t->columns && c < column + 3; c++)
        if (is_impulse(t->name[c]))
            sum += pow((table_at(t, row, c) - table_at(t, from, c)) / time, 2);
    return sqrt(sum);
}

double force_peak(const struct table *t, int column, double window)
{
    double most = 0;

    for (int i = 1, from = 0; i < t->rows; i++) {
        while (from + 1 < i && table_at(t, i, 0) - table_at(t, from + 1, 0) >= window * (1 - 1e-9))
            from++;
        most = fmax(most, mean_force(t, from, i, column));
    }
    return most;
}

double force_window(const struct table *t)
{
    return (table_at(t, t->rows - 1, 0) - table_at(t, 0, 0)) / 50;
}
