/* arkode-vectors.c -- how much memory an ARKStep takes, in vectors, before there is one. */
#include "time/arkode.h"

/* Of SUNDIALS' own, counted in 6.4.1: y now and at the last step, weights of both
 * tests, the interpolant's, the stage's data, what is summed. */
enum { OF_ARKSTEP = 11 };

int arkode_vectors(const struct method *m, const struct plan *plan)
{
    const struct arkode_row *row = (const struct arkode_row *)m; /* its first member */
    const int sides = arkode_tables_implicit(row) && plan_stiff(plan) ? 2 : 1;
    const int nodes = row->order > 4 ? ARKODE_NODES : 2;

    /* nodes: y and f; our weights */
    return OF_ARKSTEP + sides * arkode_tables_stages(row) + 2 * nodes + 1;
}
