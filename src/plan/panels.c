/* panels.c -- parts of walls and beams whose forces are told apart: which particles they have. */
#include "plan/inside.h"

#include "base/status.h"
#include "shapes/shape.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The side of a frame that a particle belongs to, a bit of shape_side(): behind which it lies
 * furthest.  Of two as far (but for rounding) that along the first axis. */
static unsigned side_of(const struct scales *s, const double *x)
{
    double most = -HUGE_VAL;
    unsigned best = 0;

    for (int d = 0; d < DIM; d++)
        for (int high = 0; high < 2; high++) {
            const double behind = high ? x[d] - s->high[d] : s->low[d] - x[d];
            if (behind > most + 1e-6 * s->dx) {
                most = behind;
                best = shape_side(d, high);
            }
        }
    return best;
}

/* Number of the side named in the list left, right, ...; -1: "all". */
static int side_named(const char *name)
{
    for (int side = 0; shape_sides[side]; side++)
        if (strcmp(shape_sides[side], name) == 0)
            return side;
    return -1;
}

static bool has(const struct scales *s, const struct settings_panel *set, const double *x)
{
    const int side = side_named(set->side);

    for (int d = 0; d < DIM; d++)
        if (x[d] < set->from[d] || x[d] >= set->to[d]) /* NaN: no bound */
            return false;
    return side < 0 || side_of(s, x) == 1u << side;
}

static const struct object *find_solid(const struct plan *p, const char *name)
{
    const struct particles *all = p->particles;

    for (int i = 0; i < all->objects; i++)
        if (all->object[i].kind != KIND_FLUID && strcmp(all->object[i].name, name) == 0)
            return &all->object[i];
    return NULL;
}

static int refuse_solid(const struct plan *p, const struct input_panel *in)
{
    char known[400] = "";
    size_t n = 0;

    for (int i = 0; i < p->particles->objects && n < sizeof known; i++)
        if (p->particles->object[i].kind != KIND_FLUID)
            n += (size_t)snprintf(known + n, sizeof known - n, "%s%s", n ? ", " : "",
                                  p->particles->object[i].name);
    return status_fail(STATUS_BAD_SCENE, "%s: panel.%s is a part of \"%s\", but no wall or beam in "
                       "the water has that name; there are: %s", in->where, in->name, in->set.of,
                       known[0] ? known : "none");
}

static int check_side(const struct plan *p, const struct input_panel *in)
{
    if (side_named(in->set.side) < 0)
        return STATUS_DONE;
    for (int i = 0; i < p->in.wall_count; i++)
        if (strcmp(p->in.wall[i].name, in->set.of) == 0
            && shape_goes_round(&p->in.wall[i].set.shape))
            return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: panel.%s.side = \"%s\", but \"%s\" is no wall of "
                       "type \"frame\", and others have no sides; choose its particles by from and "
                       "to", in->where, in->name, in->set.side, in->set.of);
}

static void direct(const double *from, double *to)
{
    double size = 0;

    for (int d = 0; d < DIM; d++)
        size = hypot(size, from[d]);
    for (int d = 0; d < DIM && size > 0; d++)
        to[d] = from[d] / size;
}

static int make_panel(struct plan *p, const struct input_panel *in, struct plan_panel *to)
{
    const struct object *o = find_solid(p, in->set.of);

    if (!o)
        return refuse_solid(p, in);
    TRY(check_side(p, in));
    to->name = in->name;
    memcpy(to->about, in->set.about, sizeof to->about);
    direct(in->set.along, to->along);
    if (!(to->id = status_alloc((unsigned long)o->n, sizeof *to->id)))
        return STATUS_FAILED;
    for (int id = o->from; id < o->from + o->n; id++)
        if (has(&p->scales, &in->set, p->particles->x0[id]))
            to->id[to->n++] = id;
    if (to->n == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: panel.%s has no particle of \"%s\" in it at "
                           "t = 0; its first layer lies half a spacing behind the face: let from "
                           "and to reach that far, and name a side that the frame has", in->where,
                           in->name, in->set.of);
    return STATUS_DONE;
}

int plan_panels_make(struct plan *p)
{
    if (!(p->book.panel = status_alloc((unsigned long)p->in.panels.n + 1, sizeof *p->book.panel)))
        return STATUS_FAILED;
    for (int i = 0; i < p->in.panels.n; i++) {
        p->book.panels++;
        TRY(make_panel(p, &p->in.panels.of[i], &p->book.panel[i]));
    }
    return STATUS_DONE;
}

void plan_panels_free(struct plan *p)
{
    for (int i = 0; i < p->book.panels; i++)
        free(p->book.panel[i].id);
    free(p->book.panel);
}

int plan_panels(const struct plan *p)
{
    return p->book.panels;
}

const char *plan_panel_name(const struct plan *p, int panel)
{
    return p->book.panel[panel].name;
}

bool plan_panel_drags(const struct plan *p, int panel)
{
    const double *along = p->book.panel[panel].along;

    return along[0] != 0 || along[1] != 0 || along[2] != 0;
}

const double *plan_panel_impulse(const struct plan *p, const double *y, int panel)
{
    return plan_impulse(p, y, p->particles->objects + panel);
}
