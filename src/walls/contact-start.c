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

int contact_start_lack(const struct part_places *at, const struct contact_cells *solids,
                       const struct contact_share *share, double *lack)
{
    const struct particles *p = at->p;
    const int n = p->n - p->from[KIND_WALL], fluid = particles_count(p, KIND_FLUID);
    struct contact_cells water;

    TRY(contact_cells_create(&water, p->scales, (const double (*)[DIM])p->x0, fluid,
                             at->kernel->support));
    for (int i = 0; i < n; i++) {
        const double full = p->scales->rho0 * share[i].open;
        struct sum s = { .at = at };
        contact_cells_visit(&water, solids->x[i], add, &s);
        lack[i] = full - s.rho < 0.2 * full ? 0 : full - s.rho;
    }
    contact_cells_free(&water);
    return STATUS_DONE;
}
