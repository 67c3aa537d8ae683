/* slice.c -- from rows of owners to ids in their order. */
#include "eval/slice.h"

#include "base/status.h"
#include "eval/observe.h"
#include "eval/share.h"
#include "ranks/ranks.h"
#include "state/period.h"

#include <stdlib.h>
#include <string.h>

struct slice slice_of(const struct moment *m)
{
    const int n = m->particles->n, me = ranks_me();

    if (!moment_is_packed(m))
        return (struct slice){ 0, me == 0 ? n : 0 };
    return (struct slice){ ranks_part(n, me), ranks_part(n, me + 1) - ranks_part(n, me) };
}

/* Those of kind k. */
static struct slice part_of(const struct moment *m, int k)
{
    const struct slice all = slice_of(m);
    const int *from = m->particles->from;
    const int last = all.from + all.n, end = last < from[k + 1] ? last : from[k + 1];
    const int low = all.from > from[k] ? all.from : from[k];

    return low < end ? (struct slice){ low, end - low } : (struct slice){ all.from, 0 };
}

/* --- from owners to whom ids belong ------------------------------------------------------------ */

/* What comes of a kind; ids are counted in it. */
struct road {
    struct ranks_route *route;
    const int *id;    /* [count of kind] by row                                      */
    int *made;        /* the same where rows are ids; NULL: lent                     */
    int coming, *who; /* [coming] ids, in the scratch of the share                   */
    double *in;       /* [coming][DIM], likewise                                     */
};

static void road_close(struct road *r)
{
    ranks_route_free(&r->route);
    free(r->made);
    *r = (struct road){ .route = NULL };
}

static int rank_of(const struct moment *m, int id)
{
    const int n = m->particles->n;
    int rank = (int)((int64_t)id * ranks_count() / n);

    while (ranks_part(n, rank + 1) <= id)
        rank++;
    return rank;
}

/* Own rows of kind k that others need, in to and row; how many. */
static int leaving(const struct moment *m, int k, const int *id, int *to, int *row)
{
    const struct moment_share *s = m->share;
    int n = 0;

    for (int j = s->from[s->me][k]; j < s->from[s->me][k + 1]; j++) {
        row[n] = s->row[j] - m->particles->from[k];
        to[n] = rank_of(m, m->particles->from[k] + id[row[n]]);
        n += to[n] != s->me;
    }
    return n;
}

/* Ids of rows; NULL: no memory. */
static const int *ids_of(struct road *r, const struct moment *m, int k)
{
    const int rows = particles_count(m->particles, k);

    if (m->particles->id[k])
        return m->particles->id[k];
    r->made = status_alloc((size_t)rows + 1, sizeof *r->made);
    for (int i = 0; r->made && i < rows; i++)
        r->made[i] = i;
    return r->made;
}

static int open_route(struct road *r, const struct moment *m, int k)
{
    const int own = m->share->from[m->share->me][k + 1] - m->share->from[m->share->me][k];
    int *to = status_alloc((size_t)own + 1, sizeof *to), *row = status_alloc((size_t)own + 1, sizeof *row);
    int status, n = 0;

    r->id = ids_of(r, m, k);
    if (r->id && to && row)
        n = leaving(m, k, r->id, to, row);
    status = ranks_route_create(&r->route, r->id && to && row ? STATUS_DONE : STATUS_FAILED,
                                DIM * sizeof(double), n, to, row);
    free(to);
    free(row);
    return status;
}

/* For kind k, all ranks together; on all the first failure. */
static int road_open(struct road *r, const struct moment *m, int k)
{
    *r = (struct road){ .who = (int *)m->share->pack, .in = m->share->all };
    TRY(open_route(r, m, k));
    r->coming = ranks_route_coming(r->route);
    ranks_route_go(r->route, sizeof *r->id, r->id, r->who);
    return STATUS_DONE;
}

/* c numbers a row, of which own ones are in `from`, for the slice's part of kind k. */
static void road_go(struct road *r, const struct moment *m, int k, size_t c, const double *from, double *to)
{
    const struct moment_share *s = m->share;
    const struct slice part = part_of(m, k);
    const int first = part.from - m->particles->from[k];

    ranks_route_go(r->route, c * sizeof *from, from, r->in);
    for (int i = 0; i < r->coming; i++)
        memcpy(to + (size_t)(r->who[i] - first) * c, r->in + (size_t)i * c, c * sizeof *to);
    for (int j = s->from[s->me][k]; j < s->from[s->me][k + 1]; j++) {
        const size_t row = (size_t)(s->row[j] - m->particles->from[k]);
        const int at = r->id[row] - first;
        if (at >= 0 && at < part.n)
            memcpy(to + (size_t)at * c, from + row * c, c * sizeof *to);
    }
}

/* --- frames ------------------------------------------------------------------------------------ */

/* The same of rows that are all here. */
static void copy_rows(const struct moment *m, int k, size_t c, const double *from, double *to)
{
    const struct slice part = part_of(m, k);

    for (int i = 0; i < part.n; i++) {
        const int id = part.from + i - m->particles->from[k];
        const size_t row = (size_t)particles_row(m->particles, (enum kind)k, id);
        memcpy(to + (size_t)i * c, from + row * c, c * sizeof *to);
    }
}

/* Are all rows of such numbers of a kind here? */
static bool are_here(const struct moment *m, int k, bool density)
{
    if (!moment_is_packed(m))
        return true;
    return k != KIND_FLUID && (!density || m->plan->row.density[k] < 0);
}

static void put(struct road *r, const struct moment *m, int k, bool density, const double *from, double *to)
{
    const size_t c = density ? 1 : DIM;

    if (are_here(m, k, density))
        copy_rows(m, k, c, from, to);
    else
        road_go(r, m, k, c, from, to);
}

static void put_densities(struct road *r, const struct moment *m, int k, const struct view *v, double *to)
{
    const struct slice part = part_of(m, k);

    if (v->rho[k])
        put(r, m, k, true, v->rho[k], to);
    for (int i = 0; !v->rho[k] && i < part.n; i++)
        to[i] = m->plan->scales.rho0;
}

static int put_kind(const struct moment *m, int k, const struct view *v, struct slice_frame *out)
{
    const struct slice part = part_of(m, k), all = slice_of(m);
    const bool travels = !are_here(m, k, false) || (v->rho[k] && !are_here(m, k, true));
    const int at = part.from - all.from;
    struct road road = { .route = NULL };
    int status = travels ? road_open(&road, m, k) : STATUS_DONE;

    if (status == STATUS_DONE) {
        put(&road, m, k, false, v->x[k], out->x[at]);
        put(&road, m, k, false, v->u[k], out->u[at]);
        put_densities(&road, m, k, v, out->rho + at);
        for (int i = 0; i < part.n; i++)
            period_home(&m->plan->scales, out->x[at + i], out->x[at + i]);
    }
    road_close(&road);
    return status;
}

int slice_take_frame(struct moment *run, double t, const double *y, struct slice_frame *out)
{
    struct view v;

    if (moment_is_packed(run)) {
        moment_view(run, t, y, &v);
        press_together(run, &v);
    } else if (slice_of(run).n > 0) {
        observe_view(run, t, y, &v);
    } else {
        return STATUS_DONE;
    }
    for (int k = 0; k < KINDS; k++)
        if (particles_count(run->particles, k) > 0)
            TRY(put_kind(run, k, &v, out));
    return STATUS_DONE;
}

/* --- y ------------------------------------------------------------------------------------------- */

static void add_piece(struct slice_state *s, long at, long n, const double *value)
{
    struct slice_piece *last = s->pieces > 0 ? &s->piece[s->pieces - 1] : NULL;

    if (n == 0)
        return;
    if (last && last->at + last->n == at && last->value + last->n == value)
        last->n += n;
    else
        s->piece[s->pieces++] = (struct slice_piece){ at, n, value };
}

/* Numbers of y in a row of the layout that are of particles of this slice. */
static int put_row(const struct moment *m, int row, const double *y, struct slice_state *s, double **room)
{
    const struct layout_row *of = &m->layout.row[row];
    const int k = moment_kind(m, row);
    const struct slice part = part_of(m, k);
    const long c = of->components;
    struct road road;
    int status = road_open(&road, m, k);

    if (status == STATUS_DONE) {
        road_go(&road, m, k, (size_t)c, y + of->offset, *room);
        add_piece(s, of->offset + (part.from - m->particles->from[k]) * c, part.n * c, *room);
        *room += part.n * c;
    }
    road_close(&road);
    return status;
}

/* Rows of the layout as they stand in y. */
static int put_rows(const struct moment *m, const double *y, struct slice_state *s)
{
    const struct layout *l = &m->layout;
    double *room = s->room;

    for (int class = 0; class < LAYOUT_CLASSES; class++)
        for (int i = 0; i < l->rows; i++) {
            const long n = (long)l->row[i].n * l->row[i].components;
            if ((int)l->row[i].what != class)
                continue;
            if (moment_kind(m, i) < KINDS)
                TRY(put_row(m, i, y, s, &room));
            else if (ranks_me() == 0)
                add_piece(s, l->row[i].offset, n, y + l->row[i].offset);
        }
    return STATUS_DONE;
}

int slice_take_state(struct moment *run, const double *y, double *by_id, struct slice_state *out)
{
    const struct slice all = slice_of(run);

    *out = (struct slice_state){ .pieces = 0 };
    if (!moment_is_packed(run)) {
        if (ranks_me() == 0) {
            moment_by_id(run, y, by_id);
            add_piece(out, 0, layout_size(&run->layout), by_id);
        }
        return STATUS_DONE;
    }
    out->room = status_alloc((size_t)all.n + 1, SHARE_WIDEST * sizeof *out->room);
    TRY(ranks_agree(out->room ? STATUS_DONE : STATUS_FAILED));
    return put_rows(run, y, out);
}

void slice_free_state(struct slice_state *state)
{
    free(state->room);
    *state = (struct slice_state){ .pieces = 0 };
}
