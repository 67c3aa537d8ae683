/* read.c -- a scene file, or a value from the command line, becomes a tree of nodes. */
#include "base/status.h"
#include "scene/parse.h"

#include <stdlib.h>

int scene_read_string(struct scene_pool *keep, const char *source, struct scene_node **root)
{
    struct scene_pool pool = { 0 };
    struct scene_parse parse = { .pool = &pool, .keep = keep };
    int status;

    *root = scene_node_create(keep, "", SCENE_GROUP, (struct scene_place){ 0 });
    if (!*root)
        return STATUS_FAILED;
    parse.level[0].node = *root;
    status = scene_source_string(&parse, source);
    scene_pool_free(&pool);
    return status;
}

static int read_into(struct scene *scene, const char *path)
{
    struct scene_pool pool = { 0 };
    struct scene_parse parse = { .pool = &pool, .keep = &scene->pool };
    int status;

    scene->path = scene_pool_print(&scene->pool, "%s", path);
    scene->root = scene_node_create(&scene->pool, "", SCENE_GROUP,
                                    (struct scene_place){ scene->path, 0 });
    if (!scene->path || !scene->root)
        return STATUS_FAILED;
    parse.level[0].node = scene->root;
    status = scene_source_file(&parse, scene->path);
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
