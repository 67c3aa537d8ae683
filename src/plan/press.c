/* press.c -- what a wall model that looks at the places of solids is told of them. */
#include "plan/inside.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

/* Walls that stand still are one group, and so are those that move alike; every skin is a
 * group of its own. */
static int group_of(const struct plan *p, int wall)
{
    if (!p->wall[wall].moves)
        return 0;
    for (int i = 0; i < wall; i++)
        if (motion_same(&p->wall[i].motion, &p->wall[wall].motion))
            return 1 + i;
    return 1 + wall;
}

static void describe(const struct plan *p, struct part_solid *solid)
{
    for (int o = 0; o < p->particles->objects; o++)
        solid[o].group = -1;
    for (int i = 0; i < p->walls; i++)
        solid[p->wall[i].object] = (struct part_solid){ .shape = &p->in.wall[i].set.shape,
                                                        .group = group_of(p, i) };
    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].object >= 0)
            solid[p->body[i].object].group = 1 + p->walls + i;
}

static struct plan_part *find(struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.wall && p->part[i].part->as.wall->press)
            return &p->part[i];
    return NULL;
}

int plan_press_make(struct plan *p, bool together)
{
    struct plan_part *wall = find(p);
    struct part_solid *solid;
    int status;

    if (!wall || !p->pressure /* nothing presses */
        || particles_count(p->particles, KIND_FLUID) == p->particles->n)
        return STATUS_DONE;
    if (!(solid = status_alloc((unsigned long)p->particles->objects + 1, sizeof *solid)))
        return STATUS_FAILED;
    describe(p, solid);
    status = wall->part->as.wall->press->create(wall->self, &(struct part_places){
        .p = p->particles, .kernel = p->kernel[PART_DENSITY], .solid = solid,
        .sharp = plan_ahead(p) > 0, .together = together });
    free(solid);
    p->passes.press = wall;
    return status;
}

void plan_press_free(struct plan *p)
{
    if (p->passes.press)
        p->passes.press->part->as.wall->press->free(p->passes.press->self);
}
