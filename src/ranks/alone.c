/* alone.c -- ranks of the serial programs: there is one, which agrees with itself. */
#include "ranks/copies.h"
#include "ranks/ranks.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

static int me; /* above 0: one of several copies, all of which end at once */

int ranks_begin(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
    me = ranks_copy();
    return ranks_refuse_copies((struct status_advice){
        .cause = "mpirun has started the program that knows no ranks",
        .remedy = "take `stiffwater run SCENE --ranks N', or `mpirun -n N stiffwater-2d-mpi run "
                  "SCENE' (in 3D stiffwater-3d-mpi)" });
}

void ranks_end(void)
{
}

int ranks_count(void)
{
    return 1;
}

int ranks_me(void)
{
    return me;
}

bool ranks_by_mpi(void)
{
    return false;
}

void ranks_leave(void)
{
}

int ranks_agree(int status)
{
    return status;
}

int ranks_agree_within(int status)
{
    return status;
}

int ranks_agree_after(int status)
{
    return status;
}

int ranks_first(double key, long order, void *said, size_t bytes)
{
    (void)order;
    (void)said;
    (void)bytes;
    return key < HUGE_VAL ? 0 : -1;
}

void ranks_firsts(int n, const double *key, const long *order, void *said, size_t bytes, int *rank)
{
    for (int i = 0; i < n; i++)
        rank[i] = ranks_first(key[i], order[i], said, bytes);
}

void ranks_most(int n, double *x)
{
    (void)n;
    (void)x;
}

void ranks_add(int n, int64_t *x)
{
    (void)n;
    (void)x;
}

void ranks_gather(const int *count, size_t bytes, const void *mine, void *all)
{
    if (mine)
        memcpy(all, mine, (size_t)count[0] * bytes);
}

void ranks_bring(const int *count, size_t bytes, const void *mine, void *all)
{
    memcpy(all, mine, (size_t)count[0] * bytes);
}

/* No cut and no route has a member: there is nothing to know of them. */
int ranks_cut_create(struct ranks_cut **cut, int dim, int n, const double *x,
                     const double *weight)
{
    (void)dim;
    (void)n;
    (void)x;
    (void)weight;
    *cut = NULL;
    return STATUS_DONE;
}

void ranks_cut_free(struct ranks_cut **cut)
{
    *cut = NULL;
}

int ranks_cut_owner(const struct ranks_cut *cut, const double *x)
{
    (void)cut;
    (void)x;
    return 0;
}

int ranks_cut_near(const struct ranks_cut *cut, const double *low, const double *high, int *rank)
{
    (void)cut;
    (void)low;
    (void)high;
    rank[0] = 0;
    return 1;
}

int ranks_route_create(struct ranks_route **route, int status, size_t widest, int n, const int *to,
                       const int *row)
{
    (void)widest;
    (void)n;
    (void)to;
    (void)row;
    *route = NULL;
    return status;
}

int ranks_route_create_uneven(struct ranks_route **route, int status, size_t widest, int n,
                              const int *to, const int *row, const int *units)
{
    (void)units;
    return ranks_route_create(route, status, widest, n, to, row);
}

void ranks_route_free(struct ranks_route **route)
{
    *route = NULL;
}

int ranks_route_coming(const struct ranks_route *route)
{
    (void)route;
    return 0;
}

void ranks_route_go(struct ranks_route *route, size_t bytes, const void *from, void *in)
{
    ranks_route_begin(route, bytes, from, in);
    ranks_route_end(route);
}

void ranks_route_begin(struct ranks_route *route, size_t bytes, const void *from, void *in)
{
    (void)route;
    (void)bytes;
    (void)from;
    (void)in;
}

void ranks_route_end(struct ranks_route *route)
{
    (void)route;
}

int ranks_route_partners(const struct ranks_route *route)
{
    (void)route;
    return 0;
}

int ranks_route_leaving(const struct ranks_route *route)
{
    (void)route;
    return 0;
}

void ranks_alike(const void *block, size_t bytes)
{
    (void)block;
    (void)bytes;
}
