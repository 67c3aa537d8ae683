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
    { "until", "s", offsetof(struct tank, until), 1, 0, 1e10, "end", PARAM_NUMBER, NULL, 0 },
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
    { "E", "Pa", 0, 1e9, 0, 1e16, "Young's modulus", PARAM_NUMBER, NULL, 0 }, { 0 },
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
        "eos : { c0 = 1e3, steps = 1e3; clamp = FALSE; kind = \"linear\"; // a remark\n"
        "  note = \"say \\\"hi\\\"\\n\"; x = (1, /* two */ -2.5); # another\n"
        "  outline = ([0, 1], [2, 3.5], (4, 5)); fields = [\"dye\", \"density\"] };\n",
        NULL, &tank);

    (void)state;
    assert_string_equal(tank.title, "dam break");
    assert_true(tank.gravity[0] == 0 && tank.gravity[1] == -9.81 && tank.gravity[2] == 0);
    assert_true(tank.eos.c0 == 1000 && tank.eos.steps == 1000 && !tank.eos.clamp);
    assert_string_equal(tank.eos.kind, "linear");
    assert_string_equal(tank.eos.note, "say \"hi\"\n");
    assert_true(tank.eos.x[0] == 1 && tank.eos.x[1] == -2.5 && tank.eos.x[2] == 0);
    assert_int_equal(tank.eos.outline.n, 3);
    assert_true(tank.eos.outline.x[1][1] == 3.5 && tank.eos.outline.x[2][0] == 4);
    assert_int_equal(tank.eos.fields, 5);
    scene_free(&scene);
    assert_null(scene);
}

static void large_and_odd_numbers_keep_their_value(void **state)
{
    struct tank tank;
    struct scene *scene = loaded(
        "eos = { speed = 3000000000; cold = -99999999999999999999; c0 = 0x10; steps = 5L;\n"
        "        x = [.5, 1.]; drift = [0.1, 1e-320] }; beam = { a = { E = 1234567890123456 } }",
        NULL, &tank);

    (void)state;
    assert_true(tank.eos.speed == 3e9 && tank.eos.cold == -1e20);
    assert_true(tank.eos.c0 == 16 && tank.eos.steps == 5 && tank.eos.x[0] == 0.5);
    assert_true(tank.eos.drift[0] == 0.1 && tank.eos.drift[1] == 1e-320);
    assert_true(tank.modulus[0] == 1234567890123456.0);
    scene_free(&scene);
}

static void marks_of_other_editors_do_no_harm(void **state)
{
    struct tank tank;
    struct scene *scene = loaded("\xEF\xBB\xBFuntil = 3;\r\neos = {\r\n fields = \"dye\";\r\n};",
                                 NULL, &tank);

    (void)state;
    assert_true(tank.until == 3 && tank.eos.fields == 4); /* one word is a list of one */
    scene_free(&scene);
}

static void a_group_that_is_not_there_gives_all_defaults(void **state)
{
    struct tank tank;
    struct scene *scene = loaded("until = 2", NULL, &tank);

    (void)state;
    assert_true(tank.eos.c0 == 20 && isnan(tank.eos.speed) && tank.eos.steps == 5);
    assert_true(tank.eos.clamp && tank.eos.count == INT_MIN);
    assert_string_equal(tank.eos.kind, "tait");
    assert_string_equal(tank.eos.note, "");
    assert_true(tank.eos.x[0] == 0.5 && tank.eos.x[1] == 0.5 && tank.eos.x[2] == 0);
    assert_true(isnan(tank.eos.drift[1]) && tank.eos.outline.n == 0 && tank.eos.fields == 5);
    assert_int_equal(scene_fill(scene, NULL, "fluid.oil", fluid_rows, NULL, 2, tank.rho0),
                     STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), "fluid.oil.rho0 is missing"));
    scene_free(&scene);
}

static void nodes_know_name_file_and_line(void **state)
{
    struct tank tank;
    struct scene *scene = loaded("until = 2;\n\nfluid = {\n  a = { rho0 = 1; };\n  b = {\n"
                                 "    rho0 = 2; } };", "fluid.b.rho0=3", &tank);
    const struct scene_node *fluid = scene_child(scene_root(scene), "fluid");

    (void)state;
    assert_int_equal(scene_count(fluid), 2);
    assert_string_equal(scene_name(scene_at(fluid, 1)), "b");
    assert_int_equal(scene_line(scene_at(fluid, 1)), 5);
    assert_string_equal(scene_file(fluid), scene_path(scene));
    assert_string_equal(scene_where(scene_child(scene_at(fluid, 1), "rho0")), "command line");
    assert_null(scene_at(fluid, 2));
    assert_null(scene_child(NULL, "a"));
    assert_int_equal(scene_count(NULL), 0);
    scene_free(&scene);
}

/* --- what is refused ------------------------------------------------------------------ */

static void wrong_values_are_refused_with_what_would_be_right(void **state)
{
    (void)state;
    refused("until = 1;\neos = { c0 = \"fast\" }", NULL,
            "t.scene:2: eos.c0 = \"fast\" is a text, but a number in m/s is expected|sound speed");
    refused("eos = {\n\nc0 = -3 }", NULL, "t.scene:3: eos.c0 = -3 m/s lies outside 0 to 10000 "
            "(sound speed)");
    refused("eos = { speed = -0.1 }", NULL, "eos.speed = -0.1 m/s must be at least 0");
    refused("eos = { cold = 6 }", NULL, "eos.cold = 6 K must be at most 5");
    refused("eos = { speed = 1e999 }", NULL, "eos.speed|too large");
    refused("eos = { steps = 1.5 }", NULL, "eos.steps = 1.5 is not a whole number");
    refused("eos = { count = 3000000000 }", NULL, "eos.count = 3e+09 is not a whole number");
    refused("eos = { clamp = 1 }", NULL, "eos.clamp = 1 is a number, but true or false is");
    refused("eos = { c0 = { } }", NULL, "eos.c0 = { ... } is a group, but a number");
    refused("eos = { note = 5 }", NULL, "eos.note = 5 is a number, but a text in quotes");
    refused("title = [1, 2]", NULL, "title = (1, 2) is a list, but a text in quotes");
    refused("eos = { kind = \"taitt\" }", NULL, "t.scene:1: eos.kind = \"taitt\" is not one of "
            "\"tait\", \"linear\", \"clamped-tait\"; did you mean \"tait\"?");
    refused("eos = { fields = [\"density\",\n \"die\"] }", NULL, "t.scene:2: eos.fields = \"die\" "
            "is not one of|did you mean \"dye\"?");
    refused("eos = { fields = [3] }", NULL, "eos.fields = 3 is a number");
    refused("eos = { outline = 3 }", NULL, "eos.outline = 3 is a number, but a list of points");
    refused("beam = 3", NULL, "beam is a value, but named groups are expected: beam = { NAME");
    refused("gravity = [0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1]",
            NULL, "0.1,... holds 15 values");
    refused("eos = { fields = 3 }", NULL, "eos.fields = 3 is a number, but a list of words");
    refused("eos = 3", NULL, "eos is a value, but a group is expected: eos = {");
    refused("until = 1\nfluid = { oil = { } }", NULL, "t.scene:2: fluid.oil.rho0 is missing|"
            "a number in kg/m^3|density at rest");
    refused("beam = { E = 3 }", NULL, "t.scene:1: beam.E is a value|NAME = { E = ...; }");
}

static void vectors_and_points_are_counted(void **state)
{
    (void)state;
    refused("gravity = [0, 0, -9.81]", NULL, "gravity: (0, 0, -9.81) holds 3 values, but in 2 "
            "dimensions 2 numbers are expected");
    refused("gravity = [1]", NULL, "holds 1 value, but");
    refused("gravity = []", NULL, "holds 0 values, but");
    refused("gravity = -9.81", NULL, "gravity = -9.81 is a number, but a list of [x, y] in m/s^2");
    refused("gravity = [0,\n\"g\"]", NULL, "t.scene:2: gravity = \"g\" is a text");
    refused("gravity = [0, -2e3]", NULL, "gravity = -2000 m/s^2 lies outside -1000 to 1000");
    refused("eos = { outline = [0, 1] }", NULL, "eos.outline = 0 is a number, but a list of points "
            "like [x, y] in m");
    refused("eos = { outline = ([0, 1], [2]) }", NULL, "eos.outline: (2) holds 1 value");
}

static void unknown_keys_get_the_nearest_known_one(void **state)
{
    (void)state;
    refused("effects = { viscocity = { } }", NULL, "t.scene:1: unknown key effects.viscocity; did "
            "you mean effects.viscosity? (known: viscosity, gravity)");
    refused("effects = { viscosity = { mew = 3 } }", NULL, "unknown key effects.viscosity.mew|mu");
    refused("effects = { gravity = { g = 3 } }", NULL, "effects.gravity.g (known: none)");
    refused("unitl = 3", NULL, "unknown key unitl; did you mean until?|known: until, gravity");
    refused("until = 3", "effects.viscosity.nu=1", "command line: unknown key "
            "effects.viscosity.nu; did you mean effects.viscosity.mu?");
}

static void the_nearest_word_is_near(void **state)
{
    static const char *const names[] = { "viscosity", "rho0", "E", "c0", "density", NULL };

    (void)state;
    assert_string_equal(scene_nearest("viscocity", names), "viscosity");
    assert_string_equal(scene_nearest("vsicosity", names), "viscosity");
    assert_string_equal(scene_nearest("0c", names), "c0");
    assert_string_equal(scene_nearest("RHO0", names), "rho0");
    assert_string_equal(scene_nearest("e", names), "E");
    assert_string_equal(scene_nearest("dens", names), "density");
    assert_null(scene_nearest("I", names));
    assert_null(scene_nearest("colour", names));
    assert_null(scene_nearest("", names));
    assert_null(scene_nearest("x", (const char *const[]){ NULL }));
}

static void broken_syntax_is_explained(void **state)
{
    (void)state;
    refused("until = 1\ntitle = dam break", NULL, "t.scene:2: dam has no quotes|\"dam\"");
    refused("title = data.csv", NULL, "data.csv has no quotes|\"data.csv\"");
    refused("clamp = yes", NULL, "yes means nothing here; write true or false");
    refused("until =\ntitle = \"x\"", NULL, "until has no value; write until = VALUE");
    refused("until = ;", NULL, "until has no value");
    refused("eos = { c0 = }", NULL, "c0 has no value");
    refused("a = 1; until =", NULL, "until has no value");
    refused("until 3", NULL, "until has no = after it");
    refused("until = 3 ms;", NULL, "ms: units are not written|explain until");
    refused("until = 3 m/s; ", NULL, "m/s: units are not written");
    refused("until = 3 furlongs;", NULL, "furlongs has no = after it");
    refused("title = a\033[31m;", NULL, "a?[31m has no quotes");
    refused("eos.c0 = 3", NULL, "eos.c0: dots are for the command line|eos = { ... }");
    refused("x = (1, 2", NULL, "t.scene:1: the ( that stands here after x is never closed");
    refused("eos = {\n  x = [1, 2\n};", NULL, "t.scene:3: this } does not close the [ of|:2");
    refused("eos = { };\n }", NULL, "t.scene:2: this } closes nothing");
    refused("x = [1, 2,]", NULL, "a value is missing between , and ]");
    refused("x = [1; 2]", NULL, "separated by commas");
    refused("x = [1 2]", NULL, "a comma is missing before 2");
    refused("x = [a = 2]", NULL, "a = ... stands in a list");
    refused("until = 1 2", NULL, "2 stands where a name is expected");
    refused("until = 5ms", NULL, "5ms is not a number");
    refused("until = 2*3", NULL, "2*3 is not a number|arithmetic");
    refused("2d = 1", NULL, "2d stands where a name is expected");
    refused("until = - 5", NULL, "must follow - at once");
    refused("until = 'x'", NULL, "double quotes");
    refused("title = \"x\nuntil = 3", NULL, "t.scene:1: a text has no closing quote");
    refused("until = 1\n/* and so on", NULL, "t.scene:2: the comment that starts here never ends");
    refused("until = 1;;", NULL, "nothing stands before this ;");
    refused("true = 3", NULL, "true is a value and cannot be a name");
    refused("= 3", NULL, "this = has no name before it");
    refused("until = 3 %", NULL, "% means nothing here");
    refused("h\xc3\xb6he = 3", NULL, "outside a to z");
    refused("until = 1; @include \"x\"", NULL, "stands alone on its line");
}

static void names_given_twice_are_refused_with_both_places(void **state)
{
    (void)state;
    refused("until = 1;\nuntil = 2;", NULL, "t.scene:2: until is given twice, first at|t.scene:1");
    refused("fluid = {\n water = { rho0 = 1; };\n oil = { rho0 = 2; };\n water = { rho0 = 3; };\n"
            "};", NULL, "t.scene:4: fluid.water is given twice, first at|t.scene:2|another name");
    refused("beam = { };\nfluid = { };\nbeam = { };", NULL, "t.scene:3: beam is given twice");
}

static void files_that_are_no_scenes_are_refused(void **state)
{
    struct scene *scene = NULL;

    (void)state;
    unlink(in_directory("t.scene"));
    check_refused(NULL, "t.scene: cannot read this scene: No such file");
    status_clear();
    assert_int_equal(scene_read(directory, &scene), STATUS_BAD_SCENE);
    assert_non_null(strstr(status_message(), "it is a directory"));
    assert_null(scene);
    refused("", NULL, "t.scene: this scene is empty");
    refused("# only a remark\n\n", NULL, "is empty");
    write_bytes("t.scene", "until = 1\0;", 11);
    check_refused(NULL, "zero bytes");
}

static void huge_and_deep_scenes_do_not_crash(void **state)
{
    const size_t n = 9 << 20;
    char *bytes = malloc(n + 1);

    (void)state;
    memset(bytes, ' ', n);
    write_bytes("t.scene", bytes, n);
    check_refused(NULL, "8 MB");
    memset(bytes, '(', 100000);
    memcpy(bytes, "x = ", 4);
    write_bytes("t.scene", bytes, 100000);
    check_refused(NULL, "more than 64 brackets");
    for (int i = 0; i < 20000; i++)
        snprintf(bytes + 9 * i, n - 9 * (size_t)i, "a%05d=1;", i);
    write_bytes("t.scene", bytes, 9 * 20000);
    check_refused(NULL, "more than 10000 settings in one group");
    free(bytes);
}

static void long_lists_are_kept_whole(void **state)
{
    char text[20000] = "eos = { outline = ( [0, 0.5]";
    size_t n = strlen(text);
    struct scene *scene;
    struct tank tank;

    (void)state;
    for (int i = 1; i < 1000; i++)
        n += (size_t)snprintf(text + n, sizeof text - n, ", [%d, 0.5]\n", i);
    snprintf(text + n, sizeof text - n, ") };");
    scene = loaded(text, NULL, &tank);
    assert_int_equal(tank.eos.outline.n, 1000);
    for (int i = 0; i < 1000; i++)
        assert_true(tank.eos.outline.x[i][0] == i && tank.eos.outline.x[i][1] == 0.5);
    scene_free(&scene);
}

/* A group that is off is not there; of effects even the name of one that never was is checked. */
static void groups_are_switched(void **state)
{
    const struct scene_node *effects, *root;
    struct scene *scene;

    (void)state;
    write_file("t.scene", "effects = { a = { x = 1; }; b = { }; };\nwall = { w = { }; v = { }; };");
    assert_int_equal(scene_read(in_directory("t.scene"), &scene), STATUS_DONE);
    root = scene_root(scene);
    effects = scene_child(root, "effects");
    assert_int_equal(scene_override(scene, "effects.a=off"), STATUS_DONE);
    assert_null(scene_child(effects, "a"));
    assert_non_null(scene_child(effects, "b"));
    assert_int_equal(scene_override(scene, "effects.b=on"), STATUS_DONE);
    assert_non_null(scene_child(effects, "b"));
    assert_int_equal(scene_override(scene, "effects.c=on"), STATUS_DONE);
    assert_non_null(scene_child(effects, "c"));
    assert_int_equal(scene_override(scene, "effects.d=off"), STATUS_DONE);
    assert_null(scene_child(effects, "d"));
    assert_int_equal(scene_count(effects), 3);
    assert_int_equal(scene_override(scene, "effects.d=on"), STATUS_DONE);
    assert_non_null(scene_child(effects, "d"));
    assert_int_equal(scene_override(scene, "wall.w=off"), STATUS_DONE);
    assert_int_equal(scene_count(scene_child(root, "wall")), 1);
    assert_null(scene_child(scene_child(root, "wall"), "w"));
    scene_free(&scene);
}

/* Numbers and vectors that are off are not there; a text may be this word. */
static void values_are_taken_away(void **state)
{
    const struct scene_node *wall;
    struct scene *scene;

    (void)state;
    write_file("t.scene", "wall = { w = { v = [1, 2]; f = 3; s = \"some\"; }; };");
    assert_int_equal(scene_read(in_directory("t.scene"), &scene), STATUS_DONE);
    wall = scene_child(scene_child(scene_root(scene), "wall"), "w");
    assert_int_equal(scene_override(scene, "wall.w.v=off"), STATUS_DONE);
    assert_null(scene_child(wall, "v"));
    assert_int_equal(scene_override(scene, "wall.f=off"), STATUS_DONE);
    assert_null(scene_child(wall, "f"));
    assert_int_equal(scene_override(scene, "wall.w.s=off"), STATUS_DONE);
    assert_non_null(scene_child(wall, "s"));
    assert_int_equal(scene_count(wall), 1);
    scene_free(&scene);
}

/* --- includes ------------------------------------------------------------------------- */

static void includes_are_looked_for_beside_the_file_that_asks(void **state)
{
    struct tank tank;
    struct scene *scene;
    char absolute[300];

    (void)state;
    mkdir(in_directory("sub"), 0700);
    write_file("sub/eos.cfg", "# deep\n  @include \"c0.cfg\" # beside eos.cfg\nsteps = 7\n");
    write_file("sub/c0.cfg", "c0 = 33\n");
    scene = loaded("eos = {\n@include \"sub/eos.cfg\"\n kind = \"linear\" };\nuntil = 4;", NULL,
                   &tank);
    assert_true(tank.eos.c0 == 33 && tank.eos.steps == 7 && tank.until == 4);
    assert_string_equal(tank.eos.kind, "linear");
    scene_free(&scene);
    write_file("sub/c0.cfg", "\nc0 = -33\n");
    check_refused(NULL, "sub/c0.cfg:2: eos.c0 = -33 m/s lies outside");
    write_file("sub/c0.cfg", "\nsteps = 33\n");
    check_refused(NULL, "sub/eos.cfg:3: eos.steps is given twice|sub/c0.cfg:2");
    write_file("sub/c0.cfg", "c0 = 3");
    refused("eos = {\n@include \"sub/eos.cfg\"\n};\nuntil = 0 }", NULL, "t.scene:4: this }");
    write_file("sub/until.cfg", "until = 6");
    snprintf(absolute, sizeof absolute, "@include \"%s\"", in_directory("sub/until.cfg"));
    scene = loaded(absolute, NULL, &tank);
    assert_true(tank.until == 6);
    scene_free(&scene);
}

static void includes_that_cannot_be_are_refused(void **state)
{
    (void)state;
    for (int i = 0; i <= 17; i++) {
        char name[20], text[40];

        snprintf(name, sizeof name, "chain%d", i);
        snprintf(text, sizeof text, "@include \"chain%d\"", i + 1);
        write_file(name, i < 17 ? text : "until = 1");
    }
    mkfifo(in_directory("fifo"), 0600);
    refused("@include \"fifo\"", NULL, "fifo|no plain file");
    unlink(in_directory("fifo"));
    refused("@include \"/dev/zero\"", NULL, "/dev/zero|no plain file");
    refused("@include \"chain0\"", NULL, "chain15:1: cannot include|too many files");
    for (int i = 0; i <= 17; i++) {
        char name[20];

        snprintf(name, sizeof name, "chain%d", i);
        unlink(in_directory(name));
    }
    refused("until = 1\n@include \"none.cfg\"\n", NULL, "t.scene:2: cannot include|none.cfg: "
            "No such file");
    refused("@include none.cfg", NULL, "t.scene:1: an include is written alone on its line");
    refused("@include \"\"", NULL, "an include is written");
    refused("@include \"a.cfg\" until = 3", NULL, "an include is written");
    refused("@include \".\"", NULL, "directory");
    write_file("a.cfg", "@include \"b.cfg\"\n");
    write_file("b.cfg", "\n@include \"a.cfg\"\n");
    refused("@include \"a.cfg\"\n", NULL, "b.cfg:2: cannot include|it includes itself in the end");
    refused("@include \"t.scene\"\n", NULL, "t.scene:1|it includes itself");
    write_file("a.cfg", "/* open\n");
    refused("@include \"a.cfg\"\n*/", NULL, "a.cfg:1: the comment that starts here never ends");
}

/* Whoever writes a scene may name any file that the reader of its errors may not see. */
static void words_of_an_included_file_are_not_told(void **state)
{
    static const char *const files[] = {
        "secret:0:0\nroot = 3\n", "a = secret\n", "a = 1secret\n", "a = \"secret", "a = [1 secret]",
        "a = [secret = 3]", "secret.b = 3", "secret 3", "1secret = 3", "a = 1 secret", "secret =\nb = 2",
        "c = 1\npassword = secret\n", "secret = \nsecret.b", "c = [secret\n",
    };

    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        write_file("no-scene", files[i]);
        refused("\n@include \"no-scene\"\n", NULL, "no-scene:");
        assert_null(strstr(status_message(), "secret"));
    }
    write_file("no-scene", "until = 1\n");
    refused("@include \"no-scene\"\ntitle = dam", NULL, "t.scene:2: dam has no quotes");
    unlink(in_directory("no-scene"));
}

/* --- the command line ----------------------------------------------------------------- */

static void overrides_set_values_of_every_kind(void **state)
{
    static const char *const given[] = {
        "eos.c0=1e3", "eos.clamp=false", "eos.kind=linear", "eos.note=\"a b\"", "eos.x=[1,-2.5]",
        " eos.steps = 9 ", "eos.fields=[\"dye\"]", "title=5", "gravity=(0, -1)", "until=3000000000",
        "eos.outline=[[0,1],[2,3]]", "effects.viscosity.mu=0.5", "effects.gravity={}",
    };
    struct tank tank;
    struct scene *scene = loaded("until = 1; title = \"old\"; eos = { note = \"x\" }", NULL, &tank);

    (void)state;
    for (size_t i = 0; i < sizeof given / sizeof *given; i++)
        assert_int_equal(scene_override(scene, given[i]), STATUS_DONE);
    fill(scene, &tank);
    assert_string_equal(status_message(), "");
    assert_true(tank.eos.c0 == 1000 && !tank.eos.clamp && tank.eos.steps == 9);
    assert_string_equal(tank.eos.kind, "linear");
    assert_string_equal(tank.eos.note, "a b");
    assert_true(tank.eos.x[0] == 1 && tank.eos.x[1] == -2.5 && tank.gravity[1] == -1);
    assert_int_equal(tank.eos.fields, 4);
    assert_string_equal(tank.title, "5");
    assert_true(tank.until == 3e9 && tank.eos.outline.n == 2 && tank.eos.outline.x[1][0] == 2);
    assert_true(tank.mu == 0.5);
    assert_non_null(scene_child(scene_child(scene_root(scene), "effects"), "gravity"));
    scene_free(&scene);
}

static void what_does_not_parse_is_a_text(void **state)
{
    static const char *const values[] = { "dam break", "[0, 1", "1; until = 3", "a\"b", "", "5 m",
                                          "\n@include \"none.cfg\"", "x = 3", "{", "#1" };
    struct tank tank;

    (void)state;
    for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
        char assignment[100];
        const char *text = values[i] + strspn(values[i], "\n");
        struct scene *scene;

        snprintf(assignment, sizeof assignment, "title=%s", values[i]);
        scene = loaded("until = 1", assignment, &tank);
        assert_string_equal(tank.title, text);
        scene_free(&scene);
    }
}

static void a_name_left_out_means_all_of_that_kind(void **state)
{
    static const char two[] = "beam = { a = { E = 1 }; b = { } }; eos = { c0 = 1 }; until = 1";
    struct tank tank;
    struct scene *scene = loaded(two, "beam.E=7", &tank);
    const struct scene_node *beam;

    (void)state;
    assert_true(tank.modulus[0] == 7 && tank.modulus[1] == 7);
    assert_int_equal(scene_override(scene, "beam.b.E=8"), STATUS_DONE);
    assert_int_equal(scene_override(scene, "beam.c={ E = 9 }"), STATUS_DONE);
    assert_int_equal(fill(scene, &tank), STATUS_DONE);
    beam = scene_child(scene_root(scene), "beam");
    assert_int_equal(scene_line(scene_child(scene_child(beam, "c"), "E")), 0);
    assert_true(tank.modulus[0] == 7 && tank.modulus[1] == 8 && tank.modulus[2] == 9);
    scene_free(&scene);
}

static void a_name_left_out_reaches_groups_in_groups(void **state)
{
    const struct scene_node *beam;
    struct scene *scene;

    (void)state;
    write_file("t.scene", "beam = { a = { end = { k = 1 } }; b = { } };");
    assert_int_equal(scene_read(in_directory("t.scene"), &scene), STATUS_DONE);
    assert_int_equal(scene_override(scene, "beam.end.k=2"), STATUS_DONE);
    assert_int_equal(scene_override(scene, "beam.load.k=2"), STATUS_DONE); /* none has it */
    beam = scene_child(scene_root(scene), "beam");
    assert_string_equal(scene_where(scene_child(scene_child(scene_at(beam, 0), "end"), "k")),
                        "command line");
    assert_non_null(scene_child(scene_child(scene_at(beam, 1), "end"), "k"));
    assert_int_equal(scene_count(beam), 3);
    assert_non_null(scene_child(scene_child(beam, "load"), "k"));
    scene_free(&scene);
}

static void overrides_that_fit_nothing_are_refused(void **state)
{
    (void)state;
    refused("until = 1", "beam.E=7", "command line: beam.E is set for every beam, but the scene "
            "has none");
    refused("until = 1; beam = { a = { } }", "beam.F=7", "command line: unknown key beam.a.F");
    refused("until = 1", "utnil=7", "command line: unknown key utnil; did you mean until?");
    refused("beam = { a = { } }", "utnil=7", "command line: unknown key utnil; did you mean");
    refused("until = 1", "until=5 ms", "command line: until = \"5 ms\" is a text, but a number in s is "
            "expected|numbers stand without quotes and units");
    refused("until = 1", "until=soon", "command line: until = \"soon\" is a text, but a number in "
            "s is expected");
    refused("until = 1", "until=-1", "command line: until = -1 s lies outside");
    refused("until = 1", "until", "\"until\" has no =|KEY=VALUE");
    refused("until = 1", "=3", "\"=3\" has a key that is no name");
    refused("until = 1", "eos..c0=3", "has a key that is no name");
    refused("until = 1", "eos.c 0=3", "has a key that is no name");
    refused("until = 1", "a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a=1", "too many dots");
    refused("until = 1", "until.x=3", "until|t.scene:1|is a value, not a group");
}

/* --- scene.used ----------------------------------------------------------------------- */

static char *used(const struct scene *scene)
{
    char *text = NULL;
    size_t n = 0;
    FILE *stream = open_memstream(&text, &n);

    assert_int_equal(scene_write_used(scene, stream), STATUS_DONE);
    fclose(stream);
    return text;
}

static const char everything[] =
    "until = 0.1; gravity = [-0.0, -9.8100000000000005]; seed = [1, \"two\", true];\n"
    "title = \"\\\"quoted\\\" \\\\ back\\nline\\ttab \\x01 \xc3\xa9\";\n"
    "eos = { c0 = 3.3333333333333333e-5; kind = \"clamped-tait\"; fields = [];\n"
    "  x = [1e-310, 0.30000000000000004]; outline = ([0.1, 0.2], [3, 4e20]); clamp = false };\n"
    "effects = { gravity = { }; viscosity = { mu = 0.7 } };\n"
    "fluid = { water = { rho0 = 1000 }; oil-2 = { rho0 = 900 } }; beam = { a = { } };";

static void scene_used_read_again_gives_the_same_bits(void **state)
{
    struct tank tank, again;
    struct scene *scene = loaded(everything, NULL, &tank), *second;
    char *first_text, *second_text;

    (void)state;
    scene_computed(scene, "eos", "speed", 1.0 / 3.0);
    scene_computed(scene, "eos", "c0", 77); /* was given: stays */
    first_text = used(scene);
    second = loaded(first_text, NULL, &again);
    assert_true(again.eos.speed == 1.0 / 3.0 && isnan(tank.eos.speed));
    assert_true(signbit(again.gravity[0]) && again.eos.cold == tank.eos.cold);
    assert_memory_equal(&again.eos.x, &tank.eos.x, sizeof tank.eos.x);
    assert_memory_equal(again.eos.outline.x, tank.eos.outline.x, 2 * sizeof *tank.eos.outline.x);
    assert_true(again.eos.c0 == tank.eos.c0 && again.until == tank.until);
    assert_memory_equal(again.gravity, tank.gravity, sizeof tank.gravity);
    assert_string_equal(again.title, tank.title);
    assert_string_equal(again.eos.kind, tank.eos.kind);
    assert_true(again.eos.fields == 0 && !again.eos.clamp && again.eos.steps == tank.eos.steps);
    assert_true(again.mu == 0.7 && again.modulus[0] == 1e9);
    assert_memory_equal(again.rho0, tank.rho0, sizeof tank.rho0);
    second_text = used(second);
    scene_free(&second);
    second = loaded(second_text, NULL, &again); /* by now all values are given ones */
    free(first_text);
    first_text = used(second);
    assert_string_equal(first_text, second_text);
    free(first_text);
    free(second_text);
    scene_free(&second);
    scene_free(&scene);
}

static void scene_used_says_unit_and_origin_of_each_value(void **state)
{
    static const char *const lines[] = {
        "until = 0.1;  # s\n", "    c0 = 3.3333333333333335e-05;  # m/s\n",
        "    steps = 5;  # default\n", "    speed = 0.5;  # m/s, computed\n",
        "    # drift = [nan, nan];  # m/s, default\n", "    # count = nan;  # default\n",
        "    gravity = {\n    };\n", "        mu = 0.7;  # Pa s\n",
        "        rho0 = 1000;  # kg/m^3\n", "        E = 1e+09;  # Pa, default\n",
        "seed = (1, \"two\", true);\n", "    oil-2 = {\n",
    };
    struct tank tank;
    struct scene *scene = loaded(everything, NULL, &tank);
    char *text;

    (void)state;
    scene_computed(scene, "eos", "speed", 0.5);
    scene_computed(scene, "eos", "drift", NAN);
    scene_computed(scene, "nowhere", "speed", 0.5);
    text = used(scene);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (!strstr(text, lines[i]))
            fail_msg("\"%s\" is not in\n%s", lines[i], text);
    assert_true(strstr(text, "until") < strstr(text, "eos") &&
                strstr(text, "eos") < strstr(text, "effects"));
    free(text);
    scene_free(&scene);
}

static void a_group_filled_twice_is_noted_once(void **state)
{
    static const char *const mu[] = { "mu", NULL }, *const modulus[] = { "E", NULL };
    struct scene *scene;
    double value;
    char *text;

    (void)state;
    write_file("t.scene", "part = { E = 5; mu = 3; }");
    assert_int_equal(scene_read(in_directory("t.scene"), &scene), STATUS_DONE);
    for (int i = 0; i < 2; i++) {
        const struct scene_node *part = scene_child(scene_root(scene), "part");

        assert_int_equal(scene_fill(scene, part, "part", beam_rows, mu, 2, &value), STATUS_DONE);
        assert_int_equal(scene_fill(scene, part, "part", mu_rows, modulus, 2, &value), STATUS_DONE);
    }
    text = used(scene);
    assert_string_equal(strchr(text, '\n') + 1, "part = {\n    E = 5;  # Pa\n    mu = 3;  # Pa s\n"
                        "};\n");
    free(text);
    scene_free(&scene);
}

static void a_full_disk_is_an_error_of_output(void **state)
{
    struct tank tank;
    struct scene *scene = loaded(everything, NULL, &tank);
    FILE *full = fopen("/dev/full", "w");

    (void)state;
    if (full) {
        setvbuf(full, NULL, _IONBF, 0);
        assert_int_equal(scene_write_used(scene, full), STATUS_IO);
        fclose(full);
    }
    scene_free(&scene);
}

/* --- what is given -------------------------------------------------------------------- */

static void every_setting_that_is_given_has_a_line(void **state)
{
    static const char lines[] =
        "until = 0.1\ngravity = (-0, -9.81)\nseed = (1, \"two\", true)\n"
        "title = \"\\\"quoted\\\" \\\\ back\\nline\\x09tab \\x01 \xc3\xa9\"\n"
        "eos.c0 = 5\neos.kind = \"clamped-tait\"\neos.fields = ()\neos.x = (1e-310, 0.30000000000000004)\n"
        "eos.outline = ((0.1, 0.2), (3, 4e+20))\neos.clamp = false\n"
        "effects.gravity = { }\neffects.buoyancy = off\nfluid.water.rho0 = 1000\nfluid.oil-2.rho0 = 900\n"
        "beam.a = { }\n";
    struct scene *scene;
    char *text = NULL;
    size_t n = 0;
    FILE *stream = open_memstream(&text, &n);

    (void)state;
    write_file("t.scene", everything);
    assert_int_equal(scene_read(in_directory("t.scene"), &scene), STATUS_DONE);
    assert_int_equal(scene_override(scene, "eos.c0=5"), STATUS_DONE);
    assert_int_equal(scene_override(scene, "effects.viscosity=off"), STATUS_DONE);
    assert_int_equal(scene_override(scene, "effects.buoyancy=off"), STATUS_DONE);
    scene_write_given(scene, stream);
    fclose(stream);
    assert_string_equal(text, lines);
    free(text);
    scene_free(&scene);
}

/* --- broken bytes --------------------------------------------------------------------- */

/* Whatever the bytes are: an answer, a message exactly when it is a refusal, no crash. */
static void check_any(const char *bytes, size_t n)
{
    struct scene *scene = NULL;
    struct tank tank;
    int status;

    write_bytes("t.scene", bytes, n);
    status_clear();
    status = load(NULL, &scene, &tank);
    assert_true(status == STATUS_DONE || status == STATUS_BAD_SCENE);
    assert_int_equal(status != STATUS_DONE, status_message()[0] != '\0');
    if (status == STATUS_DONE)
        free(used(scene));
    scene_free(&scene);
}

static void a_scene_cut_off_anywhere_is_answered(void **state)
{
    (void)state;
    for (size_t n = 0; n < sizeof everything; n++)
        check_any(everything, n);
}

static void a_scene_with_any_wrong_byte_is_answered(void **state)
{
    static const char wrong[] = "\0\n\"({[)}]=;,@#/*\\ .-+aE9\x80\xff";
    char bytes[sizeof everything];

    (void)state;
    for (size_t i = 0; i < sizeof everything - 1; i++)
        for (size_t k = i % 3; k < sizeof wrong - 1; k += 3) {
            memcpy(bytes, everything, sizeof bytes);
            bytes[i] = wrong[k];
            check_any(bytes, sizeof bytes - 1);
        }
}

/* --- all of them ---------------------------------------------------------------------- */

static int make_directory(void **state)
{
    const char *above = getenv("TMPDIR");

    (void)state;
    snprintf(directory, sizeof directory, "%.40s/scene-XXXXXX", above ? above : P_tmpdir);
    return mkdtemp(directory) ? 0 : -1;
}

static int remove_directory(void **state)
{
    static const char *const files[] = { "t.scene", "a.cfg", "b.cfg", "sub/eos.cfg", "sub/c0.cfg",
                                         "sub/until.cfg" };

    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        unlink(in_directory(files[i]));
    rmdir(in_directory("sub"));
    return rmdir(directory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_of_every_kind_are_read),
        cmocka_unit_test(large_and_odd_numbers_keep_their_value),
        cmocka_unit_test(marks_of_other_editors_do_no_harm),
        cmocka_unit_test(a_group_that_is_not_there_gives_all_defaults),
        cmocka_unit_test(nodes_know_name_file_and_line),
        cmocka_unit_test(wrong_values_are_refused_with_what_would_be_right),
        cmocka_unit_test(vectors_and_points_are_counted),
        cmocka_unit_test(unknown_keys_get_the_nearest_known_one),
        cmocka_unit_test(the_nearest_word_is_near),
        cmocka_unit_test(broken_syntax_is_explained),
        cmocka_unit_test(names_given_twice_are_refused_with_both_places),
        cmocka_unit_test(files_that_are_no_scenes_are_refused),
        cmocka_unit_test(huge_and_deep_scenes_do_not_crash),
        cmocka_unit_test(long_lists_are_kept_whole),
        cmocka_unit_test(groups_are_switched),
        cmocka_unit_test(values_are_taken_away),
        cmocka_unit_test(includes_are_looked_for_beside_the_file_that_asks),
        cmocka_unit_test(includes_that_cannot_be_are_refused),
        cmocka_unit_test(words_of_an_included_file_are_not_told),
        cmocka_unit_test(overrides_set_values_of_every_kind),
        cmocka_unit_test(what_does_not_parse_is_a_text),
        cmocka_unit_test(a_name_left_out_means_all_of_that_kind),
        cmocka_unit_test(a_name_left_out_reaches_groups_in_groups),
        cmocka_unit_test(overrides_that_fit_nothing_are_refused),
        cmocka_unit_test(scene_used_read_again_gives_the_same_bits),
        cmocka_unit_test(scene_used_says_unit_and_origin_of_each_value),
        cmocka_unit_test(a_group_filled_twice_is_noted_once),
        cmocka_unit_test(a_full_disk_is_an_error_of_output),
        cmocka_unit_test(every_setting_that_is_given_has_a_line),
        cmocka_unit_test(a_scene_cut_off_anywhere_is_answered),
        cmocka_unit_test(a_scene_with_any_wrong_byte_is_answered),
    };

    return cmocka_run_group_tests(tests, make_directory, remove_directory);
}
