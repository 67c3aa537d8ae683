/* tell.c -- the progress line of a comparison. */
#include "study/tell.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

static const double terminal_pause = 0.2, plain_pause = 5; /* [s] between lines */

static double clock_now(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void tell_start(struct tell *t, const char *what, int all, bool quiet)
{
    *t = (struct tell){ .quiet = quiet, .terminal = isatty(2), .what = what, .all = all,
                        .began = clock_now(), .told = -plain_pause };
}

static void line(const struct tell *t, int running)
{
    const double spent = clock_now() - t->began;
    const int own = t->ended - t->reused;

    fprintf(stderr, "%s%d of %d %s", t->terminal ? "\r" : "", t->ended, t->all, t->what);
    if (t->reused > 0)
        fprintf(stderr, ", %d of them from before", t->reused);
    if (t->bad > 0)
        fprintf(stderr, ", %d not done", t->bad);
    fprintf(stderr, ", %d running", running);
    if (running > 0 && t->now)
        fprintf(stderr, " (%s%s)", running > 1 ? "last begun: " : "", t->now);
    fprintf(stderr, ", %.0f s", spent);
    if (own > 0 && t->ended < t->all)
        fprintf(stderr, ", about %.0f s left", spent / own * (t->all - t->ended));
    fputs(t->terminal ? "\033[K" : "\n", stderr);
}

void tell_look(struct tell *t, int running)
{
    const double now = clock_now();
    const double pause = t->terminal ? terminal_pause : plain_pause;

    if (t->quiet || now - t->told < pause)
        return;
    line(t, running);
    t->told = now;
}

void tell_end(struct tell *t)
{
    if (t->quiet)
        return;
    line(t, 0);
    if (t->terminal)
        fputc('\n', stderr);
}
