/* contacts-solids.c -- which solids a scene has: rigid bodies first, walls, sides of the domain. */
#include "bodies/contacts-solids.h"

#include "base/status.h"
#include "shapes/shape.h"

#include <math.h>
#include <stdlib.h>

enum { SIDES = 2 * DIM };

/* A frame has a solid for each of its sides. */
static int take_memory(struct contacts *c, const struct contacts_scene *s)
{
    const size_t all = (size_t)s->bodies + (size_t)s->walls;
    size_t solids = (size_t)s->walls * SIDES + SIDES;

    for (int j = 0; j < s->walls; j++)
        solids += (size_t)solid_wall_most(s->wall[j].shape);
    for (int i = 0; i < s->bodies; i++)
        solids += s->body[i].kind->role.solid
                ? (size_t)s->body[i].kind->role.solid->solids(s->body[i].body) : 0;
    c->solid = status_alloc(solids, sizeof *c->solid);
    c->part_of = status_alloc(solids, sizeof *c->part_of);
    c->of_wall = status_alloc((size_t)s->walls + 1, sizeof *c->of_wall);
    c->known = status_alloc(all + 1, sizeof *c->known);
    return c->solid && c->part_of && c->of_wall && c->known ? STATUS_DONE : STATUS_FAILED;
}

static double least_margin(const struct contacts *c, int bodies)
{
    double least = c->scales.fluid || bodies == 0 ? 0.5 * c->scales.dx : HUGE_VAL;

    for (int i = 0; i < bodies; i++)
        least = fmin(least, c->solid[i].margin);
    return least;
}

static void know(struct contacts *c, int part)
{
    struct solid *s = &c->solid[c->solids];

    s->around = core_around(&s->core, s->middle);
    c->part_of[c->solids++] = part;
    if (part < c->bodies + c->walls)
        c->known[part] = true;
}

static int list_bodies(struct contacts *c, const struct contacts_scene *s)
{
    for (int i = 0; i < s->bodies; i++) {
        const struct body_solid *role = s->body[i].kind->role.solid;
        for (int k = 0; role && k < role->solids(s->body[i].body); k++) {
            role->facts(s->body[i].body, k, &c->solid[c->solids]);
            know(c, i);
        }
    }
    return c->solids;
}

/* Those bits of sides, which are of that part. */
static void list_sides(struct contacts *c, unsigned sides, int part, double margin)
{
    for (int axis = 0; axis < DIM; axis++)
        for (int high = 0; high < 2; high++)
            if (sides & shape_side(axis, high)) {
                solid_of_side(axis, high, c->scales.low, c->scales.high, margin,
                              &c->solid[c->solids]);
                c->solid[c->solids].stops = shape_side(axis, high);
                know(c, part);
            }
}

const struct body_surface *contacts_solids_surface(const struct contacts_body *b)
{
    const struct body_watch *watch = b->kind->watch;
    const struct body_surface *s = watch && watch->surface ? watch->surface(b->body) : NULL;

    return s && s->touches ? s : NULL;
}

/* Is there a body or a beam that touches? */
static bool any_touches(const struct contacts_scene *s, int bodies)
{
    bool any = bodies > 0;

    for (int i = 0; i < s->bodies && !any; i++)
        any = contacts_solids_surface(&s->body[i]) != NULL;
    return any;
}

static int list_wall(struct contacts *c, const struct contacts_scene *s, int j, double margin)
{
    struct solid_wall *w = &c->of_wall[j];

    TRY(solid_wall_make(s->wall[j].shape, s->wall[j].path, margin, w));
    for (int i = 0; i < w->cores; i++) {
        solid_wall_facts(w, i, s->wall[j].path, &c->solid[c->solids]);
        know(c, s->bodies + j);
    }
    return STATUS_DONE;
}

/* Rounded as the sharpest of bodies.  Sides of frames stop all bodies, others those that say so. */
static int list_walls(struct contacts *c, const struct contacts_scene *s, int bodies)
{
    const double margin = least_margin(c, bodies);
    const bool touching = any_touches(s, bodies);
    unsigned framed = 0, named = 0;

    for (int j = 0; j < s->walls && touching; j++) {
        const struct shape *shape = s->wall[j].shape;
        if (shape->kind == SHAPE_FRAME) {
            list_sides(c, ~shape->open, s->bodies + j, margin);
            framed |= ~shape->open;
        } else {
            TRY(list_wall(c, s, j, margin));
        }
    }
    for (int i = 0; i < bodies; i++)
        named |= c->solid[i].stops;
    list_sides(c, named & ~framed, s->bodies + s->walls, margin);
    return STATUS_DONE;
}

int contacts_solids_list(struct contacts *c, const struct contacts_scene *s, int *bodies)
{
    TRY(take_memory(c, s));
    *bodies = list_bodies(c, s);
    return list_walls(c, s, *bodies);
}

void contacts_solids_free(struct contacts *c)
{
    for (int j = 0; j < c->walls && c->of_wall; j++)
        solid_wall_free(&c->of_wall[j]);
    free(c->of_wall);
    free(c->solid);
    free(c->part_of);
    free(c->known);
}
