/* carve.c -- fluids make room for solids.
 *
 * A wall's face is half a spacing before its first particles, and a lattice that ends at the
 * face begins half a spacing before it: one spacing lies between fluid and solid.  A lattice
 * that does not end there has sites at any distance from the face; those nearer than a
 * quarter of a spacing are left out, so that fluid begins between 0.75 and 1.75 spacings from
 * the solid's particles.  At half a spacing the water would be a layer too thin on average by
 * a half, not by a quarter, and fluids that touch slanted walls would lose every second site
 * of their border. */
#include "fill/carve.h"

#include "base/status.h"
#include "fill/beyond.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* On the common border of fluid and wall a site is 0.73 dx from the nearest of a row
 * that stands half a spacing behind it in steps of up to 1.05 dx [dx] */
static const double room = 0.75;

/* All solids: their points, and the item of each. */
struct solids {
    const struct fill_item *item;
    int items;
    const struct scales *scales;
    struct points at;
    int *of;           /* [at.n] */
    struct buckets near;
    long *taken;       /* [items] sites that each took of one fluid */
};

static int gather(struct solids *s, const struct points *points)
{
    long n = 0;

    for (int k = 0; k < s->items; k++)
        n += s->item[k].kind == KIND_FLUID ? 0 : points[k].n;
    TRY(points_reserve(&s->at, n));
    if (!(s->of = status_alloc(n + 1, sizeof *s->of)))
        return STATUS_FAILED;
    for (int k = 0; k < s->items; k++)
        for (long i = 0; s->item[k].kind != KIND_FLUID && i < points[k].n; i++) {
            memcpy(s->at.x[s->at.n], points[k].x[i], sizeof *s->at.x);
            s->of[s->at.n++] = k;
        }
    return buckets_create(&s->near, (const double (*)[DIM])s->at.x, (int)n,
                          room * s->scales->dx);
}

/* Behind their layers walls and rigid bodies are hollow. */
static bool holds(const struct fill_item *item, const double *x)
{
    return item->shape ? shape_contains(item->shape, x)
                       : item->holds && item->holds(item->body, x);
}

/* The item that leaves no room at x, -1: there is room. */
static int solid_at(const struct solids *s, const double *x)
{
    int j = buckets_find(&s->near, x, s->near.width, NULL, NULL);

    if (j < 0)
        j = beyond_find(&s->near, s->scales, x, s->near.width, NULL, NULL);
    if (j >= 0)
        return s->of[j];
    for (int k = 0; k < s->items; k++)
        if (s->item[k].kind != KIND_FLUID && holds(&s->item[k], x))
            return k;
    return -1;
}

/* The item that took most of a fluid, -1: none took any. */
static int largest(const struct solids *s)
{
    int most = -1;

    for (int k = 0; k < s->items; k++)
        if (s->taken[k] > (most < 0 ? 0 : s->taken[most]))
            most = k;
    return most;
}

/* "wall.post (a.scene:3) takes 60 %, beam.gate (a.scene:9) takes 5 %": the first three, which
 * are forgotten then. */
static void print_shares(const struct solids *s, long sites, char *to, size_t size)
{
    size_t used = 0;

    for (int told = 0; told < 3 && used < size; told++) {
        const int k = largest(s);
        if (k < 0)
            return;
        used += snprintf(to + used, size - used, "%s%s.%s (%s) takes %.3g %%", told ? ", " : "",
                         s->item[k].group, s->item[k].name, s->item[k].where,
                         100.0 * s->taken[k] / sites);
        s->taken[k] = 0;
    }
}

static int refuse(const struct solids *s, const struct fill_item *fluid, long sites, long lost)
{
    char shares[1024] = "";

    print_shares(s, sites, shares, sizeof shares);
    return status_fail_with(STATUS_BAD_SCENE, (struct status_advice){
                                .remedy = "move the fluid or the solids, or make the solids smaller"
                            }, "%s: %s.%s lies %s in solids: they take %ld of its %ld sites, and "
                            "fluid makes room for solids as long as half of it is left; %s",
                            fluid->where, fluid->group, fluid->name,
                            lost == sites ? "wholly" : "more than half", lost, sites, shares);
}

static int carve(const struct solids *s, const struct fill_item *fluid, struct points *p,
                 struct carve *out)
{
    const long sites = p->n;
    long n = 0;

    memset(s->taken, 0, s->items * sizeof *s->taken);
    for (long i = 0; i < sites; i++) {
        const int solid = solid_at(s, p->x[i]);
        if (solid < 0)
            memmove(p->x[n++], p->x[i], sizeof *p->x);
        else
            s->taken[solid]++;
    }
    p->n = n;
    *out = (struct carve){ .n = sites - n, .most = largest(s) };
    return 2 * out->n > sites ? refuse(s, fluid, sites, out->n) : STATUS_DONE;
}

static int carve_all(struct solids *s, struct points *points, struct carve *out)
{
    if (!(s->taken = status_alloc(s->items, sizeof *s->taken)))
        return STATUS_FAILED;
    TRY(gather(s, points));
    for (int k = 0; k < s->items; k++)
        if (s->item[k].kind == KIND_FLUID)
            TRY(carve(s, &s->item[k], &points[k], &out[k]));
    return STATUS_DONE;
}

int carve_fluids(const struct fill_item *item, int items, const struct scales *scales,
                 struct points *points, struct carve *out)
{
    struct solids s = { .item = item, .items = items, .scales = scales };
    const int code = carve_all(&s, points, out);

    buckets_free(&s.near);
    points_free(&s.at);
    free(s.of);
    free(s.taken);
    return code;
}
