/* mpi-route.c -- routes by neighbourhood collectives: a rank hears of its partners alone.
 *
 * One Alltoall of counts makes a route, none is needed to use it. */
#include "ranks/ranks.h"
#include "ranks/traffic.h"

#include "base/status.h"

#include <mpi.h>
#include <stdlib.h>
#include <string.h>

/* Partners of one direction; those of rank[k] stand from first[k] on, first[n] is all. */
struct side {
    int n;
    int *rank, *count, *first;
};

struct ranks_route {
    MPI_Comm comm;         /* MPI_COMM_NULL: nothing travels anywhere          */
    struct side out, in;
    int *row;              /* [leaving] by partner                             */
    size_t widest;         /* bytes of a row at most                           */
    char *packed;          /* [leaving] so wide                                */
};

/* The partners of a direction, by how many rows each has. */
static int open_side(struct side *s, const int *rows)
{
    const int ranks = ranks_count();

    s->rank = status_alloc((size_t)ranks, sizeof(int));
    s->count = status_alloc((size_t)ranks, sizeof(int));
    s->first = status_alloc((size_t)ranks + 1, sizeof(int));
    if (!s->rank || !s->count || !s->first)
        return STATUS_FAILED;
    for (int r = 0; r < ranks; r++) {
        if (rows[r] == 0)
            continue;
        s->rank[s->n] = r;
        s->count[s->n] = rows[r];
        s->first[s->n + 1] = s->first[s->n] + rows[r];
        s->n++;
    }
    return STATUS_DONE;
}

static void close_side(struct side *s)
{
    free(s->rank);
    free(s->count);
    free(s->first);
}

/* Rows by partner, those of one in the order given; next [ranks] is where each stands. */
static void sort_rows(struct ranks_route *r, int n, const int *to, const int *row, int *next)
{
    for (int k = 0; k < r->out.n; k++)
        next[r->out.rank[k]] = r->out.first[k];
    for (int i = 0; i < n; i++)
        r->row[next[to[i]]++] = row[i];
}

/* Counts [2][ranks]: how many go to each, how many come. */
static int make(struct ranks_route *r, int n, const int *to, const int *row, int *rows)
{
    const int ranks = ranks_count();
    int status;

    for (int i = 0; i < n; i++)
        rows[to[i]]++;
    MPI_Alltoall(rows, 1, MPI_INT, rows + ranks, 1, MPI_INT, MPI_COMM_WORLD);
    status = open_side(&r->out, rows);
    if (status == STATUS_DONE)
        status = open_side(&r->in, rows + ranks);
    r->row = status_alloc((size_t)n + 1, sizeof *r->row);
    r->packed = status_alloc((size_t)n + 1, r->widest);
    status = ranks_agree(r->row && r->packed ? status : STATUS_FAILED);
    if (status != STATUS_DONE)
        return status;
    sort_rows(r, n, to, row, rows);
    MPI_Dist_graph_create_adjacent(MPI_COMM_WORLD, r->in.n, r->in.rank, r->in.count, r->out.n,
                                   r->out.rank, r->out.count, MPI_INFO_NULL, 0, &r->comm);
    return STATUS_DONE;
}

int ranks_route_create(struct ranks_route **route, size_t widest, int n, const int *to,
                       const int *row)
{
    int *rows = status_alloc(2 * (size_t)ranks_count(), sizeof *rows);
    int status;

    *route = status_alloc(1, sizeof **route);
    if (*route)
        (*route)->comm = MPI_COMM_NULL;
    status = ranks_agree(rows && *route ? STATUS_DONE : STATUS_FAILED);
    if (status == STATUS_DONE) {
        (*route)->widest = widest;
        status = make(*route, n, to, row, rows);
    }
    free(rows);
    if (status != STATUS_DONE)
        ranks_route_free(route);
    return status;
}

void ranks_route_free(struct ranks_route **route)
{
    struct ranks_route *r = *route;

    if (!r)
        return;
    if (r->comm != MPI_COMM_NULL)
        MPI_Comm_free(&r->comm);
    close_side(&r->out);
    close_side(&r->in);
    free(r->row);
    free(r->packed);
    free(r);
    *route = NULL;
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

void ranks_route_go(struct ranks_route *r, size_t bytes, const void *from, void *in)
{
    MPI_Datatype row;

    MPI_Type_contiguous((int)bytes, MPI_BYTE, &row);
    MPI_Type_commit(&row);
    for (int i = 0; i < ranks_route_leaving(r); i++)
        memcpy(r->packed + (size_t)i * bytes, (const char *)from + (size_t)r->row[i] * bytes,
               bytes);
    ranks_traffic_exchange(r->out.n, ranks_route_leaving(r) * (double)bytes);
    MPI_Neighbor_alltoallv(r->packed, r->out.count, r->out.first, row, in, r->in.count,
                           r->in.first, row, r->comm);
    MPI_Type_free(&row);
}
