/* rigid-ties.c -- what holds, drives or pulls a rigid body: keys and refusals. */
#include "bodies/rigid-ties.h"

#include "base/status.h"
#include "bodies/rigid-def.h"

#include <math.h>
#include <stddef.h>

#if DIM == 2
#define PER_DEPTH(whole, plane) plane
#else
#define PER_DEPTH(whole, plane) whole
#endif

#define AT(member) .offset = offsetof(struct rigid_hinge, member)
static const struct param hinge_params[] = {
    { .key = "at", .unit = "m", AT(at), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .required = 1, .about = "point that stays where it is; in space one of the axis" },
    { .key = "axis", .unit = "", AT(axis), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .about = "in 3D, and needed there: direction of the axis, of any length" },
    { .key = "stiffness", .unit = PER_DEPTH("N m", "N"), AT(stiffness), .max = 1e15,
      .about = "moment per radian that turns it back to where it was at t = 0" },
    { .key = "damping", .unit = PER_DEPTH("N m s", "N s"), AT(damping), .max = 1e15,
      .about = "moment per rate of turning against it" },
    { 0 },
};
#undef AT

#define AT(member) .offset = offsetof(struct rigid_slider, member)
static const struct param slider_params[] = {
    { .key = "along", .unit = "", AT(along), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .required = 1, .about = "the direction that is left to it, of any length; it does not turn" },
    { 0 },
};
#undef AT

#define AT(member) .offset = offsetof(struct rigid_spring, member)
static const struct param spring_params[] = {
    { .key = "on", .unit = "m", AT(on), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .required = 1, .about = "where it is tied to the body, as that stands at t = 0" },
    { .key = "to", .unit = "m", AT(to), .min = -1e6, .max = 1e6, .type = PARAM_VECTOR,
      .required = 1, .about = "its other end, which stays" },
    { .key = "stiffness", .unit = PER_DEPTH("N/m", "N/m^2"), AT(stiffness), .max = 1e15,
      .about = "force per length beyond `rest`" },
    { .key = "rest", .unit = "m", AT(rest), .fallback = NAN, .max = 1e6,
      .about = "length without force; left out: its length at t = 0" },
    { .key = "damping", .unit = PER_DEPTH("N s/m", "N s/m^2"), AT(damping), .max = 1e15,
      .about = "force per rate of its length, against it" },
    { .key = "slack", .unit = "", AT(slack), .type = PARAM_FLAG,
      .about = "true: a line, which only pulls and is slack below `rest`" },
    { 0 },
};
#undef AT

#define PLACE(member, n) .at = offsetof(struct rigid_def, ties.member), \
    .count = offsetof(struct rigid_def, ties.n), \
    .size = sizeof(((struct rigid_def *)NULL)->ties.member)
const struct body_group rigid_ties_groups[] = {
    { .name = "motion", .params = motion_params, PLACE(motion, motions), .most = 1,
      .about = "prescribed motion, as of a wall; with a hinge or slider, of what that is fixed to" },
    { .name = "hinge", .params = hinge_params, PLACE(hinge, hinges), .most = 1,
      .about = "it turns about a point or axis, and nothing else" },
    { .name = "slider", .params = slider_params, PLACE(slider, sliders), .most = 1,
      .about = "it moves along a line without turning" },
    { .name = "spring", .params = spring_params, PLACE(spring[0], springs), .most = RIGID_SPRINGS,
      .about = "spring.NAME: a spring, damper or line from the body to a fixed point" },
    { 0 },
};

static double length(const double *a)
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* Is there anything of a across the direction n? */
static bool leaves(const double *a, const double *n)
{
    double along = 0, across = 0;

    for (int d = 0; d < 3; d++)
        along += a[d] * n[d] / (length(n) * length(n));
    for (int d = 0; d < 3; d++)
        across = fmax(across, fabs(a[d] - along * n[d]));
    return across > 1e-9 * length(a);
}

static int check_springs(const struct rigid_ties *t, const char *path)
{
    for (int i = 0; i < t->springs; i++) {
        const struct rigid_spring *s = &t->spring[i];
        double apart[3] = { 0 };
        for (int d = 0; d < DIM; d++)
            apart[d] = s->on[d] - s->to[d];
        if (!(s->stiffness > 0) && !(s->damping > 0))
            return status_fail(STATUS_BAD_SCENE, "%s.spring.%s: has neither stiffness nor damping "
                               "and does nothing; give one, or leave it out", path, s->name);
        if (!(s->stiffness > 0) && s->rest >= 0)
            return status_fail(STATUS_BAD_SCENE, "%s.spring.%s: a rest length does nothing without "
                               "stiffness; give that, or leave rest out", path, s->name);
        if (!(length(apart) > 0) && s->rest > 0)
            return status_fail(STATUS_BAD_SCENE, "%s.spring.%s: `on` and `to` are one point, so "
                               "that a rest length of %g m has no direction; move one of them, or "
                               "set rest = 0", path, s->name, s->rest);
    }
    return STATUS_DONE;
}

static int check_hinge(const struct rigid_def *d, const char *path)
{
    const double n[3] = { d->ties.hinge.axis[0], d->ties.hinge.axis[1], d->ties.hinge.axis[2] };
    double q[TURNING_NUMBERS], R[DIM][DIM], spin[3] = { 0 };

    if (length(d->velocity) > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: a hinge leaves its centre no velocity of its own; "
                           "leave velocity out, and set spin", path);
    if (DIM == 2 && length(n) > 0)
        return status_fail(STATUS_BAD_SCENE, "%s.hinge: in 2D it turns in the plane; leave axis out",
                           path);
    if (DIM == 3 && !(length(n) > 0))
        return status_fail(STATUS_BAD_SCENE, "%s.hinge: axis has length 0; give its direction, such "
                           "as axis = [0, 1, 0]", path);
    rigid_def_turned(d, q);
    turning_matrix(q, R);
    for (int k = 0; k < DIM && DIM == 3; k++)
        for (int i = 0; i < TURNING_SPINS; i++)
            spin[k] += R[k][i] * d->spin[i];
    if (DIM == 3 && leaves(spin, n))
        return status_fail(STATUS_BAD_SCENE, "%s: spin does not lie along the axis of the hinge; it "
                           "counts about the body's own axes: give the axis there times a rate",
                           path);
    return STATUS_DONE;
}

static int check_slider(const struct rigid_def *d, const char *path)
{
    const double *n = d->ties.slider.along;

    if (!(length(n) > 0))
        return status_fail(STATUS_BAD_SCENE, "%s.slider: along has length 0; give a direction, such "
                           "as along = %s", path, DIM == 2 ? "[0, 1]" : "[0, 0, 1]");
    if (length(d->spin) > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: it does not turn on a slider; leave spin out",
                           path);
    if (leaves(d->velocity, n))
        return status_fail(STATUS_BAD_SCENE, "%s: velocity leaves the line of the slider; set it "
                           "to a multiple of `along`", path);
    return STATUS_DONE;
}

/* A speed that jumps asks for an infinite force of a body with mass. */
static int check_jumps(const struct motion *m, const char *path)
{
    const double far = 1e6; /* of `stop` left out */
    double t = 0;

    do {
        const double before = t > 0 ? nextafter(t, -far) : t, after = nextafter(t, far);
        struct motion_place a, b;
        double jump = 0;
        motion_at(m, before, &a);
        motion_at(m, after, &b);
        for (int d = 0; d < DIM; d++)
            jump = fmax(jump, fabs(a.u[d] - b.u[d]));
        if (jump > 1e-9 || fabs(a.omega - b.omega) > 1e-9)
            return status_fail(STATUS_BAD_SCENE, "%s.motion: its speed jumps by %g m/s and %g "
                               "rad/s at t = %g s, which takes an infinite force; let it begin and "
                               "end at rest: a path or turn whose first two and last two values "
                               "are the same, or phase = -90", path, jump,
                               fabs(a.omega - b.omega), t);
        t = motion_event(m, t);
    } while (t < far);
    return STATUS_DONE;
}

static int check_motion(const struct rigid_def *d, const char *path)
{
    const struct motion *m = &d->ties.motion;
    const bool jointed = d->ties.hinges || d->ties.sliders;
    struct motion_place start;
    double off;

    if (!motion_any(m))
        return status_fail(STATUS_BAD_SCENE, "%s.motion: nothing moves it; give velocity, amplitude "
                           "and frequency, path, spin, swing or turn, or leave the group out", path);
    if (!jointed && (length(d->velocity) > 0 || length(d->spin) > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: velocity and spin are those of motion; leave them "
                           "out, or set motion.velocity (m/s) and motion.spin (deg/s)", path);
    motion_at(m, 0, &start);
    off = fabs(start.angle);
    for (int k = 0; k < DIM; k++)
        off = fmax(off, fabs(start.shift[k]));
    if (off > 0)
        return status_fail(STATUS_BAD_SCENE, "%s.motion: path and turn must be 0 at t = 0, where "
                           "the body stands at `at`; take their first values off", path);
    return check_jumps(m, path);
}

int rigid_ties_prepare(struct rigid_def *d, const char *path)
{
    struct rigid_ties *t = &d->ties;

    TRY(check_springs(t, path));
    if (t->motions + t->hinges + t->sliders == 0)
        return STATUS_DONE;
    if (t->hinges && t->sliders)
        return status_fail(STATUS_BAD_SCENE, "%s: it has a hinge and a slider, and only one of "
                           "them can be; leave one out", path);
    if (d->held)
        return status_fail(STATUS_BAD_SCENE, "%s: held does not go with motion, hinge or slider, "
                           "which say themselves what is free; leave it out", path);
    if (t->hinges)
        TRY(check_hinge(d, path));
    if (t->sliders)
        TRY(check_slider(d, path));
    if (!t->motions)
        return STATUS_DONE;
    TRY(motion_prepare(&t->motion, "motion", path));
    return check_motion(d, path);
}

void rigid_ties_free(struct rigid_def *d)
{
    motion_free(&d->ties.motion);
}
