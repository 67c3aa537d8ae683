/* shape.c -- regions of space: what is inside, how far they reach.
 *
 * Membership is half-open (low <= x < high), so that a point on the border of
 * two shapes belongs to exactly one of them. */
#include "shapes/shape.h"

#include "base/status.h"
#include "shapes/shape-box.h"
#include "shapes/shape-polygon.h"
#include <math.h>
#include <string.h>

enum { LAST = DIM - 1 }; /* the axis that points up */

static const char *const types_text = DIM == 2 ? "box, polygon, disc or frame"
                                               : "box, sphere or frame";

unsigned shape_side(int axis, bool high)
{
    const int pair = axis == 0 ? 0 : axis == LAST ? 1 : 2;

    return 1u << (2 * pair + high);
}

/* What a scene gave; a struct that was merely zeroed gave nothing. */
static bool gave_vector(const double *x)
{
    bool zero = true;

    for (int d = 0; d < DIM; d++) {
        if (isnan(x[d]))
            return false;
        zero = zero && x[d] == 0;
    }
    return !zero;
}

static bool is_vector(const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (!(fabs(x[d]) <= SHAPE_REACH))
            return false;
    return true;
}

/* Refuses keys that this type would ignore. */
static int refuse_strangers(const struct shape *s, const char *path, const char *where)
{
    const bool round = s->kind == SHAPE_DISC || s->kind == SHAPE_SPHERE;
    const char *key = NULL;

    if (s->kind != SHAPE_BOX && gave_vector(s->from))
        key = "from";
    if (s->kind != SHAPE_BOX && gave_vector(s->to))
        key = "to";
    if (s->kind != SHAPE_POLYGON && s->points.n > 0)
        key = "points";
    if (!round && gave_vector(s->centre))
        key = "centre";
    if (!round && s->radius > 0)
        key = "radius";
    if (s->kind != SHAPE_BOX && s->angle != 0)
        key = "angle";
    if (!round && s->kind != SHAPE_POLYGON && s->fill && !strcmp(s->fill, "layers"))
        key = "fill = \"layers\": its lattice follows its sides already";
    if (!key)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: %s: a %s takes no %s; leave it out or choose another"
                       " type (%s)", where, path, s->type, key, types_text);
}

static int check_box(const struct shape *s, const char *path, const char *where)
{
    if (!is_vector(s->from) || !is_vector(s->to))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a box needs from and to, its lowest and"
                           " highest corner", where, path);
    for (int d = 0; d < DIM; d++)
        if (!(s->from[d] < s->to[d]))
            return status_fail(STATUS_BAD_SCENE, "%s: %s: to must lie beyond from in every"
                               " direction, but along %c from is %g m and to is %g m", where,
                               path, "xyz"[d], s->from[d], s->to[d]);
    return STATUS_DONE;
}

static int check_ball(const struct shape *s, const char *path, const char *where)
{
    if (!is_vector(s->centre) || isnan(s->radius))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a %s needs centre and radius", where, path,
                           s->type);
    if (!(s->radius > 0 && s->radius <= SHAPE_REACH))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: radius is %g m, but a %s needs one above 0",
                           where, path, s->radius, s->type);
    return STATUS_DONE;
}

static int check_frame(const struct shape *s, const char *path, const char *where)
{
    const unsigned all = (1u << 2 * DIM) - 1;

    for (int d = 0; d < DIM; d++)
        if (!(s->low[d] < s->high[d]))
            return status_fail(STATUS_BAD_SCENE, "%s: %s: a frame goes round the domain, but the"
                               " domain reaches from %g m to %g m along %c", where, path,
                               s->low[d], s->high[d], "xyz"[d]);
    if (!(s->thickness > 0 && s->thickness <= SHAPE_REACH))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a frame %g m thick holds nothing; it needs"
                           " one layer or more", where, path, s->thickness);
    if ((s->open & all) == all)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: every side of this frame is open, nothing is"
                           " left; close a side or leave the wall out", where, path);
    return STATUS_DONE;
}

static bool is_inside(const double *low, const double *high, const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (!(low[d] <= x[d] && x[d] < high[d]))
            return false;
    return true;
}

static bool box_contains(const struct shape *s, const double *x)
{
    double own[DIM];

    shape_box_own(s, x, own);
    return is_inside(s->from, s->to, own);
}

/* From a point inside to the nearest of these faces [m]. */
static double to_faces(const double *low, const double *high, const double *x)
{
    double least = HUGE_VAL;

    for (int d = 0; d < DIM; d++)
        least = fmin(least, fmin(x[d] - low[d], high[d] - x[d]));
    return least;
}

static double box_depth(const struct shape *s, const double *x)
{
    double own[DIM];

    shape_box_own(s, x, own);
    return to_faces(s->from, s->to, own);
}

static int check_polygon(const struct shape *s, const char *path, const char *where)
{
    return shape_polygon_check(&s->points, path, where);
}

static bool polygon_contains(const struct shape *s, const double *x)
{
    return shape_polygon_contains(&s->points, x);
}

static void polygon_bounds(const struct shape *s, double *low, double *high)
{
    shape_polygon_bounds(&s->points, low, high);
}

static double polygon_depth(const struct shape *s, const double *x)
{
    return shape_polygon_distance(&s->points, x);
}

static double ball_square(const struct shape *s, const double *x)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++)
        r2 += (x[d] - s->centre[d]) * (x[d] - s->centre[d]);
    return r2;
}

static bool ball_contains(const struct shape *s, const double *x)
{
    return ball_square(s, x) < s->radius * s->radius;
}

static double ball_depth(const struct shape *s, const double *x)
{
    return s->radius - sqrt(ball_square(s, x));
}

static void ball_bounds(const struct shape *s, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = s->centre[d] - s->radius;
        high[d] = s->centre[d] + s->radius;
    }
}

/* An open side takes with it all that lies beyond its plane, corners included. */
static void frame_bounds(const struct shape *s, double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = s->low[d] - (s->open & shape_side(d, false) ? 0 : s->thickness);
        high[d] = s->high[d] + (s->open & shape_side(d, true) ? 0 : s->thickness);
    }
}

static bool frame_contains(const struct shape *s, const double *x)
{
    double low[DIM], high[DIM];

    frame_bounds(s, low, high);
    return is_inside(low, high, x) && !is_inside(s->low, s->high, x);
}

/* Of what it is around, and of its own outer faces. */
static double frame_depth(const struct shape *s, const double *x)
{
    double low[DIM], high[DIM], r2 = 0;

    frame_bounds(s, low, high);
    for (int d = 0; d < DIM; d++) {
        const double out = fmax(0, fmax(s->low[d] - x[d], x[d] - s->high[d]));
        r2 += out * out;
    }
    return fmin(sqrt(r2), to_faces(low, high, x));
}

static const struct rules {
    const char *name;
    int (*check)(const struct shape *s, const char *path, const char *where);
    bool (*contains)(const struct shape *s, const double *x);
    double (*depth)(const struct shape *s, const double *x); /* of a point inside */
    void (*bounds)(const struct shape *s, double *low, double *high);
} rules[] = {
    [SHAPE_BOX] = { "box", check_box, box_contains, box_depth, shape_box_bounds },
    [SHAPE_POLYGON] = { "polygon", check_polygon, polygon_contains, polygon_depth,
                        polygon_bounds },
    [SHAPE_DISC] = { "disc", check_ball, ball_contains, ball_depth, ball_bounds },
    [SHAPE_SPHERE] = { "sphere", check_ball, ball_contains, ball_depth, ball_bounds },
    [SHAPE_FRAME] = { "frame", check_frame, frame_contains, frame_depth, frame_bounds },
};

static bool is_allowed(const char *type)
{
    for (int i = 0; shape_types[i]; i++)
        if (!strcmp(type, shape_types[i]))
            return true;
    return false;
}

static int find_kind(struct shape *s, const char *path, const char *where)
{
    const char *type = s->type ? s->type : "";

    for (int k = 0; is_allowed(type) && k < (int)(sizeof rules / sizeof *rules); k++)
        if (!strcmp(type, rules[k].name)) {
            s->kind = k;
            return STATUS_DONE;
        }
    return status_fail(STATUS_BAD_SCENE, "%s: %s: there is no type \"%s\" in %d dimensions; it is"
                       " one of %s", where, path, type, DIM, types_text);
}

int shape_check(struct shape *s, const char *path, const char *where)
{
    TRY(find_kind(s, path, where));
    TRY(refuse_strangers(s, path, where));
    return rules[s->kind].check(s, path, where);
}

bool shape_contains(const struct shape *s, const double *x)
{
    return rules[s->kind].contains(s, x);
}

double shape_depth(const struct shape *s, const double *x)
{
    return shape_contains(s, x) ? rules[s->kind].depth(s, x) : 0;
}

void shape_bounds(const struct shape *s, double *low, double *high)
{
    rules[s->kind].bounds(s, low, high);
}
