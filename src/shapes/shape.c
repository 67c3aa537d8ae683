/* shape.c -- regions of space: the table of their kinds, and what is asked of all.
 *
 * Membership is half-open (low <= x < high), so that a point on the border of
 * two shapes belongs to exactly one of them. */
#include "shapes/shape.h"

#include "base/status.h"
#include "shapes/polytope.h"
#include "shapes/shape-kind.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LAST = DIM - 1 }; /* the axis that points up */

static const struct shape_kind *const kinds[] = {
    [SHAPE_BOX] = &shape_box,
#if DIM == 2
    [SHAPE_POLYGON] = &shape_corners,
    [SHAPE_DISC] = &shape_disc,
#else
    [SHAPE_SPHERE] = &shape_sphere,
    [SHAPE_CYLINDER] = &shape_cylinder,
    [SHAPE_HULL] = &shape_hull,
#endif
    [SHAPE_FRAME] = &shape_frame,
};

enum { KINDS_OF_SHAPE = sizeof kinds / sizeof *kinds };

unsigned shape_side(int axis, bool high)
{
    const int pair = axis == 0 ? 0 : axis == LAST ? 1 : 2;

    return 1u << (2 * pair + high);
}

const struct shape_kind *shape_kind(const struct shape *s)
{
    return kinds[s->kind];
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

bool shape_is_place(const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (!(fabs(x[d]) <= SHAPE_REACH))
            return false;
    return true;
}

void shape_axis(const struct shape *s, double *axis)
{
    const double length = sqrt(s->axis[0] * s->axis[0] + s->axis[1] * s->axis[1]
                               + s->axis[2] * s->axis[2]);

    for (int d = 0; d < 3; d++)
        axis[d] = length > 0 ? s->axis[d] / length : d == 2;
}

int shape_check_axis(const struct shape *s, const char *path, const char *where)
{
    if (DIM == 3 && gave_vector(s->axis) && !shape_is_place(s->axis))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: axis is (%g, %g, %g), which is no direction;"
                           " [0, 0, 1] is upwards", where, path, s->axis[0], s->axis[1],
                           s->axis[2]);
    return STATUS_DONE;
}

bool shape_between(const double *low, const double *high, const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (!(low[d] <= x[d] && x[d] < high[d]))
            return false;
    return true;
}

double shape_to_faces(const double *low, const double *high, const double *x)
{
    double least = HUGE_VAL;

    for (int d = 0; d < DIM; d++)
        least = fmin(least, fmin(x[d] - low[d], high[d] - x[d]));
    return least;
}

static const char *types_text(void)
{
    static char text[128];
    size_t n = 0;

    for (int i = 0; shape_types[i]; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, "%s%s",
                              !i ? "" : shape_types[i + 1] ? ", " : " or ", shape_types[i]);
    return text;
}

static bool takes(const struct shape *s, const char *key)
{
    char word[32];

    snprintf(word, sizeof word, " %s ", key);
    return strstr(shape_kind(s)->keys, word) != NULL;
}

/* Refuses keys that this type would ignore. */
static int refuse_strangers(const struct shape *s, const char *path, const char *where)
{
    const struct {
        const char *name;
        bool given;
    } key[] = {
        { "from", gave_vector(s->from) }, { "to", gave_vector(s->to) },
        { "points", s->points.n > 0 }, { "centre", gave_vector(s->centre) },
        { "radius", s->radius > 0 }, { "angle", s->angle != 0 },
        { "height", s->height > 0 }, { "axis", gave_vector(s->axis) },
    };
    const char *stranger = NULL;

    for (int i = 0; i < (int)(sizeof key / sizeof *key); i++)
        if (key[i].given && !takes(s, key[i].name))
            stranger = key[i].name;
    if (!shape_kind(s)->layers && s->fill && !strcmp(s->fill, "layers"))
        stranger = "fill = \"layers\": its lattice follows its sides already";
    if (!stranger)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: %s: a %s takes no %s; leave it out or choose another"
                       " type (%s)", where, path, s->type, stranger, types_text());
}

static int find_kind(struct shape *s, const char *path, const char *where)
{
    const char *type = s->type ? s->type : "";

    for (int k = 0; k < KINDS_OF_SHAPE; k++)
        if (kinds[k] && !strcmp(type, kinds[k]->name)) {
            s->kind = k;
            return STATUS_DONE;
        }
    return status_fail(STATUS_BAD_SCENE, "%s: %s: there is no type \"%s\" in %d dimensions; it is"
                       " one of %s", where, path, type, DIM, types_text());
}

int shape_check(struct shape *s, const char *path, const char *where)
{
    TRY(find_kind(s, path, where));
    TRY(refuse_strangers(s, path, where));
    return shape_kind(s)->check(s, path, where);
}

void shape_free(struct shape *s)
{
    if (s->hull)
        polytope_free(s->hull);
    free(s->hull);
    s->hull = NULL;
}

bool shape_contains(const struct shape *s, const double *x)
{
    return shape_kind(s)->contains(s, x);
}

double shape_depth(const struct shape *s, const double *x)
{
    return shape_contains(s, x) ? shape_kind(s)->depth(s, x) : 0;
}

void shape_bounds(const struct shape *s, double *low, double *high)
{
    shape_kind(s)->bounds(s, low, high);
}

bool shape_goes_round(const struct shape *s)
{
    return shape_kind(s)->domain;
}

bool shape_is_thin(const struct shape *s, int d, double width)
{
    const struct shape_kind *kind = shape_kind(s);

    return kind->side && !kind->domain && kind->side(s, d) > 0 && !(kind->side(s, d) > width);
}

void shape_own(const struct shape *s, const double *x, double *own)
{
    if (shape_kind(s)->own)
        shape_kind(s)->own(s, x, own);
    else
        memmove(own, x, DIM * sizeof *own);
}
