/* overlap.c -- are particles of different objects too near each other, or inside
 * each other's shapes.  Distance alone does not tell: half a spacing off in all
 * directions, one lattice passes between the sites of another. */
#include "fill/overlap.h"

#include "base/status.h"
#include "fill/beyond.h"
#include "state/period.h"
#include <math.h>
#include <stdio.h>

static const double near_other = 0.7; /* least distance of fluid to fluid, skins to solids [dx] */
static const double near_walls = 0.3; /* two walls nearer than this are in one place [dx] */

static const unsigned walls = KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP);

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

/* A particle of another object and one of the kinds nearer to i than reach, or -1; over
 * periodic sides it may also be one of its own. */
static int find_near(const struct buckets *b, const struct particles *p, int i, double reach,
                     unsigned kinds)
{
    const struct partners other = { p, p->object_of[i], kinds }, any = { p, -1, kinds };
    const int j = buckets_find(b, p->x0[i], reach, is_partner, &other);

    return j >= 0 ? j : beyond_find(b, p->scales, p->x0[i], reach, is_partner, &any);
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
                       sqrt(period_square(p->scales, p->x0[i], p->x0[j], DIM)), near_other,
                       near_other * dx);
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

/* Kinds that one of this kind may not overlap: walls may stand in walls. */
static unsigned rivals(enum kind kind)
{
    const unsigned skins = KIND_BIT(KIND_SKIN) | KIND_BIT(KIND_SKIN_SLIP);

    if (kind == KIND_FLUID)
        return KIND_BIT(KIND_FLUID);
    return KIND_BIT(kind) & skins ? skins | walls : 0;
}

static int check_distances(const struct buckets *b, const struct particles *p,
                           const struct fill_item *item, double dx)
{
    for (int i = 0; i < p->n; i++) {
        const unsigned kinds = rivals(item[p->object_of[i]].kind);
        const int j = kinds ? find_near(b, p, i, near_other * dx, kinds) : -1;

        if (j >= 0)
            return refuse_near(p, item, i, j, dx);
    }
    return STATUS_DONE;
}

/* Distance alone does not tell of fluids, whose lattices pass through each other, nor of
 * walls, which are hollow. */
static int check_insides(const struct particles *p, const struct fill_item *item)
{
    for (int i = 0; i < p->n; i++) {
        const int own = p->object_of[i];
        const unsigned kinds = rivals(item[own].kind);

        for (int k = 0; kinds && k < p->objects; k++)
            if (k != own && KIND_BIT(item[k].kind) & kinds && item[k].shape
                && shape_contains(item[k].shape, p->x0[i]))
                return refuse_inside(p, item, i, k);
    }
    return STATUS_DONE;
}

static void check_walls(const struct buckets *b, const struct particles *p,
                        const struct fill_item *item, double dx)
{
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

    TRY(buckets_create(&b, (const double (*)[DIM])p->x0, p->n, near_other * dx));
    code = check(&b, p, item, dx);
    buckets_free(&b);
    return code;
}
