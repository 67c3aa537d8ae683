/* crowd.c -- counts neighbours, particle by particle where it is asked, in cells of one support. */
#include "measure/crowd.h"

#include "base/status.h"
#include "state/period.h"
#include <math.h>
#include <stdlib.h>

struct crowd {
    const struct particles *p;
    struct view view;
    double reach2;         /* neighbours are nearer than this, squared    [m^2] */
    int half, quarter;     /* of the full lattice, rounded up                   */
    double size[DIM];      /* edges of a cell, at least the support       [m]   */
    double low[DIM];       /* corner of the first cell                    [m]   */
    long cells[DIM], most; /* cells in use by direction; how many may be     */
    int *start;            /* [most+1] cell c: order[start[c]] .. [start[c+1]-1] */
    int n;                 /* particles that count                              */
    int *order;            /* [n] their rows, cell by cell; behind start        */
};

/* Strictly inside the support, with room for rounding: at r = H kernels are 0. */
static double reach2(const struct scales *s)
{
    return s->support * s->support * (1 - 1e-9);
}

int crowd_full(const struct scales *s)
{
    const int most = (int)(s->support / s->dx) + 1;
    const double within = reach2(s) / (s->dx * s->dx);
    int count = -1; /* not the site itself */

    for (int i = -most; i <= most; i++)
        for (int j = -most; j <= most; j++)
            for (int k = DIM == 3 ? -most : 0; k <= (DIM == 3 ? most : 0); k++)
                count += i * i + j * j + k * k < within;
    return count;
}

int crowd_create(const struct particles *p, struct crowd **out)
{
    const int full = crowd_full(p->scales);
    struct crowd *c = status_alloc(1, sizeof *c);

    *out = c;
    if (!c)
        return STATUS_FAILED;
    c->p = p;
    c->reach2 = reach2(p->scales);
    c->half = (full + 1) / 2;
    c->quarter = (full + 3) / 4;
    c->most = 4L * p->n + 64;
    c->start = status_alloc((unsigned long)(c->most + 1 + p->n), sizeof *c->start);
    if (!c->start) {
        crowd_free(out);
        return STATUS_FAILED;
    }
    c->order = c->start + c->most + 1;
    return STATUS_DONE;
}

void crowd_free(struct crowd **crowd)
{
    if (!*crowd)
        return;
    free((*crowd)->start);
    free(*crowd);
    *crowd = NULL;
}

const struct view *crowd_view(const struct crowd *c)
{
    return &c->view;
}

/* Fluid counts in the domain, solids less than a support below its floor (they stand there). NaN counts
 * nowhere. */
static bool is_inside(const struct scales *s, enum kind k, const double *x)
{
    const double margin = k == KIND_FLUID ? 0 : s->support;

    if (k != KIND_FLUID && !(x[DIM - 1] < s->low[DIM - 1]))
        return false;
    for (int d = 0; d < DIM; d++)
        if (s->period[d] > 0 ? !isfinite(x[d])
                             : !(x[d] >= s->low[d] - margin && x[d] <= s->high[d] + margin))
            return false;
    return true;
}

/* How many cells of this size along d: where the domain repeats, they fill it. */
static double count_along(const struct scales *s, int d, double size)
{
    if (s->period[d] > 0)
        return fmax(floor(s->period[d] / size), 1);
    return floor((s->high[d] - s->low[d] + 2 * s->support) / size) + 1;
}

/* Cells of one support, or larger where the domain is large and empty; returns how many. */
static long lay_cells(struct crowd *c)
{
    const struct scales *s = c->p->scales;
    const double most = 4.0 * c->n + 64;
    double count, size = s->support;

    do {
        count = 1;
        for (int d = 0; d < DIM; d++)
            count *= count_along(s, d, size);
        if (count > most)
            size *= 1.25;
    } while (count > most);
    for (int d = 0; d < DIM; d++) {
        c->cells[d] = (long)count_along(s, d, size);
        c->size[d] = s->period[d] > 0 ? s->period[d] / (double)c->cells[d] : size;
        c->low[d] = s->period[d] > 0 ? s->low[d] : s->low[d] - s->support;
    }
    return (long)count;
}

static long cell_of(const struct crowd *c, const double *x)
{
    long cell = 0;

    for (int d = 0; d < DIM; d++) {
        const long at = (long)((x[d] - c->low[d]) / c->size[d]);
        cell = cell * c->cells[d] + (at < c->cells[d] ? at : c->cells[d] - 1);
    }
    return cell;
}

static const double *position(const struct crowd *c, int i)
{
    int k = KIND_FLUID;

    while (i >= c->p->from[k + 1])
        k++;
    return c->view.x[k] + DIM * (long)(i - c->p->from[k]);
}

/* What is done with a row that counts, home in the domain. */
typedef void take(struct crowd *c, int i, const double *home);

/* Row i of kind k, if it counts; most solids stand above the floor. */
static void take_row(struct crowd *c, enum kind k, int i, take *with)
{
    const struct scales *s = c->p->scales;
    const double *x = c->view.x[k] + DIM * (long)(i - c->p->from[k]);
    double home[DIM];

    if (k != KIND_FLUID && !(s->period[DIM - 1] > 0) && !(x[DIM - 1] < s->low[DIM - 1]))
        return;
    period_home(s, x, home);
    if (is_inside(s, k, home))
        with(c, i, home);
}

static void take_rows(struct crowd *c, take *with)
{
    for (int k = 0; k < KINDS; k++)
        for (int i = c->p->from[k]; i < c->p->from[k + 1]; i++)
            if (k != KIND_FLUID || view_has(&c->view, i))
                take_row(c, (enum kind)k, i, with);
    for (int i = 0; i < c->view.nears; i++)
        take_row(c, KIND_FLUID, c->view.near[i], with);
}

static void note(struct crowd *c, int i, const double *home)
{
    (void)home;
    c->order[c->n++] = i;
}

static void count_in_cells(struct crowd *c)
{
    for (int m = 0; m < c->n; m++) {
        double home[DIM];
        period_home(c->p->scales, position(c, c->order[m]), home);
        c->start[cell_of(c, home) + 1]++;
    }
}

/* Each start becomes the next one. */
static void put_in_cell(struct crowd *c, int i, const double *home)
{
    c->order[c->start[cell_of(c, home)]++] = i;
}

/* Cells are found twice: to keep them would take most of a crowd's memory. */
void crowd_update(struct crowd *c, const struct view *v)
{
    long count;

    c->view = *v;
    c->n = 0;
    take_rows(c, note);
    count = lay_cells(c);
    for (long i = 0; i <= count; i++)
        c->start[i] = 0;
    count_in_cells(c);
    for (long i = 0; i < count; i++)
        c->start[i + 1] += c->start[i];
    take_rows(c, put_in_cell);
    for (long i = count; i > 0; i--)
        c->start[i] = c->start[i - 1];
    c->start[0] = 0;
}

struct company {
    int all, fluid;
};

static void count_cell(const struct crowd *c, const double *x, long cell, struct company *to)
{
    for (int m = c->start[cell]; m < c->start[cell + 1]; m++) {
        const double *y = position(c, c->order[m]);
        const bool fluid = c->order[m] < c->p->from[KIND_FLUID + 1];
        const double r2 = period_square(c->p->scales, x, y, DIM);
        to->all += r2 < c->reach2;
        to->fluid += r2 < c->reach2 && fluid;
    }
}

/* Cells of one direction that hold x and those beside it; their number. None where x is
 * further than a cell from all of them. */
static int along(const struct crowd *c, int d, double x, long at[3])
{
    const double here = floor((x - c->low[d]) / c->size[d]);
    int n = 0;

    if (c->p->scales->period[d] > 0) {
        for (long k = -1; k <= 1 && n < c->cells[d]; k++)
            at[n++] = ((long)here + k + c->cells[d]) % c->cells[d];
        return n;
    }
    const long from = (long)fmin(fmax(here - 1, 0), (double)c->cells[d]);
    const long to = (long)fmax(fmin(here + 1, (double)c->cells[d] - 1), -1);
    for (long k = from; k <= to; k++)
        at[n++] = k;
    return n;
}

/* The 3^D cells around x: their numbers go to cell, as many are returned. */
static int around(const struct crowd *c, const double *x, long cell[27])
{
    long at[3][3] = { { 0 } };
    int many[3] = { 1, 1, 1 }, n = 0;
    double home[DIM];

    period_home(c->p->scales, x, home);
    for (int d = 0; d < DIM; d++)
        many[d] = along(c, d, home[d], at[d]);
    for (int i = 0; i < many[0]; i++)
        for (int j = 0; j < many[1]; j++)
            for (int k = 0; k < many[2]; k++)
                cell[n++] = DIM == 2 ? at[0][i] * c->cells[1] + at[1][j]
                                     : (at[0][i] * c->cells[1] + at[1][j]) * c->cells[DIM - 1]
                                           + at[2][k];
    return n;
}

/* Of x, which is counted itself, too. */
static struct company company(const struct crowd *c, const double *x)
{
    struct company found = { 0, 0 };
    long cell[27];
    const int n = around(c, x, cell);

    for (int k = 0; k < n; k++)
        count_cell(c, x, cell[k], &found);
    return found;
}

void crowd_near(const struct crowd *c, const double *x, crowd_see *see, void *self)
{
    long cell[27];
    const int n = around(c, x, cell);

    for (int k = 0; k < n; k++)
        for (int m = c->start[cell[k]]; m < c->start[cell[k] + 1]; m++)
            if (c->order[m] < c->p->from[KIND_FLUID + 1] && view_has(&c->view, c->order[m]))
                see(self, c->order[m]);
}

bool crowd_is_water(const struct crowd *c, int i)
{
    struct company found;
    double home[DIM];

    period_home(c->p->scales, position(c, i), home);
    if (!is_inside(c->p->scales, KIND_FLUID, home))
        return false;
    found = company(c, position(c, i));
    return found.all - 1 >= c->half && found.fluid - 1 >= c->quarter;
}
