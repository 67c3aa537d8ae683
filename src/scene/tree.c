/* tree.c -- the nodes of a scene and the questions one may ask them. */
#include "scene/tree.h"
#include "base/status.h"

#include <stdlib.h>
#include <string.h>

struct scene_node *scene_node_create(struct scene_pool *pool, const char *name,
                                     enum scene_kind kind, struct scene_place at)
{
    struct scene_node *node = scene_pool_take(pool, sizeof *node);

    if (!node)
        return NULL;
    node->kind = kind;
    node->at = at;
    node->name = name[0] ? scene_pool_print(pool, "%s", name) : "";
    return node->name ? node : NULL;
}

int scene_node_add(struct scene_pool *pool, struct scene_node *parent, struct scene_node *child)
{
    struct scene_node **larger =
        scene_pool_grow(pool, parent->child, parent->n, &parent->room, sizeof *larger);

    if (!larger)
        return STATUS_FAILED;
    parent->child = larger;
    parent->child[parent->n++] = child;
    return STATUS_DONE;
}

int scene_node_put(struct scene_pool *pool, struct scene_node *group, struct scene_node *child)
{
    for (int i = 0; i < group->n; i++)
        if (strcmp(group->child[i]->name, child->name) == 0) {
            group->child[i] = child;
            return STATUS_DONE;
        }
    return scene_node_add(pool, group, child);
}

struct scene_node *scene_node_find(const struct scene_node *group, const char *name)
{
    if (!group || group->kind != SCENE_GROUP)
        return NULL;
    for (int i = 0; i < group->n; i++)
        if (strcmp(group->child[i]->name, name) == 0)
            return group->child[i];
    return NULL;
}

void scene_node_remove(struct scene_node *group, const struct scene_node *child)
{
    int n = 0;

    for (int i = 0; i < group->n; i++)
        if (group->child[i] != child)
            group->child[n++] = group->child[i];
    group->n = n;
}

void scene_free(struct scene **scene)
{
    if (!scene || !*scene)
        return;
    scene_pool_free(&(*scene)->pool);
    free(*scene);
    *scene = NULL;
}

const char *scene_path(const struct scene *scene)
{
    return scene->path;
}

const struct scene_node *scene_root(const struct scene *scene)
{
    return scene->root;
}

const struct scene_node *scene_child(const struct scene_node *group, const char *name)
{
    const struct scene_node *child = scene_node_find(group, name);

    return child && !child->off ? child : NULL;
}

bool scene_changed(const struct scene_node *group, const char *key, const char **was,
                   const char **now)
{
    const struct scene_node *child = scene_node_find(group, key);

    if (!child || child->at.file || child->kind != SCENE_TEXT
        || (child->was && child->was->kind != SCENE_TEXT))
        return false;
    if (child->was)
        *was = child->was->text;
    *now = child->text;
    return true;
}

void scene_leave_out(struct scene *scene, const char *group, const char *key)
{
    struct scene_node *node = scene_node_find(scene->root, group);

    if (node)
        scene_node_remove(node, scene_node_find(node, key));
}

int scene_count(const struct scene_node *group)
{
    return group ? group->n : 0;
}

const struct scene_node *scene_at(const struct scene_node *group, int i)
{
    return group && i >= 0 && i < group->n ? group->child[i] : NULL;
}

const char *scene_name(const struct scene_node *node)
{
    return node->name;
}

bool scene_is_group(const struct scene_node *node)
{
    return node && node->kind == SCENE_GROUP;
}

const char *scene_file(const struct scene_node *node)
{
    return node->at.file ? node->at.file : "command line";
}

int scene_line(const struct scene_node *node)
{
    return node->at.file ? node->at.line : 0;
}

const char *scene_where(const struct scene_node *node)
{
    static char text[2][256];
    static int turn;

    if (node->at.file || !node->beside)
        return scene_place_text(node->at);
    turn = !turn;
    snprintf(text[turn], sizeof text[turn], "command line (the file has %.64s and no %.64s)", node->beside,
             node->name);
    return text[turn];
}

const char *scene_place_text(struct scene_place at)
{
    static char text[2][1024];
    static int turn;

    turn = !turn;
    if (!at.file)
        return "command line";
    if (at.line > 0)
        snprintf(text[turn], sizeof text[turn], "%s:%d", at.file, at.line);
    else
        snprintf(text[turn], sizeof text[turn], "%s", at.file);
    return text[turn];
}
