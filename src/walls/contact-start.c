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

int contact_start_short(const struct part_places *at, const struct contact_mean *mean,
                        const struct contact_others *others, const double *around, double *to)
{
    const struct particles *p = at->p;
    const int first = p->from[KIND_WALL], fluid = particles_count(p, KIND_FLUID);
    struct contact_cells water;

    TRY(contact_cells_create(&water, p->scales, (const double (*)[DIM])p->x0, fluid,
                             at->kernel->support));
    for (int i = 0; i < mean->n; i++) {
        const double full = others->room[i];
        struct sum s = { .at = at };
        double slope;
        const double filled = contact_others_fill(others, i, around[i], &slope);
        contact_cells_visit(&water, p->x0[first + mean->solid[i]], add, &s);
        const double lack = full - s.rho - filled;
        to[mean->solid[i]] = filled + (lack < 0.2 * full ? 0 : lack);
    }
    contact_cells_free(&water);
    return STATUS_DONE;
}
