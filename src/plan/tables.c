/* tables.c -- which laws act between which kinds, in table order, and which densities
 * are summed before them. */
#include "plan/inside.h"

#include "base/status.h"
#include "space/laws.h"

#include <string.h>

/* The density of solids that a wall model settles by itself has no rate. */
static bool owns(const struct plan *p, const struct part_law *law, int owner)
{
    const bool solid = KIND_BIT(owner) & KIND_SOLIDS;

    return !(solid && law->columns == COLUMN_DRHO && !p->in.walls->as.wall->as_fluid);
}

/* Partner kinds by owner kind. */
static const unsigned *kinds_of(const struct plan_part *part)
{
    const struct part_law *law = part->part->as.law;

    return law->kinds ? law->kinds(part->self) : law->acts;
}

/* Partner kinds that a part may have, where one effect alone acts between fluid and solids. */
static unsigned may_meet(const struct plan *p, const struct plan_part *part, int owner)
{
    const char *only = p->in.walls->as.wall->only;

    if (!only || strcmp(part->part->name, only) == 0)
        return ~0u;
    return KIND_BIT(owner) & KIND_SOLIDS ? ~KIND_BIT(KIND_FLUID) : ~KIND_SOLIDS;
}

static int add_law(struct plan *p, struct pairs_table *table, const struct plan_part *part,
                   int owner, int partner)
{
    const struct part_law *law = engine_law(p->engine, part->part);
    struct pairs_table *t = &table[owner * KINDS + partner];

    if (!(kinds_of(part)[owner] & may_meet(p, part, owner) & KIND_BIT(partner))
        || !owns(p, law, owner))
        return STATUS_DONE;
    if (t->n == PAIRS_LAWS)
        return status_fail(STATUS_BAD_SCENE, "more than %d effects between particles", PAIRS_LAWS);
    t->work[t->n++] = (struct pairs_work){
        .law = law->choose ? law->choose(part->self) : law->pairs,
        .self = part->self,
        .kernel = p->table.kernel[law->kernel],
        .slot = part->slot,
        .needs = law->rows,
    };
    p->list_def.acts[owner] |= KIND_BIT(partner);
    t->needs |= law->rows;
    return STATUS_DONE;
}

/* Laws that stand together and share a kernel ask for its rows once. */
static void share_kernels(struct pairs_table *t)
{
    for (int i = t->n - 1; i > 0; i--)
        if (t->work[i].kernel == t->work[i - 1].kernel) {
            t->work[i - 1].needs |= t->work[i].needs;
            t->work[i].needs = 0;
        }
}

enum sides { EXPLICIT = 1, IMPLICIT = 2, BOTH = 3 };

/* Which laws a table holds. */
struct choice {
    enum sides sides;
    unsigned columns;      /* those that add to these and to no others; 0: all */
    bool without_pressure; /* those that do not read it                        */
};

static bool is_chosen(const struct plan *p, const struct plan_part *part,
                      const struct choice *which)
{
    const struct part_law *law = part->part->as.law;

    if (!law || (which->columns && law->columns != which->columns))
        return false;
    if (which->without_pressure && (part->part->needs & FIELD_PRESSURE))
        return false;
    return which->sides & (part == p->stiff ? IMPLICIT : EXPLICIT);
}

static int make_table(struct plan *p, struct pairs_table *table, struct choice which)
{
    for (int i = 0; i < p->parts; i++) {
        if (!is_chosen(p, &p->part[i], &which))
            continue;
        for (int a = 0; a < KINDS; a++)
            for (int b = 0; b < KINDS; b++)
                TRY(add_law(p, table, &p->part[i], a, b));
    }
    for (int i = 0; i < KINDS * KINDS; i++) {
        share_kernels(&table[i]);
        p->engine->sum->arrange(&table[i], true);
    }
    return STATUS_DONE;
}

/* The mass that all particles have, or 0. */
static double common_mass(const struct particles *p)
{
    for (int i = 1; i < p->n; i++)
        if (p->m[i] != p->m[0])
            return 0;
    return p->n > 0 ? p->m[0] : 0;
}

int plan_tables_make(struct plan *p)
{
    enum { ONE = KINDS * KINDS };
    struct plan_tables *to = &p->table;

    to->all = status_alloc(6 * ONE, sizeof *to->all);
    if (!to->all)
        return STATUS_FAILED;
    to->mass = common_mass(p->particles);
    to->densities = to->all + ONE;
    to->velocities = to->all + 2 * ONE;
    to->without_pressure = to->all + 3 * ONE;
    to->explicit = p->stiff ? to->all + 4 * ONE : to->all;
    to->implicit = to->all + 5 * ONE;
    for (int i = 0; i < p->parts; i++)
        to->mixed |= p->part[i].part->as.law
                    && p->part[i].part->as.law->columns == (COLUMN_DRHO | COLUMN_FORCE);
    TRY(make_table(p, to->all, (struct choice){ BOTH, 0, false }));
    TRY(make_table(p, to->densities, (struct choice){ BOTH, COLUMN_DRHO, false }));
    TRY(make_table(p, to->velocities, (struct choice){ BOTH, COLUMN_FORCE, false }));
    TRY(make_table(p, to->without_pressure, (struct choice){ BOTH, 0, true }));
    if (!p->stiff)
        return STATUS_DONE;
    TRY(make_table(p, to->explicit, (struct choice){ EXPLICIT, 0, false }));
    return make_table(p, to->implicit, (struct choice){ IMPLICIT, 0, false });
}

static void add_field(struct plan *p, const struct plan_part *part)
{
    struct plan_field *f = &p->passes.field[p->passes.fields++];

    f->part = part;
    if (part->part->as.summed->carry)
        p->drifter = part;
    for (int k = 0; k < KINDS; k++) {
        const bool solid = KIND_BIT(k) & KIND_SOLIDS;
        if (!(solid && (part->part->provides & FIELD_DENSITY) && !p->in.walls->as.wall->as_fluid))
            f->meets[k] = part->part->as.summed->meets[k] & may_meet(p, part, k);
        p->list_def.acts[k] |= f->meets[k];
    }
}

/* Sums of a filter need pairs as laws do. */
static void add_filter(struct plan *p, const struct part_filter *filter)
{
    p->passes.filters = true;
    for (int k = 0; k < KINDS; k++)
        p->list_def.acts[k] |= filter->meets[k];
}

/* In which order they are summed is the passes' matter. */
void plan_fields_make(struct plan *p)
{
    for (int i = 0; i < p->parts; i++) {
        if (p->part[i].part->as.summed)
            add_field(p, &p->part[i]);
        if (p->part[i].part->as.filter)
            add_filter(p, p->part[i].part->as.filter);
    }
}
