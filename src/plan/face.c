/* face.c -- what a viscosity at the faces of solids needs, and who may have it. */
#include "plan/face.h"

#include "base/status.h"
#include "scene/scene.h"
#include "space/laws.h"

#include <stdlib.h>

/* --- memory ------------------------------------------------------------------ */

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
    const struct face_plan *of = m->plan->face;
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

/* --- who takes part ----------------------------------------------------------- */

static const struct object *sliding(const struct plan *p)
{
    for (int i = 0; i < p->particles->objects; i++)
        for (int d = 0; d < DIM; d++)
            if (p->particles->object[i].slide[d] != 0)
                return &p->particles->object[i];
    return NULL;
}

static int check_sliding(const struct scene *scene, const struct object *slides,
                         const struct plan_part *part)
{
    if (slides && slides->kind == KIND_WALL_SLIP)
        return status_fail(STATUS_BAD_SCENE, "%s: wall.%s has a velocity of its surface, but "
                           "slip = true, so that nothing is dragged along; leave one of them out",
                           scene_path(scene), slides->name);
    if (slides && !part)
        return status_fail(STATUS_BAD_SCENE, "%s: wall.%s.surface drags the fluid along by a "
                           "viscosity, of which the scene has none: name effects.laminar-viscosity "
                           "= { mu = ...; }", scene_path(scene), slides->name);
    return STATUS_DONE;
}

/* The viscosity that asks for it, or if a face slides the one that there is. */
static int find_part(struct plan *p, const struct scene *scene, const struct plan_part **part)
{
    const struct object *slides = sliding(p);

    *part = NULL;
    for (int i = 0; i < p->parts; i++) {
        const struct plan_part *one = &p->part[i];
        if (!one->part->as.operator || !(slides || one->part->as.operator->faces(one->self)))
            continue;
        if (*part)
            return status_fail(STATUS_BAD_SCENE, "%s: %s and %s both act at the faces of walls, "
                               "but one can; leave one of them out, or set its stick = "
                               "\"particles\" if no face slides", scene_path(scene), (*part)->path,
                               one->path);
        *part = one;
    }
    return check_sliding(scene, slides, *part);
}

int face_make(struct plan *p, const struct scene *scene)
{
    const struct plan_part *part;
    struct face_plan *o;

    TRY(find_part(p, scene, &part));
    if (!part || particles_count(p->particles, KIND_WALL)
                 + particles_count(p->particles, KIND_SKIN) == 0)
        return STATUS_DONE;
    if (!(o = p->face = status_alloc(1, sizeof *o)))
        return STATUS_FAILED;
    o->part = part;
    o->mirrored = part->part->as.operator->faces(part->self);
    o->acts[KIND_FLUID] = KIND_STICKY;
    o->acts[KIND_WALL] = o->acts[KIND_SKIN] = KIND_BIT(KIND_FLUID);
    for (int i = 0; i < p->walls; i++)
        o->turns |= walls_motion_turns(&p->wall[i].motion);
    return STATUS_DONE;
}

bool face_among(const struct plan *p, const struct pairs_table *table)
{
    return table == p->table.all || table == p->table.velocities
           || table == p->table.without_pressure
           || table == (p->face->part == p->stiff ? p->table.implicit : p->table.explicit);
}
