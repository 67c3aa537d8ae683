/* mpi-cut.c -- cuts by Zoltan's recursive coordinate bisection (Berger and Bokhari, "A
 * partitioning strategy for nonuniform problems on multiprocessors", 1987). */
#include "ranks/ranks.h"

#include "base/status.h"

#include <stdlib.h>
#include <zoltan.h>

struct ranks_cut {
    struct Zoltan_Struct *zoltan;
    int dim, n;
    const double *x, *weight; /* of the caller, while it is made               */
};

/* Lattices have many particles at one coordinate, and no plane across an axis shares these out.  So planes are
 * a little aslant: along axis d counts x[d] + slant x[d + 1], where no two of a lattice are alike. */
static const double slant = 6.18e-4;

static void skew(int dim, const double *x, double *to)
{
    for (int d = 0; d < dim; d++)
        to[d] = x[d] + slant * x[(d + 1) % dim];
}

static int dimension(void *of, int *error)
{
    *error = ZOLTAN_OK;
    return ((struct ranks_cut *)of)->dim;
}

static int count(void *of, int *error)
{
    *error = ZOLTAN_OK;
    return ((struct ranks_cut *)of)->n;
}

/* Points of a rank are named by their numbers there: ids need not differ between ranks, as
 * nobody asks which points go where. */
static void list(void *of, int globals, int locals, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local,
                 int weights, float *weight, int *error)
{
    const struct ranks_cut *cut = of;

    (void)globals;
    (void)locals;
    (void)weights;
    for (int i = 0; i < cut->n; i++) {
        global[i] = local[i] = (ZOLTAN_ID_TYPE)i;
        weight[i] = (float)cut->weight[i];
    }
    *error = ZOLTAN_OK;
}

static void places(void *of, int globals, int locals, int n, ZOLTAN_ID_PTR global,
                   ZOLTAN_ID_PTR local, int dim, double *x, int *error)
{
    const struct ranks_cut *cut = of;

    (void)globals;
    (void)locals;
    (void)global;
    for (int i = 0; i < n; i++)
        skew(dim, cut->x + (size_t)local[i] * dim, x + (size_t)i * dim);
    *error = ZOLTAN_OK;
}

/* Before anything else it is told to be silent. */
static bool set_up(struct ranks_cut *cut)
{
    static const char *const setting[][2] = {
        { "DEBUG_LEVEL", "0" }, { "LB_METHOD", "RCB" }, { "KEEP_CUTS", "1" },
        { "OBJ_WEIGHT_DIM", "1" }, { "NUM_GID_ENTRIES", "1" }, { "NUM_LID_ENTRIES", "1" },
        { "RETURN_LISTS", "NONE" }, { "IMBALANCE_TOL", "1.01" }, { "RCB_OUTPUT_LEVEL", "0" },
    };
    bool good = true;

    for (size_t i = 0; i < sizeof setting / sizeof setting[0]; i++)
        good &= Zoltan_Set_Param(cut->zoltan, setting[i][0], setting[i][1]) == ZOLTAN_OK;
    return good && Zoltan_Set_Num_Geom_Fn(cut->zoltan, dimension, cut) == ZOLTAN_OK
        && Zoltan_Set_Num_Obj_Fn(cut->zoltan, count, cut) == ZOLTAN_OK
        && Zoltan_Set_Obj_List_Fn(cut->zoltan, list, cut) == ZOLTAN_OK
        && Zoltan_Set_Geom_Multi_Fn(cut->zoltan, places, cut) == ZOLTAN_OK;
}

static int partition(struct ranks_cut *cut)
{
    ZOLTAN_ID_PTR in_global, in_local, out_global, out_local;
    int changes, globals, locals, in, out, *in_rank, *in_part, *out_rank, *out_part;
    const int error = Zoltan_LB_Partition(cut->zoltan, &changes, &globals, &locals, &in,
                                          &in_global, &in_local, &in_rank, &in_part, &out,
                                          &out_global, &out_local, &out_rank, &out_part);

    if (error == ZOLTAN_OK || error == ZOLTAN_WARN)
        return STATUS_DONE;
    return status_fail(STATUS_FAILED, "space cannot be cut between %d ranks: Zoltan gives error "
                       "%d", ranks_count(), error);
}

int ranks_cut_create(struct ranks_cut **out, int dim, int n, const double *x,
                     const double *weight)
{
    struct ranks_cut *cut = status_alloc(1, sizeof *cut);
    float version;
    int status = STATUS_FAILED;

    *out = cut;
    if (ranks_agree(cut ? STATUS_DONE : STATUS_FAILED) != STATUS_DONE) {
        ranks_cut_free(out);
        return STATUS_FAILED;
    }
    if (Zoltan_Initialize(0, NULL, &version) == ZOLTAN_OK) {
        *cut = (struct ranks_cut){ Zoltan_Create(MPI_COMM_WORLD), dim, n, x, weight };
        if (cut->zoltan && set_up(cut))
            status = STATUS_DONE;
    }
    status = ranks_agree(status);
    if (status == STATUS_DONE)
        status = ranks_agree(partition(cut));
    if (status != STATUS_DONE)
        ranks_cut_free(out);
    return status;
}

void ranks_cut_free(struct ranks_cut **cut)
{
    if (*cut && (*cut)->zoltan)
        Zoltan_Destroy(&(*cut)->zoltan);
    free(*cut);
    *cut = NULL;
}

int ranks_cut_owner(const struct ranks_cut *cut, const double *x)
{
    double at[3] = { 0 };
    int rank = 0, part;

    skew(cut->dim, x, at);
    Zoltan_LB_Point_PP_Assign(cut->zoltan, at, &rank, &part);
    return rank;
}

static int ascending(const void *l, const void *r)
{
    const int *a = l, *b = r;

    return (*a > *b) - (*a < *b);
}

int ranks_cut_near(const struct ranks_cut *cut, const double *low, const double *high, int *rank)
{
    double from[3] = { 0 }, to[3] = { 0 };
    int n = 0;

    skew(cut->dim, low, from);
    skew(cut->dim, high, to);
    Zoltan_LB_Box_Assign(cut->zoltan, from[0], from[1], from[2], to[0], to[1], to[2], rank, &n);
    qsort(rank, (size_t)n, sizeof *rank, ascending);
    return n;
}
