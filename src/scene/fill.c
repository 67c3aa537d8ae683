/* fill.c -- fills a struct from a group of the scene by its rows. */
#include "base/status.h"
#include "scene/tree.h"

#include <string.h>

struct fill {
    struct scene *scene;
    const struct scene_node *group; /* NULL: the scene does not have it */
    const char *path;
    const struct param *rows;
    const char *const *also;
    int dimension;
};

/* "fluid.water.rho0"; NULL if there is no memory. */
static const char *address(const struct fill *f, const char *key)
{
    return scene_pool_print(&f->scene->pool, "%s%s%s", f->path, f->path[0] ? "." : "", key);
}

static int known_keys(const struct fill *f, const char **names)
{
    int n = 0;

    for (const struct param *row = f->rows; row && row->key; row++, n++)
        if (names)
            names[n] = row->key;
    for (const char *const *also = f->also; also && *also; also++, n++)
        if (names)
            names[n] = *also;
    return n;
}

static void list_names(const char *const *names, char *to, size_t room)
{
    size_t n = 0;

    to[0] = '\0';
    for (int i = 0; names[i] && n < room; i++)
        n += (size_t)snprintf(to + n, room - n, "%s%s", i > 0 ? ", " : "", names[i]);
    if (n >= room)
        memcpy(to + room - 4, "...", 4);
}

static int refuse_key(const struct fill *f, const struct scene_node *node,
                      const char *const *names)
{
    const char *nearest = scene_nearest(node->name, names);
    const char *wrong = address(f, node->name), *right = nearest ? address(f, nearest) : "";
    char known[2000];

    if (!wrong || !right)
        return STATUS_FAILED;
    list_names(names, known, sizeof known);
    return status_fail(STATUS_BAD_SCENE, "%s: unknown key %s%s%s%s (known: %s)",
                       scene_where(node), wrong, nearest ? "; did you mean " : "", right,
                       nearest ? "?" : "", known[0] ? known : "none");
}

static int check_keys(const struct fill *f)
{
    const char **names;

    names = scene_pool_take(&f->scene->pool, (size_t)(known_keys(f, NULL) + 1) * sizeof *names);
    if (!names)
        return STATUS_FAILED;
    known_keys(f, names);
    for (int i = 0; i < scene_count(f->group); i++) {
        bool known = false;

        for (int k = 0; names[k]; k++)
            known = known || strcmp(names[k], f->group->child[i]->name) == 0;
        if (!known)
            return refuse_key(f, f->group->child[i], names);
    }
    return STATUS_DONE;
}

static int check_group(const struct fill *f)
{
    if (!f->group)
        return STATUS_DONE;
    if (!scene_is_group(f->group))
        return status_fail(STATUS_BAD_SCENE, "%s: %s is a value, but a group is expected: "
                           "%s = { NAME = VALUE; ... };", scene_where(f->group), f->path,
                           f->group->name);
    if (f->path[0])
        TRY(scene_note_group(f->scene, f->path));
    return check_keys(f);
}

static int fill_row(const struct fill *f, const struct param *row, char *into)
{
    struct scene_wish wish = { .scene = f->scene, .row = row, .name = address(f, row->key),
                               .node = scene_node_find(f->group, row->key),
                               .dimension = f->dimension, .to = into + row->offset };

    if (!wish.name)
        return STATUS_FAILED;
    if (wish.node)
        TRY(scene_value_read(&wish));
    else if (row->required)
        return status_fail(STATUS_BAD_SCENE, "%s: %s is missing and has no default: %s, %s",
                           f->group ? scene_where(f->group) : f->scene->path, wish.name,
                           scene_value_expected(row, f->dimension), row->about);
    else
        scene_value_default(&wish);
    return scene_value_note(&wish, f->path);
}

/* Values that others read are noted too, until those say more about them. */
static int note_others(const struct fill *f)
{
    for (const char *const *also = f->also; f->group && also && *also; also++) {
        const struct scene_node *node = scene_node_find(f->group, *also);

        if (node && node->kind != SCENE_GROUP)
            TRY(scene_note_raw(f->scene, f->path, node));
    }
    return STATUS_DONE;
}

int scene_fill(struct scene *scene, const struct scene_node *group, const char *path,
               const struct param *rows, const char *const *also, int dimension, void *into)
{
    const struct fill f = { scene, group, path, rows, also, dimension };

    TRY(check_group(&f));
    for (const struct param *row = rows; row && row->key; row++)
        TRY(fill_row(&f, row, into));
    return note_others(&f);
}

int scene_check_named(const struct scene_node *kind)
{
    if (kind && !scene_is_group(kind))
        return status_fail(STATUS_BAD_SCENE, "%s: %s is a value, but named groups are expected: "
                           "%s = { NAME = { ... }; };", scene_where(kind), kind->name, kind->name);
    for (int i = 0; i < scene_count(kind); i++) {
        const struct scene_node *child = kind->child[i];

        if (scene_is_group(child))
            continue;
        if (!child->at.file)
            return status_fail(STATUS_BAD_SCENE, "command line: %s.%s is set for every %s, but "
                               "the scene has none", kind->name, child->name, kind->name);
        return status_fail(STATUS_BAD_SCENE, "%s: %s.%s is a value, but named groups are expected "
                           "here: %s = { NAME = { %s = ...; }; };", scene_where(child),
                           kind->name, child->name, kind->name, child->name);
    }
    return STATUS_DONE;
}
