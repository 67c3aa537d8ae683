/* team.c -- trials of half and twice as many threads. */
#include "run/team.h"

enum { PASSES = 24 }; /* of a window at least, so that some of them make a list anew */

static const double window = 0.01;  /* [s] at least                                  */
static const double first = 0.05;   /* [s] before the first trial, and after a change */
static const double longest = 20;   /* [s] between two trials at most                */
static const double repays = 1.1;   /* times as fast twice as many threads must be   */
static const double hopeless = 1.5; /* times as slow: one window tells               */

void team_start(struct team *t, int most, bool fixed)
{
    *t = (struct team){ .fixed = fixed || most == 1, .most = most, .now = most, .wait = first };
}

/* Those that worked last. */
static int at_work(const struct team *t)
{
    return t->other && t->turn % 2 ? t->other : t->now;
}

static void begin_window(struct team *t)
{
    t->seconds = 0;
    t->passes = 0;
    t->skip = 1;
}

/* Half as many or twice as many, in turn. */
static void begin_trial(struct team *t)
{
    const int more = 2 * t->now < t->most ? 2 * t->now : t->most, fewer = (t->now + 1) / 2;

    t->other = (t->up && more > t->now) || fewer == t->now ? more : fewer;
    t->up = !t->up;
    t->turn = 0;
    begin_window(t);
}

static double middle(const double took[TEAM_TURNS])
{
    const double a = took[0], b = took[1], c = took[2];
    const double low = a < b ? a : b, high = a < b ? b : a;

    return c < low ? low : c > high ? high : c;
}

/* Is it worth its threads?  So many more must be faster by a part. */
static bool better(const struct team *t, double now, double other)
{
    return t->other > t->now ? now > repays * other : other < repays * now;
}

static void end_trial(struct team *t, bool change)
{
    t->wait = change ? first : t->wait < longest / 2 ? 2 * t->wait : longest;
    if (change) {
        t->up = t->other > t->now;
        t->now = t->other;
    }
    t->other = 0;
    begin_window(t);
}

/* A window of the trial is over. */
static void judge(struct team *t)
{
    const int k = t->turn / 2;

    t->took[t->turn % 2][k] = t->seconds / (double)t->passes;
    t->turn++;
    begin_window(t);
    if (t->turn % 2 == 0 && t->took[1][k] > hopeless * t->took[0][k])
        end_trial(t, false);
    else if (t->turn == 2 * TEAM_TURNS)
        end_trial(t, better(t, middle(t->took[0]), middle(t->took[1])));
}

int team_step(struct team *t, double seconds, long passes)
{
    t->worked += at_work(t) * seconds;
    t->passed += seconds;
    if (t->fixed || t->skip-- > 0)
        return at_work(t);
    t->skip = 0;
    t->seconds += seconds;
    t->passes += passes;
    if (!t->other && t->seconds >= t->wait)
        begin_trial(t);
    else if (t->other && t->seconds >= window && t->passes >= PASSES)
        judge(t);
    return at_work(t);
}

double team_mean(const struct team *t)
{
    return t->passed > 0 ? t->worked / t->passed : t->now;
}
