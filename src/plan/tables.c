/* tables.c -- which laws act between which kinds, in table order, and which fields
 * are summed before them. */
#include "plan/inside.h"

#include "base/status.h"
#include "space/laws.h"

/* The density of solids that a wall model settles by itself has no rate. */
static bool owns(const struct plan *p, const struct part *part, int owner)
{
    const bool solid = KIND_BIT(owner) & KIND_SOLIDS;

    return !(solid && part->columns == COLUMN_DRHO && !p->walls_as_fluid);
}

static int add_law(struct plan *p, struct pairs_table *table, const struct plan_part *part,
                   int owner, int partner)
{
    struct pairs_table *t = &table[owner * KINDS + partner];

    if (!(part->part->acts[owner] & KIND_BIT(partner)) || !owns(p, part->part, owner))
        return STATUS_DONE;
    if (t->n == PAIRS_LAWS)
        return status_fail(STATUS_BAD_SCENE, "more than %d effects between particles", PAIRS_LAWS);
    t->work[t->n++] = (struct pairs_work){
        .law = part->part->choose ? part->part->choose(part->self) : part->part->pairs,
        .self = part->self,
        .kernel = p->kernel[part->part->kernel],
        .slot = part->slot,
        .needs = part->part->rows,
    };
    p->list_def.acts[owner] |= KIND_BIT(partner);
    t->needs |= part->part->rows;
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

/* The laws of these sides that add to these columns and to no others; 0: all laws. */
static int make_table(struct plan *p, struct pairs_table *table, enum sides sides,
                      unsigned columns)
{
    for (int i = 0; i < p->parts; i++) {
        const struct plan_part *part = &p->part[i];
        if (part->slot < 0 || (columns && part->part->columns != columns)
            || !(sides & (part == p->stiff ? IMPLICIT : EXPLICIT)))
            continue;
        for (int a = 0; a < KINDS; a++)
            for (int b = 0; b < KINDS; b++)
                TRY(add_law(p, table, part, a, b));
    }
    for (int i = 0; i < KINDS * KINDS; i++) {
        share_kernels(&table[i]);
        p->engine->sum->arrange(&table[i], true);
    }
    return STATUS_DONE;
}

int plan_tables_make(struct plan *p)
{
    enum { ONE = KINDS * KINDS };

    p->table = status_alloc(5 * ONE, sizeof *p->table);
    if (!p->table)
        return STATUS_FAILED;
    p->rates = p->table + ONE;
    p->forces = p->table + 2 * ONE;
    p->explicit = p->stiff ? p->table + 3 * ONE : p->table;
    p->implicit = p->table + 4 * ONE;
    for (int i = 0; i < p->parts; i++)
        p->mixed |= p->part[i].part->columns == (COLUMN_DRHO | COLUMN_FORCE);
    TRY(make_table(p, p->table, BOTH, 0));
    TRY(make_table(p, p->rates, BOTH, COLUMN_DRHO));
    TRY(make_table(p, p->forces, BOTH, COLUMN_FORCE));
    if (!p->stiff)
        return STATUS_DONE;
    TRY(make_table(p, p->explicit, EXPLICIT, 0));
    return make_table(p, p->implicit, IMPLICIT, 0);
}

static void add_field(struct plan *p, const struct plan_part *part)
{
    struct plan_field *f = &p->field[p->fields++];

    f->part = part;
    if (part->part->carry)
        p->drifter = part;
    for (int k = 0; k < KINDS; k++) {
        const bool solid = KIND_BIT(k) & KIND_SOLIDS;
        if (!(solid && (part->part->provides & FIELD_DENSITY) && !p->walls_as_fluid))
            f->meets[k] = part->part->meets[k];
        p->list_def.acts[k] |= f->meets[k];
    }
}

/* The fluid's density first: the others are made of it. */
void plan_fields_make(struct plan *p)
{
    for (int first = 1; first >= 0; first--)
        for (int i = 0; i < p->parts; i++)
            if (p->part[i].part->gather
                && first == ((p->part[i].part->provides & FIELD_DENSITY) != 0))
                add_field(p, &p->part[i]);
}
