/* input.c -- reads every key of a scene by the rows of all tables; named objects in
 * input-objects.c. */
#include "plan/input.h"

#include "base/status.h"
#include "plan/catalogue.h"
#include "plan/idle.h"
#include "plan/input-objects.h"
#include "pressure/pressure.h"
#include "scene/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    TRY(scene_fill(scene, scene_child(root, "disturbance"), "disturbance",
                   settings_disturbance_params, NULL, DIM, &in->disturbance));
    TRY(scene_fill(scene, scene_child(root, "pcisph"), "pcisph", settings_pcisph_params, NULL,
                   DIM, &in->pcisph));
    TRY(scene_fill(scene, scene_child(root, "mps"), "mps", settings_mps_params, NULL, DIM,
                   &in->mps));
    settings_mps_complete(&in->mps);
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

static bool has_row(const struct param *rows, const char *key)
{
    while (rows->key && strcmp(rows->key, key) != 0)
        rows++;
    return rows->key != NULL;
}

/* Another type on the command line: what the file says to its own type goes with that.  What
 * neither knows, and what the command line gives itself, is refused as ever. */
static void leave_out_others(struct scene *scene)
{
    const struct scene_node *group = scene_child(scene_root(scene), "eos");
    const char *was = pressure_table[0]->name, *now = was, *gap = "";
    const struct part *old = NULL, *new = NULL;
    char keys[400] = "";
    size_t n = 0;

    if (scene_changed(group, "type", &was, &now)) {
        old = catalogue_part(pressure_table, was);
        new = catalogue_part(pressure_table, now);
    }
    for (const struct param *row = old && new ? old->params : NULL; row && row->key; row++) {
        const struct scene_node *node = scene_child(group, row->key);

        if (!node || scene_line(node) == 0 || has_row(new->params, row->key)
            || n >= sizeof keys)
            continue;
        n += (size_t)snprintf(keys + n, sizeof keys - n, "%seos.%s (%s)", gap, row->key,
                              scene_where(node));
        gap = ", ";
        scene_leave_out(scene, "eos", row->key);
    }
    if (n > 0)
        status_warn("eos.type = \"%s\" on the command line leaves out what belongs to \"%s\", "
                    "the type without it: %s", now, was, keys);
}

static int read_eos(struct scene *scene, const struct engine *engine, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "eos");
    const char *also[INPUT_KEYS] = { NULL };
    struct eos *eos;
    bool open;
    int n = 0;

    leave_out_others(scene);
    for (int i = 0; pressure_table[i]; i++)
        n = input_add_keys(pressure_table[i]->params, also, n);
    TRY(scene_fill(scene, group, "eos", settings_eos_params, also, DIM, &in->eos));
    in->pressure = catalogue_part(pressure_table, in->eos.type);
    in->walls = catalogue_part(engine->walls, in->set.walls);
    in->pressure_self = status_alloc(1, in->pressure->size);
    if (!in->pressure_self)
        return STATUS_FAILED;
    n = input_add_keys(settings_eos_params, also, 0);
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
    const char *names[INPUT_KEYS] = { NULL };

    for (int i = 0, n = 0; engine->effects[i] && n < INPUT_KEYS - 1; i++)
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

int input_read(struct scene *scene, const struct engine *engine, struct input *in)
{
    *in = (struct input){0};
    catalogue_prepare(engine);
    TRY(read_top(scene, in));
    TRY(check_tank(scene, in));
    TRY(read_eos(scene, engine, in));
    TRY(input_fluids(scene, in));
    TRY(read_effects(scene, engine, in));
    TRY(input_walls(scene, in));
    TRY(input_bodies(scene, in));
    TRY(input_contacts(scene, in));
    TRY(input_probes(scene, in));
    TRY(input_panels(scene, in));
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
    for (int i = 0; i < in->fluids; i++)
        shape_free(&in->fluid[i].set.shape);
    free(in->fluid);
    for (int i = 0; i < in->wall_count; i++) {
        motion_free(&in->wall[i].motion);
        shape_free(&in->wall[i].set.shape);
    }
    free(in->wall);
    free(in->body);
    free(in->pairs.of);
    free(in->probe);
    free(in->panels.of);
    *in = (struct input){0};
}
