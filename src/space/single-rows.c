/* single-rows.c -- fetches records of single precision and forms rows. */
#include "space/single-row.h"

/* Where the records of one half's owners are. */
LANES_INLINE void find_owners(const struct single_owners *at, int half, const float *record,
                              size_t floats, const float **of)
{
    const int first = at->first[half];

    if (first + SINGLE_HALF <= at->end)
        for (int l = 0; l < SINGLE_HALF; l++)
            of[l] = record + ((size_t)first + (size_t)l) * floats;
    else
        for (int l = 0; l < SINGLE_HALF; l++)
            of[l] = record + (size_t)(first + l < at->end ? first + l : at->dummy) * floats;
}

/* `alike` is a constant, as for rows. */
LANES_INLINE void fill_side(const struct single_records *all, bool alike,
                            const struct single_owners *at, struct single_side *own)
{
    const float *of[LANES];
    struct held h;

    for (int half = 0; half < 2; half++)
        find_owners(at, half, all->record, alike || DIM == 2 ? 8 : 12, of + half * SINGLE_HALF);
    whole(of, alike, all->mass, &h);
    for (int d = 0; d < DIM; d++) {
        own->x[d] = h.x[d];
        own->a.v[d] = h.v[d];
    }
    own->a.rho = h.rho;
    own->a.p2 = h.p2;
    own->a.m = h.m;
    own->a.irho = h.irho;
}

void single_rows_side(const struct single_records *all, const struct single_owners *at,
                      struct single_side *own)
{
    if (SHORT && all->mass > 0)
        fill_side(all, SHORT, at, own);
    else
        fill_side(all, false, at, own);
}

/* Row k, and its r^2, as in gather.c; `needs` and `alike` are constants. */
LANES_INLINE lanes fill_row(const float *const of[LANES], const struct single_records *all,
                           bool alike, const struct single_side *own, unsigned needs,
                           struct block *b, int k)
{
    struct whole_row row;

    single_row_at(of, all, alike, own, &row);
    b->r2[k] = row.pair.r2;
    b->mm[k] = row.mm;
    for (int d = 0; d < DIM; d++) {
        b->x[d][k] = row.pair.x[d];
        if (needs & NEED_V)
            b->v[d][k] = row.pair.v[d];
    }
    if (needs & NEED_XV)
        b->xv[k] = row.pair.xv;
    if (needs & NEED_RHO) {
        b->rho[k] = row.pair.rho;
        b->p2[k] = row.pair.p2;
    }
    if (needs & NEED_IRHO)
        b->irho[k] = row.pair.irho;
    if (needs & NEED_MASS)
        b->m[k] = row.m;
    return row.pair.r2;
}

LANES_INLINE void fill(const struct single_records *all, bool alike,
                       const struct single_places from[2], int n, const struct single_side *own,
                       unsigned needs, struct block *b, int at)
{
    const int *first = from[0].j, *second = from[1].j;
    lanes last = { 0 };

    for (int k = at; k < at + n; k++) {
        const float *of[LANES];

        single_find(all, alike, first, second, of);
        const lanes r2 = fill_row(of, all, alike, own, needs, b, k);
        if (k > at)
            b->r[k - 1] = lanes_sqrt(last);
        last = r2;
        first += from[0].step;
        second += from[1].step;
    }
    if (n > 0)
        b->r[at + n - 1] = lanes_sqrt(last);
}

/* Fewer kinds of rows than in double precision: a needless store costs less here. */
void single_rows_fill(const struct single_records *all, const struct single_places from[2], int n,
                      const struct single_side *own, unsigned needs, struct block *b, int at)
{
    enum { PLAIN = NEED_XV | NEED_RHO, USUAL = PLAIN | NEED_IRHO,
           ALL = USUAL | NEED_V | NEED_MASS };
    const bool alike = SHORT && all->mass > 0;

    if (alike && !(needs & (NEED_MASS | NEED_V | NEED_IRHO)))
        fill(all, SHORT, from, n, own, PLAIN, b, at);
    else if (alike && !(needs & (NEED_MASS | NEED_V)))
        fill(all, SHORT, from, n, own, USUAL, b, at);
    else if (alike)
        fill(all, SHORT, from, n, own, ALL, b, at);
    else if (needs & (NEED_MASS | NEED_V))
        fill(all, false, from, n, own, ALL, b, at);
    else
        fill(all, false, from, n, own, USUAL, b, at);
}
