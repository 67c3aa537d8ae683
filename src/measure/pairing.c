/* pairing.c -- nearest neighbours of the fluid, found in cells of about one spacing. */
#include "measure/pairing.h"

#include "base/status.h"
#include "state/period.h"
#include <math.h>
#include <stdlib.h>

enum { OUTSIDE = -1 };

/* Half of the mean spacing: nearer is paired. */
static const double half = 0.5;

struct pairing {
    const struct particles *p;
    int n;                 /* fluid                                             */
    double size[DIM];      /* edges of a cell                             [m]   */
    long cells[DIM], most; /* cells in use by direction; how many may be        */
    int *start;            /* [most+1] cell c: order[start[c]] .. [start[c+1]-1] */
    int *order;            /* [n] fluid cell by cell                            */
    long *cell;            /* [n] cell of a particle, or OUTSIDE                */
};

int pairing_create(const struct particles *p, struct pairing **out)
{
    struct pairing *g = status_alloc(1, sizeof *g);

    *out = g;
    if (!g)
        return STATUS_FAILED;
    g->p = p;
    g->n = particles_count(p, KIND_FLUID);
    g->most = 4L * g->n + 64;
    g->start = status_alloc((size_t)g->most + 1, sizeof *g->start);
    g->order = status_alloc((size_t)g->n + 1, sizeof *g->order);
    g->cell = status_alloc((size_t)g->n + 1, sizeof *g->cell);
    if (g->start && g->order && g->cell)
        return STATUS_DONE;
    pairing_free(out);
    return STATUS_FAILED;
}

void pairing_free(struct pairing **pairing)
{
    if (!*pairing)
        return;
    free((*pairing)->start);
    free((*pairing)->order);
    free((*pairing)->cell);
    free(*pairing);
    *pairing = NULL;
}

/* How many cells of this size along d: where the domain repeats, they fill it. */
static double count_along(const struct scales *s, int d, double size)
{
    const double cells = floor((s->high[d] - s->low[d]) / size);

    return s->period[d] > 0 ? fmax(cells, 1) : cells + 1;
}

/* Neighbours on a lattice are found in the 3^D cells around; larger cells where the
 * domain is large and empty.  Returns how many there are. */
static long lay_cells(struct pairing *g)
{
    const struct scales *s = g->p->scales;
    double count, size = 1.1 * s->dx;

    for (;; size *= 1.25) {
        count = 1;
        for (int d = 0; d < DIM; d++)
            count *= count_along(s, d, size);
        if (count <= (double)g->most)
            break;
    }
    for (int d = 0; d < DIM; d++) {
        g->cells[d] = (long)count_along(s, d, size);
        g->size[d] = s->period[d] > 0 ? s->period[d] / (double)g->cells[d] : size;
    }
    return (long)count;
}

/* Along d; NaN and what is outside: OUTSIDE. */
static long place_of(const struct pairing *g, int d, const double *x)
{
    const struct scales *s = g->p->scales;
    double home[DIM];
    long at;

    period_home(s, x, home);
    if (!(home[d] >= s->low[d] && home[d] <= s->high[d]) && !(s->period[d] > 0 && isfinite(x[d])))
        return OUTSIDE;
    at = (long)((home[d] - s->low[d]) / g->size[d]);
    return at < g->cells[d] ? at : g->cells[d] - 1;
}

static long cell_of(const struct pairing *g, const double *x)
{
    long cell = 0;

    for (int d = 0; d < DIM; d++) {
        const long at = place_of(g, d, x);
        if (at == OUTSIDE)
            return OUTSIDE;
        cell = cell * g->cells[d] + at;
    }
    return cell;
}

static void sort(struct pairing *g, const double *x)
{
    const long count = lay_cells(g);

    for (long c = 0; c <= count; c++)
        g->start[c] = 0;
    for (int i = 0; i < g->n; i++) {
        g->cell[i] = cell_of(g, x + DIM * (size_t)i);
        if (g->cell[i] != OUTSIDE)
            g->start[g->cell[i] + 1]++;
    }
    for (long c = 0; c < count; c++)
        g->start[c + 1] += g->start[c];
    for (int i = 0; i < g->n; i++)
        if (g->cell[i] != OUTSIDE)
            g->order[g->start[g->cell[i]]++] = i;
    for (long c = count; c > 0; c--) /* each start has become the next one */
        g->start[c] = g->start[c - 1];
    g->start[0] = 0;
}

/* Least square of the distance from i to the others of a cell [m^2]. */
static double nearest_in(const struct pairing *g, const double *x, int i, long cell, double best)
{
    for (int k = g->start[cell]; k < g->start[cell + 1]; k++) {
        const int j = g->order[k];
        const double r2 = period_square(g->p->scales, x + DIM * (size_t)i, x + DIM * (size_t)j,
                                        DIM);
        if (j != i && r2 < best)
            best = r2;
    }
    return best;
}

/* Cells from..to along d are up to `reach` away from that of x; numbers count on beyond
 * the sides where the domain repeats, but not twice round. */
static void range_of(const struct pairing *g, int d, const double *x, long reach, long *from,
                     long *to)
{
    const long at = place_of(g, d, x);

    *from = at - reach;
    *to = at + reach;
    if (g->p->scales->period[d] > 0) {
        if (2 * reach + 1 > g->cells[d])
            *to = *from + g->cells[d] - 1;
        return;
    }
    *from = at > reach ? at - reach : 0;
    *to = at + reach < g->cells[d] ? at + reach : g->cells[d] - 1;
}

static long wrapped(const struct pairing *g, int d, long at)
{
    const long n = g->cells[d];

    return (at % n + n) % n;
}

/* ... of the cells up to `reach` cells away. */
static double nearest_around(const struct pairing *g, const double *x, int i, long reach)
{
    const struct scales *s = g->p->scales;
    long from[3] = { 0, 0, 0 }, to[3] = { 0, 0, 0 };
    double best = s->support * s->support;

    for (int d = 0; d < DIM; d++)
        range_of(g, d, x + DIM * (size_t)i, reach, &from[d], &to[d]);
    for (long a = from[0]; a <= to[0]; a++)
        for (long b = from[1]; b <= to[1]; b++)
            for (long c = from[2]; c <= to[2]; c++) {
                const long row = wrapped(g, 0, a) * g->cells[1] + wrapped(g, 1, b);
                best = nearest_in(g, x, i, DIM == 2 ? row : row * g->cells[DIM - 1]
                                                                + wrapped(g, DIM - 1, c), best);
            }
    return best;
}

/* Distance of the nearest neighbour [m], INFINITY when there is none within the support. */
static double nearest(const struct pairing *g, const double *x, int i)
{
    const double far = g->p->scales->support;
    double r2 = nearest_around(g, x, i, 1), size = g->size[0];

    for (int d = 1; d < DIM; d++)
        size = fmin(size, g->size[d]);
    if (r2 > size * size) /* a cell further away there may be a nearer one */
        r2 = nearest_around(g, x, i, (long)ceil(far / size));
    return r2 < far * far ? sqrt(r2) : INFINITY;
}

void pairing_find(struct pairing *g, const struct view *v, struct pairing_index *out)
{
    const double *x = v->x[KIND_FLUID], *rho = v->rho[KIND_FLUID];
    double sum = 0;
    int inside = 0, paired = 0, company = 0;

    *out = (struct pairing_index){ .least = INFINITY };
    sort(g, x);
    for (int id = 0; id < g->n; id++) {
        const int i = particles_row(v->p, KIND_FLUID, id);
        double r;
        if (g->cell[i] == OUTSIDE)
            continue;
        inside++;
        r = nearest(g, x, i) / pow(v->p->m[i] / (rho ? rho[i] : g->p->scales->rho0), 1.0 / DIM);
        if (r == INFINITY)
            continue;
        company++;
        paired += r < half;
        sum += r;
        out->least = fmin(out->least, r);
    }
    out->share = inside ? (double)paired / inside : 0;
    out->mean = company ? sum / company : NAN;
    if (!company)
        out->least = NAN;
}
