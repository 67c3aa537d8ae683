/* error.c -- distances between tables of two runs. */
#include "study/error.h"

#include "output/force.h"

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

/* Which columns of a table count, by the ends of their names (NULL-ended), and whether as they
 * are or as what they have changed since the first row: where particles begin depends on their
 * spacing. */
struct what {
    const char *const *ends;
    bool change;
};

static double seen(const struct table *t, int row, int column, const struct what *what)
{
    return table_at(t, row, column) - (what->change ? table_at(t, 0, column) : 0);
}

/* Squares of row i, or of its difference to that of `from', summed over columns; a number
 * that is none counts as 0. */
static double square(const struct table *t, int i, const struct table *from,
                     const struct what *what)
{
    double sum = 0;

    for (int c = 1; c < t->columns; c++)
        for (const char *const *end = what->ends; *end; end++) {
            const double far = seen(t, i, c, what) - (from ? seen(from, i, c, what) : 0);
            if (ends_in(t->name[c], *end) && isfinite(far))
                sum += far * far;
        }
    return sum;
}

static double error_of(const struct table *run, const struct table *reference,
                       const struct what *what)
{
    double sum = 0, most = 0;

    if (!table_alike(run, reference) || !table_same_times(run, reference))
        return NAN;
    for (int i = 0; i < run->rows; i++) {
        sum += square(run, i, reference, what);
        most = fmax(most, square(reference, i, NULL, what));
    }
    return most > 0 ? sqrt(sum / run->rows / most) : NAN;
}

double error_front(const struct table *run, const struct table *reference)
{
    static const char *const ends[] = { "x", NULL };

    return error_of(run, reference, &(struct what){ ends, true });
}

double error_tip(const struct table *run, const struct table *reference)
{
    static const char *const ends[] = { ".tip_x", ".tip_y", NULL };

    return error_of(run, reference, &(struct what){ ends, true });
}

double error_body(const struct table *run, const struct table *reference)
{
    static const char *const centre[] = { ".x", ".y", ".z", NULL };

    return error_of(run, reference, &(struct what){ centre, true });
}

static const char *const impulses[] = { ".ix", ".iy", ".iz", NULL };

double error_impulse(const struct table *run, const struct table *reference)
{
    return error_of(run, reference, &(struct what){ impulses, true });
}

double error_probe(const struct table *run, const struct table *reference)
{
    static const char *const means[] = { ".mean", NULL }, *const all[] = { "", NULL };
    bool windows = false;

    for (int c = 1; c < run->columns; c++)
        windows = windows || ends_in(run->name[c], means[0]);
    return error_of(run, reference, &(struct what){ windows ? means : all, false });
}

/* On any object. */
static double largest_force(const struct table *t)
{
    double most = 0;

    for (int c = 1; c < t->columns; c++)
        if (ends_in(t->name[c], ".ix"))
            most = fmax(most, force_peak(t, c, force_window(t)));
    return most;
}

double error_force(const struct table *run, const struct table *reference)
{
    if (!table_alike(run, reference) || !table_same_times(run, reference))
        return NAN;
    const double should = largest_force(reference);
    return should > 0 ? fabs(largest_force(run) - should) / should : NAN;
}
