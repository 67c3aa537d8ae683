/* wet.c -- solids that something meets in the list of pairs.
 *
 * All others have a force of exactly +0 by pairs, so that sums over solids, in order of ids, do
 * without them.  On many ranks each has pairs of its own particles, and all know all of those
 * solids; where ranks have all rows of y, any solid may be one. */
#include "eval/share.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

int wet_create(const struct plan *p, struct wet_solids *wet)
{
    const size_t solids = (size_t)(p->particles->n - particles_count(p->particles, KIND_FLUID)) + 1;

    wet->met = status_alloc(solids, sizeof *wet->met);
    wet->has = status_alloc(solids, sizeof *wet->has);
    wet->row = status_alloc(solids, sizeof *wet->row);
    wet->other = status_alloc(solids, sizeof *wet->other);
    wet->of = status_alloc((size_t)p->particles->objects + 1, sizeof *wet->of);
    wet->f = status_alloc(solids, sizeof *wet->f);
    return wet->met && wet->has && wet->row && wet->other && wet->of && wet->f ? STATUS_DONE
                                                                                : STATUS_FAILED;
}

void wet_free(struct wet_solids *wet)
{
    free(wet->met);
    free(wet->has);
    free(wet->row);
    free(wet->other);
    free(wet->of);
    free(wet->f);
    free(wet->seen);
    *wet = (struct wet_solids){ 0 };
}

/* --- which they are ------------------------------------------------------------------------- */

static int number_of(const struct moment *m, int row)
{
    return particles_id_of(m->particles, row) - m->particles->from[KIND_WALL];
}

/* Owners of a group that have a neighbour in a segment: its first row says so. */
static void mark_owners(const struct moment *m, int group, const struct list_segment *s)
{
    const struct list *l = m->list;
    struct wet_solids *wet = &m->work->wet;

    for (int lane = 0; s->rows > 0 && lane < l->lanes; lane++)
        if (list_place(s->j[lane]) != l->listed) {
            const int id = number_of(m, l->order[l->group_slot[group] + lane]);
            wet->has[id] = true;
            wet->met[id] |= s->partner == KIND_FLUID;
        }
}

static void see_neighbours(const struct list *l, int group, bool *seen)
{
    for (int s = l->segment_from[group]; s < l->segment_from[group + 1]; s++)
        for (int i = 0; l->segment[s].partner != KIND_FLUID && i < l->segment[s].rows * l->lanes; i++)
            seen[list_place(l->segment[s].j[i])] = true;
}

/* Solids of others that are neighbours of own fluid: many entries name the same place. */
static void mark_neighbours(const struct moment *m)
{
    const struct list *l = m->list;
    bool *seen = m->work->wet.seen;

    memset(seen, 0, ((size_t)l->listed + 1) * sizeof *seen);
    for (int g = l->group_from[KIND_FLUID]; g < l->group_from[KIND_FLUID + 1]; g++)
        if (m->share->full || drift_near_group(l, g))
            see_neighbours(l, g, seen);
    for (int place = l->start[KIND_WALL]; place < l->listed; place++)
        if (seen[place])
            m->work->wet.met[number_of(m, l->order[place])] = true;
}

static void mark(const struct moment *m)
{
    const struct list *l = m->list;

    for (int g = l->group_from[KIND_WALL]; g < l->groups; g++)
        for (int s = l->segment_from[g]; s < l->segment_from[g + 1]; s++)
            mark_owners(m, g, &l->segment[s]);
    if (m->share)
        mark_neighbours(m);
}

/* On many ranks: what all have heard, or any. */
static void mark_known(const struct moment *m)
{
    const struct moment_share *s = m->share;
    bool *has = m->work->wet.has;

    if (s && s->full)
        memset(has, true, (size_t)(s->n - m->particles->from[KIND_WALL]) * sizeof *has);
    for (int i = 0; s && !s->full && i < s->wet.from[s->ranks]; i++)
        has[number_of(m, s->wet.row[i])] = true;
}

static void name_rows(const struct moment *m)
{
    const struct particles *p = m->particles;
    struct wet_solids *wet = &m->work->wet;
    int n = 0;

    for (int i = 0; i < p->objects; i++) {
        const struct object *o = &p->object[i];
        wet->of[i] = n;
        for (int id = o->from; o->kind != KIND_FLUID && id < o->from + o->n; id++)
            if (wet->has[id - p->from[KIND_WALL]])
                wet->row[n++] = particles_row_of(p, id);
    }
    wet->of[p->objects] = n;
}

/* Forces of before are gone. */
static void forget(const struct moment *m)
{
    const int first = m->particles->from[KIND_WALL];
    struct wet_solids *wet = &m->work->wet;

    for (int k = 0; k < wet->of[m->particles->objects]; k++)
        memset(wet->f[wet->row[k] - first], 0, sizeof *wet->f);
    wet->of[m->particles->objects] = 0;
}

void wet_mark(struct moment *m)
{
    const size_t solids = (size_t)(m->particles->n - m->particles->from[KIND_WALL]);
    struct wet_solids *wet = &m->work->wet;

    if (wet->list == m->list && wet->builds == m->list->builds)
        return;
    forget(m);
    memset(wet->met, 0, solids * sizeof *wet->met);
    memset(wet->has, 0, solids * sizeof *wet->has);
    mark(m);
    wet->list = m->list;
    wet->builds = m->list->builds;
    wet->named = false;
}

void wet_find(struct moment *m)
{
    wet_mark(m);
    if (m->work->wet.named)
        return;
    mark_known(m);
    name_rows(m);
    m->work->wet.named = true;
}

bool wet_is_near(const struct moment *m, int row)
{
    const int id = number_of(m, row);

    return m->work->wet.has[id] || m->work->wet.met[id];
}

void wet_forget(struct moment *m)
{
    m->work->busy.list = NULL;
    m->work->wet.list = NULL;
    m->work->narrowed = NULL;
}

/* --- forces --------------------------------------------------------------------------------- */

/* Of rows [n]. */
static void take(const struct moment *m, int n, const int *row)
{
    const int first = m->particles->from[KIND_WALL];
    double (*f)[DIM] = m->work->wet.f;

    for (int k = 0; k < n; k++) {
        const int place = m->list->slot[row[k]]; /* -1: of others, or nowhere */
        for (int d = 0; d < DIM; d++)
            f[row[k] - first][d] = place < 0 ? 0 : m->work->f[(size_t)place * DIM + d];
    }
}

/* Where ranks have their own rows, those of others come. */
void wet_take(struct moment *m)
{
    const int first = m->particles->from[KIND_WALL];
    const struct moment_share *s = m->share;
    struct wet_solids *wet = &m->work->wet;

    wet_find(m);
    for (int k = 0; k < wet->others; k++)
        memset(wet->f[wet->other[k] - first], 0, sizeof *wet->f);
    wet->others = 0;
    if (s && !s->full)
        take(m, s->wet.from[s->me + 1] - s->wet.from[s->me], s->wet.row + s->wet.from[s->me]);
    else
        take(m, wet->of[m->particles->objects], wet->row);
}

bool wet_counts(const struct moment *m, int row)
{
    const struct particles *p = m->particles;
    const int k = p->object[p->object_of[row]].kind;

    return m->share && m->share->packed
               ? list_inside(&m->list->def, share_was(m, k) + (size_t)(row - p->from[k]) * DIM)
               : m->list->slot[row] >= 0;
}

/* Where solids press each other, all rows of an object are looked at. */
int wet_rows(const struct moment *m, int object)
{
    const struct wet_solids *wet = &m->work->wet;

    return wet->others > 0 ? m->particles->object[object].n : wet->of[object + 1] - wet->of[object];
}

int wet_row(const struct moment *m, int object, int k)
{
    const struct wet_solids *wet = &m->work->wet;

    return wet->others > 0 ? particles_row_of(m->particles, m->particles->object[object].from + k)
                           : wet->row[wet->of[object] + k];
}
