/* progress.c -- one line that says how far a run is and how long it will take. */
#include "output/progress.h"

#include <math.h>
#include <time.h>
#include <unistd.h>

static const double terminal_pause = 0.2, plain_pause = 5; /* [s] between lines */
static const double memory = 20; /* [s] of the clock that the rate looks back */

static double seconds(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* "1 h 05 min", "3 min 20 s", "12 s" */
static void spell(char *to, size_t room, double time)
{
    const long s = time < 1e8 ? lround(time) : 100000000;

    if (s >= 3600)
        snprintf(to, room, "%ld h %02ld min", s / 3600, s / 60 % 60);
    else if (s >= 60)
        snprintf(to, room, "%ld min %02ld s", s / 60, s % 60);
    else
        snprintf(to, room, "%ld s", s);
}

static void line(struct progress *p, const char *text)
{
    if (p->terminal)
        fprintf(p->to, "\r%s\033[K", text);
    else
        fprintf(p->to, "%s\n", text);
    fflush(p->to);
    p->shown = true;
}

void progress_start(struct progress *p, FILE *to, double from, double until, bool quiet)
{
    *p = (struct progress){ .to = to, .quiet = quiet, .until = until, .told_t = from };
    p->terminal = !quiet && isatty(fileno(to));
    p->began = p->told = seconds();
}

/* First the mean since the start, later what was seen of late: a run that slows
 * down says so. */
static void learn(struct progress *p, double t, double now)
{
    const double past = now - p->told;
    const double rate = past > 0 ? (t - p->told_t) / past : 0;
    const double weight = fmax(1 - exp(-past / memory), past / fmax(now - p->began, 1e-9));

    p->rate += weight * (rate - p->rate);
    p->told = now;
    p->told_t = t;
}

void progress_step(struct progress *p, double t, double h, const char *limiter)
{
    char text[160], left[40] = "";
    double now;

    if (p->quiet)
        return;
    now = seconds();
    if (p->shown && now - p->told < (p->terminal ? terminal_pause : plain_pause))
        return;
    learn(p, t, now);
    if (p->rate > 0 && now - p->began > 1)
        spell(left, sizeof left, (p->until - t) / p->rate);
    snprintf(text, sizeof text, "%5.1f %%  t = %.4g of %g s  step %.2e s (%s)  %s%s",
             p->until > 0 ? 100 * t / p->until : 100, t, p->until, h, limiter, left,
             left[0] ? " left" : "");
    line(p, text);
}

void progress_end(struct progress *p, double t)
{
    char text[160], spent[40];

    if (p->quiet)
        return;
    spell(spent, sizeof spent, seconds() - p->began);
    snprintf(text, sizeof text, "%5.1f %%  t = %.4g of %g s  after %s",
             p->until > 0 ? 100 * t / p->until : 100, t, p->until, spent);
    line(p, text);
    if (p->terminal)
        fputc('\n', p->to);
}
