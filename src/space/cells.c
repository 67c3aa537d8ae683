/* cells.c -- sorts all particles by kind, cell and id (counting sort).
 *
 * The cells of a huge box with a tiny support are made coarser until there are
 * not many more of them than particles. */
#include "space/cells.h"

#include "base/status.h"
#include "base/threads.h"
#include "space/growing.h"
#include "space/list-private.h"

#include <math.h>
#include <string.h>

/* Cells along x in one radius: narrow cells keep runs of places short.  Two to
 * five differ by 3 % of a rebuild. */
enum { FINE = 3 };

/* Particles of one kind from which sorting repays waking the threads. */
enum { WORTH_THREADS = 4096 };

/* Rows of a kind that are here, of all or of some. */
struct rows {
    const int *row; /* [n] by ascending id; NULL: from `first` on */
    int first, n;
};

static struct rows rows_here(const struct list *list, int kind)
{
    const struct list_whole *whole = list->whole;
    const int *from = whole ? whole->from : list->def.from;

    return (struct rows){ whole ? whole->row + from[kind] : NULL, from[kind], from[kind + 1] - from[kind] };
}

static inline int row_at(const struct rows *rows, int k)
{
    return rows->row ? rows->row[k] : rows->first + k;
}

/* Marks particles inside of this thread's rows. */
static void mark_part(struct list *list, const struct cloud *cloud, int kind, struct growing *all)
{
    const struct rows rows = rows_here(list, kind);
    const struct threads_part part = threads_part(rows.n);
    const double *home = list_homes(list, cloud, kind);
    struct growing mine = growing_none();

    for (int k = part.from; k < part.to; k++) {
        const int i = row_at(&rows, k);
        const double *x = home + (size_t)DIM * (size_t)(i - list->def.from[kind]);

        list->slot[i] = list_inside(&list->def, x) ? 0 : -1;
        if (list->slot[i] == 0)
            growing_take(&mine, coords_at(x));
    }
    THREADS_IN_TURN(growing_join(all, &mine));
}

/* Marks particles inside, and the box around them; returns how many. */
static int bounds(struct list *list, const struct cloud *cloud, int kind, double *low, double *high)
{
    struct growing all = growing_none();

    THREADS(rows_here(list, kind).n > WORTH_THREADS, mark_part(list, cloud, kind, &all));
    coords_put(all.low, low);
    coords_put(all.high, high);
    return (int)all.n;
}

/* Cells of a grid over low..high, coarser until there are at most `most`. */
static double resize(struct cells *c, const double *high, double radius, double most)
{
    for (double coarse = 1;; coarse *= 1.25) {
        double cells = 1;

        for (int d = 0; d < DIM; d++) {
            c->per_metre[d] = (d == 0 ? FINE : 1) / (coarse * radius);
            cells *= floor((high[d] - c->low[d]) * c->per_metre[d]) + 1;
        }
        if (cells <= most)
            return cells;
    }
}

size_t cells_shape(const struct list *list, struct cells *c, const double *high, double n)
{
    const double radius = list->def.support + list->def.skin;
    const size_t cells = (size_t)resize(c, high, radius, 8.0 * n + 4096);

    for (int d = 0; d < DIM; d++)
        c->n[d] = (int)((high[d] - c->low[d]) * c->per_metre[d]) + 1;
    return cells;
}

int cells_grid(struct list *list, struct cells *c, const double *high, double n)
{
    size_t cells = 0;

    memset(c->n, 0, sizeof c->n);
    c->farthest = 0;
    if (n > 0) {
        cells = cells_shape(list, c, high, n);
        for (int d = 0; d < DIM; d++)
            c->farthest = fmax(c->farthest, fmax(fabs(c->low[d]), fabs(high[d])));
    }
    if (!list_grow((void **)&c->start, &c->room, cells + 2, sizeof *c->start))
        return list_no_memory(list);
    memset(c->start, 0, (cells + 2) * sizeof *c->start);
    return STATUS_DONE;
}

/* Along the plough's way. */
int cells_rank(const struct cells *c, const double *x)
{
    int at[DIM], row;

    for (int d = 0; d < DIM; d++)
        at[d] = (int)((x[d] - c->low[d]) * c->per_metre[d]);
#if DIM == 2
    row = at[1];
#else
    row = at[2] * c->n[1] + (at[2] % 2 ? c->n[1] - 1 - at[1] : at[1]);
#endif
    return row * c->n[0] + (row % 2 ? c->n[0] - 1 - at[0] : at[0]);
}

/* Counts are in start[cell + 2], so that after placing start[cell] is right. */
void cells_add_up(struct cells *c, int first)
{
    size_t cells = 1;

    for (int d = 0; d < DIM; d++)
        cells *= (size_t)c->n[d];
    c->start[0] = c->start[1] = first;
    for (size_t k = 2; k <= cells + 1; k++)
        c->start[k] += c->start[k - 1];
}

/* Of this thread's rows: which cell each is in. */
static void rank_part(struct list *list, const struct cloud *cloud, int kind,
                      const struct cells *c)
{
    const struct rows rows = rows_here(list, kind);
    const struct threads_part part = threads_part(rows.n);
    const double *home = list_homes(list, cloud, kind);

    for (int k = part.from; k < part.to; k++) {
        const int i = row_at(&rows, k);
        if (list->slot[i] >= 0)
            list->slot[i] = cells_rank(c, home + (size_t)DIM * (size_t)(i - list->def.from[kind]));
    }
}

static void count(struct list *list, const struct cloud *cloud, int kind, struct cells *c)
{
    const struct rows rows = rows_here(list, kind);

    THREADS(rows.n > WORTH_THREADS, rank_part(list, cloud, kind, c));
    for (int k = 0; k < rows.n; k++) {
        const int i = row_at(&rows, k);
        if (list->slot[i] >= 0)
            c->start[list->slot[i] + 2]++;
    }
    cells_add_up(c, list->start[kind]);
}

/* Two coordinates (one, if no more are left) as the scan compares them. */
static int word(const double *x, int left, double per_metre)
{
    const unsigned low = (unsigned)(long long)(x[0] * per_metre);
    const unsigned high = left > 1 ? (unsigned)(long long)(x[1] * per_metre) : 0;

    return (int)(high << 16 | (low & 0xffff));
}

void cells_note(struct list *list, int slot, const double *x)
{
    struct list_private *own = list->own;

    for (int w = 0; w < LIST_WORDS; w++)
        own->place[w][slot] = word(x + 2 * w, DIM - 2 * w, own->per_metre);
}

/* The next place of its cell for the particle in row i, unless it is left out. */
static inline void place_row(struct list *list, struct cells *c, int i)
{
    if (list->slot[i] < 0)
        return;
    const int s = c->start[list->slot[i] + 1]++;

    list->slot[i] = s;
    list->order[s] = i;
}

/* Places in turn, cell by cell, in a cell by ascending id. */
static void place(struct list *list, const struct cloud *cloud, int kind, struct cells *c)
{
    const struct rows rows = rows_here(list, kind);
    const int *row = cloud->row[kind];

    if (row && !rows.row)
        for (int k = 0; k < rows.n; k++)
            place_row(list, c, rows.first + row[k]);
    else
        for (int k = 0; k < rows.n; k++)
            place_row(list, c, row_at(&rows, k));
}

/* Of this thread's rows: where they are, now that all places are known. */
static void note_part(struct list *list, const struct cloud *cloud, int kind)
{
    const struct rows rows = rows_here(list, kind);
    const struct threads_part part = threads_part(rows.n);
    const double *home = list_homes(list, cloud, kind);

    for (int k = part.from; k < part.to; k++) {
        const int i = row_at(&rows, k), slot = list->slot[i];
        const size_t at = (size_t)DIM * (size_t)(i - list->def.from[kind]);
        double *built = list->own->built + (size_t)DIM * (size_t)i;

        for (int d = 0; d < DIM; d++)
            built[d] = slot < 0 ? INFINITY : cloud->x[kind][at + (size_t)d];
        if (slot >= 0)
            cells_note(list, slot, home + at);
    }
}

static int sort_kind(struct list *list, const struct cloud *cloud, int kind)
{
    struct cells *c = &list->own->cells[kind];
    double high[DIM];
    const int inside = bounds(list, cloud, kind, c->low, high);
    double n = inside;

    if (list->whole) {
        const struct list_bounds *all = &list->whole->of[kind];
        memcpy(c->low, all->low, sizeof c->low);
        memcpy(high, all->high, sizeof high);
        n = all->n;
    }
    TRY(cells_grid(list, c, high, n));
    count(list, cloud, kind, c);
    place(list, cloud, kind, c);
    THREADS(rows_here(list, kind).n > WORTH_THREADS, note_part(list, cloud, kind));
    list->start[kind + 1] = list->start[kind] + inside;
    return STATUS_DONE;
}

/* Those that stand still, behind as many others as before, keep their places. */
int cells_sort(struct list *list, const struct cloud *cloud)
{
    const unsigned sorted = list->own->sorted;
    int was[KINDS + 1];

    memcpy(was, list->start, sizeof was);
    list->own->sorted = 0;
    list->start[0] = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        if ((sorted & KIND_BIT(kind)) && list_is_still(list, kind) && list->start[kind] == was[kind])
            list->start[kind + 1] = was[kind + 1];
        else
            TRY(sort_kind(list, cloud, kind));
        list->own->sorted |= KIND_BIT(kind);
    }
    return STATUS_DONE;
}
