/* given.c -- a scene as its files and the command line give it, a line for each setting. */
#include "scene/tree.h"

/* The names on the way to a node. */
struct address {
    const struct address *above; /* NULL: the top level */
    const char *name;
};

static void write_address(const struct address *at, FILE *to)
{
    if (at->above) {
        write_address(at->above, to);
        fputc('.', to);
    }
    fputs(at->name, to);
}

static void write_group(const struct scene_node *group, const struct address *above, FILE *to);

static void write_setting(const struct scene_node *node, const struct address *above, FILE *to)
{
    const struct address at = { above, node->name };

    if (node->kind == SCENE_GROUP && node->n > 0 && !node->off) {
        write_group(node, &at, to);
        return;
    }
    write_address(&at, to);
    fputs(" = ", to);
    if (node->kind == SCENE_GROUP)
        fputs(node->off ? "off" : "{ }", to);
    else
        scene_write_node(node, to);
    fputc('\n', to);
}

static void write_group(const struct scene_node *group, const struct address *above, FILE *to)
{
    for (int i = 0; i < group->n; i++)
        write_setting(group->child[i], above, to);
}

void scene_write_given(const struct scene *scene, FILE *to)
{
    write_group(scene->root, NULL, to);
}
