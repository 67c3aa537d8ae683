/* added.c -- what every added part must do. */
#include "added.h"

#include "base/status.h"
#include "plan/catalogue.h"
#include "plan/inside.h"
#include "space/laws.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern const struct part *const effects_table_lanes2[], *const effects_table_lanes4[],
    *const effects_table_lanes8[];
extern const struct part *const walls_table_lanes2[], *const walls_table_lanes4[],
    *const walls_table_lanes8[];

/* The tables of all widths that the build has, whatever this machine can run. */
static const struct part *const *const tables[][2] = {
    { effects_table_lanes2, walls_table_lanes2 },
#ifdef STIFFWATER_V3
    { effects_table_lanes4, walls_table_lanes4 },
#endif
#ifdef STIFFWATER_V4
    { effects_table_lanes8, walls_table_lanes8 },
#endif
};
enum { TABLES = sizeof tables / sizeof tables[0] };

#if DIM == 2
const char *const added_lattice =
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, 0.0];"
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.1]; periodic = [\"x\", \"y\"]; };"
    "reference = { speed = 1.0; }; eos = { c0 = 20.0; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.1, 0.1]; }; };";
const double added_wave = 0.1;
#else
const char *const added_lattice =
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, 0.0];"
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.4, 0.2, 0.2]; periodic = [\"x\", \"y\", \"z\"]; };"
    "reference = { speed = 1.0; }; eos = { c0 = 20.0; };"
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.4, 0.2, 0.2]; }; };";
const double added_wave = 0.4;
#endif

static const struct part *find(enum added_table table, const char *name)
{
    const struct part *found = NULL;

    for (int i = 0; i < TABLES; i++) {
        found = catalogue_part(tables[i][table], name);
        check(found, "%d lanes: %s is not in the table", 2 << i, name);
    }
    return found;
}

static void check_text(int (*tell)(const char *, FILE *), const char *of, const char *words)
{
    size_t size;
    char *text;
    FILE *to = open_memstream(&text, &size);

    assert_non_null(to);
    assert_int_equal(tell(of, to), STATUS_DONE);
    fclose(to);
    check(strstr(text, words), "%s: \"%s\" is not in: %s", of, words, text);
    free(text);
}

void added_is_told(enum added_table table, const char *name)
{
    const struct part *part = find(table, name);

    check_text(catalogue_list, table == ADDED_EFFECTS ? "effects" : "walls", part->about);
    check_text(catalogue_explain, name, part->equation);
    check_text(catalogue_explain, name, part->source);
    for (const struct param *r = part->params; r && r->key; r++)
        check_text(catalogue_explain, name, r->about);
}

void added_costs_nothing(const char *name)
{
    const struct part *const part = catalogue_part(engine_pick()->effects, name);
    const struct layout *l;
    const char *path;
    struct tank t;

    tank_make(&t, tank_water, tank_frame, TANK_EFFECTS, NULL);
    for (int i = 0; i < plan_parts(t.plan); i++)
        assert_string_not_equal(plan_part(t.plan, i, &path)->name, name);
    for (int i = 0; part && part->as.law && i < KINDS * KINDS; i++)
        for (int k = 0; k < t.plan->table.all[i].n; k++)
            check(t.plan->table.all[i].work[k].law != part->as.law->pairs, "%s is at work", name);
    assert_int_equal(t.plan->passes.fields, 0);
    l = plan_layout(t.plan);
    assert_int_equal(l->rows, 5); /* x, u, both densities, book */
    tank_free(&t);
}

void added_at_all_widths(void (*check_one)(void))
{
    static const char *const wish[] = { "2", "4", "8" };
    const int most = engine_pick()->lanes;

    for (int i = 0; 2 << i <= most; i++) {
        setenv("STIFFWATER_LANES", wish[i], 1);
        assert_int_equal(engine_pick()->lanes, 2 << i);
        check_one();
    }
    unsetenv("STIFFWATER_LANES");
}
