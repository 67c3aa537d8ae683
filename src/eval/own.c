/* own.c -- a rank's own rows stand before those of others, kind by kind, where y has them.
 *
 * So vectors of the size of y are written in their first rows alone, and the rest of them takes no
 * memory.  Each rank has an order of its own; all speak of particles by their ids, and of entries of
 * y by those that they would have if rows were ids. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <string.h>

static int own_count(const struct moment_share *s, int k)
{
    return s->from[s->me][k + 1] - s->from[s->me][k];
}

/* --- their order --------------------------------------------------------------------------- */

/* Points of a skin stand in order of ids, as bodies and contacts read them. */
bool own_packs(const struct moment *m, int k)
{
    return m->share->packed && k != KIND_SKIN && k != KIND_SKIN_SLIP
           && (k == KIND_FLUID || m->plan->row.density[k] >= 0);
}

int moment_rows_of(const struct moment *m, enum kind k)
{
    return m->share && own_packs(m, k) ? own_count(m->share, k) : particles_count(m->particles, k);
}

/* Own ones first, both in order of ids; from [n] by row. */
static void divide(const struct moment *m, int k, const int *owner, int *from)
{
    const int first = m->particles->from[k], n = particles_count(m->particles, k);
    int at = 0;

    for (int other = 0; other < 2; other++)
        for (int i = 0; i < n; i++)
            if ((owner[first + i] != m->share->me) == other)
                from[at++] = i;
}

int own_divide(struct moment *m, const int *owner, double *y)
{
    const struct particles *p = m->particles;
    int *room = status_alloc((size_t)p->n + 1, sizeof *room);
    const int *from[KINDS] = { 0 };
    struct vector_rows row[MOMENT_ROWS];
    int status = room ? STATUS_DONE : STATUS_FAILED;

    for (int k = 0; k < KINDS && room; k++)
        if (own_packs(m, k)) {
            divide(m, k, owner, room + p->from[k]);
            from[k] = room + p->from[k];
        }
    if (status == STATUS_DONE)
        status = vector_rows_move(moment_rows(m, from, row), row, 1, &y);
    if (status == STATUS_DONE)
        status = moment_rearrange(m, from);
    free(room);
    return ranks_agree(status);
}

static bool is_mine(const struct moment *m, int k, const int *owner, int i)
{
    const int first = m->particles->from[k];

    return owner[particles_id_of(m->particles, first + i)] == m->share->me;
}

int own_exchange(const struct moment *m, int k, const int *owner, int *from)
{
    const int n = particles_count(m->particles, k);
    int rows = 0, gap = 0, next;

    for (int i = 0; i < n; i++) {
        from[i] = i;
        rows += is_mine(m, k, owner, i);
    }
    for (next = rows; own_packs(m, k); gap++, next++) {
        while (gap < rows && is_mine(m, k, owner, gap))
            gap++;
        while (next < n && !is_mine(m, k, owner, next))
            next++;
        if (gap >= rows)
            break;
        from[gap] = next;
        from[next] = gap;
    }
    return own_packs(m, k) ? rows : n;
}

/* --- names of entries, and which are here ----------------------------------------------------- */

/* Entry i, as the number of a row becomes another one's. */
static long renamed(const struct moment *m, long i, bool to_common)
{
    int which = 0;
    const struct layout_row *r = layout_find(&m->layout, i, &which);
    const int row = r ? (int)(r - m->layout.row) : 0;

    if (!r)
        return i;
    which = to_common ? moment_id(m, row, which) : moment_row(m, row, which);
    return r->offset + (long)which * r->components + (i - r->offset) % r->components;
}

static long common(const void *self, long i)
{
    return renamed(self, i, true);
}

static long here(const void *self, long name)
{
    return renamed(self, name, false);
}

/* Block i of y follows n pieces; returns how many there are with it.  What is of no particles joins. */
static int add_piece(const struct moment *m, int i, int n)
{
    struct moment_share *s = m->share;
    const struct layout_row *r = &m->layout.row[i];
    const int k = moment_kind(m, i), rows = k < KINDS ? moment_rows_of(m, (enum kind)k) : r->n;
    const bool joins = k == KINDS && n > 0 && s->here.joins && s->here.piece[n - 1][1] == r->offset;

    if (!joins)
        s->here.piece[n++][0] = r->offset;
    s->here.joins = k == KINDS;
    s->here.piece[n - 1][1] = r->offset + (long)rows * r->components;
    return n;
}

struct vector_own moment_own(const struct moment *m)
{
    const struct layout *l = &m->layout;
    int n = 0;

    if (!m->share || !m->share->packed)
        return (struct vector_own){ 0 };
    for (int class = 0; class < LAYOUT_CLASSES; class++) /* as they stand in y */
        for (int i = 0; i < l->rows; i++)
            if ((int)l->row[i].what == class)
                n = add_piece(m, i, n);
    return (struct vector_own){ .pieces = n, .piece = (const long (*)[2])m->share->here.piece,
                                 .self = m, .common = common, .here = here };
}

void moment_take(const struct moment *m, const double *y, double *to)
{
    const struct vector_own own = moment_own(m);

    if (own.pieces == 0)
        vector_copy(layout_size(&m->layout), y, to);
    for (int k = 0; k < own.pieces; k++)
        vector_copy(own.piece[k][1] - own.piece[k][0], y + own.piece[k][0], to + own.piece[k][0]);
}

void moment_clear(const struct moment *m, long from, long to, double *y)
{
    const struct vector_own own = moment_own(m);

    if (own.pieces == 0)
        memset(y + from, 0, (size_t)(to - from) * sizeof *y);
    for (int k = 0; k < own.pieces; k++) {
        const long first = from > own.piece[k][0] ? from : own.piece[k][0];
        const long last = to < own.piece[k][1] ? to : own.piece[k][1];
        if (first < last)
            memset(y + first, 0, (size_t)(last - first) * sizeof *y);
    }
}

void moment_combine(const struct moment *m, int terms, const double *c, const double *const *x,
                    double *to)
{
    const struct vector_own own = moment_own(m);
    const double *part[terms];

    if (own.pieces == 0)
        vector_combine(terms, c, x, layout_size(&m->layout), to);
    for (int k = 0; k < own.pieces; k++) {
        const long from = own.piece[k][0];
        for (int i = 0; i < terms; i++)
            part[i] = x[i] + from;
        vector_combine(terms, c, part, own.piece[k][1] - from, to + from);
    }
}

bool moment_is_packed(const struct moment *m)
{
    return m->share && m->share->packed;
}

double moment_numbers(const struct moment *m)
{
    const struct vector_own own = moment_own(m);
    double n = own.pieces == 0 ? (double)layout_size(&m->layout) : 0;

    for (int k = 0; k < own.pieces; k++)
        n += (double)(own.piece[k][1] - own.piece[k][0]);
    return n;
}
