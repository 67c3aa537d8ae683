/* contact-room.c -- how much of the kernel around a particle of a solid is open to water. */
#include "walls/contact-room.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "shapes/shape.h"
#include "state/period.h"
#include "walls/contact-beside.h"
#include "walls/contact-look.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CUTS = CONTACT_BESIDE_CUTS, POINTS = 1 << DIM };

/* The sum of one particle. */
struct tally {
    const struct contact_room *room;
    const double *x;    /* the particle                  */
    int first, group;   /* id of the first solid; its own group */
    struct contact_beside *beside; /* points whose cells may matter */
    const double *across;   /* of a layer that is alone; NULL */
    double side[2];         /* what is open behind and before it */
    struct contact_share sum;
};

static double length_of(const double *step)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++)
        r2 += step[d] * step[d];
    return sqrt(r2);
}

double contact_room_cell(const struct part_places *at)
{
    return pow(at->p->scales->dx, DIM);
}

double contact_room_kernel(const struct part_places *at, double cell, double r)
{
    const double dx = at->p->scales->dx, least = at->kernel->kernel->singular ? dx / 2 : 0;

    return kernel_w(at->kernel, fmax(r, least)) * cell;
}

/* --- cells around a particle --------------------------------------------------------- */

static int cells_of(const struct contact_room *r)
{
    int cells = 1;

    for (int d = 0; d < DIM; d++)
        cells *= r->side;
    return cells;
}

/* The step from a particle to the middle of cell k around it. */
static void middle_of(const struct contact_room *r, int k, double *middle)
{
    for (int d = 0; d < DIM; d++, k /= r->side)
        middle[d] = (k % r->side - r->side / 2) * r->at->p->scales->dx;
}

/* The same around each particle. */
static int weigh_cells(struct contact_room *r)
{
    const double cell = contact_room_cell(r->at);
    double middle[DIM];

    r->side = 2 * (int)ceil(r->at->kernel->support / r->at->p->scales->dx) + 1;
    r->weight = status_alloc((unsigned long)cells_of(r), sizeof *r->weight);
    for (int k = 0; r->weight && k < cells_of(r); k++) {
        middle_of(r, k, middle);
        r->weight[k] = contact_room_kernel(r->at, cell, length_of(middle));
    }
    return r->weight ? STATUS_DONE : STATUS_FAILED;
}

int contact_room_create(struct contact_room *r, const struct part_places *at,
                        const struct contact_cells *solids)
{
    const struct particles *p = at->p;
    const int first = p->from[KIND_WALL], n = p->n - first;

    *r = (struct contact_room){ .at = at, .cells = solids };
    r->skin = status_alloc((unsigned long)n + 1, sizeof *r->skin);
    r->bounds = status_alloc((unsigned long)p->objects + 1, sizeof *r->bounds);
    if (!r->skin || !r->bounds || weigh_cells(r) != STATUS_DONE) {
        contact_room_free(r);
        return STATUS_FAILED;
    }
    for (int o = 0; o < p->objects; o++)
        if (at->solid[o].group >= 0 && at->solid[o].shape)
            shape_bounds(at->solid[o].shape, r->bounds[o][0], r->bounds[o][1]);
    for (int i = 0; i < n; i++)
        if (!at->solid[p->object_of[first + i]].shape)
            contact_skin_fit(at, solids, i, &r->skin[i]);
    return STATUS_DONE;
}

void contact_room_free(struct contact_room *r)
{
    free(r->skin);
    free(r->bounds);
    free(r->weight);
    r->skin = NULL;
    r->bounds = NULL;
    r->weight = NULL;
}

/* --- what is open -------------------------------------------------------------------- */

static bool in_bounds(double (*const bounds)[DIM], const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (x[d] < bounds[0][d] || x[d] > bounds[1][d])
            return false;
    return true;
}

static bool in_domain(const struct scales *s, const double *x)
{
    for (int d = 0; d < DIM; d++)
        if (x[d] < s->low[d] || x[d] >= s->high[d])
            return false;
    return true;
}

/* A place at `step` from the particle.  Another solid may stand outside the domain, and may
 * leave. */
static bool is_open(const struct tally *it, int cuts, const double *step)
{
    const struct part_places *at = it->room->at;
    double x[DIM], home[DIM];
    bool open;

    for (int d = 0; d < DIM; d++)
        x[d] = it->x[d] + step[d];
    period_home(at->p->scales, x, home);
    open = in_domain(at->p->scales, home);
    for (int o = 0; o < at->p->objects; o++) {
        const struct part_solid *solid = &at->solid[o];
        if (solid->group < 0 || !solid->shape || !in_bounds(it->room->bounds[o], home)
            || !shape_contains(solid->shape, home))
            continue;
        if (solid->group == it->group)
            return false;
        open = true;
    }
    return open && !contact_beside_fills(it->beside, cuts, step);
}

/* Of a cube around `middle', its sides 2 half. */
static enum contact_look look_at(const struct tally *it, int cuts, const double *middle,
                                 double half)
{
    double low[DIM], high[DIM];

    for (int d = 0; d < DIM; d++) {
        low[d] = it->x[d] + middle[d] - half;
        high[d] = it->x[d] + middle[d] + half;
    }
    return contact_look(it->room->at, it->room->bounds, it->group, it->beside->count[cuts] > 0,
                        low, high);
}

/* Steps to the corners of a cube around `middle`, its sides 2 half. */
static void corners(const double *middle, double half, double (*step)[DIM])
{
    for (int k = 0; k < POINTS; k++)
        for (int d = 0; d < DIM; d++)
            step[k][d] = middle[d] + (k >> d & 1 ? half : -half);
}

/* Which of these places are open, a bit each. */
static unsigned open_ones(const struct tally *it, int cuts, double (*step)[DIM])
{
    unsigned open = 0;

    for (int k = 0; k < POINTS; k++)
        open |= (unsigned)is_open(it, cuts, step[k]) << k;
    return open;
}

static void add_side(struct tally *it, const double *step, double w)
{
    double part = 0;

    for (int d = 0; it->across && d < DIM; d++)
        part += step[d] * it->across[d];
    it->side[part > 0] += w;
}

/* A part of a cell around `middle`, its sides 2 half, weight w if it is open.  It is cut in
 * halves where its corners do not agree; the last are measured by Gauss' points. */
static void add_part(struct tally *it, const double *middle, double half, int cuts, double w)
{
    const enum contact_look look = look_at(it, cuts, middle, 0.995 * half); /* points: within 0.99 */
    const unsigned all = (1u << POINTS) - 1;
    double step[POINTS][DIM];
    unsigned open;

    if (look == CONTACT_SHUT)
        return;
    corners(middle, 0.99 * half, step); /* faces often lie between cells */
    open = look == CONTACT_OPEN ? all : open_ones(it, cuts, step);
    if (open != 0 && open != all && cuts > 0) {
        corners(middle, half / 2, step);
        for (int k = 0; k < POINTS; k++) {
            contact_beside_keep(it->beside, cuts - 1, step[k], half / 2);
            add_part(it, step[k], half / 2, cuts - 1, w / POINTS);
        }
        return;
    }
    corners(middle, half / sqrt(3), step);
    if (open != 0 && open != all)
        open = open_ones(it, cuts, step);
    for (int k = 0; k < POINTS; k++) {
        if (!(open & 1u << k))
            continue;
        it->sum.open += w / POINTS;
        for (int d = 0; d < DIM; d++)
            it->sum.normal[d] += w / POINTS * step[k][d] / length_of(step[k]);
        add_side(it, step[k], w / POINTS);
    }
}

static void keep_skin(void *self, int j, double r, const double *step)
{
    struct tally *it = self;
    const struct part_places *at = it->room->at;

    const struct part_solid *solid = &at->solid[at->p->object_of[it->first + j]];

    if (!solid->shape && solid->group == it->group
        && r <= at->kernel->support + 2 * at->p->scales->dx)
        contact_beside_add(it->beside, j, step);
}

/* The direction across a solid that is one layer thick where particle i is; false: it has
 * more, as far as one can tell. */
static bool across_of(const struct contact_room *r, int i, double *across)
{
    const struct particles *p = r->at->p;
    const double *x = r->cells->x[i], dx = p->scales->dx;
    const struct shape *shape = r->at->solid[p->object_of[p->from[KIND_WALL] + i]].shape;
    double own[DIM], beside[DIM], there[DIM];

    if (r->skin[i].alone)
        memcpy(across, r->skin[i].axis[DIM - 1], sizeof own);
    for (int d = 0; shape && d < DIM; d++) {
        if (!shape_is_thin(shape, d, 1.5 * dx))
            continue;
        shape_own(shape, x, own);
        for (int e = 0; e < DIM; e++) {
            memcpy(beside, x, sizeof beside);
            beside[e] += dx;
            shape_own(shape, beside, there);
            across[e] = (there[d] - own[d]) / dx;
        }
        return true;
    }
    return r->skin[i].alone;
}

struct contact_share contact_room_share(const struct contact_room *r, int i)
{
    const int first = r->at->p->from[KIND_WALL], cells = cells_of(r);
    const double half = r->at->p->scales->dx / 2;
    struct contact_beside beside; /* large: not all of it is cleared */
    struct tally it;
    double across[DIM], middle[DIM];

    it.room = r;
    it.x = r->cells->x[i];
    it.first = first;
    it.group = r->at->solid[r->at->p->object_of[first + i]].group;
    it.beside = &beside;
    beside.skin = r->skin;
    beside.n = 0;
    it.sum = (struct contact_share){ 0 };
    it.across = across_of(r, i, across) ? across : NULL;
    it.side[0] = it.side[1] = 0;
    contact_cells_visit(r->cells, it.x, keep_skin, &it);
    for (int k = 0; k < cells; k++) {
        if (!(r->weight[k] > 0))
            continue;
        middle_of(r, k, middle);
        contact_beside_keep(&beside, CUTS, middle, half);
        add_part(&it, middle, half, CUTS, r->weight[k]);
    }
    it.sum.alone = it.across != NULL;
    if (it.across)
        it.sum.open = fmax(it.side[0], it.side[1]);
    return it.sum;
}
