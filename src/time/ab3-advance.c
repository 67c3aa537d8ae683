/* ab3-advance.c -- the formulas of "ab3". */
#include "time/ab3.h"

#include "base/status.h"

enum { START_EMBEDDED = 2 };

/* c[k] += factor times the weight of f[k] in the divided difference over t[points]. */
static void add_difference(int points, const double *t, double factor, double *c)
{
    for (int k = 0; k < points; k++) {
        double span = 1;
        for (int j = 0; j < points; j++)
            if (j != k)
                span *= t[k] - t[j];
        c[k] += factor / span;
    }
}

/* (AB); the error is what the next rates add to it. */
static int multistep(struct ab3 *x, double h)
{
    const double a = x->t_old - x->time[1], b = x->t_old - x->time[2], h2 = h * h / 2,
                 h3 = h * h * h / 3, h4 = h * h * h * h / 4;
    const double t[AB3_POINTS + 1] = { x->time[0], x->time[1], x->time[2], x->t_old + h };
    double c[AB3_POINTS + 1] = { 1, h }, e[AB3_POINTS + 1] = { 0 };

    add_difference(2, t, h2, c + 1);
    add_difference(3, t, h3 + a * h2, c + 1);
    vector_combine(4, c, (const double *[]){ x->y_old, x->f[0], x->f[1], x->f[2] }, x->n, x->y);
    TRY(rates_ask(&x->rates, t[3], x->y, x->f[3]));
    add_difference(4, t, h4 + (a + b) * h3 + a * b * h2, e);
    vector_combine(4, e, (const double *const *)x->f, x->n, vector_data(x->error));
    return STATUS_DONE;
}

/* Bogacki and Shampine's 3(2): four stages, of which the last is the next step's first. */
static int start(struct ab3 *x, double h)
{
    double *second = vector_data(x->error), *third = x->f[2], *last = x->f[3];
    const double *const k[] = { x->y_old, x->f[0], second, third };
    const double to_second[] = { 1, h / 2 }, to_third[] = { 1, 0, 3 * h / 4 },
                 to_end[] = { 1, 2 * h / 9, h / 3, 4 * h / 9 },
                 error[] = { -5 * h / 72, h / 12, h / 9, -h / 8 };

    vector_combine(2, to_second, k, x->n, x->y);
    TRY(rates_ask(&x->rates, x->t_old + h / 2, x->y, second));
    vector_combine(3, to_third, k, x->n, x->y);
    TRY(rates_ask(&x->rates, x->t_old + 3 * h / 4, x->y, third));
    vector_combine(4, to_end, k, x->n, x->y);
    TRY(rates_ask(&x->rates, x->t_old + h, x->y, last));
    vector_combine(4, error, (const double *[]){ x->f[0], second, third, last }, x->n, second);
    return STATUS_DONE;
}

int ab3_advance(struct ab3 *x, double h)
{
    const bool starts = x->known < AB3_POINTS;

    x->control.k = starts ? START_EMBEDDED + 1 : AB3_POINTS + 1;
    return starts ? start(x, h) : multistep(x, h);
}

void ab3_remember(struct ab3 *x, bool replace)
{
    double *const fresh = x->f[AB3_POINTS];
    const int last = replace ? 1 : AB3_POINTS;

    x->begun = x->f[0];
    x->f[AB3_POINTS] = replace ? x->f[0] : x->f[AB3_POINTS - 1];
    for (int k = last - 1; k > 0; k--) {
        x->f[k] = x->f[k - 1];
        x->time[k] = x->time[k - 1];
    }
    x->f[0] = fresh;
    x->time[0] = x->t;
    if (!replace && x->known < AB3_POINTS)
        x->known++;
}
