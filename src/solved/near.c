/* near.c -- places and neighbours, copied from a pair list. */
#include "solved/near.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

static int take_places(struct near *s, int places)
{
    if (places <= s->room_places && s->from)
        return STATUS_DONE;
    free(s->origin), free(s->x), free(s->u), free(s->from);
    s->room_places = places + places / 8 + 64;
    const size_t room = (size_t)s->room_places;
    s->origin = status_alloc(room, sizeof *s->origin);
    s->x = status_alloc(room, sizeof *s->x);
    s->u = status_alloc(room, sizeof *s->u);
    s->from = status_alloc(room + 1, sizeof *s->from);
    return s->origin && s->x && s->u && s->from ? STATUS_DONE : STATUS_FAILED;
}

static int take_neighbours(struct near *s, size_t pairs)
{
    if (pairs <= s->room && s->place)
        return STATUS_DONE;
    free(s->place);
    s->room = pairs + pairs / 8 + 64;
    s->place = status_alloc(s->room, sizeof *s->place);
    return s->place ? STATUS_DONE : STATUS_FAILED;
}

void near_images(struct near *s, const struct list *l)
{
    for (int i = s->n; i < s->places; i++)
        for (int d = 0; d < DIM; d++) {
            const int o = s->origin[i];
            const double home = s->x[o][d] - l->offset[o][d];
            s->x[i][d] = home + l->offset[i][d];
        }
}

static void read_places(struct near *s, const struct list *l, const struct view *v)
{
    for (int k = 0; k < KINDS; k++)
        for (int i = l->start[k]; i < l->start[k + 1]; i++) {
            const size_t row = (size_t)(l->order[i] - v->p->from[k]);
            s->origin[i] = i;
            for (int d = 0; d < DIM; d++) {
                s->x[i][d] = v->x[k][row * DIM + (size_t)d] + (l->offset ? l->offset[i][d] : 0);
                s->u[i][d] = v->u[k][row * DIM + (size_t)d];
            }
        }
    for (int i = s->n; i < s->places; i++)
        s->origin[i] = l->slot[l->order[i]];
    near_images(s, l);
}

/* Neighbours of the particle in lane `lane` of group g that are near enough; to NULL: their
 * number. */
static size_t gather(const struct near *s, const struct list *l, int g, int lane, double reach,
                     int *to)
{
    const int i = l->group_slot[g] + lane;
    size_t n = 0;
    double step[DIM];

    for (int k = l->segment_from[g]; k < l->segment_from[g + 1]; k++)
        for (int row = 0; row < l->segment[k].rows; row++) {
            const int j = list_place(l->segment[k].j[(size_t)row * (size_t)l->lanes + (size_t)lane]);
            if (j == l->listed || !(near_step(s, i, j, step) < reach * reach))
                continue;
            if (to)
                to[n] = j;
            n++;
        }
    return n;
}

/* Calls for all owners: counts first, then fills. */
static void visit(struct near *s, const struct list *l, double reach, bool fill)
{
#pragma omp parallel for schedule(static)
    for (int g = 0; g < l->groups; g++)
        for (int lane = 0; lane < l->lanes; lane++) {
            const int i = l->group_slot[g] + lane;
            if (i >= l->start[l->group_kind[g] + 1])
                break;
            if (fill)
                gather(s, l, g, lane, reach, s->place + s->from[i]);
            else
                s->from[i + 1] = gather(s, l, g, lane, reach, NULL);
        }
}

int near_make(struct near *s, const struct list *l, const struct view *v, double reach)
{
    TRY(take_places(s, l->listed));
    s->n = l->start[KINDS];
    s->fluid = l->start[KIND_FLUID + 1];
    s->places = l->listed;
    read_places(s, l, v);
    memset(s->from, 0, ((size_t)s->n + 1) * sizeof *s->from);
    visit(s, l, reach, false);
    for (int i = 0; i < s->n; i++)
        s->from[i + 1] += s->from[i];
    TRY(take_neighbours(s, s->from[s->n]));
    visit(s, l, reach, true);
    return STATUS_DONE;
}

void near_free(struct near *s)
{
    free(s->origin), free(s->x), free(s->u), free(s->from), free(s->place);
    *s = (struct near){ 0 };
}
