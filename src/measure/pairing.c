/* pairing.c -- nearest neighbours of the fluid, found in cells of about one spacing. */
#include "measure/pairing.h"

#include "base/status.h"
#include <math.h>
#include <stdlib.h>

enum { OUTSIDE = -1 };

/* Half of the mean spacing: nearer is paired. */
static const double half = 0.5;

struct pairing {
    const struct particles *p;
    int n;                 /* fluid                                             */
    double size;           /* edge of a cell                              [m]   */
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

/* Neighbours on a lattice are found in the 3^D cells around; larger cells where the
 * domain is large and empty.  Returns how many there are. */
static long lay_cells(struct pairing *g)
{
    const struct scales *s = g->p->scales;
    double count;

    g->size = 1.1 * s->dx;
    for (;; g->size *= 1.25) {
        count = 1;
        for (int d = 0; d < DIM; d++)
            count *= floor((s->high[d] - s->low[d]) / g->size) + 1;
        if (count <= (double)g->most)
            break;
    }
    for (int d = 0; d < DIM; d++)
        g->cells[d] = (long)((s->high[d] - s->low[d]) / g->size) + 1;
    return (long)count;
}

/* NaN is outside. */
static long cell_of(const struct pairing *g, const double *x)
{
    const struct scales *s = g->p->scales;
    long cell = 0;

    for (int d = 0; d < DIM; d++) {
        if (!(x[d] >= s->low[d] && x[d] <= s->high[d]))
            return OUTSIDE;
        cell = cell * g->cells[d] + (long)((x[d] - s->low[d]) / g->size);
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
        double r2 = 0;
        for (int d = 0; d < DIM; d++) {
            const double step = x[DIM * (size_t)i + d] - x[DIM * (size_t)j + d];
            r2 += step * step;
        }
        if (j != i && r2 < best)
            best = r2;
    }
    return best;
}

/* ... of the cells up to `reach` cells away. */
static double nearest_around(const struct pairing *g, const double *x, int i, long reach)
{
    const struct scales *s = g->p->scales;
    long from[3] = { 0, 0, 0 }, to[3] = { 0, 0, 0 };
    double best = s->support * s->support;

    for (int d = 0; d < DIM; d++) {
        const long at = (long)((x[DIM * (size_t)i + d] - s->low[d]) / g->size);
        from[d] = at > reach ? at - reach : 0;
        to[d] = at + reach < g->cells[d] ? at + reach : g->cells[d] - 1;
    }
    for (long a = from[0]; a <= to[0]; a++)
        for (long b = from[1]; b <= to[1]; b++)
            for (long c = from[2]; c <= to[2]; c++)
                best = nearest_in(g, x, i, DIM == 2 ? a * g->cells[1] + b
                                  : (a * g->cells[1] + b) * g->cells[DIM - 1] + c, best);
    return best;
}

/* Distance of the nearest neighbour [m], INFINITY when there is none within the support. */
static double nearest(const struct pairing *g, const double *x, int i)
{
    const double far = g->p->scales->support;
    double r2 = nearest_around(g, x, i, 1);

    if (r2 > g->size * g->size) /* a cell further away somebody may be nearer */
        r2 = nearest_around(g, x, i, (long)ceil(far / g->size));
    return r2 < far * far ? sqrt(r2) : INFINITY;
}

void pairing_find(struct pairing *g, const struct view *v, struct pairing_index *out)
{
    const double *x = v->x[KIND_FLUID], *rho = v->rho[KIND_FLUID];
    double sum = 0;
    int inside = 0, paired = 0, company = 0;

    *out = (struct pairing_index){ .least = INFINITY };
    sort(g, x);
    for (int i = 0; i < g->n; i++) {
        double r;
        if (g->cell[i] == OUTSIDE)
            continue;
        inside++;
        r = nearest(g, x, i) / pow(g->p->m[i] / (rho ? rho[i] : g->p->scales->rho0), 1.0 / DIM);
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
