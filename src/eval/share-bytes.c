/* share-bytes.c -- memory that sharing takes, of what is written of its arrays.
 *
 * Once a list stands it is known which rows are here and which come; before, and where rows are ids, it is
 * reckoned. */
#include "eval/share.h"

#include "base/pages.h"
#include "ranks/ranks.h"
#include "space/list.h"

static double owners_bytes(const struct moment_share *s)
{
    return (double)s->n * (sizeof *s->mine + sizeof *s->owner + sizeof *s->row);
}

/* Of particles in an order of their own: rows and names, and where solids are now and were at first; of those
 * that move how fast, and where lists were made. */
static double order_bytes(const struct moment *m)
{
    const struct particles *p = m->particles;
    const double row = sizeof *p->m + sizeof *p->object_of + sizeof *p->dye + 2 * sizeof(int);
    double bytes = p->n * row;

    for (int k = KIND_WALL; k < KINDS; k++)
        bytes += (share_stands(m, k) ? 2 : 5) * (double)sizeof *p->x * particles_count(p, k);
    return bytes;
}

/* Of fluid that is here: places where lists were made for runs and for looks, and now; of what comes from
 * others velocities; densities of all. */
static double places_bytes(const struct moment *m)
{
    const struct moment_share *s = m->share;
    const size_t place = DIM * sizeof *s->built;
    const double here = pages_bytes(moment_rows_of(m, KIND_FLUID), s->near.n, s->near.row, place);

    return 3 * here + pages_bytes(0, s->near.n, s->near.row, place) + (double)s->n * sizeof *s->now.rho;
}

static double numbers_of(const struct moment *m, int n, const int *row)
{
    double numbers = 0;

    for (int i = 0; i < n; i++)
        numbers += share_width(row[i] < m->particles->from[KIND_FLUID + 1] ? KIND_FLUID : KIND_WALL);
    return numbers;
}

/* What comes and leaves, with the names of rows, by two routes: what leaves is packed once more. */
static double routes_bytes(const struct moment *m)
{
    const struct moment_share *s = m->share;
    const double comes = numbers_of(m, s->halo.n, s->halo.row), leaves = numbers_of(m, s->halo.leaves, s->halo.out);

    return (comes + 2 * leaves + (DIM + 1) * s->near.leaves) * sizeof(double)
           + (s->halo.n + 3.0 * s->halo.leaves + 3.0 * s->near.leaves + 2.0 * s->near.n + list_known(m->own)
              + s->wet.from[s->ranks]) * sizeof(int);
}

/* All of y goes to the first rank, which puts it together, and where own particles are to a cut. */
static double scratch_bytes(const struct moment *m)
{
    const struct moment_share *s = m->share;
    const double own = s->from[s->me][KINDS] - s->from[s->me][0], whole = layout_size(&m->layout);

    return (moment_numbers(m) + (s->me > 0 ? DIM * own : 2 * whole)) * sizeof *s->all;
}

/* Rows are ids: of fluid places where lists were made, and places and velocities that come, in pages in which they
 * are scattered; densities of all; y of all, rates of all and own ones, which each hears, and what comes and leaves. */
static double scattered_bytes(const struct moment *m)
{
    const struct moment_share *s = m->share;
    const double fluid = m->particles->from[KIND_FLUID + 1], whole = layout_size(&m->layout);

    return (3 * DIM * fluid + s->n + (2 + 1.0 / s->ranks) * whole) * sizeof(double) + routes_bytes(m);
}

/* Each has all sums of all owners, its own packed before: forces and rates of densities. */
static double full_bytes(const struct moment *m)
{
    const struct moment_share *s = m->share;
    const double own = s->from[s->me][KINDS] - s->from[s->me][0], sums = (DIM + 1) * sizeof *s->all;

    return owners_bytes(s) + m->particles->from[KIND_FLUID + 1] * DIM * (double)sizeof *s->built
           + (s->n + own) * sums + s->n * (double)sizeof *s->places.place;
}

double moment_share_bytes(const struct moment *m)
{
    const struct moment_share *s = m->share;

    if (!s)
        return 0;
    if (s->full)
        return full_bytes(m);
    if (!s->packed)
        return owners_bytes(s) + scattered_bytes(m);
    return owners_bytes(s) + order_bytes(m) + places_bytes(m) + routes_bytes(m) + scratch_bytes(m);
}

double moment_share_bytes_all(const struct moment *m)
{
    const struct moment_share *s = m->share;

    return s ? owners_bytes(s) + s->n * (DIM + SHARE_WIDEST * (1 + 1.0 / s->ranks)) * sizeof(double)
                   + (double)s->n * sizeof *s->places.place
             : 0;
}

int moment_nears(const struct moment *m)
{
    return moment_is_packed(m) ? m->share->near.n : 0;
}

double moment_list_bytes(const struct moment *m)
{
    return m->own ? list_written(m->own) : 0;
}

double moment_sums_bytes(const struct moment *m)
{
    return workspace_written(m->plan, m->work);
}
