/* face.c -- what a viscosity at the faces of solids works in. */
#include "eval/face.h"

#include "base/status.h"
#include "space/laws.h"

#include <stdlib.h>

int face_fit_slots(struct face *o, const struct list *l)
{
    const size_t slots = (size_t)l->listed + 1;

    if (slots <= o->slots)
        return STATUS_DONE;
    free(o->velocity);
    free(o->slip);
    o->slots = slots + slots / 8;
    o->velocity = workspace_lines(o->slots * COUPLE_STRIDE);
    o->slip = workspace_lines(o->slots * COUPLE_STRIDE);
    return o->velocity && o->slip ? STATUS_DONE : STATUS_FAILED;
}

int face_fit_pairs(struct face *o, const struct list *l)
{
    const size_t want = (size_t)l->rows_before[l->groups] * (size_t)l->lanes;

    if (want <= o->room)
        return STATUS_DONE;
    free(o->job.c);
    o->room = want + want / 4;
    o->job.c = status_alloc(o->room, sizeof *o->job.c);
    return o->job.c ? STATUS_DONE : STATUS_FAILED;
}

static int take_memory(const struct plan *p, struct face *o)
{
    const size_t n = (size_t)p->particles->n;

    o->job.diagonal = status_alloc(n, sizeof(double));
    o->job.firm = status_alloc(n, sizeof(double));
    o->law = status_alloc(n * DIM, sizeof(double));
    o->f = status_alloc(n * DIM, sizeof(double));
    o->partial = status_alloc(n / FACE_BLOCK + 1, sizeof(double));
    if (o->of->turns && !(o->arm = status_alloc(n * DIM, sizeof(double))))
        return STATUS_FAILED;
    return o->job.diagonal && o->job.firm && o->law && o->f && o->partial ? STATUS_DONE
                                                                          : STATUS_FAILED;
}

int face_create(struct moment *m)
{
    const struct plan_face *of = m->plan->face;
    struct face *o;

    if (!of)
        return STATUS_DONE;
    if (!(o = m->face = status_alloc(1, sizeof *o)))
        return STATUS_FAILED;
    o->of = of;
    o->job = (struct couple_job){
        .acts = of->acts, .couple = of->part->part->as.operator->couple, .self = of->part->self,
        .needs = of->part->part->as.law->rows & ~(unsigned)NEED_V,
        .kernel = m->plan->kernel[of->part->part->as.law->kernel],
    };
    return take_memory(m->plan, o);
}

void face_free(struct face **face)
{
    struct face *o = *face;

    if (!o)
        return;
    double *const memory[] = { o->job.c, o->job.diagonal, o->job.firm, o->velocity, o->slip,
                               o->law, o->f, o->partial, o->arm };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        free(memory[i]);
    free(o);
    *face = NULL;
}

bool face_among(const struct plan *p, const struct pairs_table *table)
{
    return table == p->table.all || table == p->table.velocities
           || table == p->table.without_pressure
           || table == (p->face->part == p->stiff ? p->table.implicit : p->table.explicit);
}
