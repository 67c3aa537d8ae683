/* manual.c -- fills the tables into the man page, from the rows that the program reads:
 *
 *     manual-3d >ROWS;  manual-2d doc/stiffwater.1.in ROWS >stiffwater.1
 *
 * Both are this file, compiled for a dimension each.  ROWS holds a line per key, so that
 * the page, which is that of 2D, can say what differs in 3D. */
#include "base/status.h"
#include "bodies/bodies.h"
#include "cli/commands.h"
#include "cli/elsewhere.h"
#include "cli/roff.h"
#include "kernels/kernel.h"
#include "plan/catalogue.h"
#include "plan/settings-contact.h"
#include "plan/settings-mps.h"
#include "plan/settings.h"
#include "pressure/pressure.h"
#include "fill/flow.h"
#include "time/method.h"
#include "state/motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = ELSEWHERE_LINE };

/* Keys by group, as a user writes them. */
static const struct group {
    const char *title, *prefix, *about;
    const struct param *rows[3];
} groups[] = {
    { "top level", "", "Keys at the top level", { settings_params } },
    { "kernel", "kernel.", "Smoothing kernels and pair list", { settings_kernel_params } },
    { "domain", "domain.", "The box that counts; a wall of type \"frame\" surrounds it",
      { settings_domain_params } },
    { "reference", "reference.", "Scales of the flow", { settings_reference_params } },
    { "disturbance", "disturbance.", "A start that differs by next to nothing, as `spread` makes it",
      { settings_disturbance_params } },
    { "pcisph", "pcisph.", "Pressure by prediction and correction: of the method pcisph alone",
      { settings_pcisph_params } },
    { "eos", "eos.", "Equation of state; beside these, the keys of its type: see EQUATIONS OF "
                     "STATE",
      { settings_eos_params } },
    { "fluid.NAME", "fluid.NAME.", "A region filled with fluid",
      { shape_params, settings_fluid_params, flow_params } },
    { "wall.NAME", "wall.NAME.", "A region filled with wall",
      { shape_params, settings_wall_params, motion_params } },
    { "contact.NAME", "contact.NAME.", "How two solids touch", { settings_contact_params } },
    { "probe.NAME", "probe.NAME.", "A place to measure at", { settings_probe_params } },
    { "panel.NAME", "panel.NAME.", "A part of a wall or beam whose force is told",
      { settings_panel_params } },
    { "output", "output.", "How often files are written", { settings_output_params } },
    { "mps", "mps.", "How the method mps computes", { settings_mps_params } },
};

enum { GROUPS = sizeof groups / sizeof groups[0] };

static void show_key(const char *title, const char *prefix, const struct param *r)
{
    char facts[LINE] = "", name[LINE];
    FILE *to = fmemopen(facts, sizeof facts, "w");

    roff_facts(to, r);
    fclose(to);
    if (DIM == 3) {
        printf("%s %s\t%s\t%s\n", title, r->key, facts, r->about);
        return;
    }
    roff_tag(stdout, prefix, r->key, facts);
    roff_paragraph(stdout, r->about);
    snprintf(name, sizeof name, "%s %s", title, r->key);
    elsewhere_show(name, r, facts);
}

static void show_keys(const char *title, const char *prefix, const struct param *rows)
{
    for (const struct param *r = rows; r && r->key; r++)
        show_key(title, prefix, r);
}

static void show_thing(const char *title, const char *name, const char *about,
                       const char *equation, const char *source)
{
    if (DIM == 3)
        return;
    roff_heading(stdout, title, name);
    roff_paragraph(stdout, about);
    if (equation) {
        puts(".br");
        roff_text(stdout, equation, -1);
        putchar('\n');
    }
    if (source) {
        fputs(".br\nSource: ", stdout);
        roff_paragraph(stdout, source);
    }
}

static void show_parts(const struct part *const *table, const char *title, const char *prefix,
                       bool by_name)
{
    for (int i = 0; table[i]; i++) {
        const struct part *p = table[i];
        char keys[LINE];
        snprintf(keys, sizeof keys, by_name ? "%s%s." : "%s", prefix, p->name);
        show_thing(title, p->name, p->about, p->equation, p->source);
        show_keys(p->name, keys, p->params);
    }
}

static void show_effects(void)
{
    show_parts(engine_pick()->effects, "effects.", "effects.", true);
}

static void show_eos(void)
{
    show_parts(pressure_table, "", "eos.", false);
}

static void show_walls(void)
{
    show_parts(engine_pick()->walls, "", "walls.", false);
}

static void show_groups(void)
{
    for (int i = 0; i < GROUPS; i++) {
        const struct group *g = &groups[i];
        show_thing("", g->title, g->about, NULL, NULL);
        for (int k = 0; k < 3; k++)
            show_keys(g->title, g->prefix, g->rows[k]);
    }
}

static void show_bodies(void)
{
    for (int i = 0; bodies_table[i]; i++) {
        const struct body_identity *b = &bodies_table[i]->identity;
        char prefix[LINE];
        snprintf(prefix, sizeof prefix, "%s.NAME.", b->group);
        show_thing("", b->name, b->about, b->equation, b->source);
        show_keys(b->name, prefix, b->params);
        for (const struct body_group *g = b->groups; g && g->name; g++) {
            char key[2 * LINE];
            snprintf(key, sizeof key, "%s%s.%s", prefix, g->name, g->most > 1 ? "NAME." : "");
            show_keys(key, key, g->params);
        }
    }
}

static void show_kernels(void)
{
    for (int i = 0; engine_pick()->kernels[i]; i++) {
        const struct kernel *k = engine_pick()->kernels[i];
        roff_tag(stdout, "", k->name, "");
        roff_paragraph(stdout, k->about);
        fputs("Source: ", stdout);
        roff_paragraph(stdout, k->source);
    }
}

static void show_methods(void)
{
    for (int i = 0; method_table[i]; i++) {
        roff_tag(stdout, "", method_table[i]->name, "");
        roff_paragraph(stdout, method_table[i]->told.about);
    }
}

static void show_options(const struct argp_option *o)
{
    for (; o->name; o++) {
        char tag[LINE], behind[LINE];
        snprintf(tag, sizeof tag, "-%c, --%s", o->key, o->name);
        snprintf(behind, sizeof behind, "%s", o->arg ? o->arg : "");
        roff_tag(stdout, "", tag, behind);
        roff_paragraph(stdout, o->doc);
    }
}

static void show_commands(void)
{
    for (const struct commands_row *c = commands_table; c->name; c++) {
        const char *more = strchr(c->doc, '\v');
        char heading[LINE];
        snprintf(heading, sizeof heading, "%s %s", c->name, c->args);
        roff_heading(stdout, "stiffwater ", heading);
        roff_text(stdout, c->doc, more ? (int)(more - c->doc) : -1);
        putchar('\n');
        if (more)
            roff_paragraph(stdout, more + 1);
        show_options(c->options);
    }
}

static void show_title(void)
{
    printf(".TH STIFFWATER 1 \"\" \"stiffwater %s\" \"User commands\"\n", PACKAGE_VERSION);
}

/* What a line of the template calls for. */
static const struct {
    const char *word;
    void (*show)(void);
    bool keys; /* it has some: asked for in 3D too */
} tables[] = {
    { "@title@\n", show_title, false },
    { "@commands@\n", show_commands, false },
    { "@keys@\n", show_groups, true },
    { "@effects@\n", show_effects, true },
    { "@eos@\n", show_eos, true },
    { "@walls@\n", show_walls, true },
    { "@bodies@\n", show_bodies, true },
    { "@kernels@\n", show_kernels, false },
    { "@methods@\n", show_methods, false },
};

enum { TABLES = sizeof tables / sizeof tables[0] };

static bool show_table(const char *line, bool *called)
{
    for (int i = 0; i < TABLES; i++)
        if (strcmp(line, tables[i].word) == 0) {
            called[i] = true;
            tables[i].show();
            return true;
        }
    return false;
}

/* Lines of the template that call for a table become it; all must be called for. */
static int fill(const char *path)
{
    bool called[TABLES] = { false };
    char line[LINE];
    FILE *from = fopen(path, "r");

    if (!from)
        return status_fail(STATUS_IO, "%s cannot be read", path);
    while (fgets(line, sizeof line, from))
        if (!show_table(line, called))
            fputs(line, stdout);
    fclose(from);
    for (int i = 0; i < TABLES; i++)
        if (!called[i])
            return status_fail(STATUS_FAILED, "%s has no line %s", path, tables[i].word);
    return STATUS_DONE;
}

/* A group of the catalogue that is not in this file's table; effects and bodies
 * have tables of their own. */
static int check_groups(void)
{
    for (int i = 0; catalogue_groups[i]; i++) {
        const char *name = catalogue_groups[i];
        bool found = strcmp(name, "effects") == 0;
        for (int k = 0; k < GROUPS; k++)
            found |= strncmp(groups[k].prefix, name, strlen(name)) == 0;
        for (int k = 0; bodies_table[k]; k++)
            found |= strcmp(bodies_table[k]->identity.group, name) == 0;
        if (!found)
            return status_fail(STATUS_FAILED, "group %s is missing in src/manual.c", name);
    }
    return elsewhere_check();
}

static int write_page(const char *template, const char *rows)
{
    TRY(elsewhere_read(rows));
    TRY(fill(template));
    return check_groups();
}

static void show_rows(void)
{
    for (int i = 0; i < TABLES; i++)
        if (tables[i].keys)
            tables[i].show();
}

int main(int argc, char **argv)
{
    int status = STATUS_DONE;

    catalogue_prepare(engine_pick());
    if (DIM == 3)
        show_rows();
    else if (argc == 3)
        status = write_page(argv[1], argv[2]);
    else
        status = status_fail(STATUS_BAD_SCENE, "manual-2d TEMPLATE ROWS");
    if (status == STATUS_DONE && fflush(stdout) != 0)
        status = status_fail(STATUS_IO, "the page cannot be written");
    if (status != STATUS_DONE)
        fprintf(stderr, "manual: %s\n", status_message());
    return status;
}
