/* contact-start.c -- what water lacks around solids at t = 0. */
#include "walls/contact-start.h"

#include "base/status.h"
#include "kernels/kernel.h"

struct sum {
    const struct part_places *at;
    double rho; /* [kg/m^D] */
};

static void add(void *self, int j, double r, const double *step)
{
    struct sum *s = self;

    (void)step;
    s->rho += s->at->p->m[j] * kernel_w(s->at->kernel, r);
}

/* Water on both sides of one layer, which feels their sum; once for each object. */
static void doubt(const struct particles *p, int id, int *last)
{
    const struct object *o = &p->object[p->object_of[id]];
    const bool skin = o->kind == KIND_SKIN || o->kind == KIND_SKIN_SLIP;

    if (p->object_of[id] == *last)
        return;
    *last = p->object_of[id];
    status_warn("%s.%s is one layer of particles with water on both sides at t = 0, near (%g, %g) "
                "m: walls = \"contact\" holds them apart there as long as their pressures are "
                "alike; %s", skin ? "beam" : "wall", o->name, p->x0[id][0], p->x0[id][1],
                skin ? "set layers = 2 or more" : "make it two spacings thick");
}

int contact_start_short(const struct part_places *at, const struct contact_mean *mean,
                        const struct contact_others *others, const struct contact_share *share,
                        const double *around, double *to)
{
    const struct particles *p = at->p;
    const int first = p->from[KIND_WALL], fluid = particles_count(p, KIND_FLUID);
    struct contact_cells water;
    int doubted = -1;

    TRY(contact_cells_create(&water, p->scales, (const double (*)[DIM])p->x0, fluid,
                             at->kernel->support));
    for (int k = 0; k < mean->n; k++) {
        const int i = mean->by_solid[k];
        const double full = others->room[i];
        struct sum s = { .at = at };
        double slope;
        const double filled = contact_others_fill(others, i, around[i], &slope);
        contact_cells_visit(&water, p->x0[first + mean->solid[i]], add, &s);
        const double lack = full - s.rho - filled;
        if (share[mean->solid[i]].alone && s.rho > 1.3 * full)
            doubt(p, first + mean->solid[i], &doubted);
        to[mean->solid[i]] = filled + (lack < 0.2 * full ? 0 : lack);
    }
    contact_cells_free(&water);
    return STATUS_DONE;
}
