/* cloud.c -- particles of all ranks, seen by the first of them. */
#include "output/cloud.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <stdlib.h>
#include <string.h>

/* Particles that a rank has. */
static int part_of(const struct cloud_frame *c, int rank)
{
    return ranks_part(c->n, rank + 1) - ranks_part(c->n, rank);
}

/* The numbers of `here` particles, array after array. */
static void lay(struct cloud_frame *c, const double *room)
{
    const size_t here = (size_t)c->here, dim = (size_t)c->dim;

    c->x = room;
    c->u = c->x + dim * here;
    c->rho = c->u + dim * here;
    c->p = c->rho + here;
}

static void pack(const struct cloud_frame *c, double *room)
{
    struct cloud_frame to = *c;
    const size_t here = (size_t)c->here * sizeof *room, dim = (size_t)c->dim;

    lay(&to, room);
    memcpy((double *)to.x, c->x, dim * here);
    memcpy((double *)to.u, c->u, dim * here);
    memcpy((double *)to.rho, c->rho, here);
    memcpy((double *)to.p, c->p, here);
}

/* Rank by rank; room [that of the largest part]. */
static void show_parts(const struct cloud_frame *c, cloud_see *see, void *self, double *room)
{
    const size_t bytes = (2 * (size_t)c->dim + 2) * sizeof *room;
    const int ranks = ranks_count(), me = ranks_me();
    struct cloud_frame part = *c;
    int count[ranks];

    if (me > 0)
        pack(c, room);
    else
        see(self, c);
    memset(count, 0, sizeof count);
    for (int r = 1; r < ranks; r++) {
        count[r] = part_of(c, r);
        ranks_bring(count, bytes, me > 0 ? room : NULL, me > 0 ? NULL : room);
        count[r] = 0;
        part.from = ranks_part(c->n, r);
        part.here = part_of(c, r);
        lay(&part, room);
        if (me == 0)
            see(self, &part);
    }
}

int cloud_show(const struct cloud_frame *c, cloud_see *see, void *self)
{
    const unsigned long most = (unsigned long)(c->n / ranks_count() + 1);
    double *room;
    int status;

    if (!c->shared) {
        see(self, c);
        return STATUS_DONE;
    }
    room = status_alloc(most, (2 * (unsigned long)c->dim + 2) * sizeof *room);
    status = ranks_agree(room ? STATUS_DONE : STATUS_FAILED);
    if (status == STATUS_DONE)
        show_parts(c, see, self, room);
    free(room);
    return status;
}
