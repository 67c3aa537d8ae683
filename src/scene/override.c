/* override.c -- KEY=VALUE from the command line. */
#include "base/status.h"
#include "scene/tree.h"

#include <ctype.h>
#include <string.h>

enum { PARTS_MAX = 16 };

struct override {
    struct scene *scene;
    const char *assignment;
    char *part[PARTS_MAX]; /* [n] of the dotted key */
    int n;
    struct scene_node *value;
};

static int malformed(const char *assignment, const char *why)
{
    return status_fail(STATUS_BAD_SCENE, "command line: \"%s\" %s; write KEY=VALUE, such as "
                       "fluid.water.rho0=1000", assignment, why);
}

static bool is_name(const char *s)
{
    if (!isalpha((unsigned char)*s) && *s != '*')
        return false;
    while (isalnum((unsigned char)*s) || (*s && strchr("-_*", *s)))
        s++;
    return *s == '\0';
}

/* The text without blanks around it. */
static char *trimmed(struct scene_pool *pool, const char *from, const char *to)
{
    while (from < to && isspace((unsigned char)*from))
        from++;
    while (to > from && isspace((unsigned char)to[-1]))
        to--;
    return scene_pool_print(pool, "%.*s", (int)(to - from), from);
}

static int split_key(struct override *o, char *key)
{
    for (char *part = key, *dot; part; part = dot) {
        dot = strchr(part, '.');
        if (dot)
            *dot++ = '\0';
        if (o->n == PARTS_MAX)
            return malformed(o->assignment, "has too many dots in its key");
        if (!is_name(part))
            return malformed(o->assignment, "has a key that is no name (letters, digits, - and _)");
        o->part[o->n++] = part;
    }
    return STATUS_DONE;
}

/* What the value says as a scene would; NULL when it is just a text. */
static struct scene_node *parsed(struct scene_pool *pool, const char *text)
{
    const bool quiet = status_message()[0] == '\0';
    const char *source = scene_pool_print(pool, "value = %s", text);
    struct scene_node *root = NULL;

    if (source && scene_read_string(pool, source, &root) == STATUS_DONE && root->n == 1)
        return root->child[0];
    if (quiet)
        status_clear(); /* not a failure: the value is taken as a text */
    return NULL;
}

static int make_value(struct override *o, const char *text)
{
    struct scene_pool *pool = &o->scene->pool;

    o->value = parsed(pool, text);
    if (!o->value)
        o->value = scene_node_create(pool, "", SCENE_TEXT, (struct scene_place){ 0 });
    if (!o->value)
        return STATUS_FAILED;
    if (!o->value->text)
        o->value->text = text;
    o->value->at = (struct scene_place){ 0 };
    o->value->name = o->part[o->n - 1];
    return STATUS_DONE;
}

/* Answers whether `name` in this group means a member of each group in it:
 * "beam.E" does when beam holds nothing but named groups. */
static bool means_all(const struct override *o, const struct scene_node *group, const char *name,
                      bool last)
{
    bool held = false;

    if (group == o->scene->root || group->n == 0)
        return false;
    for (int i = 0; i < group->n; i++) {
        if (group->child[i]->kind != SCENE_GROUP)
            return false;
        held = held || scene_node_find(group->child[i], name);
    }
    return held || (last && o->value->kind != SCENE_GROUP);
}

/* Notes the group of the file that a new one may be a misprint of.  Keys and effects are known by
 * their names anyway. */
static int note_similar(struct override *o, const struct scene_node *parent,
                        struct scene_node *made)
{
    const char **names;
    int n = 0;

    if (parent == o->scene->root || strcmp(parent->name, "effects") == 0)
        return STATUS_DONE;
    names = scene_pool_take(&o->scene->pool, (size_t)(parent->n + 1) * sizeof *names);
    if (!names)
        return STATUS_FAILED;
    for (int i = 0; i < parent->n; i++)
        if (parent->child[i]->kind == SCENE_GROUP && parent->child[i]->at.file)
            names[n++] = parent->child[i]->name;
    made->beside = scene_nearest(made->name, names);
    return STATUS_DONE;
}

static struct scene_node *make_group(struct override *o, struct scene_node *parent,
                                     const char *name)
{
    struct scene_node *group = scene_node_create(&o->scene->pool, name, SCENE_GROUP,
                                                 (struct scene_place){ 0 });

    if (!group || note_similar(o, parent, group) != STATUS_DONE
        || scene_node_add(&o->scene->pool, parent, group) != STATUS_DONE)
        return NULL;
    return group;
}

/* "off" and "on" take a group away and put it back: effects and objects have no values of their
 * own that they could be. */
static bool is_switch(const struct override *o, const struct scene_node *group,
                      const struct scene_node *child)
{
    const char *text = o->value->kind == SCENE_TEXT ? o->value->text : "";

    return (strcmp(text, "off") == 0 || strcmp(text, "on") == 0)
           && (child ? child->kind == SCENE_GROUP : strcmp(group->name, "effects") == 0);
}

/* "off" takes away a value that cannot be this text, too: what a file says of a number or a list
 * is then as if it were not there. */
static bool is_removal(const struct override *o, const struct scene_node *child)
{
    return child && (child->kind == SCENE_NUMBER || child->kind == SCENE_LIST)
           && o->value->kind == SCENE_TEXT && strcmp(o->value->text, "off") == 0;
}

/* What was off already stays, marked, so that its name is checked like any other's. */
static int turn(struct override *o, struct scene_node *group, struct scene_node *child)
{
    const bool off = strcmp(o->value->text, "off") == 0, was = child && !child->off;

    if (was && off)
        scene_node_remove(group, child);
    else if (!child)
        child = make_group(o, group, o->part[o->n - 1]);
    if (!child)
        return STATUS_FAILED;
    child->off = off;
    return STATUS_DONE;
}

/* A node of its own for each group that the value is for. */
static int put(struct override *o, struct scene_node *group, const struct scene_node *child)
{
    struct scene_node *value = scene_pool_take(&o->scene->pool, sizeof *value);

    if (!value)
        return STATUS_FAILED;
    *value = *o->value;
    if (child)
        value->was = child->at.file ? child : child->was;
    return scene_node_put(&o->scene->pool, group, value);
}

/* Sets the value at part[i], part[i+1] ... below group. */
static int set(struct override *o, struct scene_node *group, int i)
{
    const bool last = i == o->n - 1;
    struct scene_node *child = scene_node_find(group, o->part[i]);

    if (last && is_switch(o, group, child))
        return turn(o, group, child);
    if (last && is_removal(o, child)) {
        scene_node_remove(group, child);
        return STATUS_DONE;
    }
    if (!child && means_all(o, group, o->part[i], last)) {
        for (int k = 0; k < group->n; k++)
            TRY(set(o, group->child[k], i));
        return STATUS_DONE;
    }
    if (last)
        return put(o, group, child);
    if (!child)
        child = make_group(o, group, o->part[i]);
    if (!child)
        return STATUS_FAILED;
    if (child->kind != SCENE_GROUP)
        return status_fail(STATUS_BAD_SCENE, "command line: \"%s\": %s (%s) is a value, not a "
                           "group, so nothing in it can be set", o->assignment, o->part[i],
                           scene_where(child));
    return set(o, child, i + 1);
}

int scene_override(struct scene *scene, const char *assignment)
{
    struct override o = { .scene = scene, .assignment = assignment };
    const char *equals = strchr(assignment, '=');
    char *key, *value;

    if (!equals)
        return malformed(assignment, "has no =");
    key = trimmed(&scene->pool, assignment, equals);
    value = trimmed(&scene->pool, equals + 1, equals + strlen(equals));
    if (!key || !value)
        return STATUS_FAILED;
    TRY(split_key(&o, key));
    TRY(make_value(&o, value));
    return set(&o, scene->root, 0);
}
