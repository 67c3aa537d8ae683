/* input.c -- reads every key of a scene by the rows of all tables. */
#include "plan/input.h"

#include "base/status.h"
#include "plan/catalogue.h"
#include "plan/idle.h"
#include "pressure/pressure.h"
#include "scene/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One set of rows that reads its share of a group's keys. */
struct share {
    const struct param *rows;
    void *into;
};

enum { KEYS = 96 };

static int add_keys(const struct param *rows, const char **keys, int n)
{
    for (const struct param *r = rows; r && r->key && n < KEYS - 1; r++)
        keys[n++] = r->key;
    keys[n] = NULL;
    return n;
}

/* Several sets of rows read one group: each knows the keys of the others. */
static int fill_shares(struct scene *scene, const struct scene_node *group, const char *path,
                       const struct share *share, int shares)
{
    for (int i = 0; i < shares; i++) {
        const char *also[KEYS] = { NULL };
        int n = 0;
        for (int j = 0; j < shares; j++)
            if (j != i)
                n = add_keys(share[j].rows, also, n);
        TRY(scene_fill(scene, group, path, share[i].rows, also, DIM, share[i].into));
    }
    return STATUS_DONE;
}

static int read_top(struct scene *scene, struct input *in)
{
    const struct scene_node *root = scene_root(scene);

    TRY(scene_fill(scene, root, "", settings_params, catalogue_groups, DIM, &in->set));
    if (in->set.dimension != DIM)
        return status_fail(STATUS_BAD_SCENE, "dimension = %d, but this program is for %d",
                           in->set.dimension, DIM);
    TRY(scene_fill(scene, scene_child(root, "kernel"), "kernel", settings_kernel_params, NULL,
                   DIM, &in->kernel));
    TRY(scene_fill(scene, scene_child(root, "domain"), "domain", settings_domain_params, NULL,
                   DIM, &in->domain));
    TRY(scene_fill(scene, scene_child(root, "reference"), "reference",
                   settings_reference_params, NULL, DIM, &in->reference));
    return scene_fill(scene, scene_child(root, "output"), "output", settings_output_params,
                      NULL, DIM, &in->output);
}

/* Before any shape is read: a frame goes around the domain, so many spacings thick. */
static int check_tank(const struct scene *scene, const struct input *in)
{
    const struct scene_node *root = scene_root(scene), *domain = scene_child(root, "domain");
    const char *where = domain ? scene_where(domain) : scene_path(scene);

    if (scene_count(scene_child(root, "fluid")) + scene_count(scene_child(root, "wall")) == 0)
        return STATUS_DONE;
    if (isnan(in->set.spacing))
        return status_fail(STATUS_BAD_SCENE, "%s: spacing is needed: the distance of particles "
                           "[m], such as 0.002", scene_path(scene));
    for (int d = 0; d < DIM; d++) {
        if (isnan(in->domain.from[d]) || isnan(in->domain.to[d]))
            return status_fail(STATUS_BAD_SCENE, "%s: domain.from and domain.to are needed: the "
                               "lowest and highest corner of the box that counts [m]", where);
        if (!(in->domain.to[d] > in->domain.from[d]))
            return status_fail(STATUS_BAD_SCENE, "%s: domain.to must lie beyond domain.from in "
                               "every direction, but along %c from is %g m and to is %g m", where,
                               "xyz"[d], in->domain.from[d], in->domain.to[d]);
    }
    return STATUS_DONE;
}

/* A part does not know the line where its keys stand. */
static int complete(const struct part *part, void *self, const char *where)
{
    char text[1024];
    int status = part->complete ? part->complete(self) : STATUS_DONE;

    if (status == STATUS_DONE)
        return status;
    snprintf(text, sizeof text, "%s", status_message());
    status_clear();
    return status_fail(status, "%s: %s", where, text);
}

static int read_eos(struct scene *scene, const struct engine *engine, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "eos");
    const char *also[KEYS] = { NULL };
    struct eos *eos;
    bool open;
    int n = 0;

    for (int i = 0; pressure_table[i]; i++)
        n = add_keys(pressure_table[i]->params, also, n);
    TRY(scene_fill(scene, group, "eos", settings_eos_params, also, DIM, &in->eos));
    in->pressure = catalogue_part(pressure_table, in->eos.type);
    in->walls = catalogue_part(engine->walls, in->set.walls);
    in->pressure_self = status_alloc(1, in->pressure->size);
    if (!in->pressure_self)
        return STATUS_FAILED;
    n = add_keys(settings_eos_params, also, 0);
    TRY(scene_fill(scene, group, "eos", in->pressure->params, also, DIM, in->pressure_self));
    eos = in->pressure_self;
    open = isnan(eos->c0);
    TRY(complete(in->pressure, eos, group ? scene_where(group) : scene_path(scene)));
    if (open && !isnan(eos->c0))
        scene_computed(scene, "eos", "c0", eos->c0);
    if (in->walls->size && !(in->walls_self = status_alloc(1, in->walls->size)))
        return STATUS_FAILED;
    return STATUS_DONE;
}

static bool has_gravity(const struct input *in)
{
    for (int d = 0; d < DIM; d++)
        if (in->set.gravity[d] != 0)
            return true;
    return false;
}

/* In the order of the table, whatever the order in the scene. */
static int read_effects(struct scene *scene, const struct engine *engine, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "effects");
    const char *names[KEYS] = { NULL };

    for (int i = 0, n = 0; engine->effects[i] && n < KEYS - 1; i++)
        if (!catalogue_implied(engine->effects[i]))
            names[n++] = engine->effects[i]->name;
    TRY(scene_fill(scene, group, "effects", NULL, names, DIM, NULL));
    for (int i = 0; engine->effects[i]; i++) {
        const struct part *part = engine->effects[i];
        const struct scene_node *node = scene_child(group, part->name);
        struct input_effect *e = &in->effect[in->effects];

        if (catalogue_implied(part) ? !has_gravity(in) || in->fluids == 0 : !node)
            continue;
        if (in->effects == INPUT_EFFECTS)
            return status_fail(STATUS_BAD_SCENE, "more than %d effects", INPUT_EFFECTS);
        if (node && !scene_is_group(node))
            return status_fail(STATUS_BAD_SCENE, "%s: effects.%s must be a group: %s = { }",
                               scene_where(node), part->name, part->name);
        snprintf(e->path, sizeof e->path, "effects.%s", part->name);
        e->part = part;
        e->self = part->size ? status_alloc(1, part->size) : NULL;
        in->effects++;
        if (part->size && !e->self)
            return STATUS_FAILED;
        if (node)
            TRY(scene_fill(scene, node, e->path, part->params, NULL, DIM, e->self));
    }
    return STATUS_DONE;
}

/* The group of named objects `group`: checks that each is a group itself. */
static int check_objects(const struct scene_node *group, const char *name)
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

static void *objects(const struct scene_node *group, size_t size)
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

static int read_fluids(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "fluid");

    TRY(check_objects(group, "fluid"));
    if (!(in->fluid = objects(group, sizeof *in->fluid)))
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

static int read_walls(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "wall");

    TRY(check_objects(group, "wall"));
    if (!(in->wall = objects(group, sizeof *in->wall)))
        return STATUS_FAILED;
    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        struct input_wall *w = &in->wall[in->wall_count++];
        char path[80];

        snprintf(w->name, sizeof w->name, "%s", scene_name(node));
        snprintf(w->where, sizeof w->where, "%s", scene_where(node));
        snprintf(path, sizeof path, "wall.%s", w->name);
        TRY(fill_shares(scene, node, path,
                        (struct share[]){ { shape_params, &w->set.shape },
                                          { settings_wall_params, &w->set },
                                          { walls_motion_params, &w->motion } }, 3));
        frame_of(in, &w->set.shape);
        TRY(shape_check(&w->set.shape, path, w->where));
        TRY(idle_wall(node, path, &w->motion));
        TRY(walls_motion_prepare(&w->motion, path, w->where));
    }
    return STATUS_DONE;
}

static int read_probes(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "probe");

    TRY(check_objects(group, "probe"));
    if (!(in->probe = objects(group, sizeof *in->probe)))
        return STATUS_FAILED;
    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        struct input_probe *p = &in->probe[in->probes++];
        char path[80];

        snprintf(p->name, sizeof p->name, "%s", scene_name(node));
        snprintf(path, sizeof path, "probe.%s", p->name);
        TRY(scene_fill(scene, node, path, settings_probe_params, NULL, DIM, &p->set));
        if (in->domain.periodic & 1u << (DIM - 1) && strcmp(p->set.what, "height") == 0)
            return status_fail(STATUS_BAD_SCENE, "%s: %s: there is no height where the vertical "
                               "repeats (domain.periodic); take what = \"pressure\" or "
                               "\"velocity\"", scene_where(node), path);
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
        TRY(scene_fill(scene, node, b->path, kind->identity.params, NULL, DIM, b->params));
        TRY(idle_body(node, b->path, b));
        b->kind = kind->identity.choose ? kind->identity.choose(b->params) : kind;
    }
    return STATUS_DONE;
}

static int read_bodies(struct scene *scene, struct input *in)
{
    int n = 0;

    for (int k = 0; bodies_table[k]; k++) {
        const char *name = bodies_table[k]->identity.group;
        const struct scene_node *group = scene_child(scene_root(scene), name);
        TRY(check_objects(group, name));
        n += scene_count(group);
    }
    if (n > INPUT_BODIES)
        return status_fail(STATUS_BAD_SCENE, "%s: %d beams are more than the %d that a scene may "
                           "have", scene_path(scene), n, INPUT_BODIES);
    if (!(in->body = status_alloc(n + 1, sizeof *in->body)))
        return STATUS_FAILED;
    for (int k = 0; bodies_table[k]; k++)
        TRY(read_bodies_of(scene, bodies_table[k], in));
    return STATUS_DONE;
}

int input_read(struct scene *scene, const struct engine *engine, struct input *in)
{
    *in = (struct input){0};
    catalogue_prepare(engine);
    TRY(read_top(scene, in));
    TRY(check_tank(scene, in));
    TRY(read_eos(scene, engine, in));
    TRY(read_fluids(scene, in));
    TRY(read_effects(scene, engine, in));
    TRY(read_walls(scene, in));
    TRY(read_bodies(scene, in));
    TRY(read_probes(scene, in));
    return idle_scene(scene, in);
}

void input_free(struct input *in)
{
    for (int i = 0; i < in->effects; i++)
        free(in->effect[i].self);
    for (int i = 0; i < in->bodies; i++)
        free(in->body[i].params);
    free(in->pressure_self);
    free(in->walls_self);
    free(in->fluid);
    for (int i = 0; i < in->wall_count; i++)
        walls_motion_free(&in->wall[i].motion);
    free(in->wall);
    free(in->body);
    free(in->probe);
    *in = (struct input){0};
}
