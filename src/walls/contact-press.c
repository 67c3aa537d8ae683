/* contact-press.c -- the pressure of solids of walls = "contact"; equations: contact.c. */
#include "walls/contact-press.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "walls/contact-reach.h"
#include "walls/contact-start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define EPS 1e-3

enum { CHUNK = 128, MANY = 1024 }; /* particles, slices */

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
    bool *touched;   /* other solids are near                          */
    int *row;        /* from the first solid                           */
    struct contact_reach reach;
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
    free(w->touched);
    free(w->row);
    contact_reach_free(&w->reach);
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
    w->touched = status_alloc(n, sizeof *w->touched);
    w->row = status_alloc(n, sizeof *w->row);
    if (w->rho && w->pi && w->around && w->slope && w->touched && w->row
        && contact_reach_create(&w->reach, &c->mean) == STATUS_DONE
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
    m->w->touched[i] = m->w->touched[j] = true;
}

/* o of all particles where the solids of p are: x of moments, else x0. */
static void look_around(const struct contact_press_self *c, const struct particles *p,
                        struct part_press_work *w)
{
    struct meeting m = { .c = c, .p = p, .w = w };
    const double (*x)[DIM] = (const double (*)[DIM])(p->x ? p->x : p->x0);

    if (c->others.groups < 2) /* around is 0 for good */
        return;
    memset(w->around, 0, (size_t)c->mean.n * sizeof *w->around);
    memset(w->touched, 0, (size_t)c->mean.n * sizeof *w->touched);
    for (int k = w->others.placed; k < c->mean.n; k++) {
        const int i = c->others.member[k];
        memcpy(w->others.x[i], x[row_of(c, p, i)], sizeof w->others.x[i]);
    }
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

static int meet(const void *self, struct part_press_work *w, const struct particles *p,
                const double *p2, double (*f)[DIM], int *row)
{
    const struct contact_press_self *c = self;
    struct meeting m = { .c = c, .p = p, .w = w, .p2 = p2, .f = f };
    int n = 0;

    if (c->others.groups < 2)
        return 0;
    for (int i = 0; i < c->mean.n; i++)
        if (w->touched[i]) {
            row[n] = row_of(c, p, i) - p->from[KIND_WALL];
            memset(f[row[n++]], 0, sizeof *f);
        }
    if (n > 0)
        contact_others_visit(&c->others, &w->others, add_force, &m);
    return n;
}

/* --- places, once -------------------------------------------------------------------------------- */

static int take_start(struct contact_press_self *c, const struct part_places *at)
{
    struct part_press_work *w;
    int status;

    TRY(work(c, &w));
    look_around(c, at->p, w);
    status = contact_start_short(at, &c->mean, &c->others, w->around, c->missing);
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
    return take_start(c, at);
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

    return contact_mean_memory(&c->mean) + contact_reach_memory(&c->mean) + 5.0 * c->mean.n
           + 8.0 * c->mean.n * (c->others.groups > 1 ? 8 + DIM : 6);
}

static void start(const void *self, const struct particles *p, enum kind k, double *rho)
{
    const struct contact_press_self *c = self;
    const double *missing = c->missing + (p->from[k] - p->from[KIND_WALL]);

    for (int i = 0; i < particles_count(p, k); i++)
        rho[i] -= missing[i];
}

/* --- pressure ---------------------------------------------------------------------------- */

/* A chunk of means of densities [kg/m^D] becomes the densities shown, and share = dd+/dd. */
static void one_side(const struct contact_press_self *c, int n, double *mean, double *share)
{
    for (int k = 0; k < n; k++) {
        const double d = mean[k] / c->eos.rho0 - 1, root = sqrt(d * d + EPS * EPS);
        const double over = d > 0 ? (d + root) / 2 : EPS * EPS / (2 * (root - d)); /* all digits */
        mean[k] = c->eos.rho0 * (1 + over);
        share[k] = over / root;
    }
}

/* Rows of slices, and r there. */
static void read_slice(const struct contact_press_self *c, struct part_press_work *w,
                       const struct particles *p, const double *rho, int slice)
{
    const int from = slice * CONTACT_ROWS, to = from + CONTACT_ROWS;

    for (int i = from; i < to && i < c->mean.n; i++) {
        w->row[i] = row_of(c, p, i) - p->from[KIND_WALL];
        w->rho[i] = rho[w->row[i]]
                    + contact_others_fill(&c->others, i, w->around[i], &w->slope[i]);
    }
}

/* A few slices: what they show, and m pi/N; m of the first solid. */
static void press_chunk(const struct contact_press_self *c, struct part_press_work *w,
                        const double *m, double *shown, const int *slice, int slices)
{
    const double *inverse = c->mean.inverse;
    double rho[CHUNK] = { 0 }, share[CHUNK], press[CHUNK];

    for (int k = 0; k < slices; k++) {
        contact_mean_sums(&c->mean, slice[k], w->rho, rho + k * CONTACT_ROWS);
        for (int l = 0; l < CONTACT_ROWS; l++)
            rho[k * CONTACT_ROWS + l] *= inverse[slice[k] * CONTACT_ROWS + l];
    }
    one_side(c, slices * CONTACT_ROWS, rho, share);
    eos_pressures(&c->eos, slices * CONTACT_ROWS, rho, press);
    for (int k = 0; k < slices * CONTACT_ROWS; k++) {
        const int i = slice[k / CONTACT_ROWS] * CONTACT_ROWS + k % CONTACT_ROWS;
        if (i >= c->mean.n)
            break;
        shown[w->row[i]] = rho[k];
        w->pi[i] = m[w->row[i]] * inverse[i] * (press[k] / (rho[k] * rho[k]) * share[k]);
    }
}

static void push_slice(const struct contact_press_self *c, const struct part_press_work *w,
                       const double *m, double *p2, int slice)
{
    const int from = slice * CONTACT_ROWS, to = from + CONTACT_ROWS;
    double sum[CONTACT_ROWS];

    contact_mean_sums(&c->mean, slice, w->pi, sum);
    for (int i = from; i < to && i < c->mean.n; i++)
        p2[w->row[i]] = sum[i - from] / m[w->row[i]];
}

static void press_slices(const struct contact_press_self *c, struct part_press_work *w,
                         const struct particles *p, const struct part_pressed *io,
                         const struct contact_slices *of)
{
    const double *m = p->m + p->from[KIND_WALL];
    const int *const *slice = (const int *const *)of->slice, *n = of->n;
    const int solids = p->n - p->from[KIND_WALL];

#pragma omp parallel for schedule(static) if (n[CONTACT_R] > MANY)
    for (int k = 0; k < n[CONTACT_R]; k++)
        read_slice(c, w, p, io->rho, slice[CONTACT_R][k]);
    for (int i = 0; i < solids; i++) {
        io->shown[i] = c->eos.rho0;
        io->p2[i] = 0;
    }
#pragma omp parallel for schedule(static) if (n[CONTACT_PI] > MANY)
    for (int k = 0; k < n[CONTACT_PI]; k += CHUNK / CONTACT_ROWS) {
        const int left = n[CONTACT_PI] - k, most = CHUNK / CONTACT_ROWS;
        press_chunk(c, w, m, io->shown, slice[CONTACT_PI] + k, left < most ? left : most);
    }
#pragma omp parallel for schedule(static) if (n[CONTACT_Q] > MANY)
    for (int k = 0; k < n[CONTACT_Q]; k++)
        push_slice(c, w, m, io->p2, slice[CONTACT_Q][k]);
}

static void press(const void *self, struct part_press_work *w, const struct particles *p,
                  const struct part_pressed *io)
{
    const struct contact_press_self *c = self;

    look_around(c, p, w);
    if (!io->all && c->others.groups > 1)
        contact_reach_widen(&w->reach, w->touched);
    press_slices(c, w, p, io, io->all ? &w->reach.all : &w->reach.near);
}

static void narrow(const void *self, struct part_press_work *w, const bool *met)
{
    (void)self;
    contact_reach_narrow(&w->reach, met);
}

const struct part_press contact_press = {
    .create = create,
    .free = destroy,
    .start = start,
    .work = work,
    .work_free = work_free,
    .narrow = narrow,
    .press = press,
    .meet = meet,
    .memory = memory,
};
