/* arkode-tables.c -- the tables of a method: SUNDIALS' by their names, ours, or for
 * bodies alone the explicit partner that an implicit table makes for itself. */
#include "time/arkode.h"

#include "time/stability.h"
#include <stdio.h>
#include <string.h>

static ARKodeButcherTable of_ours(const struct tableau *t)
{
    double flat[TABLEAU_STAGES * TABLEAU_STAGES], b[TABLEAU_STAGES], c[TABLEAU_STAGES],
        d[TABLEAU_STAGES];

    for (int i = 0; i < t->stages; i++) {
        memcpy(flat + i * t->stages, t->a[i], (size_t)t->stages * sizeof *flat);
        c[i] = tableau_node(t, i);
    }
    memcpy(b, t->b, sizeof b);
    memcpy(d, t->d, sizeof d);
    return ARKodeButcherTable_Create(t->stages, t->order, t->embedded, c, flat, b, d);
}

/* For a right-hand side that is the implicit side and a load that neither changes
 * between events nor feels the state: a stage at c h has received c h of the load,
 * which all stands in the first stage.  With b and d of the implicit table, the sum
 * of both sides takes the very steps that the implicit table takes of the whole, and
 * quadratures get its weights.  Its first stage must be explicit. */
static ARKodeButcherTable partner(const ARKodeButcherTable of)
{
    ARKodeButcherTable t = of ? ARKodeButcherTable_Copy(of) : NULL;

    if (!t)
        return NULL;
    for (int i = 0; i < t->stages; i++) {
        memset(t->A[i], 0, (size_t)t->stages * sizeof *t->A[i]);
        t->A[i][0] = t->c[i];
    }
    return t;
}

static ARKodeButcherTable implicit(const struct arkode_row *row)
{
    return row->own_dirk ? of_ours(row->own_dirk) : ARKodeButcherTable_LoadDIRKByName(row->dirk);
}

static ARKodeButcherTable explicit_of(const struct arkode_row *row)
{
    return row->own ? of_ours(row->own) : ARKodeButcherTable_LoadERKByName(row->erk);
}

static bool explicit_alone(const struct arkode_row *row)
{
    return row->own || row->erk;
}

bool arkode_tables_implicit(const struct arkode_row *row)
{
    return row->dirk || row->own_dirk;
}

int arkode_tables_stages(const struct arkode_row *row)
{
    const ARKodeButcherTable t = explicit_alone(row) ? explicit_of(row) : implicit(row);
    const int stages = t ? t->stages : TABLEAU_STAGES;

    ARKodeButcherTable_Free(t);
    return stages;
}

static bool fits(const struct arkode_row *row, const ARKodeButcherTable t)
{
    return t && t->stages <= TABLEAU_STAGES && t->d && t->q == row->order;
}

void arkode_tables_read(const ARKodeButcherTable from, struct tableau *t)
{
    *t = (struct tableau){ .stages = from->stages, .order = from->q, .embedded = from->p };
    for (int i = 0; i < t->stages; i++) {
        memcpy(t->a[i], from->A[i], (size_t)t->stages * sizeof(double));
        t->b[i] = from->b[i];
        t->d[i] = from->d[i];
    }
}

static void keep(struct arkode *a, const ARKodeButcherTable from)
{
    arkode_tables_read(from, &a->table);
    /* beams taken explicitly have no damping to speak of */
    a->stable.wave = stability_wave(&a->table,
                                    plan_stiff(a->plan) && !a->imex ? 0 : STABILITY_DAMPING);
    a->stable.decay = stability_decay(&a->table);
}

/* Ten periods of a beam's first mode take a thousandth of its amplitude. */
static void keep_implicit(struct arkode *a, const ARKodeButcherTable from)
{
    struct tableau t;

    arkode_tables_read(from, &t);
    a->stable.swing = stability_swing(&t, 1e-3);
}

static void name(struct arkode *a)
{
    const struct arkode_row *row = a->row;
    const char *of_explicit = row->own ? row->own->name : row->erk ? row->erk : "",
               *of_implicit = row->own_dirk ? row->own_dirk->name : row->dirk;

    snprintf(a->tables, sizeof a->tables, "%s%s%s", of_explicit,
             a->imex && of_explicit[0] ? " + " : "", a->imex ? of_implicit : "");
}

bool arkode_tables_set(struct arkode *a)
{
    const struct arkode_row *row = a->row;
    ARKodeButcherTable dirk = a->imex ? implicit(row) : NULL;
    ARKodeButcherTable erk = explicit_alone(row) ? explicit_of(row) : partner(dirk);
    const bool fine = fits(row, erk) && (!a->imex || fits(row, dirk))
                   && ARKStepSetTables(a->ark, erk->q, erk->p, dirk, erk) == 0;

    name(a);
    if (fine)
        keep(a, erk);
    if (fine && a->imex)
        keep_implicit(a, dirk);
    ARKodeButcherTable_Free(dirk);
    ARKodeButcherTable_Free(erk);
    return fine;
}
