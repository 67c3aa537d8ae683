/* mpi-route.c -- routes: a rank sends to its partners and hears of them alone.
 *
 * One Alltoall of counts makes a route, and tells who has no memory for it; none is needed to use it.  Routes
 * are made with each list of pairs, so they have no communicator of their own, for which all would have to
 * wait some times: messages of one come in the order in which they were sent. */
#include "ranks/mpi-wait.h"
#include "ranks/ranks.h"
#include "ranks/traffic.h"

#include "base/status.h"

#include <mpi.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* Partners of one direction; those of rank[k] stand from first[k] on, first[n] is all. */
struct side {
    int n;
    int *rank, *count, *first;
};

enum { ROUTE_TAG = 4117 }; /* tests/ranks/counters.c knows it, too */

struct ranks_route {
    struct side out, in;
    int rows;
    int *row, *units;      /* [rows] by partner: where one begins, how many pieces */
    bool straight;         /* one begins where the one before ends              */
    char *packed;          /* [leaving] as wide as a piece may be              */
    MPI_Request *wait;     /* [partners of both directions]                    */
};

static bool open_side(struct side *s)
{
    const size_t ranks = (size_t)ranks_count();

    s->rank = status_alloc(ranks, sizeof(int));
    s->count = status_alloc(ranks, sizeof(int));
    s->first = status_alloc(ranks + 1, sizeof(int));
    return s->rank && s->count && s->first;
}

/* The partners of a direction, by how many rows each has. */
static void fill_side(struct side *s, const int *rows)
{
    for (int r = 0; r < ranks_count(); r++) {
        if (rows[r] == 0)
            continue;
        s->rank[s->n] = r;
        s->count[s->n] = rows[r];
        s->first[s->n + 1] = s->first[s->n] + rows[r];
        s->n++;
    }
}

static void close_side(struct side *s)
{
    free(s->rank);
    free(s->count);
    free(s->first);
}

/* What leaves here.  units NULL: each row is one piece. */
struct leaving {
    int n;
    const int *to, *row, *units;
};

static int units_of(const struct leaving *l, int i)
{
    return l->units ? l->units[i] : 1;
}

static int pieces(const struct leaving *l)
{
    int sum = 0;

    for (int i = 0; i < l->n; i++)
        sum += units_of(l, i);
    return sum;
}

/* Rows by partner, those of one in the order given; next [ranks] is where each stands. */
static void sort_rows(struct ranks_route *r, const struct leaving *l, int *next)
{
    int from = 0;

    memset(next, 0, (size_t)ranks_count() * sizeof *next);
    for (int i = 0; i < l->n; i++)
        next[l->to[i]]++;
    for (int rank = 0; rank < ranks_count(); rank++) {
        const int rows = next[rank];
        next[rank] = from;
        from += rows;
    }
    for (int i = 0; i < l->n; i++) {
        const int at = next[l->to[i]]++;
        r->row[at] = l->row[i];
        r->units[at] = units_of(l, i);
    }
    r->straight = true;
    for (int i = 1; i < l->n; i++)
        r->straight &= r->row[i] == r->row[i - 1] + r->units[i - 1];
}

void ranks_route_free(struct ranks_route **route)
{
    struct ranks_route *r = *route;

    if (!r)
        return;
    close_side(&r->out);
    close_side(&r->in);
    free(r->row);
    free(r->units);
    free(r->packed);
    free(r->wait);
    free(r);
    *route = NULL;
}

/* All memory, before anybody is asked; NULL: there is none. */
static struct ranks_route *open_route(size_t widest, const struct leaving *l)
{
    struct ranks_route *r = status_alloc(1, sizeof *r);

    if (!r)
        return NULL;
    r->rows = l->n;
    r->row = status_alloc((size_t)l->n + 1, sizeof *r->row);
    r->units = status_alloc((size_t)l->n + 1, sizeof *r->units);
    r->packed = status_alloc((size_t)pieces(l) + 1, widest);
    r->wait = status_alloc(2 * (size_t)ranks_count(), sizeof *r->wait);
    if (!open_side(&r->out) || !open_side(&r->in) || !r->row || !r->units || !r->packed || !r->wait)
        ranks_route_free(&r);
    return r;
}

/* Pieces [2][ranks], how many go to each and how many come; false: some rank has no route, which it
 * says by a number below 0. */
static bool ask_all(const struct ranks_route *r, const struct leaving *l, int *rows)
{
    const int ranks = ranks_count();
    bool all = r != NULL;
    MPI_Request done;

    for (int i = 0; i < ranks; i++)
        rows[i] = r ? 0 : -1;
    for (int i = 0; r && i < l->n; i++)
        rows[l->to[i]] += units_of(l, i);
    MPI_Ialltoall(rows, 1, MPI_INT, rows + ranks, 1, MPI_INT, MPI_COMM_WORLD, &done);
    ranks_wait(1, &done);
    for (int i = 0; i < ranks; i++)
        all &= rows[ranks + i] >= 0;
    return all;
}

int ranks_route_create(struct ranks_route **route, int status, size_t widest, int n, const int *to,
                       const int *row)
{
    return ranks_route_create_uneven(route, status, widest, n, to, row, NULL);
}

int ranks_route_create_uneven(struct ranks_route **route, int status, size_t widest, int n,
                              const int *to, const int *row, const int *units)
{
    const struct leaving l = { n, to, row, units };
    struct ranks_route *r = *route = status == STATUS_DONE ? open_route(widest, &l) : NULL;
    int rows[2 * ranks_count()];

    if (!ask_all(r, &l, rows)) {
        status = ranks_agree(status == STATUS_DONE && !r ? STATUS_FAILED : status);
        ranks_route_free(route);
        return status;
    }
    fill_side(&r->out, rows);
    fill_side(&r->in, rows + ranks_count());
    sort_rows(r, &l, rows);
    return STATUS_DONE;
}

int ranks_route_coming(const struct ranks_route *route)
{
    return route->in.first[route->in.n];
}

int ranks_route_leaving(const struct ranks_route *route)
{
    return route->out.first[route->out.n];
}

int ranks_route_partners(const struct ranks_route *route)
{
    return route->out.n;
}

/* Rows that leave, one partner's after the other's; where they stand so there is nothing to do. */
static const char *pack(const struct ranks_route *r, size_t bytes, const void *from)
{
    char *to = r->packed;

    if (r->straight && r->rows > 0)
        return (const char *)from + (size_t)r->row[0] * bytes;
    for (int i = 0; i < r->rows; i++) {
        const size_t size = (size_t)r->units[i] * bytes;
        memcpy(to, (const char *)from + (size_t)r->row[i] * bytes, size);
        to += size;
    }
    return r->packed;
}

void ranks_route_begin(struct ranks_route *r, size_t bytes, const void *from, void *in)
{
    MPI_Datatype piece;
    MPI_Request *wait = r->wait;

    MPI_Type_contiguous((int)bytes, MPI_BYTE, &piece);
    MPI_Type_commit(&piece);
    for (int i = 0; i < r->in.n; i++)
        MPI_Irecv((char *)in + (size_t)r->in.first[i] * bytes, r->in.count[i], piece, r->in.rank[i],
                  ROUTE_TAG, MPI_COMM_WORLD, wait++);
    const char *out = pack(r, bytes, from);
    for (int i = 0; i < r->out.n; i++)
        MPI_Isend(out + (size_t)r->out.first[i] * bytes, r->out.count[i], piece, r->out.rank[i], ROUTE_TAG,
                  MPI_COMM_WORLD, wait++);
    ranks_wake();
    MPI_Type_free(&piece); /* only after what has begun with it */
    ranks_traffic_exchange(r->out.n, ranks_route_leaving(r) * (double)bytes);
}

void ranks_route_end(struct ranks_route *r)
{
    ranks_wait(r->in.n + r->out.n, r->wait);
}

void ranks_route_go(struct ranks_route *route, size_t bytes, const void *from, void *in)
{
    ranks_route_begin(route, bytes, from, in);
    ranks_route_end(route);
}
