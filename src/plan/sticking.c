/* sticking.c -- which viscosity acts at the faces of solids. */
#include "plan/inside.h"

#include "base/status.h"
#include "scene/scene.h"

static const struct object *sliding(const struct plan *p)
{
    for (int i = 0; i < p->particles->objects; i++)
        for (int d = 0; d < DIM; d++)
            if (p->particles->object[i].slide[d] != 0)
                return &p->particles->object[i];
    return NULL;
}

static int check_sliding(const struct plan *p, const struct scene *scene,
                         const struct object *slides, const struct plan_part *part)
{
    if (slides && slides->kind == KIND_WALL_SLIP)
        return status_fail(STATUS_BAD_SCENE, "%s: wall.%s has a velocity of its surface, but "
                           "slip = true, so that nothing is dragged along; leave one of them out",
                           scene_path(scene), slides->name);
    if (slides && !part)
        return status_fail(STATUS_BAD_SCENE, "%s: wall.%s.surface drags the fluid along by a "
                           "viscosity, of which the scene has none: name effects.laminar-viscosity "
                           "= { mu = ...; }", scene_path(scene), slides->name);
    if (slides && p->in.walls->as.wall->only)
        return status_fail(STATUS_BAD_SCENE, "%s: wall.%s.surface drags nothing along where effects.%s "
                           "alone acts between fluid and solids; take other walls than \"%s\"",
                           scene_path(scene), slides->name, p->in.walls->as.wall->only,
                           p->in.walls->name);
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
    return check_sliding(p, scene, slides, *part);
}

int plan_face_make(struct plan *p, const struct scene *scene)
{
    const struct plan_part *part;
    struct plan_face *o;

    if (p->in.fluids == 0) /* a belt drags bodies, too */
        return STATUS_DONE;
    TRY(find_part(p, scene, &part));
    if (!part || p->in.walls->as.wall->only
        || particles_count(p->particles, KIND_WALL)
                 + particles_count(p->particles, KIND_SKIN) == 0)
        return STATUS_DONE;
    if (!(o = p->face = status_alloc(1, sizeof *o)))
        return STATUS_FAILED;
    o->part = part;
    o->mirrored = part->part->as.operator->faces(part->self);
    o->acts[KIND_FLUID] = KIND_STICKY;
    o->acts[KIND_WALL] = o->acts[KIND_SKIN] = KIND_BIT(KIND_FLUID);
    for (int i = 0; i < p->walls; i++)
        o->turns |= motion_turns(&p->wall[i].motion);
    return STATUS_DONE;
}

bool plan_face_implicit(const struct plan *p)
{
    return p->face && p->face->part == p->stiff;
}
