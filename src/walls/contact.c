/* contact.c -- solids that stop water where its full kernel begins.
 *
 * Points of walls and skins obey (D1) like the fluid, with the velocity of the solid: so their
 * density is a function of positions.  Its constant is such that it reaches that at rest when
 * all the room around that is open to water is full:
 *
 *   rho_w(0) = rho(p_start) - lack_w                                       contact-start.h
 *   d = sum_w' A_ww' rho_w'/rho0 - 1                                       contact-mean.h
 *   d+ = (d + sqrt(d^2 + eps^2))/2,  eps = 1e-3
 *   e_w = e(rho0 (1 + d+)),  pi_w = p(rho0 (1 + d+))/(rho0 (1 + d+))^2 d+/sqrt(d^2 + eps^2)
 *   q_w = sum_w' A_w'w pi_w' m_w'/m_w                                            (W6)
 *
 * and q_w stands for p_w/rho_w^2 in (P1).  q_w is the exact derivative of the energy stored,
 * sum m e, so the book closes to rounding; it is never negative, so nothing sucks.  The density
 * that solids show is rho0 (1 + d+). */
#include "base/lanes.h"
#include "base/status.h"
#include "kernels/kernel.h"
#include "matter/eos.h"
#include "walls/contact-mean.h"
#include "walls/contact-start.h"
#include "walls/solid-rows.h"
#include "walls/walls.h"

#include <math.h>
#include <stdlib.h>

#define EPS 1e-3

struct contact {
    struct eos eos;
    struct contact_mean mean;
    double *lack; /* [solids] kg/m^D */
};

static const char *const with[] = { "continuity", NULL };

static int prepare(void *self, const struct scales *s)
{
    struct contact *c = self;

    c->eos = (struct eos){ .rho0 = s->rho0, .c0 = s->c0, .gamma = s->gamma };
    return 0;
}

/* --- places, once ---------------------------------------------------------------------- */

static int look_around(struct contact *c, const struct part_places *at,
                       const struct contact_cells *solids, struct contact_share *share)
{
    const int n = at->p->n - at->p->from[KIND_WALL];
    struct contact_room room;

    TRY(contact_room_create(&room, at, solids));
#pragma omp parallel for schedule(dynamic, 64) if (n > 64)
    for (int i = 0; i < n; i++)
        share[i] = contact_room_share(&room, i);
    contact_room_free(&room);
    TRY(contact_mean_create(&c->mean, at, solids, share));
    return contact_start_lack(at, solids, share, c->lack);
}

static int create(void *self, const struct part_places *at)
{
    struct contact *c = self;
    const int first = at->p->from[KIND_WALL], n = at->p->n - first;
    struct contact_share *share = status_alloc((unsigned long)n + 1, sizeof *share);
    struct contact_cells solids;
    int status;

    c->lack = status_alloc((unsigned long)n + 1, sizeof *c->lack);
    if (!share || !c->lack) {
        free(share);
        return STATUS_FAILED;
    }
    status = contact_cells_create(&solids, at->p->scales, (const double (*)[DIM])(at->p->x0 + first),
                                  n, at->kernel->support + 2 * at->p->scales->dx);
    if (status == STATUS_DONE)
        status = look_around(c, at, &solids, share);
    contact_cells_free(&solids);
    free(share);
    return status;
}

static void destroy(void *self)
{
    struct contact *c = self;

    contact_mean_free(&c->mean);
    free(c->lack);
    c->lack = NULL;
}

static double memory(const void *self)
{
    const struct contact *c = self;

    return contact_mean_memory(&c->mean);
}

static void start(const void *self, const struct particles *p, enum kind k, double *rho)
{
    const struct contact *c = self;
    const double *lack = c->lack + (p->from[k] - p->from[KIND_WALL]);

    for (int i = 0; i < particles_count(p, k); i++)
        rho[i] -= lack[i];
}

/* --- pressure ---------------------------------------------------------------------------- */

/* From the mean of densities [kg/m^D] what is shown; returns pi. */
static double one_sided(const struct contact *c, double mean, double *shown)
{
    const double d = mean / c->eos.rho0 - 1, root = sqrt(d * d + EPS * EPS);
    const double over = d > 0 ? (d + root) / 2 : EPS * EPS / (2 * (root - d)); /* all digits */
    const double rho = c->eos.rho0 * (1 + over);
    double p;

    eos_pressures(&c->eos, 1, &rho, &p);
    *shown = rho;
    return p / (rho * rho) * over / root;
}

/* Numbers of the mean come in its own order: rho and m pi/N. */
static void press(const void *self, const struct particles *p, const struct part_pressed *io)
{
    const struct contact *c = self;
    const struct contact_mean *mean = &c->mean;
    const int first = p->from[KIND_WALL];
    double *rho = io->scratch, *pi = rho + mean->n;

#pragma omp parallel for schedule(static) if (mean->n > 4096)
    for (int i = 0; i < mean->n; i++)
        rho[i] = io->rho[particles_row_of(p, first + mean->solid[i]) - first];
    for (int i = 0; i < p->n - first; i++) {
        io->shown[i] = c->eos.rho0;
        io->p2[i] = 0;
    }
#pragma omp parallel for schedule(static) if (mean->n > 4096)
    for (int i = 0; i < mean->n; i++) {
        const int row = particles_row_of(p, first + mean->solid[i]);
        const double inverse = mean->inverse[i];
        pi[i] = p->m[row] * inverse
                * one_sided(c, contact_mean_sum(mean, i, rho) * inverse, &io->shown[row - first]);
    }
#pragma omp parallel for schedule(static) if (mean->n > 4096)
    for (int i = 0; i < mean->n; i++) {
        const int row = particles_row_of(p, first + mean->solid[i]);
        io->p2[row - first] = contact_mean_sum(mean, i, pi) / p->m[row];
    }
}

static const struct part_press pressed = {
    .create = create,
    .free = destroy,
    .start = start,
    .press = press,
    .memory = memory,
};

static const struct part_wall wall = {
    .as_fluid = true,
    .with = with,
    .press = &pressed,
};

const struct part LANE_NAME(walls_contact) = {
    .name = "contact",
    .about = "solids that stop water at their faces, without gap or suction",
    .equation = "(W6) rho_w by (D1), d = sum_w' A_ww' rho_w'/rho0 - 1, d+ = (d + sqrt(d^2 + "
                "1e-6))/2, e_w = e(rho0 (1 + d+)), q_w = sum_w' A_w'w de_w'/drho; (P1) with q_w",
    .source = "Crespo, Gomez-Gesteira, Dalrymple, Comput. Mater. Contin. 5 (2007) 173-184, with "
              "a constant, a mean and one side of its own",
    .size = sizeof(struct contact),
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .prepare = prepare,
    .blocks = solid_rows_add,
    .as.wall = &wall,
};
