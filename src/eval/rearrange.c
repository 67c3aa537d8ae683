/* rearrange.c -- particles change rows: what a moment keeps of them goes along. */
#include "eval/rearrange.h"

#include "base/status.h"
#include "eval/inside.h"
#include "plan/solver.h"
#include "state/particles-private.h"

#include <string.h>

static int move_list(struct moment *m, const int *const from[KINDS])
{
    const int *row[KINDS];

    memcpy(row, m->particles->row, sizeof row);
    return m->plan->engine->sum->list->rearrange(m->own, from, row);
}

int moment_rearrange(struct moment *m, const int *const from[KINDS])
{
    if (m->beside)
        particles_follow(m->particles, m->beside->particles);
    else
        TRY(particles_rearrange(m->particles, from));
    wet_forget(m);
    if (m->own && !m->own->whole) /* else share_make() follows */
        TRY(move_list(m, from));
    if (m->solver && from[KIND_FLUID])
        TRY(m->plan->solver->rearrange(m, from[KIND_FLUID]));
    return m->observer ? moment_rearrange(m->observer, from) : STATUS_DONE;
}

void moment_follow(struct moment *m, const struct moment *run)
{
    particles_follow(m->particles, run->particles);
}

int moment_kind(const struct moment *m, int row)
{
    const struct plan_rows *of = &m->plan->row;

    if (row == of->x || row == of->u)
        return KIND_FLUID;
    for (int k = 0; k < KINDS; k++)
        if (row == of->density[k])
            return k;
    return KINDS;
}

/* The kind whose particles block i of y holds, with where they stand; KINDS: none. */
static int block_of(const struct moment *m, int i, struct vector_rows *to)
{
    const struct layout_row *r = &m->layout.row[i];

    *to = (struct vector_rows){ .offset = r->offset, .n = r->n, .components = r->components };
    return moment_kind(m, i);
}

int moment_rows(const struct moment *m, const int *const from[KINDS],
                struct vector_rows row[MOMENT_ROWS])
{
    int n = 0;

    for (int i = 0; i < m->layout.rows; i++) {
        struct vector_rows one;
        const int k = block_of(m, i, &one);

        if (k < KINDS && (one.from = from[k]))
            row[n++] = one;
    }
    return n;
}

int moment_travels(const struct moment *m, const struct vector_travel *const travel[KINDS],
                   struct vector_rows row[MOMENT_ROWS])
{
    int n = 0;

    for (int i = 0; i < m->layout.rows; i++) {
        struct vector_rows one;
        const int k = block_of(m, i, &one);

        if (k < KINDS && (one.travel = travel[k]))
            row[n++] = one;
    }
    return n;
}

int moment_id(const struct moment *m, int row, int which)
{
    const int k = moment_kind(m, row), *id = k < KINDS ? m->particles->id[k] : NULL;

    return id ? id[which] : which;
}

int moment_row(const struct moment *m, int row, int id)
{
    const int k = moment_kind(m, row), *rows = k < KINDS ? m->particles->row[k] : NULL;

    return rows ? rows[id] : id;
}

void moment_by_id(const struct moment *m, const double *y, double *to)
{
    for (int r = 0; r < m->layout.rows; r++) {
        const struct layout_row *row = &m->layout.row[r];
        const size_t c = (size_t)row->components;

        for (int i = 0; i < row->n; i++)
            memcpy(to + row->offset + moment_id(m, r, i) * c, y + row->offset + i * c,
                   c * sizeof *y);
    }
}
