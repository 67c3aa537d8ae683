/* running.c -- running means of a polygon through readings. */
#include "measure/running.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct running {
    int columns;
    double *window;         /* [columns] [s]                                  */
    double longest;         /* of them [s]                                    */
    long from, n, room;     /* readings kept: from .. n-1                     */
    double *t;              /* [room] [s]                                     */
    double *value;          /* [room][columns]                                */
};

int running_create(int columns, const double *window, struct running **out)
{
    struct running *r = *out = status_alloc(1, sizeof *r);

    if (!r)
        return STATUS_FAILED;
    r->columns = columns;
    r->window = status_alloc((unsigned long)columns + 1, sizeof *r->window);
    if (!r->window) {
        running_free(out);
        return STATUS_FAILED;
    }
    for (int i = 0; i < columns; i++) {
        r->window[i] = window[i];
        r->longest = fmax(r->longest, window[i]);
    }
    return STATUS_DONE;
}

void running_free(struct running **running)
{
    if (!*running)
        return;
    free((*running)->window);
    free((*running)->t);
    free((*running)->value);
    free(*running);
    *running = NULL;
}

/* Readings that no mean will ask for again: a mean at a time after the last reading
 * reaches back by the longest window, to a line that begins before. */
static void forget(struct running *r)
{
    while (r->from + 1 < r->n && r->t[r->from + 1] <= r->t[r->n - 1] - r->longest)
        r->from++;
    if (r->from <= r->n / 2)
        return;
    r->n -= r->from;
    memmove(r->t, r->t + r->from, (size_t)r->n * sizeof *r->t);
    memmove(r->value, r->value + r->from * r->columns,
            (size_t)(r->n * r->columns) * sizeof *r->value);
    r->from = 0;
}

static int make_room(struct running *r, long n)
{
    const long room = 2 * n + 64;
    double *t, *value;

    if (n <= r->room)
        return STATUS_DONE;
    if ((t = realloc(r->t, (size_t)room * sizeof *t)))
        r->t = t;
    if ((value = realloc(r->value, (size_t)(room * r->columns + 1) * sizeof *value)))
        r->value = value;
    if (!t || !value)
        return status_starved("running means of %d probes over %g s cannot be kept", r->columns,
                              r->longest);
    r->room = room;
    return STATUS_DONE;
}

int running_keep(struct running *r, struct archive *a)
{
    long n;

    if (!r)
        return STATUS_DONE;
    n = r->n - r->from;
    TRY(archive_integers(a, "means", &n, 1));
    if (archive_fills(a)) {
        TRY(make_room(r, n));
        r->from = 0;
        r->n = n;
    }
    TRY(archive_numbers(a, "means.t", r->t + r->from, n));
    return archive_numbers(a, "means.value", r->value + r->from * r->columns, n * r->columns);
}

int running_add(struct running *r, double t, const double *value)
{
    forget(r);
    TRY(make_room(r, r->n + 1));
    r->t[r->n] = t;
    memcpy(r->value + r->n * r->columns, value, (size_t)r->columns * sizeof *value);
    r->n++;
    return STATUS_DONE;
}

/* The value at t, from reading k to the next one. */
static double at(const struct running *r, int column, long k, double t)
{
    const double *v = r->value + k * r->columns + column;
    const double share = (t - r->t[k]) / (r->t[k + 1] - r->t[k]);

    return (1 - share) * v[0] + share * v[r->columns];
}

double running_mean(const struct running *r, int column, double t)
{
    double begin, end, sum = 0;

    if (r->n == r->from)
        return NAN;
    end = fmin(t, r->t[r->n - 1]);
    begin = fmax(end - r->window[column], r->t[r->from]);
    if (!(end > begin))
        return r->value[(r->n - 1) * r->columns + column];
    for (long k = r->from; k + 1 < r->n; k++) {
        const double a = fmax(r->t[k], begin), b = fmin(r->t[k + 1], end);
        if (b > a)
            sum += (b - a) * (at(r, column, k, a) + at(r, column, k, b)) / 2;
    }
    return sum / (end - begin);
}
