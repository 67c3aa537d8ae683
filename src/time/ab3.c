/* ab3.c -- Adams-Bashforth with error control.
 *
 * Adams-Bashforth of order 3 with steps of any length h = t_(n+1) - t_n: the parabola
 * through the last three rates, integrated.  With divided differences f[..]:
 *
 *   y_(n+1) = y_n + f_n I_0 + f[n,n-1] I_1 + f[n,n-1,n-2] I_2                   (AB)
 *   I_k = int from t_n to t_(n+1) of (t - t_n)..(t - t_(n-k+1)) dt
 *
 * and the error is the next term, f[n+1,n,n-1,n-2] I_3, for which f_(n+1) is asked for:
 * one right-hand side a step, also of one that is rejected, and the same f_(n+1) is the
 * next step's f_n.  The first two steps after a start are Runge-Kutta's of order 3(2),
 * three right-hand sides each.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section III.5;
 * the start: Bogacki, Shampine, Appl. Math. Lett. 2 (1989) 321-325. */
#include "time/ab3.h"

#include "base/status.h"
#include "time/dense.h"
#include "time/rates.h"
#include <math.h>
#include <stdlib.h>

enum { POINTS = 3, START_EMBEDDED = 2 };

struct ab3 {
    struct paced frame;         /* first                                       */
    struct rates rates;
    double *f[POINTS + 1];      /* [n] at time[], newest first; the last one is
                                   that of a step which is tried               */
    double time[POINTS];
    int known;                  /* of f and time                               */
    const double *begun;        /* [n] f at t_old                              */
};

/* --- the formulas ----------------------------------------------------------- */

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
    const struct paced *to = &x->frame;
    const double a = to->t_old - x->time[1], b = to->t_old - x->time[2], h2 = h * h / 2,
                 h3 = h * h * h / 3, h4 = h * h * h * h / 4;
    const double t[POINTS + 1] = { x->time[0], x->time[1], x->time[2], to->t_old + h };
    double c[POINTS + 1] = { 1, h }, e[POINTS + 1] = { 0 };

    add_difference(2, t, h2, c + 1);
    add_difference(3, t, h3 + a * h2, c + 1);
    vector_combine(4, c, (const double *[]){ to->y_old, x->f[0], x->f[1], x->f[2] }, to->n, to->y);
    TRY(rates_ask(&x->rates, t[3], to->y, x->f[3]));
    add_difference(4, t, h4 + (a + b) * h3 + a * b * h2, e);
    vector_combine(4, e, (const double *const *)x->f, to->n, vector_data(to->error));
    return STATUS_DONE;
}

/* Bogacki and Shampine's 3(2): four stages, of which the last is the next step's first. */
static int start(struct ab3 *x, double h)
{
    const struct paced *to = &x->frame;
    double *second = vector_data(to->error), *third = x->f[2], *last = x->f[3];
    const double *const k[] = { to->y_old, x->f[0], second, third };
    const double to_second[] = { 1, h / 2 }, to_third[] = { 1, 0, 3 * h / 4 },
                 to_end[] = { 1, 2 * h / 9, h / 3, 4 * h / 9 },
                 error[] = { -5 * h / 72, h / 12, h / 9, -h / 8 };

    vector_combine(2, to_second, k, to->n, to->y);
    TRY(rates_ask(&x->rates, to->t_old + h / 2, to->y, second));
    vector_combine(3, to_third, k, to->n, to->y);
    TRY(rates_ask(&x->rates, to->t_old + 3 * h / 4, to->y, third));
    vector_combine(4, to_end, k, to->n, to->y);
    TRY(rates_ask(&x->rates, to->t_old + h, to->y, last));
    vector_combine(4, error, (const double *[]){ x->f[0], second, third, last }, to->n, second);
    return STATUS_DONE;
}

static int advance(struct paced *frame, double h)
{
    struct ab3 *x = (struct ab3 *)frame;
    const bool starts = x->known < POINTS;

    frame->control.k = starts ? START_EMBEDDED + 1 : POINTS + 1;
    return starts ? start(x, h) : multistep(x, h);
}

static double error(struct paced *frame, double h)
{
    (void)h;
    return N_VWrmsNorm(frame->error, frame->weight);
}

/* --- rates -------------------------------------------------------------------- */

static int begin(struct paced *frame)
{
    struct ab3 *x = (struct ab3 *)frame;

    TRY(rates_ask(&x->rates, frame->t, frame->y, x->f[0]));
    x->time[0] = frame->t;
    x->known = 1;
    return STATUS_DONE;
}

static const char *refusal(const struct paced *frame)
{
    return ((const struct ab3 *)frame)->rates.refusal;
}

static void remember(struct paced *frame, bool replace)
{
    struct ab3 *x = (struct ab3 *)frame;
    double *const fresh = x->f[POINTS];
    const int last = replace ? 1 : POINTS;

    x->begun = x->f[0];
    x->f[POINTS] = replace ? x->f[0] : x->f[POINTS - 1];
    for (int k = last - 1; k > 0; k--) {
        x->f[k] = x->f[k - 1];
        x->time[k] = x->time[k - 1];
    }
    x->f[0] = fresh;
    x->time[0] = frame->t;
    if (!replace && x->known < POINTS)
        x->known++;
}

/* The Hermite interpolant of the last step's ends: its error is of order h^4. */
static void inside(const struct paced *frame, double t, double *y)
{
    const struct ab3 *x = (const struct ab3 *)frame;
    const double time[2] = { frame->t, frame->t_old };
    double c[4];

    dense_hermite(2, time, t, c, c + 2);
    vector_combine(4, c, (const double *[]){ frame->y, frame->y_old, x->f[0], x->begun },
                   frame->n, y);
}

/* --- the bound ---------------------------------------------------------------- */

static double longest(double factor, const struct limit *limit)
{
    static const double safety = 0.95;

    return limit->rate > 0 ? safety * factor / limit->rate : HUGE_VAL;
}

/* That of equal steps, beams being explicit: the roots r of
 * r^3 - r^2 - z (23 r^2 - 16 r + 5)/12 stay within 1.001 up to |z| = 0.700 for the waves of
 * the fluid, with their damping of stability.h (0.724 without any), and up to 0.546 for
 * decay. */
static double bound(const struct paced *x, struct limit *of)
{
    static const double wave = 0.700, decay = 0.546;
    struct limit limit[2];
    double h[2];

    moment_limit(x->moment, x->t, x->y, plan_stiff(x->plan), limit);
    h[0] = longest(wave, &limit[0]);
    h[1] = longest(decay, &limit[1]);
    *of = limit[h[1] < h[0]];
    return fmin(h[0], h[1]);
}

static double haste(struct paced *frame)
{
    const struct ab3 *x = (const struct ab3 *)frame;

    return vector_most(frame->n, x->f[0], vector_read(frame->weight));
}

/* --- memory, and what it says of itself ----------------------------------------- */

static int take_memory(struct paced *frame)
{
    struct ab3 *x = (struct ab3 *)frame;

    x->rates.moment = frame->moment;
    for (int k = 0; k <= POINTS; k++)
        TRY(paced_numbers(frame, &x->f[k]));
    return STATUS_DONE;
}

static void free_memory(struct paced *frame)
{
    for (int k = 0; k <= POINTS; k++)
        free(((struct ab3 *)frame)->f[k]);
}

static int vectors(const struct method *m, const struct plan *plan)
{
    (void)m, (void)plan;
    return PACED_VECTORS + POINTS + 1;
}

/* Rates, and the error. */
static int own(const struct method *m, const struct plan *plan)
{
    (void)m, (void)plan;
    return POINTS + 1 + 1;
}

static const char *serves(const struct plan *plan)
{
    return plan_size(plan) == 0 ? "nothing in this scene moves" : NULL;
}

static const char *table(const void *self)
{
    (void)self;
    return "AB3, variable step";
}

/* Low gain, as Runge-Kutta pairs have it at their stability limit.  Half of tol: at 1e-2
 * a dam break then loses a fifth less energy, for 1 % more steps. */
const struct paced_kind ab3_kind = {
    .method = { .name = "ab3",
                .told = { "explicit multistep, Adams-Bashforth of order 3 with error control, 1 "
                         "right-hand side a step",
                          "Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, "
                          "section III.5" },
                .order = 3, .serves = serves, .table = table, .room = { vectors, own }, PACED_METHOD },
    .size = sizeof(struct ab3),
    .control = { { 0.28, -0.23, 0 }, 0.5, 2, 1.3 },
    .take_memory = take_memory,
    .free_memory = free_memory,
    .begin = begin,
    .advance = advance,
    .error = error,
    .refusal = refusal,
    .remember = remember,
    .bound = bound,
    .haste = haste,
    .inside = inside,
};
