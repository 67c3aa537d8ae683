/* input-objects.c -- reads the named objects of a scene: fluids, walls, bodies. */
#include "plan/input-objects.h"

#include "base/status.h"
#include "matter/eos.h"
#include "plan/idle.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* One set of rows that reads its share of a group's keys. */
struct share {
    const struct param *rows;
    void *into;
};

int input_add_keys(const struct param *rows, const char **keys, int n)
{
    for (const struct param *r = rows; r && r->key && n < INPUT_KEYS - 1; r++)
        keys[n++] = r->key;
    keys[n] = NULL;
    return n;
}

/* Several sets of rows read one group: each knows the keys of the others. */
static int fill_shares(struct scene *scene, const struct scene_node *group, const char *path,
                       const struct share *share, int shares)
{
    for (int i = 0; i < shares; i++) {
        const char *also[INPUT_KEYS] = { NULL };
        int n = 0;
        for (int j = 0; j < shares; j++)
            if (j != i)
                n = input_add_keys(share[j].rows, also, n);
        TRY(scene_fill(scene, group, path, share[i].rows, also, DIM, share[i].into));
    }
    return STATUS_DONE;
}

int input_check_objects(const struct scene_node *group, const char *name)
{
    if (group && !scene_is_group(group))
        return status_fail(STATUS_BAD_SCENE, "%s: %s must be a group of named objects: "
                           "%s = { NAME = { ... } }", scene_where(group), name, name);
    TRY(scene_check_named(group));
    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        if (!scene_is_group(node))
            return status_fail(STATUS_BAD_SCENE, "%s: %s.%s must be a named object: "
                               "%s = { NAME = { ... } }", scene_where(node), name,
                               scene_name(node), name);
        if (strlen(scene_name(node)) > 40)
            return status_fail(STATUS_BAD_SCENE, "%s: the name %s is longer than 40 letters",
                               scene_where(node), scene_name(node));
    }
    return STATUS_DONE;
}

void *input_objects(const struct scene_node *group, size_t size)
{
    return status_alloc(scene_count(group) + 1, size);
}

/* What a flow at the start must know of the rest of the scene. */
static int read_flow(const struct input *in, struct input_fluid *f, const char *path)
{
    const struct eos *eos = in->pressure_self;

    shape_bounds(&f->set.shape, f->flow.low, f->flow.high);
    f->flow.gravity = -in->set.gravity[DIM - 1];
    f->flow.rho0 = eos->rho0;
    return flow_check(&f->flow, path, f->where);
}

int input_fluids(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "fluid");

    TRY(input_check_objects(group, "fluid"));
    if (!(in->fluid = input_objects(group, sizeof *in->fluid)))
        return STATUS_FAILED;
    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        struct input_fluid *f = &in->fluid[in->fluids++];
        char path[80];

        snprintf(f->name, sizeof f->name, "%s", scene_name(node));
        snprintf(f->where, sizeof f->where, "%s", scene_where(node));
        snprintf(path, sizeof path, "fluid.%s", f->name);
        TRY(fill_shares(scene, node, path,
                        (struct share[]){ { shape_params, &f->set.shape },
                                          { settings_fluid_params, &f->set },
                                          { flow_params, &f->flow } }, 3));
        if (strcmp(f->set.shape.type, "frame") == 0)
            return status_fail(STATUS_BAD_SCENE, "%s: %s: a frame is a shape for walls, not "
                               "for a fluid", f->where, path);
        TRY(shape_check(&f->set.shape, path, f->where));
        TRY(idle_fluid(node, path, f));
        TRY(read_flow(in, f, path));
    }
    return STATUS_DONE;
}

/* A frame goes around the domain, as thick as the kernel reaches. */
static void frame_of(const struct input *in, struct shape *s)
{
    memcpy(s->low, in->domain.from, sizeof s->low);
    memcpy(s->high, in->domain.to, sizeof s->high);
    s->thickness = ceil(in->kernel.support) * in->set.spacing;
    s->open = in->domain.open | (in->domain.lid ? 0 : shape_side(DIM - 1, true));
    for (int d = 0; d < DIM; d++)
        if (in->domain.periodic & 1u << d)
            s->open |= shape_side(d, false) | shape_side(d, true);
}

/* Sides that end below the domain's top leave room for splashes. */
static int rim_of(const char *path, struct input_wall *w)
{
    struct shape *s = &w->set.shape;
    const double rim = w->set.rim, low = s->low[DIM - 1], high = s->high[DIM - 1];

    if (isnan(rim))
        return STATUS_DONE;
    if (strcmp(s->type, "frame") != 0)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.rim is for walls of type \"frame\"; a %s ends "
                           "where its shape ends: leave rim out", w->where, path, s->type);
    if (!(low < rim && rim <= high))
        return status_fail(STATUS_BAD_SCENE, "%s: %s.rim = %g m lies outside the domain, which goes "
                           "from %g m to %g m along %c; put it between them, or make domain.to "
                           "higher", w->where, path, rim, low, high, "xyz"[DIM - 1]);
    s->open |= shape_side(DIM - 1, true);
    s->sunk = high - rim;
    return STATUS_DONE;
}

int input_walls(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "wall");

    TRY(input_check_objects(group, "wall"));
    if (!(in->wall = input_objects(group, sizeof *in->wall)))
        return STATUS_FAILED;
    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        struct input_wall *w = &in->wall[in->wall_count++];

        snprintf(w->name, sizeof w->name, "%s", scene_name(node));
        snprintf(w->where, sizeof w->where, "%s", scene_where(node));
        snprintf(w->path, sizeof w->path, "wall.%s", w->name);
        TRY(fill_shares(scene, node, w->path,
                        (struct share[]){ { shape_params, &w->set.shape },
                                          { settings_wall_params, &w->set },
                                          { motion_params, &w->motion } }, 3));
        frame_of(in, &w->set.shape);
        TRY(rim_of(w->path, w));
        TRY(shape_check(&w->set.shape, w->path, w->where));
        TRY(idle_wall(node, w->path, &w->motion));
        TRY(motion_prepare(&w->motion, w->path, w->where));
    }
    return STATUS_DONE;
}

static int fill_group(struct scene *scene, const struct scene_node *node, const char *path,
                      const struct body_group *group, void *into)
{
    TRY(scene_fill(scene, node, path, group->params, NULL, DIM, into));
    return group->params == motion_params ? idle_wall(node, path, into) : STATUS_DONE;
}

static int fill_named(struct scene *scene, const struct scene_node *node, const char *path,
                      const struct body_group *group, char *into, int *count)
{
    TRY(input_check_objects(node, path));
    if (scene_count(node) > group->most)
        return status_fail(STATUS_BAD_SCENE, "%s: %s has %d members, and a body may have %d",
                           scene_where(node), path, scene_count(node), group->most);
    for (int i = 0; i < scene_count(node); i++) {
        const struct scene_node *member = scene_at(node, i);
        char *to = into + (size_t)i * group->size, name[160];
        snprintf(name, sizeof name, "%s.%s", path, scene_name(member));
        *(const char **)(void *)to = scene_name(member);
        TRY(fill_group(scene, member, name, group, to));
        *count = i + 1;
    }
    return STATUS_DONE;
}

/* Its own keys, and those of the groups inside. */
static int fill_body(struct scene *scene, const struct scene_node *node, struct input_body *b)
{
    const struct body_identity *kind = &b->kind->identity;
    const char *also[INPUT_KEYS] = { NULL };
    int n = 0;

    for (const struct body_group *g = kind->groups; g && g->name; g++)
        also[n++] = g->name;
    TRY(scene_fill(scene, node, b->path, kind->params, also, DIM, b->params));
    for (const struct body_group *g = kind->groups; g && g->name; g++) {
        const struct scene_node *inside = scene_child(node, g->name);
        char path[120], *into = (char *)b->params;
        int *count = (int *)(void *)(into + g->count);
        snprintf(path, sizeof path, "%s.%s", b->path, g->name);
        if (inside && g->most == 1)
            TRY(fill_group(scene, inside, path, g, into + g->at));
        if (inside && g->most == 1)
            *count = 1;
        if (inside && g->most > 1)
            TRY(fill_named(scene, inside, path, g, into + g->at, count));
    }
    return STATUS_DONE;
}

static int read_bodies_of(struct scene *scene, const struct body_kind *kind, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), kind->identity.group);

    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        struct input_body *b = &in->body[in->bodies++];

        snprintf(b->name, sizeof b->name, "%s", scene_name(node));
        snprintf(b->path, sizeof b->path, "%s.%s", kind->identity.group, b->name);
        snprintf(b->where, sizeof b->where, "%s", scene_where(node));
        b->kind = kind;
        if (!(b->params = status_alloc(1, kind->identity.size)))
            return STATUS_FAILED;
        TRY(fill_body(scene, node, b));
        TRY(idle_body(node, b->path, b));
        b->kind = kind->identity.choose ? kind->identity.choose(b->params) : kind;
    }
    return STATUS_DONE;
}

int input_bodies(struct scene *scene, struct input *in)
{
    int n = 0;

    for (int k = 0; bodies_table[k]; k++) {
        const char *name = bodies_table[k]->identity.group;
        const struct scene_node *group = scene_child(scene_root(scene), name);
        TRY(input_check_objects(group, name));
        n += scene_count(group);
    }
    if (n > INPUT_BODIES)
        return status_fail(STATUS_BAD_SCENE, "%s: %d bodies and beams are more than the %d that a "
                           "scene may have", scene_path(scene), n, INPUT_BODIES);
    if (!(in->body = status_alloc(n + 1, sizeof *in->body)))
        return STATUS_FAILED;
    for (int k = 0; bodies_table[k]; k++)
        TRY(read_bodies_of(scene, bodies_table[k], in));
    return STATUS_DONE;
}
