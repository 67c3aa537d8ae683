/* objects.c -- the things of a scene: bodies, and the particles of fluids, walls and skins. */
#include "plan/inside.h"

#include "base/status.h"
#include "fill/fill.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A body knows its path in the scene, but not the line where it stands. */
static int refuse_body(int status, const struct input_body *in)
{
    char text[1024];

    snprintf(text, sizeof text, "%s", status_message());
    status_clear();
    return status_fail(status, "%s: %s", in->where, text);
}

int plan_bodies_make(struct plan *p)
{
    if (!(p->body = status_alloc(p->in.bodies + 1, sizeof *p->body)))
        return STATUS_FAILED;
    for (int i = 0; i < p->in.bodies; i++) {
        const struct input_body *in = &p->in.body[i];
        struct plan_body *b = &p->body[p->bodies];
        b->kind = in->kind;
        b->object = -1;
        snprintf(b->name, sizeof b->name, "%s", in->name);
        snprintf(b->path, sizeof b->path, "%s", in->path);
        const int status = in->kind->make.create(in->params, &p->scales, in->name,
                                                  in->path, &b->body);
        if (status != STATUS_DONE)
            return refuse_body(status, in);
        p->bodies++;
        b->points = in->kind->skin(b->body, NULL, NULL);
        b->skin = p->scales.fluid ? b->points : 0; /* without water nothing presses */
    }
    return STATUS_DONE;
}

static bool holds(const void *body, const double *x)
{
    const struct plan_body *b = body;

    return b->kind->watch->holds(b->body, x);
}

/* skin NULL: without the places of points. */
static void list_items(struct plan *p, struct fill_item *item, double (*skin)[DIM])
{
    int n = 0, at = 0;

    for (int i = 0; i < p->in.fluids; i++, n++) {
        item[n] = (struct fill_item){ .group = "fluid", .where = p->in.fluid[i].where,
                                      .kind = KIND_FLUID, .shape = &p->in.fluid[i].set.shape };
        strcpy(item[n].name, p->in.fluid[i].name);
    }
    for (int i = 0; i < p->in.wall_count; i++, n++) {
        const struct input_wall *w = &p->in.wall[i];
        item[n] = (struct fill_item){ .group = "wall", .where = w->where,
                                      .kind = w->set.slip ? KIND_WALL_SLIP : KIND_WALL,
                                      .shape = &w->set.shape };
        strcpy(item[n].name, w->name);
    }
    for (int i = 0; i < p->bodies; i++) {
        const struct plan_body *b = &p->body[i];
        if (b->skin == 0)
            continue;
        item[n] = (struct fill_item){ .group = b->kind->identity.group,
                                      .where = p->in.body[i].where, .points = b->skin };
        strcpy(item[n].name, b->name);
        if (b->kind->watch && b->kind->watch->holds) {
            item[n].holds = holds;
            item[n].body = b;
        }
        b->kind->skin(b->body, skin ? skin + at : NULL, &item[n].kind);
        item[n].point = skin ? (const double (*)[DIM])(skin + at) : NULL;
        n++;
        at += b->skin;
    }
}

static int find_object(const struct particles *p, const char *name, bool skin)
{
    for (int i = 0; i < p->objects; i++) {
        const enum kind k = p->object[i].kind;
        const bool is_skin = k == KIND_SKIN || k == KIND_SKIN_SLIP;
        if (k != KIND_FLUID && is_skin == skin && strcmp(p->object[i].name, name) == 0)
            return i;
    }
    return -1;
}

/* Items of a plan; *skins: points of all bodies. */
static int count_items(const struct plan *p, int *skins)
{
    int items = p->in.fluids + p->in.wall_count;

    *skins = 0;
    for (int i = 0; i < p->bodies; i++) {
        items += p->body[i].skin > 0;
        *skins += p->body[i].skin;
    }
    return items;
}

int plan_objects_count(struct plan *p, struct plan_survey *to)
{
    int skins, status = STATUS_FAILED;
    const int items = count_items(p, &skins);
    struct fill_item *item = status_alloc(items + 1, sizeof *item);
    struct fill_counts counts = { .of = status_alloc(items + 1, sizeof *counts.of) };

    to->object = status_alloc(items + 1, sizeof *to->object);
    if (item && counts.of && to->object) {
        list_items(p, item, NULL);
        status = fill_count(item, items, &p->scales, plan_memory_each(p, true),
                            plan_memory_each(p, false), &counts);
    }
    for (int i = 0; counts.known && i < items; i++) {
        struct plan_survey_object *o = &to->object[to->objects++];
        o->n = counts.of[i];
        o->group = item[i].group;
        memcpy(o->name, item[i].name, sizeof o->name);
    }
    to->fluid = counts.fluid;
    to->solid = counts.solid;
    free(counts.of);
    free(item);
    return status;
}

int plan_objects_fill(struct plan *p)
{
    int skins, status;
    const int items = count_items(p, &skins);
    struct fill_item *item;
    double (*skin)[DIM];

    item = status_alloc(items + 1, sizeof *item);
    skin = status_alloc(skins + 1, sizeof *skin);
    status = item && skin ? STATUS_DONE : STATUS_FAILED;
    if (status == STATUS_DONE) {
        list_items(p, item, skin);
        status = fill_particles(item, items, &p->scales, plan_memory_each(p, true),
                                plan_memory_each(p, false), &p->particles);
    }
    free(item);
    free(skin);
    return status;
}

int plan_objects_name(struct plan *p)
{
    struct particles *all = p->particles;

    if (!(p->wall = status_alloc(p->in.wall_count + 1, sizeof *p->wall)))
        return STATUS_FAILED;
    for (int i = 0; i < p->in.wall_count; i++) {
        struct plan_wall *w = &p->wall[p->walls++];
        w->motion = p->in.wall[i].motion;
        w->moves = motion_any(&w->motion);
        w->object = find_object(all, p->in.wall[i].name, false);
        memcpy(all->object[w->object].slide, p->in.wall[i].set.surface, sizeof all->object->slide);
        for (int d = 0; d < DIM; d++)
            p->moving_walls |= p->in.wall[i].set.surface[d] != 0;
        p->moving_walls |= w->moves;
    }
    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].skin > 0)
            p->body[i].object = find_object(all, p->body[i].name, true);
    for (int i = 0, f = 0; i < all->objects; i++)
        if (all->object[i].kind == KIND_FLUID)
            memset(all->dye + all->object[i].from, p->in.fluid[f++].set.dye, all->object[i].n);
    return STATUS_DONE;
}
