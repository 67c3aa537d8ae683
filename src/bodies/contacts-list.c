/* contacts-list.c -- which solids there are, and which of them may touch. */
#include "bodies/contacts-list.h"

#include "base/status.h"
#include "shapes/shape.h"
#include "state/period.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* At the start nothing may be deeper: overlap is energy from nowhere, and this much stores
 * less than a thousandth of what d_U stores. */
static const double start_depth = 0.05; /* [d_U] */

/* Numbers that xi of all pairs may have. */
enum { MOST_NUMBERS = 2000000 };

void contacts_list_free(struct contacts **contacts)
{
    struct contacts *c = *contacts;

    if (!c)
        return;
    free(c->solid);
    free(c->part_of);
    free(c->known);
    free(c->skinned);
    free(c->pair);
    free(c->skin);
    for (int i = 0; i < c->lifts; i++)
        contacts_uplift_free(&c->lift[i].of);
    free(c->lift);
    free(c);
    *contacts = NULL;
}

enum { SIDES = 2 * DIM };

/* A frame has a solid for each of its sides. */
static int take_memory(struct contacts *c, const struct contacts_scene *s)
{
    const size_t all = (size_t)s->bodies + (size_t)s->walls;
    size_t solids = (size_t)s->walls * SIDES + SIDES;

    for (int i = 0; i < s->bodies; i++)
        solids += s->body[i].kind->role.solid
                ? (size_t)s->body[i].kind->role.solid->solids(s->body[i].body) : 0;
    c->solid = status_alloc(solids, sizeof *c->solid);
    c->part_of = status_alloc(solids, sizeof *c->part_of);
    c->known = status_alloc(all + 1, sizeof *c->known);
    c->skinned = status_alloc(all + 1, sizeof *c->skinned);
    return c->solid && c->part_of && c->known && c->skinned ? STATUS_DONE : STATUS_FAILED;
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

/* Rounded as the sharpest of bodies.  Sides of frames stop all bodies, others those that say so. */
static void list_walls(struct contacts *c, const struct contacts_scene *s, int bodies)
{
    const double margin = least_margin(c, bodies);
    unsigned framed = 0, named = 0;

    for (int j = 0; j < s->walls; j++) {
        const struct shape *shape = s->wall[j].shape;
        if (shape->kind == SHAPE_FRAME) {
            list_sides(c, ~shape->open, s->bodies + j, margin);
            framed |= ~shape->open;
        } else if (solid_of_shape(shape, s->wall[j].path, margin, &c->solid[c->solids])) {
            know(c, s->bodies + j);
        }
    }
    for (int i = 0; i < bodies; i++)
        named |= c->solid[i].stops;
    list_sides(c, named & ~framed, s->bodies + s->walls, margin);
}

/* Does solid i, of a body, feel that solid? */
static bool meets(const struct contacts *c, int i, int solid)
{
    if (c->part_of[solid] == c->part_of[i])
        return false;
    return c->part_of[solid] < c->bodies + c->walls
           || (c->solid[i].stops & c->solid[solid].stops) != 0;
}

static struct contacts_rub rub_of(const struct contacts *c, const struct contacts_scene *s, int part,
                                  int solid)
{
    return contacts_rules_of(s, contacts_rules_path(s, part),
                             contacts_rules_path(s, c->part_of[solid]));
}

static int check_room(double places)
{
    if (places * DIM > MOST_NUMBERS)
        return status_fail(STATUS_BAD_SCENE, "bodies and walls may touch at %.0f places, each of which "
                           "remembers how far it is bent: %.0f numbers, and at most %d are allowed; "
                           "use fewer bodies, discs and spheres, which have one place for each "
                           "pair, or clumps of fewer balls (a larger pitch)", places, places * DIM,
                           MOST_NUMBERS);
    return STATUS_DONE;
}

/* Each has one place or more. */
static double count_pairs(const struct contacts *c, int bodies)
{
    double n = 0;

    for (int i = 0; i < bodies; i++)
        for (int j = i + 1; j < c->solids; j++)
            n += meets(c, i, j);
    return n;
}

static int list_pairs(struct contacts *c, const struct contacts_scene *s, int bodies)
{
    const double most = count_pairs(c, bodies);

    TRY(check_room(most));
    c->pair = status_alloc((size_t)most + 1, sizeof *c->pair);
    if (!c->pair)
        return STATUS_FAILED;
    for (int i = 0; i < bodies; i++)
        for (int j = i + 1; j < c->solids; j++) {
            if (!meets(c, i, j))
                continue;
            struct contacts_pair *p = &c->pair[c->pairs++];
            const struct contacts_rub rub = rub_of(c, s, c->part_of[i], j);
            contacts_pair_make(p, &c->solid[i], &c->solid[j], &rub, !c->scales.fluid);
            p->first = i;
            p->second = j;
            p->from = c->places;
            c->places += p->places;
        }
    return STATUS_DONE;
}

/* NULL: it touches nothing. */
static const struct body_surface *surface_of(const struct contacts_body *b)
{
    const struct body_watch *watch = b->kind->watch;
    const struct body_surface *s = watch && watch->surface ? watch->surface(b->body) : NULL;

    return s && s->touches ? s : NULL;
}

static int no_skin(void)
{
    return status_fail(STATUS_BAD_SCENE, "a beam with contact = true touches by its skin, and that is "
                       "there in water only; name a fluid, be it far away, or leave contact out");
}

/* Skins touch all solids but sides that are no wall's, which only rigid bodies name. */
static int list_skins(struct contacts *c, const struct contacts_scene *s)
{
    c->skin = status_alloc((size_t)s->bodies * (size_t)c->solids + 1, sizeof *c->skin);
    if (!c->skin)
        return STATUS_FAILED;
    for (int i = 0; i < s->bodies; i++) {
        const struct body_surface *surface = surface_of(&s->body[i]);
        if (surface && s->body[i].points == 0)
            return no_skin();
        for (int j = 0; j < c->solids && surface; j++) {
            if (c->part_of[j] == c->bodies + c->walls)
                continue;
            struct contacts_skin *p = &c->skin[c->skins++];
            const struct contacts_rub rub = rub_of(c, s, i, j);
            if (rub.made)
                return status_fail(STATUS_BAD_SCENE, "%s: law = \"hertz-mindlin\" is for rigid bodies and "
                                   "walls, and a beam touches by its skin; leave the law out for beams",
                                   s->body[i].path);
            contacts_skin_make(p, &s->body[i], surface, &c->solid[j], &rub, &c->scales);
            p->body = i;
            p->second = j;
            p->from = c->places;
            c->places += p->points;
            c->known[i] = c->skinned[i] = true;
        }
    }
    return STATUS_DONE;
}

/* Of solids, the first are bodies. */
static int list_lifts(struct contacts *c, const struct contacts_scene *s, int bodies)
{
    c->lift = status_alloc((size_t)bodies + 1, sizeof *c->lift);
    if (!c->lift)
        return STATUS_FAILED;
    for (int i = 0; i < bodies; i++) {
        const struct contacts_body *b = &s->body[c->part_of[i]];
        struct contacts_lift *l = &c->lift[c->lifts];
        if (!c->solid[i].uplift || b->points == 0)
            continue;
        TRY(contacts_uplift_create(&c->solid[i], b, &c->scales, &l->of));
        l->solid = i;
        l->body = c->part_of[i];
        c->lifts++;
    }
    return STATUS_DONE;
}

struct contacts_stand contacts_list_stand(const struct contacts *c, const struct solid_place *a,
                                          const struct solid_place *b)
{
    struct contacts_stand s = { .a = a, .b = b };

    for (int d = 0; d < DIM; d++)
        s.apart[d] = period_nearest(&c->scales, d, a->x[d] - b->x[d]);
    return s;
}

static int check_start(const struct contacts *c)
{
    for (int i = 0; i < c->pairs; i++) {
        const struct contacts_pair *p = &c->pair[i];
        const struct contacts_stand s = contacts_list_stand(c, &p->a->start, &p->b->start);
        const double depth = contacts_pair_depth(p, &s), most = start_depth * p->depth;
        char deep[40] = "far";
        TRY(contacts_pair_check(p));
        if (depth <= most)
            continue;
        if (depth < HUGE_VAL)
            snprintf(deep, sizeof deep, "%g m", depth);
        return status_fail(STATUS_BAD_SCENE, "%s and %s overlap at t = 0: they are %s inside each "
                           "other, and at most %g m may be, as overlap is energy from nowhere; move "
                           "them apart, so that their faces touch or less", p->a->path, p->b->path,
                           deep, most);
    }
    return STATUS_DONE;
}

static int build(struct contacts *c, const struct contacts_scene *s)
{
    int bodies;

    c->scales = *s->scales;
    c->bodies = s->bodies;
    c->walls = s->walls;
    TRY(contacts_rules_check(s));
    TRY(take_memory(c, s));
    bodies = list_bodies(c, s);
    list_walls(c, s, bodies);
    TRY(list_pairs(c, s, bodies));
    TRY(list_skins(c, s));
    TRY(list_lifts(c, s, bodies));
    TRY(check_room((double)c->places));
    return check_start(c);
}

int contacts_list_create(const struct contacts_scene *scene, struct contacts **out)
{
    struct contacts *c = status_alloc(1, sizeof *c);
    int code = c ? build(c, scene) : STATUS_FAILED;

    if (code != STATUS_DONE || c->places == 0)
        contacts_list_free(&c);
    *out = c;
    return code;
}
