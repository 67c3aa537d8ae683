/* arkode-vectors.c -- how much memory an ARKStep takes, in vectors, before there is one. */
#include "time/arkode.h"

/* Of SUNDIALS' own, counted in 6.4.1: y now and at the last step, weights of both
 * tests, the interpolant's, the stage's data, what is summed. */
enum { OF_ARKSTEP = 11 };

static int stages(const struct arkode_row *row)
{
    const ARKodeButcherTable table = row->own ? NULL : ARKodeButcherTable_LoadERKByName(row->erk);
    const int n = row->own ? row->own->stages : table ? table->stages : TABLEAU_STAGES;

    ARKodeButcherTable_Free(table);
    return n;
}

int arkode_vectors(const struct method *m, const struct plan *plan)
{
    const struct arkode_row *row = (const struct arkode_row *)m; /* its first member */
    const int sides = row->dirk && plan_stiff(plan) ? 2 : 1;
    const int nodes = row->order > 4 ? ARKODE_NODES : 2;

    return OF_ARKSTEP + sides * stages(row) + 2 * nodes + 1; /* nodes: y and f; our weights */
}
