/* overlap.c -- are particles of different objects too near each other, or inside
 * each other's shapes.  Distance alone does not tell: half a spacing off in all
 * directions, one lattice passes between the sites of another. */
#include "fill/overlap.h"

#include "base/status.h"
#include "fill/buckets.h"
#include "state/period.h"
#include <math.h>
#include <stdio.h>

static const double near_fluid = 0.7; /* least distance of fluid to others [dx] */
static const double near_walls = 0.3; /* two walls nearer than this are in one place [dx] */

struct partners {
    const struct particles *p;
    int object;     /* not this one, -1: any */
    unsigned kinds; /* of these, as bits */
};

static bool is_partner(const void *self, int j)
{
    const struct partners *w = self;
    const int object = w->p->object_of[j];

    return object != w->object && KIND_BIT(w->p->object[object].kind) & w->kinds;
}

/* Number k of the 2^DIM images of x that are nearest to the middle of the domain: over the
 * sides whose bits are set in k.  False: one of them does not repeat, or is too far away. */
static bool image(const struct scales *s, const double *x, int k, double reach, double *to)
{
    for (int d = 0; d < DIM; d++) {
        const double middle = 0.5 * (s->low[d] + s->high[d]);
        to[d] = x[d];
        if (!(k >> d & 1))
            continue;
        to[d] += x[d] < middle ? s->period[d] : -s->period[d];
        if (!(s->period[d] > 0) || fabs(to[d] - middle) >= 0.5 * s->period[d] + reach)
            return false;
    }
    return true;
}

/* The same over periodic sides and their corners, where it may also be one of its own. */
static int find_beyond(const struct buckets *b, const struct particles *p, int i, double reach,
                       unsigned kinds)
{
    const struct partners any = { p, -1, kinds };
    double x[DIM];
    int j = -1;

    for (int k = 1; k < 1 << DIM && j < 0; k++)
        if (image(p->scales, p->x0[i], k, reach, x))
            j = buckets_find(b, x, reach, is_partner, &any);
    return j;
}

/* A particle of another object and one of the kinds nearer to i than reach, or -1. */
static int find_near(const struct buckets *b, const struct particles *p, int i, double reach,
                     unsigned kinds)
{
    const struct partners other = { p, p->object_of[i], kinds };
    const int j = buckets_find(b, p->x0[i], reach, is_partner, &other);

    return j >= 0 ? j : find_beyond(b, p, i, reach, kinds);
}

static void print_place(char *to, size_t room, const double *x)
{
    int used = snprintf(to, room, "(%g", x[0]);

    for (int d = 1; d < DIM; d++)
        used += snprintf(to + used, room - used, ", %g", x[d]);
    snprintf(to + used, room - used, ")");
}

static int refuse_near(const struct particles *p, const struct fill_item *item, int i, int j,
                       double dx)
{
    const struct fill_item *a = &item[p->object_of[i]], *b = &item[p->object_of[j]];
    char place[96];

    print_place(place, sizeof place, p->x0[i]);
    return status_fail(STATUS_BAD_SCENE, "%s: %s.%s overlaps %s.%s (%s): near %s m two of their"
                       " particles are %.3g m apart, and less than %.1f spacings (%.3g m) is too"
                       " near; move or shorten one of them so that their borders only touch",
                       a->where, a->group, a->name, b->group, b->name, b->where, place,
                       sqrt(period_square(p->scales, p->x0[i], p->x0[j], DIM)), near_fluid,
                       near_fluid * dx);
}

static int refuse_inside(const struct particles *p, const struct fill_item *item, int i, int k)
{
    const struct fill_item *a = &item[p->object_of[i]], *b = &item[k];
    char place[96];

    print_place(place, sizeof place, p->x0[i]);
    return status_fail(STATUS_BAD_SCENE, "%s: %s.%s overlaps %s.%s (%s): a particle of %s.%s at"
                       " %s m is inside; move or shorten one of them so that their borders only"
                       " touch",
                       a->where, a->group, a->name, b->group, b->name, b->where, a->group, a->name,
                       place);
}

static void warn(const struct particles *p, const struct fill_item *item, int i, int j)
{
    const struct fill_item *a = &item[p->object_of[i]], *b = &item[p->object_of[j]];
    char place[96];

    print_place(place, sizeof place, p->x0[i]);
    status_warn("%s: %s.%s and %s.%s (%s) fill the same space near %s m; the fluid feels the"
                " particles of both", a->where, a->group, a->name, b->group, b->name, b->where,
                place);
}

static int check_distances(const struct buckets *b, const struct particles *p,
                           const struct fill_item *item, double dx)
{
    for (int i = 0; i < p->from[KIND_FLUID + 1]; i++) {
        const int j = find_near(b, p, i, near_fluid * dx, ~0u);

        if (j >= 0)
            return refuse_near(p, item, i, j, dx);
    }
    return STATUS_DONE;
}

static int check_insides(const struct particles *p, const struct fill_item *item)
{
    for (int i = 0; i < p->n; i++) {
        const int own = p->object_of[i];

        for (int k = 0; k < p->objects; k++) {
            const bool fluid = item[k].kind == KIND_FLUID || item[own].kind == KIND_FLUID;

            if (k != own && fluid && item[k].shape && shape_contains(item[k].shape, p->x0[i]))
                return refuse_inside(p, item, i, k);
        }
    }
    return STATUS_DONE;
}

static void check_walls(const struct buckets *b, const struct particles *p,
                        const struct fill_item *item, double dx)
{
    const unsigned walls = KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP);

    for (int i = p->from[KIND_WALL]; i < p->from[KIND_WALL_SLIP + 1]; i++) {
        const int j = find_near(b, p, i, near_walls * dx, walls);

        if (j >= 0) {
            warn(p, item, i, j);
            return;
        }
    }
}

static int check(const struct buckets *b, const struct particles *p, const struct fill_item *item,
                 double dx)
{
    TRY(check_distances(b, p, item, dx));
    TRY(check_insides(p, item));
    check_walls(b, p, item, dx);
    return STATUS_DONE;
}

int overlap_check(const struct particles *p, const struct fill_item *item, double dx)
{
    struct buckets b;
    int code;

    TRY(buckets_create(&b, (const double (*)[DIM])p->x0, p->n, near_fluid * dx));
    code = check(&b, p, item, dx);
    buckets_free(&b);
    return code;
}
