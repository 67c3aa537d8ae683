/* catalogue-keys.c -- `explain` of a single key. */
#include "plan/catalogue-keys.h"

#include "bodies/bodies.h"
#include "plan/catalogue-rows.h"
#include "plan/catalogue.h"
#include "pressure/pressure.h"
#include "scene/scene.h"

#include <string.h>

enum { NAMES = 256 };

/* What was asked for, taken apart at its dots. */
struct asked {
    char group[64], member[64]; /* "" where it is not said */
    const char *key;
    bool values;                /* it is a value of keys, not a key */
    bool all;                   /* rather all keys of the group */
    const char *told;           /* whose row was told last */
    const char **names;         /* [NAMES] of all keys, instead of telling them, or NULL */
    FILE *to;                   /* NULL: only the unit matters */
    int found;
    const char *unit;           /* of all that were found, "": they differ */
};

static bool take_apart(struct asked *a, const char *name)
{
    const char *first = strchr(name, '.'), *last = strrchr(name, '.');

    a->key = last ? last + 1 : name;
    if (!first)
        return *name;
    if ((size_t)(first - name) >= sizeof a->group || (size_t)(last - first) >= sizeof a->member)
        return false;
    memcpy(a->group, name, (size_t)(first - name));
    if (last > first)
        memcpy(a->member, first + 1, (size_t)(last - first - 1));
    return *a->key;
}

static bool means(const char *asked, const char *group)
{
    return !*asked || strcmp(asked, group) == 0;
}

/* Is the row asked for? */
static bool fits(const struct asked *a, const struct param *r)
{
    if (!a->values)
        return a->all || strcmp(r->key, a->key) == 0;
    for (const char *const *word = r->words; word && *word; word++)
        if (strcmp(*word, a->key) == 0)
            return true;
    return false;
}

static void tell(struct asked *a, const char *group, const char *whose, const struct param *r)
{
    if (a->names && a->found < NAMES - 1)
        a->names[a->found] = r->key;
    if (!a->to) {
        a->unit = a->found == 0 || strcmp(a->unit, r->unit) == 0 ? r->unit : "";
        return;
    }
    if (!a->all || a->told != whose)
        fprintf(a->to, "%s%s%s%s\n", strcmp(group, "scene") == 0 ? "top level of a scene" : group,
                a->all ? ".NAME" : "", *whose ? ", " : "", whose);
    a->told = whose;
    catalogue_row(r, a->to);
}

/* The row of the key among those of "GROUP" or "GROUP ...". */
static void look(struct asked *a, const char *group, const char *whose, const struct param *rows)
{
    if (!means(a->group, group))
        return;
    for (const struct param *r = rows; r && r->key; r++)
        if (fits(a, r)) {
            tell(a, group, whose, r);
            a->found++;
        }
}

static void look_in_parts(struct asked *a, const char *group, const struct part *const *table)
{
    for (int i = 0; table[i]; i++)
        look(a, group, table[i]->name, table[i]->params);
}

static void look_in_effects(struct asked *a)
{
    const struct part *const *table = engine_pick()->effects;

    for (int i = 0; table[i]; i++)
        if (means(a->member, table[i]->name))
            look(a, "effects", table[i]->name, table[i]->params);
}

static void look_in_bodies(struct asked *a)
{
    for (int i = 0; bodies_table[i]; i++) {
        const struct body_identity *b = &bodies_table[i]->identity;
        look(a, b->group, b->name, b->params);
        for (const struct body_group *g = b->groups; g && g->name; g++)
            look(a, b->group, g->name, g->params);
    }
}

static void look_in_groups(struct asked *a)
{
    const struct param *const *rows;
    const char *name;

    for (int i = 0; (name = catalogue_group(i, &rows)); i++)
        for (int k = 0; k < CATALOGUE_ROWS && rows[k]; k++)
            look(a, name, "", rows[k]);
}

static bool look_everywhere(struct asked *a)
{
    look_in_groups(a);
    look_in_parts(a, "eos", pressure_table);
    look_in_parts(a, "walls", engine_pick()->walls);
    look_in_effects(a);
    look_in_bodies(a);
    return a->found > 0;
}

bool catalogue_explain_key(const char *name, FILE *to)
{
    struct asked a = { .to = to };

    if (!take_apart(&a, name))
        return false;
    if (look_everywhere(&a))
        return true;
    a.values = !strchr(name, '.');
    return a.values && look_everywhere(&a);
}

/* Groups at the top level that hold objects with names of their own. */
static bool has_names(const char *group)
{
    static const char *const objects[] = { "fluid", "wall", "probe", "panel", "contact", NULL };

    for (int i = 0; objects[i]; i++)
        if (strcmp(objects[i], group) == 0)
            return true;
    for (int i = 0; bodies_table[i]; i++)
        if (strcmp(bodies_table[i]->identity.group, group) == 0)
            return true;
    return false;
}

bool catalogue_explain_named(const char *name, FILE *to, const char **near)
{
    const char *names[NAMES];
    struct asked a = { .all = true, .names = names, .unit = "" };

    *near = NULL;
    if (!take_apart(&a, name) || *a.member || !has_names(a.group) || !look_everywhere(&a))
        return false;
    names[a.found < NAMES ? a.found : NAMES - 1] = NULL;
    *near = scene_nearest(a.key, names);
    if (*near)
        return false;
    a.names = NULL;
    a.to = to;
    return look_everywhere(&a);
}

const char *catalogue_unit(const char *name)
{
    struct asked a = { .unit = "" };

    if (!take_apart(&a, name))
        return "";
    if (!*a.group)
        strcpy(a.group, "scene");
    look_everywhere(&a);
    return a.unit;
}
