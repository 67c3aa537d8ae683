/* catalogue.c -- `list` and `explain`, from the same tables that a run uses. */
#include "plan/catalogue.h"

#include "base/status.h"
#include "bodies/bodies.h"
#include "plan/catalogue-rows.h"
#include "plan/kernels.h"
#include "plan/settings-contact.h"
#include "plan/settings-mps.h"
#include "plan/settings.h"
#include "pressure/pressure.h"
#include "scene/scene.h"
#include "fill/flow.h"
#include "state/motion.h"

#include <math.h>
#include <string.h>

const char *const catalogue_groups[] = {
    "kernel", "domain", "reference", "disturbance", "pcisph", "mps", "eos", "effects", "fluid",
    "wall", "beam", "body", "contact", "probe", "panel", "output", NULL
};

/* Keys of a scene by group; rows that several sets share stand one after another. */
static const struct group {
    const char *name, *about;
    const struct param *rows[CATALOGUE_ROWS];
} groups[] = {
    { "scene", "keys at the top level", { settings_params } },
    { "kernel", "smoothing kernel and pair list", { settings_kernel_params } },
    { "domain", "the box that counts; a wall of type \"frame\" surrounds it",
      { settings_domain_params } },
    { "reference", "scales of the flow", { settings_reference_params } },
    { "disturbance", "a start that differs by next to nothing, as `spread` makes it",
      { settings_disturbance_params } },
    { "pcisph", "the method pcisph: pressure by prediction and correction",
      { settings_pcisph_params } },
    { "eos", "equation of state; its own keys: see `explain tait`, `explain linear`",
      { settings_eos_params } },
    { "output", "how often files are written", { settings_output_params } },
    { "fluid", "fluid.NAME: a region filled with fluid",
      { shape_params, settings_fluid_params, flow_params } },
    { "wall", "wall.NAME: a region filled with wall",
      { shape_params, settings_wall_params, motion_params } },
    { "probe", "probe.NAME: a place to measure at", { settings_probe_params } },
    { "panel", "panel.NAME: a part of a wall or beam whose force is told",
      { settings_panel_params } },
    { "contact", "contact.NAME: friction and restitution of two solids, or of all of two kinds",
      { settings_contact_params } },
    { "mps", "how the method mps computes", { settings_mps_params } },
};

enum { NAMES = 128, GROUPS = sizeof groups / sizeof groups[0] };

const char *catalogue_group(int i, const struct param *const **rows)
{
    if (i >= GROUPS)
        return NULL;
    *rows = groups[i].rows;
    return groups[i].name;
}

const struct part *catalogue_part(const struct part *const *table, const char *name)
{
    for (int i = 0; table[i]; i++)
        if (strcmp(table[i]->name, name) == 0)
            return table[i];
    return NULL;
}

bool catalogue_implied(const struct part *part)
{
    return part->as.force && part->as.force->weight;
}

static void part_names(const struct part *const *table, const char **names)
{
    int n = 0;

    while (table[n] && n < NAMES - 1) {
        names[n] = table[n]->name;
        n++;
    }
    names[n] = NULL;
}

void catalogue_prepare(const struct engine *engine)
{
    const char *kernels[NAMES], *eos[NAMES], *walls[NAMES];

    kernels_names(engine, kernels, NAMES);
    part_names(pressure_table, eos);
    part_names(engine->walls, walls);
    settings_prepare(kernels, eos, walls);
}

static void list_parts(const struct part *const *table, FILE *to)
{
    for (int i = 0; table[i]; i++)
        fprintf(to, "%-22s %s\n", table[i]->name, table[i]->about);
}

static void list_bodies(FILE *to)
{
    for (int i = 0; bodies_table[i]; i++)
        fprintf(to, "%-22s %s\n", bodies_table[i]->identity.name, bodies_table[i]->identity.about);
}

static void list_flows(FILE *to)
{
    for (int i = 0; flow_table[i]; i++)
        fprintf(to, "%-22s %s; keys: %s\n", flow_table[i]->name, flow_table[i]->about,
                flow_table[i]->keys);
}

int catalogue_list(const char *what, FILE *to)
{
    static const char *const words[] = { "effects", "kernels", "eos", "pressure", "walls",
                                         "bodies", "flows", "methods", NULL };
    const char *near;

    if (strcmp(what, "effects") == 0)
        list_parts(engine_pick()->effects, to);
    else if (strcmp(what, "kernels") == 0)
        kernels_list(engine_pick(), to);
    else if (strcmp(what, "eos") == 0 || strcmp(what, "pressure") == 0)
        list_parts(pressure_table, to);
    else if (strcmp(what, "walls") == 0)
        list_parts(engine_pick()->walls, to);
    else if (strcmp(what, "bodies") == 0)
        list_bodies(to);
    else if (strcmp(what, "flows") == 0)
        list_flows(to);
    else {
        near = scene_nearest(what, words);
        return status_fail(STATUS_BAD_SCENE, "list %s: no such table%s%s%s; there are effects, "
                           "kernels, eos, pressure, walls, bodies, flows, methods", what,
                           near ? " (did you mean " : "", near ? near : "", near ? "?)" : "");
    }
    return STATUS_DONE;
}

static void explain_thing(const char *name, const char *about, const char *equation,
                          const char *source, const struct param *rows, FILE *to)
{
    fprintf(to, "%s -- %s\n", name, about);
    if (equation)
        fprintf(to, "  %s\n", equation);
    if (source)
        fprintf(to, "  source: %s\n", source);
    if (rows && rows->key)
        catalogue_rows(rows, to);
    else
        fputs("  no parameters\n", to);
}

bool catalogue_explain_group(const char *name, FILE *to)
{
    for (int i = 0; i < GROUPS; i++)
        if (strcmp(groups[i].name, name) == 0) {
            fprintf(to, "%s -- %s\n", name, groups[i].about);
            for (int k = 0; k < CATALOGUE_ROWS && groups[i].rows[k]; k++)
                catalogue_rows(groups[i].rows[k], to);
            return true;
        }
    return false;
}

static bool explain_part(const struct part *const *table, const char *name, FILE *to)
{
    const struct part *p = catalogue_part(table, name);

    if (p)
        explain_thing(p->name, p->about, p->equation, p->source, p->params, to);
    return p != NULL;
}

static bool explain_body(const char *name, FILE *to)
{
    for (int i = 0; bodies_table[i]; i++)
        if (strcmp(bodies_table[i]->identity.name, name) == 0) {
            const struct body_identity *b = &bodies_table[i]->identity;
            explain_thing(b->name, b->about, b->equation, b->source, b->params, to);
            catalogue_body_rows(b->groups, to);
            return true;
        }
    return false;
}

/* Shapes of the other dimension too: the user has perhaps not said which. */
static const char *const shapes[] = { "box", "polygon", "disc", "sphere", "cylinder", "frame",
                                     NULL };

static const char *const listed[] = { "effects", "kernels", "walls", "bodies", NULL };

static bool among(const char *const *words, const char *word)
{
    while (*words && strcmp(*words, word) != 0)
        words++;
    return *words != NULL;
}

static bool explain_shape(const char *name, FILE *to)
{
    if (!among(shapes, name))
        return false;
    fprintf(to, "%s -- a shape: %sNAME.type%s\n", name,
            strcmp(name, "frame") == 0 ? "wall." : "fluid.NAME.type or wall.",
            among(shape_types, name) ? "" : DIM == 2 ? "; with dimension = 3 only"
                                                     : "; with dimension = 2 only");
    catalogue_rows(shape_params, to);
    return true;
}

/* A table that is a word of the scene too: what can stand there. */
static bool explain_table(const char *name, FILE *to)
{
    if (!among(listed, name))
        return false;
    fprintf(to, "%s -- see `explain NAME` for each\n", name);
    return catalogue_list(name, to) == STATUS_DONE;
}

/* Every name that `explain` knows, for the nearest one. */
static void all_names(const char **names)
{
    const struct part *const *tables[] = { engine_pick()->effects, pressure_table,
                                          engine_pick()->walls };
    int n = 0;

    for (int t = 0; t < 3; t++)
        for (int i = 0; tables[t][i] && n < NAMES - 1; i++)
            names[n++] = tables[t][i]->name;
    for (int i = 0; bodies_table[i] && n < NAMES - 1; i++)
        names[n++] = bodies_table[i]->identity.name;
    for (int i = 0; i < GROUPS && n < NAMES - 1; i++)
        names[n++] = groups[i].name;
    for (int i = 0; shapes[i] && n < NAMES - 1; i++)
        names[n++] = shapes[i];
    for (int i = 0; listed[i] && n < NAMES - 1; i++)
        names[n++] = listed[i];
    kernels_names(engine_pick(), names + n, NAMES - n);
}

int catalogue_explain(const char *name, FILE *to)
{
    const char *names[NAMES];
    const char *near;
    bool wall;

    catalogue_prepare(engine_pick());
    if (strcmp(name, "effects.NAME") == 0)
        name = "effects";
    if (strncmp(name, "effects.", 8) == 0 && !strchr(name + 8, '.'))
        name += 8;
    wall = explain_part(engine_pick()->walls, name, to); /* `contact` is a group, too */
    if (explain_part(engine_pick()->effects, name, to) || explain_part(pressure_table, name, to)
        || explain_body(name, to) || catalogue_explain_group(name, to) || wall
        || kernels_explain(engine_pick(), name, to)
        || explain_shape(name, to) || explain_table(name, to))
        return STATUS_DONE;
    all_names(names);
    near = scene_nearest(name, names);
    return status_fail(STATUS_BAD_SCENE, "explain %s: no such thing%s%s%s; `stiffwater list "
                       "effects` and its like show what there is", name,
                       near ? " (did you mean " : "", near ? near : "", near ? "?)" : "");
}
