/* error.c -- distances between tables of two runs. */
#include "study/error.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static bool ends_in(const char *name, const char *end)
{
    const size_t n = strlen(name), k = strlen(end);

    return n >= k && strcmp(name + n - k, end) == 0;
}

double error_positions(const struct table *run, const struct table *reference)
{
    static const char *const axes[] = { "x", "y", "z" };
    const int kind = table_column(run, "kind");
    double sum = 0;
    long n = 0;

    if (!table_alike(run, reference) || kind < 0)
        return NAN;
    for (int i = 0; i < run->rows; i++) {
        if (table_at(run, i, kind) != 0)
            continue;
        n++;
        for (int d = 0; d < 3; d++) {
            const int c = table_column(run, axes[d]);
            const double far = c < 0 ? 0 : table_at(run, i, c) - table_at(reference, i, c);
            sum += far * far;
        }
    }
    return n > 0 ? sqrt(sum / n) : NAN;
}

/* Sum over the columns with one of these endings (NULL-ended) of the squared difference
 * between a row of a and one of b; a number that is none counts as no difference. */
static double distance2(const struct table *a, int i, const struct table *b, int j,
                        const char *const *ends)
{
    double sum = 0;

    for (int c = 1; c < a->columns; c++)
        for (const char *const *end = ends; *end; end++) {
            const double far = table_at(a, i, c) - table_at(b, j, c);
            if (ends_in(a->name[c], *end) && isfinite(far))
                sum += far * far;
        }
    return sum;
}

static double error_of(const struct table *run, const struct table *reference,
                       const char *const *ends)
{
    double sum = 0, most = 0;

    if (!table_alike(run, reference) || !table_same_times(run, reference))
        return NAN;
    for (int i = 0; i < run->rows; i++) {
        sum += distance2(run, i, reference, i, ends);
        most = fmax(most, distance2(reference, i, reference, 0, ends));
    }
    return most > 0 ? sqrt(sum / run->rows / most) : NAN;
}

double error_front(const struct table *run, const struct table *reference)
{
    static const char *const ends[] = { "x", NULL };

    return error_of(run, reference, ends);
}

double error_tip(const struct table *run, const struct table *reference)
{
    static const char *const ends[] = { ".tip_x", ".tip_y", NULL };

    return error_of(run, reference, ends);
}

double error_impulse(const struct table *run, const struct table *reference)
{
    static const char *const ends[] = { ".ix", ".iy", ".iz", NULL };

    return error_of(run, reference, ends);
}
