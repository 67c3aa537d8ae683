/* idle.c -- keys that do nothing without another: the user wants something that
 * will not happen.
 *
 * A key counts as given when its value is not its default, so that scene.used, where all
 * of them stand, is as good as the scene. */
#include "plan/idle.h"

#include "base/status.h"
#include "scene/scene.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NEEDS = 8 };

struct rule {
    const char *key, *needs[NEEDS]; /* one of these */
};

#define MOVES { "velocity", "amplitude", "path", "spin", "swing", "turn" }
static const struct rule motion_rules[] = {
    { "amplitude", { "frequency" } },
    { "swing", { "frequency" } },
    { "frequency", { "amplitude", "swing" } },
    { "phase", { "frequency" } },
    { "direction", { "path" } },
    { "pivot", { "spin", "swing", "turn" } },
    { "start", MOVES },
    { "stop", MOVES },
    { 0 },
};

static const struct rule drop_rules[] = {
    { "flow_pressure", { "flow_size" } },
    { "flow_size", { "flow_pressure" } },
    { 0 },
};

static const struct rule body_rules[] = {
    { "follower", { "tip_force", "load" } },
    { 0 },
};

static bool differs(double value, double fallback)
{
    return isnan(fallback) ? !isnan(value) : value != fallback;
}

static bool is_given(const struct param *row, const void *values)
{
    const char *at = (const char *)values + row->offset;

    switch (row->type) {
    case PARAM_NUMBER:
        return differs(*(const double *)at, row->fallback);
    case PARAM_INTEGER:
        return *(const int *)at != (isnan(row->fallback) ? INT_MIN : (int)row->fallback);
    case PARAM_FLAG:
        return *(const bool *)at != (row->fallback != 0);
    case PARAM_WORD:
        return strcmp(*(const char *const *)at, row->words[0]) != 0;
    case PARAM_TEXT:
        return (*(const char *const *)at)[0] != '\0';
    case PARAM_VECTOR:
        for (int d = 0; d < DIM; d++)
            if (differs(((const double *)at)[d], row->fallback))
                return true;
        return false;
    case PARAM_POINTS:
    case PARAM_PAIRS:
        return ((const struct param_points *)at)->n > 0;
    case PARAM_WORDS:
        return *(const unsigned *)at != 0;
    }
    return false;
}

static bool key_given(const struct param *rows, const void *values, const char *key)
{
    for (; rows->key; rows++)
        if (strcmp(rows->key, key) == 0)
            return is_given(rows, values);
    return false;
}

static const char *where(const struct scene_node *group, const char *key)
{
    const struct scene_node *node = scene_child(group, key);

    return scene_where(node ? node : group);
}

static void list(const char *const *words, char *to, size_t room)
{
    size_t n = 0;

    for (int i = 0; i < NEEDS && words[i] && n < room; i++)
        n += (size_t)snprintf(to + n, room - n, "%s%s", i ? " or " : "", words[i]);
}

static int check_rules(const struct scene_node *node, const char *path, const struct param *rows,
                       const void *values, const struct rule *rule)
{
    for (; rule->key; rule++) {
        bool served = false;
        char needs[120];
        if (!key_given(rows, values, rule->key))
            continue;
        for (int i = 0; i < NEEDS && rule->needs[i]; i++)
            served |= key_given(rows, values, rule->needs[i]);
        list(rule->needs, needs, sizeof needs);
        if (!served)
            return status_fail(STATUS_BAD_SCENE, "%s: %s.%s does nothing without %s; give that, or "
                               "leave %s out", where(node, rule->key), path, rule->key, needs,
                               rule->key);
    }
    return STATUS_DONE;
}

/* Keys of flows: those that the kind names, and its origin. */
static int check_flow(const struct scene_node *node, const char *path, const struct flow *f)
{
    const struct flow_kind *kind = flow_find(f);

    for (const struct param *row = flow_params; row->key; row++) {
        const bool known = strcmp(row->key, "flow") == 0
                           || (kind && (strcmp(row->key, "flow_centre") == 0
                                        || strstr(kind->keys, row->key)
                                        || (kind->may && strstr(kind->may, row->key))));
        if (!known && is_given(row, f))
            return status_fail(STATUS_BAD_SCENE, "%s: %s.%s does nothing with flow = \"%s\" (%s); "
                               "choose a flow that has it (`list flows`), or leave %s out",
                               where(node, row->key), path, row->key, f->type, row->about,
                               row->key);
    }
    return kind && kind->may ? check_rules(node, path, flow_params, f, drop_rules) : STATUS_DONE;
}

int idle_fluid(const struct scene_node *node, const char *path, const struct input_fluid *f)
{
    TRY(check_flow(node, path, &f->flow));
    if (flow_find(&f->flow) && strcmp(f->set.initial, "released") == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.initial = \"released\" solves for the "
                           "pressure of fluid at rest, which would replace that of flow = "
                           "\"%s\"; leave one of them out", where(node, "initial"), path,
                           f->flow.type);
    if (!isnan(f->set.surface) && strcmp(f->set.initial, "hydrostatic") != 0)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.surface does nothing with initial = \"%s\", "
                           "where there is no depth; leave one of them out",
                           where(node, "surface"), path, f->set.initial);
    return STATUS_DONE;
}

int idle_wall(const struct scene_node *node, const char *path, const struct motion *m)
{
    return check_rules(node, path, motion_params, m, motion_rules);
}

/* A ratio of 0 says that it shall not count. */
static void doubt_ratio(const struct scene_node *node, const char *path, const struct input_body *b)
{
    for (const struct param *row = b->kind->identity.params; row->key; row++)
        if (strcmp(row->key, "nu") == 0 && is_given(row, b->params)
            && *(const double *)((const char *)b->params + row->offset) != 0
            && !key_given(b->kind->identity.params, b->params, "plane"))
            status_warn("%s: %s.nu counts with plane = \"strain\" only, a plate that is wide; "
                        "without it the beam is a narrow strip", where(node, "nu"), path);
}

int idle_body(const struct scene_node *node, const char *path, const struct input_body *b)
{
    doubt_ratio(node, path, b);
    return check_rules(node, path, b->kind->identity.params, b->params, body_rules);
}

static int check_probes(const struct scene *scene, const struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "probe");

    if (in->probes == 0 || in->fluids > 0)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: probe.%s has nothing to measure, as the scene has no "
                       "fluid; name one, or leave the probe out", scene_where(scene_at(group, 0)),
                       in->probe[0].name);
}

static bool has_frame(const struct input *in)
{
    for (int i = 0; i < in->wall_count; i++)
        if (strcmp(in->wall[i].set.shape.type, "frame") == 0)
            return true;
    return false;
}

static void doubt_frame(const struct scene_node *root, const struct input *in)
{
    static const char *const keys[] = { "open", "lid" };
    const struct scene_node *domain = scene_child(root, "domain");

    for (int i = 0; i < 2 && !has_frame(in); i++)
        if (key_given(settings_domain_params, &in->domain, keys[i]))
            status_warn("%s: domain.%s is about walls of type \"frame\", and there is none",
                        where(domain, keys[i]), keys[i]);
}

/* Kernels of uses that no effect of the scene has. */
static void doubt_kernels(const struct scene_node *root, const struct input *in)
{
    static const char *const keys[PART_KERNELS] = {
        [PART_PRESSURE] = "pressure", [PART_VISCOSITY] = "viscosity"
    };
    const struct scene_node *kernel = scene_child(root, "kernel");

    for (int use = 0; use < PART_KERNELS; use++) {
        bool used = !keys[use];
        for (int i = 0; i < in->effects; i++)
            used |= in->effect[i].part->as.law && (int)in->effect[i].part->as.law->kernel == use;
        if (!used && key_given(settings_kernel_params, &in->kernel, keys[use]))
            status_warn("%s: kernel.%s does nothing here, as no effect of the scene uses it",
                        where(kernel, keys[use]), keys[use]);
    }
}

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

static void doubt_top(const struct scene_node *root, const struct input *in)
{
    if (!isnan(in->set.substep) && !begins(in->set.method, "staggered")
        && !begins(in->set.method, "mri"))
        status_warn("%s: substep is for the methods staggered and mri; others take none",
                    where(root, "substep"));
    if (in->fluids > 0 && in->wall_count + in->bodies == 0
        && key_given(settings_params, &in->set, "walls"))
        status_warn("%s: walls = \"%s\" does nothing, as the scene has no solids",
                    where(root, "walls"), in->set.walls);
    if (in->fluids == 0 && in->effects > 0)
        status_warn("%s: effects act on fluid, and the scene has none",
                    scene_where(scene_child(root, "effects")));
}

/* Keys of bodies that are about the water around them. */
static void doubt_dry(const struct scene_node *root, const struct input *in)
{
    static const char *const keys[] = { "uplift", "film" };

    for (int i = 0; i < in->bodies && in->fluids == 0; i++) {
        const struct body_identity *b = &in->body[i].kind->identity;
        const struct scene_node *node = scene_child(scene_child(root, b->group), in->body[i].name);
        for (int k = 0; k < 2; k++)
            if (key_given(b->params, in->body[i].params, keys[k]))
                status_warn("%s: %s.%s does nothing, as the scene has no fluid", where(node, keys[k]),
                            in->body[i].path, keys[k]);
    }
}

int idle_scene(const struct scene *scene, const struct input *in)
{
    const struct scene_node *root = scene_root(scene);

    TRY(check_probes(scene, in));
    doubt_frame(root, in);
    doubt_kernels(root, in);
    doubt_top(root, in);
    doubt_dry(root, in);
    idle_methods(root, in);
    return STATUS_DONE;
}
