/* read.c -- a scene file becomes a tree of nodes, by way of libconfig. */
#include "base/status.h"
#include "scene/text.h"

#include <libconfig.h>
#include <stdlib.h>
#include <string.h>

/* What text.c lets through and libconfig still refuses. */
static int refuse_syntax(const struct scene_text *text, const config_t *config)
{
    const int line = config_error_line(config);
    const int at = line < 1 ? 0 : line > text->lines ? text->lines - 1 : line - 1;

    return status_fail(STATUS_BAD_SCENE, "%s: %s; settings are written NAME = VALUE;",
                       scene_place_text(text->place[at]), config_error_text(config));
}

static int take_value(struct scene_pool *pool, const config_setting_t *setting,
                      struct scene_node *node)
{
    switch (config_setting_type(setting)) {
    case CONFIG_TYPE_BOOL:
        node->flag = config_setting_get_bool(setting);
        break;
    case CONFIG_TYPE_STRING:
        node->text = scene_pool_print(pool, "%s", config_setting_get_string(setting));
        return node->text ? STATUS_DONE : STATUS_FAILED;
    case CONFIG_TYPE_FLOAT:
        node->number = config_setting_get_float(setting);
        break;
    }
    return STATUS_DONE;
}

static enum scene_kind kind_of(const config_setting_t *setting)
{
    switch (config_setting_type(setting)) {
    case CONFIG_TYPE_GROUP:
        return SCENE_GROUP;
    case CONFIG_TYPE_LIST:
        return SCENE_LIST;
    case CONFIG_TYPE_BOOL:
        return SCENE_FLAG;
    case CONFIG_TYPE_STRING:
        return SCENE_TEXT;
    default: /* text.c writes every number as a float */
        return SCENE_NUMBER;
    }
}

/* Copies what the setting holds into node; text.c has bounded the depth. */
static int copy(const struct scene_text *text, const config_setting_t *setting,
                struct scene_node *node)
{
    if (!config_setting_is_aggregate(setting))
        return take_value(text->keep, setting, node);
    for (int i = 0; i < config_setting_length(setting); i++) {
        const config_setting_t *from = config_setting_get_elem(setting, (unsigned)i);
        const int line = (int)config_setting_source_line(from);
        struct scene_node *to = scene_node_create(text->keep, config_setting_name(from),
                                                  kind_of(from), text->place[line - 1]);

        if (!to)
            return STATUS_FAILED;
        TRY(copy(text, from, to));
        TRY(scene_node_add(text->keep, node, to));
    }
    return STATUS_DONE;
}

/* From the finished text to nodes below root. */
static int parse(const struct scene_text *text, struct scene_node *root)
{
    config_t config;
    int status;

    config_init(&config);
    if (config_read_string(&config, text->bytes))
        status = copy(text, config_root_setting(&config), root);
    else
        status = refuse_syntax(text, &config);
    config_destroy(&config);
    return status;
}

int scene_read_string(struct scene_pool *keep, const char *source, struct scene_node **root)
{
    struct scene_pool pool = { 0 };
    struct scene_text text = { .pool = &pool, .keep = keep };
    int status = STATUS_FAILED;

    *root = scene_node_create(keep, "", SCENE_GROUP, (struct scene_place){ 0 });
    if (*root)
        status = scene_text_string(&text, source);
    if (status == STATUS_DONE)
        status = parse(&text, *root);
    scene_pool_free(&pool);
    return status;
}

static int read_into(struct scene *scene, const char *path)
{
    struct scene_pool pool = { 0 };
    struct scene_text text = { .pool = &pool, .keep = &scene->pool };
    int status;

    scene->path = scene_pool_print(&scene->pool, "%s", path);
    scene->root = scene_node_create(&scene->pool, "", SCENE_GROUP,
                                    (struct scene_place){ scene->path, 0 });
    if (!scene->path || !scene->root)
        return STATUS_FAILED;
    status = scene_text_file(&text, scene->path);
    if (status == STATUS_DONE)
        status = parse(&text, scene->root);
    scene_pool_free(&pool);
    if (status == STATUS_DONE && scene->root->n == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: this scene is empty; it holds settings such as "
                           "NAME = VALUE; and groups such as NAME = { ... };", path);
    return status;
}

int scene_read(const char *path, struct scene **out)
{
    struct scene *scene = status_alloc(1, sizeof *scene);
    int status;

    *out = NULL;
    if (!scene)
        return STATUS_FAILED;
    status = read_into(scene, path);
    if (status != STATUS_DONE)
        scene_free(&scene);
    *out = scene;
    return status;
}
