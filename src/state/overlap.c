/* overlap.c -- are particles of different objects too near each other, or inside
 * each other's shapes.  Distance alone does not tell: half a spacing off in all
 * directions, one lattice passes between the sites of another.
 *
 * Particles are sorted into cells as wide as the distance in question, the
 * cells into buckets by their number modulo the buckets: near particles lie
 * near in memory, and two cells in one bucket cost time only. */
#include "state/overlap.h"

#include "base/status.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static const double near_fluid = 0.7; /* least distance of fluid to others [dx] */
static const double near_walls = 0.3; /* two walls nearer than this are in one place [dx] */

struct buckets {
    double width;   /* [m] */
    uint64_t mask;  /* buckets - 1 */
    int *start;     /* [buckets + 1] into member */
    int *member;    /* [n] particles, bucket by bucket */
};

static uint64_t bucket_of(const struct buckets *c, const double *x, const int *shift)
{
    static const uint64_t stride[3] = { 1, 73856093, 19349663 };
    uint64_t number = 0;

    for (int d = 0; d < DIM; d++)
        number += stride[d] * (uint64_t)((int64_t)floor(x[d] / c->width) + shift[d]);
    return number & c->mask;
}

/* Counting sort: counts, ends of buckets, then members from the back. */
static void sort(const struct buckets *c, const struct particles *p)
{
    const int here[3] = { 0 };

    for (int i = 0; i < p->n; i++)
        c->start[bucket_of(c, p->x0[i], here)]++;
    for (uint64_t b = 0; b <= c->mask; b++)
        c->start[b + 1] += c->start[b];
    for (int i = p->n - 1; i >= 0; i--)
        c->member[--c->start[bucket_of(c, p->x0[i], here)]] = i;
}

static double distance2(const double *a, const double *b)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++)
        r2 += (a[d] - b[d]) * (a[d] - b[d]);
    return r2;
}

/* A particle of another object and one of the kinds nearer to i than reach, or -1. */
static int find_near(const struct buckets *c, const struct particles *p, int i, double reach,
                     unsigned kinds)
{
    const int block = DIM == 2 ? 9 : 27;

    for (int k = 0; k < block; k++) {
        const int shift[3] = { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 };
        const uint64_t b = bucket_of(c, p->x0[i], shift);

        for (int m = c->start[b]; m < c->start[b + 1]; m++) {
            const int j = c->member[m], object = p->object_of[j];

            if (object != p->object_of[i] && KIND_BIT(p->object[object].kind) & kinds
                && distance2(p->x0[i], p->x0[j]) < reach * reach)
                return j;
        }
    }
    return -1;
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
                       sqrt(distance2(p->x0[i], p->x0[j])), near_fluid, near_fluid * dx);
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

static int check_distances(const struct buckets *c, const struct particles *p,
                           const struct fill_item *item, double dx)
{
    for (int i = 0; i < p->from[KIND_FLUID + 1]; i++) {
        const int j = find_near(c, p, i, near_fluid * dx, ~0u);

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

static void check_walls(const struct buckets *c, const struct particles *p,
                        const struct fill_item *item, double dx)
{
    const unsigned walls = KIND_BIT(KIND_WALL) | KIND_BIT(KIND_WALL_SLIP);

    for (int i = p->from[KIND_WALL]; i < p->from[KIND_WALL_SLIP + 1]; i++) {
        const int j = find_near(c, p, i, near_walls * dx, walls);

        if (j >= 0) {
            warn(p, item, i, j);
            return;
        }
    }
}

static int check(const struct buckets *c, const struct particles *p, const struct fill_item *item,
                 double dx)
{
    sort(c, p);
    TRY(check_distances(c, p, item, dx));
    TRY(check_insides(p, item));
    check_walls(c, p, item, dx);
    return STATUS_DONE;
}

int overlap_check(const struct particles *p, const struct fill_item *item, double dx)
{
    struct buckets c = { .width = near_fluid * dx, .mask = 1 };
    int code = STATUS_FAILED;

    while (c.mask < (uint64_t)p->n)
        c.mask = 2 * c.mask + 1;
    c.start = status_alloc(c.mask + 2, sizeof *c.start);
    c.member = status_alloc(p->n, sizeof *c.member);
    if (c.start && c.member)
        code = check(&c, p, item, dx);
    free(c.start);
    free(c.member);
    return code;
}
