/* scene.c -- tests of src/scene: what is read, what is refused and with which
 * words, what the command line changes, and that scene.used says it all again. */
#include "base/status.h"
#include "scene/scene.h"

#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

/* --- a small world with one of each kind ------------------------------------------- */

struct part {
    double c0, speed, cold;
    int steps, count;
    bool clamp;
    const char *kind, *note;
    double x[3], drift[3];
    struct param_points outline;
    unsigned fields;
};

struct tank {
    double until, gravity[3];
    const char *title;
    struct part eos;
    double mu, rho0[8], modulus[8];
};

#define AT(member) offsetof(struct part, member)
static const char *const kinds[] = { "tait", "linear", "clamped-tait", NULL };
static const char *const fields[] = { "density", "pressure", "dye", NULL };

static const struct param eos_rows[] = {
    { "c0", "m/s", AT(c0), 20, 0, 1e4, "sound speed", PARAM_NUMBER, NULL, 0 },
    { "speed", "m/s", AT(speed), NAN, 0, HUGE_VAL, "largest speed", PARAM_NUMBER, NULL, 0 },
    { "cold", "K", AT(cold), 0.1, -HUGE_VAL, 5, "a temperature", PARAM_NUMBER, NULL, 0 },
    { "steps", "", AT(steps), 5, 1, 2e9, "how many steps", PARAM_INTEGER, NULL, 0 },
    { "count", "", AT(count), NAN, 0, 0, "computed count", PARAM_INTEGER, NULL, 0 },
    { "clamp", "", AT(clamp), 1, 0, 1, "no tension", PARAM_FLAG, NULL, 0 },
    { "kind", "", AT(kind), 0, 0, 0, "which equation", PARAM_WORD, kinds, 0 },
    { "note", "", AT(note), 0, 0, 0, "a remark", PARAM_TEXT, NULL, 0 },
    { "x", "m", AT(x), 0.5, -10, 10, "where it is", PARAM_VECTOR, NULL, 0 },
    { "drift", "m/s", AT(drift), NAN, 0, 0, "how it moves", PARAM_VECTOR, NULL, 0 },
    { "outline", "m", AT(outline), 0, 0, 0, "corners", PARAM_POINTS, NULL, 0 },
    { "fields", "", AT(fields), 5, 0, 0, "what is written", PARAM_WORDS, fields, 0 },
    { 0 },
};
static const struct param top_rows[] = {
    { "until", "s", offsetof(struct tank, until), 1, 0, 1e9, "end", PARAM_NUMBER, NULL, 0 },
    { "gravity", "m/s^2", offsetof(struct tank, gravity), 0, -1e3, 1e3, "gravity", PARAM_VECTOR,
      NULL, 0 },
    { "title", "", offsetof(struct tank, title), 0, 0, 0, "title", PARAM_TEXT, NULL, 0 },
    { 0 },
};
static const struct param mu_rows[] = {
    { "mu", "Pa s", 0, 1e-3, 0, 1e4, "dynamic viscosity", PARAM_NUMBER, NULL, 0 }, { 0 },
};
static const struct param fluid_rows[] = {
    { "rho0", "kg/m^3", 0, 0, 1, 1e5, "density at rest", PARAM_NUMBER, NULL, 1 }, { 0 },
};
static const struct param beam_rows[] = {
    { "E", "Pa", 0, 1e9, 0, 1e15, "Young's modulus", PARAM_NUMBER, NULL, 0 }, { 0 },
};
static const char *const top_others[] = { "eos", "effects", "fluid", "beam", "seed", NULL };
static const char *const effect_names[] = { "viscosity", "gravity", NULL };

static int fill_named(struct scene *scene, const char *kind, const struct param *rows, double *to)
{
    const struct scene_node *group = scene_child(scene_root(scene), kind);

    TRY(scene_check_named(group));
    for (int i = 0; i < scene_count(group) && i < 8; i++) {
        char path[64];

        snprintf(path, sizeof path, "%s.%.40s", kind, scene_name(scene_at(group, i)));
        TRY(scene_fill(scene, scene_at(group, i), path, rows, NULL, 2, &to[i]));
    }
    return STATUS_DONE;
}

static int fill(struct scene *scene, struct tank *tank)
{
    const struct scene_node *root = scene_root(scene);
    const struct scene_node *effects = scene_child(root, "effects");

    memset(tank, 0, sizeof *tank);
    TRY(scene_fill(scene, root, "", top_rows, top_others, 2, tank));
    TRY(scene_fill(scene, scene_child(root, "eos"), "eos", eos_rows, NULL, 2, &tank->eos));
    TRY(scene_fill(scene, effects, "effects", NULL, effect_names, 2, NULL));
    for (int i = 0; i < 2; i++) {
        const struct scene_node *effect = scene_child(effects, effect_names[i]);
        const char *const path[] = { "effects.viscosity", "effects.gravity" };

        if (effect)
            TRY(scene_fill(scene, effect, path[i], i == 0 ? mu_rows : NULL, NULL, 2, &tank->mu));
    }
    TRY(fill_named(scene, "fluid", fluid_rows, tank->rho0));
    return fill_named(scene, "beam", beam_rows, tank->modulus);
}

/* --- files in a directory of their own --------------------------------------------- */

static char directory[64];

static const char *in_directory(const char *name)
{
    static char path[2][256];
    static int turn;

    turn = !turn;
    snprintf(path[turn], sizeof path[turn], "%s/%s", directory, name);
    return path[turn];
}

static void write_bytes(const char *name, const char *bytes, size_t n)
{
    FILE *file = fopen(in_directory(name), "w");

    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, n, file), n);
    fclose(file);
}

static void write_file(const char *name, const char *text)
{
    write_bytes(name, text, strlen(text));
}

/* The scene that t.scene and perhaps an override make; the caller frees it. */
static int load(const char *override, struct scene **scene, struct tank *tank)
{
    TRY(scene_read(in_directory("t.scene"), scene));
    if (override)
        TRY(scene_override(*scene, override));
    return fill(*scene, tank);
}

static struct scene *loaded(const char *text, const char *override, struct tank *tank)
{
    struct scene *scene = NULL;
    int status;

    write_file("t.scene", text);
    status_clear();
    status = load(override, &scene, tank);
    if (status != STATUS_DONE)
        print_message("refused: %s\n", status_message());
    assert_int_equal(status, STATUS_DONE);
    assert_string_equal(status_message(), "");
    return scene;
}

/* Asserts that t.scene is refused and that the message has all pieces, parted by |. */
static void check_refused(const char *override, const char *pieces)
{
    struct scene *scene = NULL;
    struct tank tank;
    char copy[400], *rest = copy;
    int status;

    status_clear();
    status = load(override, &scene, &tank);
    scene_free(&scene);
    snprintf(copy, sizeof copy, "%s", pieces);
    if (status != STATUS_BAD_SCENE)
        fail_msg("code %d where \"%s\" was to be refused", status, pieces);
    for (char *piece; (piece = strsep(&rest, "|"));)
        if (!strstr(status_message(), piece))
            fail_msg("\"%s\" is not in \"%s\"", piece, status_message());
}

static void refused(const char *text, const char *override, const char *pieces)
{
    write_file("t.scene", text);
    check_refused(override, pieces);
}

/* --- values ------------------------------------------------------------------------- */

static void values_of_every_kind_are_read(void **state)
{
    struct tank tank;
    struct scene *scene = loaded(
        "title = \"dam \" \"break\"; gravity = [0, -9.81];\n"
        "eos : { c0 = 1e3, steps = 1e3; clamp = FALSE; kind = \"linear\";\n"
        "  note = \"say \\\"hi\\\"\\n\"; x = (1, 0x10 /* ten */, ); };\n" + 0, NULL, &tank);

    (void)state;
    scene_free(&scene);
}
