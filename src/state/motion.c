/* motion.c -- prescribed motion of walls and bodies. */
#include "state/motion.h"

#include "base/status.h"
#include "state/track.h"

#include <math.h>
#include <stdio.h>

enum { UP = DIM - 1, MOMENTS = 2000, PHASES = 16 };

#define AT(member) .offset = offsetof(struct motion, member)
const struct param motion_params[] = {
    { .key = "velocity", .unit = "m/s", .type = PARAM_VECTOR, AT(velocity), .min = -1e4, .max = 1e4,
      .about = "constant velocity" },
    { .key = "amplitude", .unit = "m", .type = PARAM_VECTOR, AT(amplitude), .min = -1e3, .max = 1e3,
      .about = "amplitude of a sine motion added to it" },
    { .key = "frequency", .unit = "Hz", AT(frequency), .max = 1e4,
      .about = "frequency of the sine motions, amplitude and swing" },
    { .key = "phase", .unit = "deg", AT(phase), .min = -360, .max = 360,
      .about = "where the sine begins: at 0 with full speed, at -90 and 90 from rest" },
    { .key = "start", .unit = "s", AT(start), .max = 1e6,
      .about = "time at which it begins to move" },
    { .key = "stop", .unit = "s", AT(stop), .fallback = 1e6, .max = 1e6,
      .about = "time from which on it stands still where it is" },
    { .key = "direction", .unit = "", .type = PARAM_VECTOR, AT(direction), .min = -1e6, .max = 1e6,
      .about = "direction of `path`, of any length" },
    { .key = "path", .unit = "", .type = PARAM_PAIRS, AT(path), .min = -1e6, .max = 1e6,
      .about = "pairs of a time after start [s] and a distance [m] along `direction`" },
    { .key = "pivot", .unit = "m", .type = PARAM_VECTOR, AT(pivot), .min = -1e6, .max = 1e6,
      .about = "point about which it turns, in the plane of x and the last coordinate" },
    { .key = "spin", .unit = "deg/s", AT(spin), .min = -1e6, .max = 1e6,
      .about = "constant rate at which it turns, anticlockwise" },
    { .key = "swing", .unit = "deg", AT(swing), .min = -180, .max = 180,
      .about = "amplitude of a sine of its angle" },
    { .key = "turn", .unit = "", .type = PARAM_PAIRS, AT(turn), .min = -1e6, .max = 1e6,
      .about = "pairs of a time after start [s] and an angle [deg]" },
    { 0 },
};

static double radians(double degrees)
{
    return degrees * M_PI / 180;
}

int motion_prepare(struct motion *m, const char *path, const char *where)
{
    double length = 0;
    char key[128];

    if (!(m->stop > m->start))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: stop = %g s does not lie after start = %g s",
                           where, path, m->stop, m->start);
    for (int d = 0; d < DIM; d++)
        length += m->direction[d] * m->direction[d];
    if (m->path.n > 0 && length == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: path needs a direction, such as %s", where,
                           path, DIM == 2 ? "direction = [0, 1]" : "direction = [0, 0, 1]");
    for (int d = 0; d < DIM && length > 0; d++)
        m->direction[d] /= sqrt(length);
    snprintf(key, sizeof key, "%s.path", path);
    TRY(track_create(&m->path, key, where, &m->path_track));
    snprintf(key, sizeof key, "%s.turn", path);
    return track_create(&m->turn, key, where, &m->turn_track);
}

void motion_free(struct motion *m)
{
    track_free(&m->path_track);
    track_free(&m->turn_track);
}

static bool shakes(const struct motion *m)
{
    bool any = m->swing != 0;

    for (int d = 0; d < DIM; d++)
        any |= m->amplitude[d] != 0;
    return any && m->frequency > 0;
}

bool motion_any(const struct motion *m)
{
    for (int d = 0; d < DIM; d++)
        if (m->velocity[d] != 0)
            return true;
    return m->spin != 0 || m->path.n > 0 || m->turn.n > 0 || shakes(m);
}

bool motion_turns(const struct motion *m)
{
    return m->spin != 0 || m->turn.n > 0 || (m->swing != 0 && m->frequency > 0);
}

void motion_at(const struct motion *m, double t, struct motion_place *to)
{
    const double omega = 2 * M_PI * m->frequency, phase = radians(m->phase);
    const bool on = t >= m->start && t < m->stop;
    const double s = on ? t - m->start : t < m->start ? 0 : m->stop - m->start;
    const double sine = sin(omega * s + phase) - sin(phase);
    const double fast = on ? omega * cos(omega * s + phase) : 0;
    const double bent = on ? -omega * omega * sin(omega * s + phase) : 0;
    double path[3], turn[3];

    track_at(m->path_track, s, &path[0], &path[1], &path[2]);
    track_at(m->turn_track, s, &turn[0], &turn[1], &turn[2]);
    for (int d = 0; d < DIM; d++) {
        to->shift[d] = m->velocity[d] * s + m->amplitude[d] * sine + m->direction[d] * path[0];
        to->u[d] = m->velocity[d] * on + m->amplitude[d] * fast + m->direction[d] * path[1] * on;
        to->a[d] = m->amplitude[d] * bent + m->direction[d] * path[2] * on;
    }
    to->angle = radians(m->spin * s + m->swing * sine + turn[0]);
    to->cosine = cos(to->angle);
    to->sine = sin(to->angle);
    to->omega = radians(m->spin * on + m->swing * fast + turn[1] * on);
    to->alpha = radians(m->swing * bent + turn[2] * on);
}

static bool same_numbers(const double *a, const double *b, int n)
{
    for (int i = 0; i < n; i++)
        if (a[i] != b[i])
            return false;
    return true;
}

static bool same_points(const struct param_points *a, const struct param_points *b)
{
    return a->n == b->n && (a->n == 0 || same_numbers(a->x[0], b->x[0], 3 * a->n));
}

bool motion_same(const struct motion *a, const struct motion *b)
{
    return same_numbers(a->velocity, b->velocity, 3) && same_numbers(a->amplitude, b->amplitude, 3)
           && a->frequency == b->frequency && a->phase == b->phase && a->start == b->start
           && a->stop == b->stop && same_numbers(a->direction, b->direction, 3)
           && same_points(&a->path, &b->path) && same_numbers(a->pivot, b->pivot, 3)
           && a->spin == b->spin && a->swing == b->swing && same_points(&a->turn, &b->turn);
}

void motion_point(const struct motion *m, const struct motion_place *p,
                        const double *x0, double *x, double *u)
{
    const double across = x0[0] - m->pivot[0], above = x0[UP] - m->pivot[UP];
    const double turned[2] = { p->cosine * across - p->sine * above,
                               p->sine * across + p->cosine * above };

    for (int d = 0; d < DIM; d++) {
        x[d] = x0[d] + p->shift[d];
        u[d] = p->u[d];
    }
    x[0] += turned[0] - across;
    x[UP] += turned[1] - above;
    u[0] -= p->omega * turned[1];
    u[UP] += p->omega * turned[0];
}

void motion_back(const struct motion *m, const struct motion_place *p, const double *x,
                       double *x0)
{
    const double across = x[0] - p->shift[0] - m->pivot[0];
    const double above = x[UP] - p->shift[UP] - m->pivot[UP];

    for (int d = 0; d < DIM; d++)
        x0[d] = x[d] - p->shift[d];
    x0[0] = m->pivot[0] + p->cosine * across + p->sine * above;
    x0[UP] = m->pivot[UP] - p->sine * across + p->cosine * above;
}

double motion_event(const struct motion *m, double t)
{
    const struct track *track[] = { m->path_track, m->turn_track };
    double next = HUGE_VAL, when[6] = { m->start, m->stop };
    int n = 2;

    if (!motion_any(m))
        return next;
    for (int i = 0; i < 2; i++)
        if (track[i]) {
            when[n++] = m->start + track_first(track[i]);
            when[n++] = m->start + track_last(track[i]);
        }
    for (int i = 0; i < n; i++)
        if (when[i] > t && when[i] <= m->stop)
            next = fmin(next, when[i]);
    return next;
}

double motion_bend(const struct motion *m, double t)
{
    const double next = fmin(track_next(m->path_track, m->start, t),
                             track_next(m->turn_track, m->start, t));

    return fmin(motion_event(m, t), next <= m->stop ? next : HUGE_VAL);
}

/* Corner number i of a box. */
static void corner(const double *low, const double *high, int i, double *x)
{
    for (int d = 0; d < DIM; d++)
        x[d] = i >> d & 1 ? high[d] : low[d];
}

/* The fastest corner of a box at t [m/s]; how far corners are from where they began: to reach. */
static double speed_at(const struct motion *m, const double *low, const double *high, double t,
                       double *reach)
{
    struct motion_place p;
    double most = 0;

    motion_at(m, t, &p);
    for (int i = 0; i < 1 << DIM; i++) {
        double x0[DIM], x[DIM], u[DIM], u2 = 0;
        corner(low, high, i, x0);
        motion_point(m, &p, x0, x, u);
        for (int d = 0; d < DIM; d++) {
            reach[d] = fmax(reach[d], fabs(x[d] - x0[d]));
            u2 += u[d] * u[d];
        }
        most = fmax(most, sqrt(u2));
    }
    return most;
}

double motion_extent(const struct motion *m, const double *low, const double *high,
                           double until, double *reach)
{
    double most = 0;

    for (int d = 0; d < DIM; d++)
        reach[d] = 0;
    if (!motion_any(m))
        return 0;
    for (int k = 0; k <= MOMENTS; k++)
        most = fmax(most, speed_at(m, low, high, until * k / MOMENTS, reach));
    if (m->frequency * until > MOMENTS / PHASES) /* too fast for these: one period */
        for (int k = 0; k < PHASES; k++)
            most = fmax(most, speed_at(m, low, high, fmin(until, m->start + k / (PHASES * m->frequency)),
                                       reach));
    return most;
}
