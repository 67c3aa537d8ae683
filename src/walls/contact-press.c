/* contact-press.c -- the pressure of solids of walls = "contact"; equations: contact.c. */
#include "walls/contact-press.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "walls/contact-side.h"
#include "walls/contact-start.h"

#include <stdlib.h>
#include <string.h>

enum { CHUNK = 128 };

int contact_press_prepare(void *self, const struct scales *s)
{
    struct contact_press_self *c = self;

    c->eos = (struct eos){ .rho0 = s->rho0, .c0 = s->c0, .gamma = s->gamma };
    return STATUS_DONE;
}

/* --- what members work in, all in the order of the mean -------------------------------------- */

struct part_press_work {
    double *rho;     /* r                                     [kg/m^D] */
    double *pi;      /* m pi/N                                         */
    double *around;  /* o                                     [kg/m^D] */
    double *slope;   /* dg/do of the last press()                      */
    struct contact_others_work others;
};

static void work_free(struct part_press_work **work)
{
    struct part_press_work *w = *work;

    if (!w)
        return;
    free(w->rho);
    free(w->pi);
    free(w->around);
    free(w->slope);
    contact_others_work_free(&w->others);
    free(w);
    *work = NULL;
}

static int work(const void *self, struct part_press_work **out)
{
    const struct contact_press_self *c = self;
    const unsigned long n = (unsigned long)c->mean.n + 1;
    struct part_press_work *w = *out = status_alloc(1, sizeof *w);

    if (!w)
        return STATUS_FAILED;
    w->rho = status_alloc(n, sizeof *w->rho);
    w->pi = status_alloc(n, sizeof *w->pi);
    w->around = status_alloc(n, sizeof *w->around);
    w->slope = status_alloc(n, sizeof *w->slope);
    if (w->rho && w->pi && w->around && w->slope
        && contact_others_work(&c->others, &w->others) == STATUS_DONE)
        return STATUS_DONE;
    work_free(out);
    return STATUS_FAILED;
}

/* --- other solids ------------------------------------------------------------------------------ */

/* A visit of pairs of other solids. */
struct meeting {
    const struct contact_press_self *c;
    const struct particles *p;
    const struct part_press_work *w;
    const double *p2;      /* [solids] by row */
    double (*f)[DIM];
};

static int row_of(const struct contact_press_self *c, const struct particles *p, int i)
{
    return particles_row_of(p, p->from[KIND_WALL] + c->mean.solid[i]);
}

static void add_around(void *self, int i, int j, double r, const double *step)
{
    const struct meeting *m = self;
    const double w = kernel_w(m->c->kernel, r);

    (void)step;
    m->w->around[i] += m->p->m[row_of(m->c, m->p, j)] * w;
    m->w->around[j] += m->p->m[row_of(m->c, m->p, i)] * w;
}

/* o of all particles where the solids of p are: x of moments, else x0. */
static void look_around(const struct contact_press_self *c, const struct particles *p,
                        struct part_press_work *w)
{
    struct meeting m = { .c = c, .p = p, .w = w };
    const double (*x)[DIM] = (const double (*)[DIM])(p->x ? p->x : p->x0);

    memset(w->around, 0, (size_t)c->mean.n * sizeof *w->around);
    if (c->others.groups < 2)
        return;
    for (int i = 0; i < c->mean.n; i++)
        memcpy(w->others.x[i], x[row_of(c, p, i)], sizeof w->others.x[i]);
    contact_others_place(&c->others, &w->others);
    contact_others_visit(&c->others, &w->others, add_around, &m);
}

/* F_ij = -m_i m_j (q_i g'_i + q_j g'_j) gradW, on i. */
static void add_force(void *self, int i, int j, double r, const double *step)
{
    const struct meeting *m = self;
    const int first = m->p->from[KIND_WALL], a = row_of(m->c, m->p, i), b = row_of(m->c, m->p, j);
    const double q = m->p2[a - first] * m->w->slope[i] + m->p2[b - first] * m->w->slope[j];
    const double push = r > 0 ? m->p->m[a] * m->p->m[b] * q * kernel_gradient(m->c->kernel, r) / r
                              : 0;

    for (int d = 0; d < DIM; d++) {
        m->f[a - first][d] += push * step[d];
        m->f[b - first][d] -= push * step[d];
    }
}

static bool meet(const void *self, struct part_press_work *w, const struct particles *p,
                 const double *p2, double (*f)[DIM])
{
    const struct contact_press_self *c = self;
    struct meeting m = { .c = c, .p = p, .w = w, .p2 = p2, .f = f };

    if (c->others.groups < 2)
        return false;
    contact_others_visit(&c->others, &w->others, add_force, &m);
    return true;
}

/* --- places, once -------------------------------------------------------------------------------- */

static int take_start(struct contact_press_self *c, const struct part_places *at,
                      const struct contact_share *share)
{
    struct part_press_work *w;
    int status;

    TRY(work(c, &w));
    look_around(c, at->p, w);
    status = contact_start_short(at, &c->mean, &c->others, share, w->around, c->missing);
    work_free(&w);
    return status;
}

static int take_places(struct contact_press_self *c, const struct part_places *at,
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
    TRY(contact_others_create(&c->others, at, &c->mean, share));
    return take_start(c, at, share);
}

static int create(void *self, const struct part_places *at)
{
    struct contact_press_self *c = self;
    const int first = at->p->from[KIND_WALL], n = at->p->n - first;
    struct contact_share *share = status_alloc((unsigned long)n + 1, sizeof *share);
    struct contact_cells solids;
    int status;

    c->kernel = at->kernel;
    c->missing = status_alloc((unsigned long)n + 1, sizeof *c->missing);
    if (!share || !c->missing) {
        free(share);
        return STATUS_FAILED;
    }
    status = contact_cells_create(&solids, at->p->scales,
                                  (const double (*)[DIM])(at->p->x0 + first), n,
                                  at->kernel->support + 2 * at->p->scales->dx);
    if (status == STATUS_DONE)
        status = take_places(c, at, &solids, share);
    contact_cells_free(&solids);
    free(share);
    return status;
}

static void destroy(void *self)
{
    struct contact_press_self *c = self;

    contact_mean_free(&c->mean);
    contact_others_free(&c->others);
    free(c->missing);
    c->missing = NULL;
}

static double memory(const void *self)
{
    const struct contact_press_self *c = self;

    return contact_mean_memory(&c->mean) + 8.0 * c->mean.n * (c->others.groups > 1 ? 8 + DIM : 6);
}

static void start(const void *self, const struct particles *p, enum kind k, double *rho)
{
    const struct contact_press_self *c = self;
    const double *missing = c->missing + (p->from[k] - p->from[KIND_WALL]);

    for (int i = 0; i < particles_count(p, k); i++)
        rho[i] = contact_side_start(&c->eos, rho[i]) - missing[i];
}

/* --- pressure ---------------------------------------------------------------------------- */

/* Particles from..to-1 of the mean: what they show, and m pi/N. */
static void press_chunk(const struct contact_press_self *c, struct part_press_work *w,
                        const struct particles *p, double *shown, int from, int to)
{
    const int first = p->from[KIND_WALL], n = to - from;
    double rho[CHUNK] = { 0 }, share[CHUNK], press[CHUNK];

    for (int k = 0; k < n; k++)
        rho[k] = contact_mean_sum(&c->mean, from + k, w->rho) * c->mean.inverse[from + k];
    contact_side(&c->eos, n, rho, share);
    eos_pressures(&c->eos, n, rho, press);
    for (int k = 0; k < n; k++) {
        const int row = row_of(c, p, from + k);
        shown[row - first] = rho[k];
        w->pi[from + k] = p->m[row] * c->mean.inverse[from + k]
                          * (press[k] / (rho[k] * rho[k]) * share[k]);
    }
}

static void press(const void *self, struct part_press_work *w, const struct particles *p,
                  const struct part_pressed *io)
{
    const struct contact_press_self *c = self;
    const int first = p->from[KIND_WALL], n = c->mean.n;

    look_around(c, p, w);
#pragma omp parallel for schedule(static) if (n > 4096)
    for (int i = 0; i < n; i++)
        w->rho[i] = io->rho[row_of(c, p, i) - first]
                    + contact_others_fill(&c->others, i, w->around[i], &w->slope[i]);
    for (int i = 0; i < p->n - first; i++) {
        io->shown[i] = c->eos.rho0;
        io->p2[i] = 0;
    }
#pragma omp parallel for schedule(static) if (n > 4096)
    for (int i = 0; i < n; i += CHUNK)
        press_chunk(c, w, p, io->shown, i, i + CHUNK < n ? i + CHUNK : n);
#pragma omp parallel for schedule(static) if (n > 4096)
    for (int i = 0; i < n; i++) {
        const int row = row_of(c, p, i);
        io->p2[row - first] = contact_mean_sum(&c->mean, i, w->pi) / p->m[row];
    }
}

const struct part_press contact_press = {
    .create = create,
    .free = destroy,
    .start = start,
    .work = work,
    .work_free = work_free,
    .press = press,
    .meet = meet,
    .memory = memory,
};
