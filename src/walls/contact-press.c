/* contact-press.c -- the pressure of solids of walls = "contact"; equations: contact.c. */
#include "walls/contact-press.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "walls/contact-side.h"
#include "walls/contact-start.h"
#include "walls/contact-together.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int contact_press_prepare(void *self, const struct scales *s)
{
    struct contact_press_self *c = self;

    c->eos = (struct eos){ .rho0 = s->rho0, .c0 = s->c0, .gamma = s->gamma };
    return STATUS_DONE;
}

/* --- what members work in -------------------------------------------------------------------- */

void contact_press_work_free(struct part_press_work **work)
{
    struct part_press_work *w = *work;

    if (!w)
        return;
    free(w->rho);
    free(w->pi);
    free(w->around);
    free(w->slope);
    free(w->touched);
    free(w->rows[0]);
    free(w->rows[1]);
    free(w->rest.slice);
    contact_reach_free(&w->reach);
    contact_others_work_free(&w->others);
    free(w);
    *work = NULL;
}

int contact_press_work(const void *self, struct part_press_work **out)
{
    const struct contact_press_self *c = self;
    const unsigned long n = (unsigned long)c->mean.slices * CONTACT_ROWS + 1;
    struct part_press_work *w = *out = status_alloc(1, sizeof *w);

    if (!w)
        return STATUS_FAILED;
    w->rho = status_alloc(n, sizeof *w->rho);
    w->pi = status_alloc(n, sizeof *w->pi);
    w->around = status_alloc(n, sizeof *w->around);
    w->slope = status_alloc(n, sizeof *w->slope);
    w->touched = status_alloc(n, sizeof *w->touched);
    w->rows[0] = status_alloc(n, sizeof *w->row);
    w->rows[1] = status_alloc(n, sizeof *w->row);
    w->rest.slice = status_alloc(n / CONTACT_ROWS + 1, sizeof *w->rest.slice);
    if (w->rest.slice && w->rho && w->pi && w->around && w->slope && w->touched && w->rows[0] && w->rows[1]
        && contact_reach_create(&w->reach, &c->mean) == STATUS_DONE
        && contact_others_work(&c->others, &w->others) == STATUS_DONE)
        return STATUS_DONE;
    contact_press_work_free(out);
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

static void add_around(void *self, int i, int j, double r, const double *step)
{
    const struct meeting *m = self;
    const double w = kernel_w(m->c->kernel, r);

    (void)step;
    m->w->around[i] += m->p->m[contact_press_row(m->c, m->p, j)] * w;
    m->w->around[j] += m->p->m[contact_press_row(m->c, m->p, i)] * w;
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
        memcpy(w->others.x[i], x[contact_press_row(c, p, i)], sizeof w->others.x[i]);
    }
    contact_others_place(&c->others, &w->others);
    contact_others_visit(&c->others, &w->others, add_around, &m);
}

/* F_ij = -m_i m_j (q_i g'_i + q_j g'_j) gradW, on i. */
static void add_force(void *self, int i, int j, double r, const double *step)
{
    const struct meeting *m = self;
    const int first = m->p->from[KIND_WALL];
    const int a = contact_press_row(m->c, m->p, i), b = contact_press_row(m->c, m->p, j);
    const double q = m->p2[a - first] * m->w->slope[i] + m->p2[b - first] * m->w->slope[j];
    const double push = r > 0 ? m->p->m[a] * m->p->m[b] * q * kernel_gradient(m->c->kernel, r) / r
                              : 0;

    for (int d = 0; d < DIM; d++) {
        m->f[a - first][d] += push * step[d];
        m->f[b - first][d] -= push * step[d];
    }
}

int contact_press_meet(const void *self, struct part_press_work *w, const struct particles *p,
                const double *p2, double (*f)[DIM], int *row)
{
    const struct contact_press_self *c = self;
    struct meeting m = { .c = c, .p = p, .w = w, .p2 = p2, .f = f };
    int n = 0;

    if (c->others.groups < 2)
        return 0;
    for (int i = 0; i < c->mean.n; i++)
        if (w->touched[i]) {
            row[n] = contact_press_row(c, p, i) - p->from[KIND_WALL];
            memset(f[row[n++]], 0, sizeof *f);
        }
    if (n > 0)
        contact_others_visit(&c->others, &w->others, add_force, &m);
    return n;
}

/* --- places, once -------------------------------------------------------------------------------- */

static int take_start(struct contact_press_self *c, const struct part_places *at,
                      const struct contact_share *share)
{
    struct part_press_work *w;
    int status;

    TRY(contact_press_work(c, &w));
    look_around(c, at->p, w);
    status = contact_start_short(at, &c->mean, &c->others, share, w->around, c->missing);
    contact_press_work_free(&w);
    return status;
}

static int take_kinds(struct contact_press_self *c, const struct particles *p)
{
    c->kind = status_alloc((unsigned long)c->mean.n + 1, sizeof *c->kind);
    for (int i = 0; c->kind && i < c->mean.n; i++)
        c->kind[i] = p->object[p->object_of[p->from[KIND_WALL] + c->mean.solid[i]]].kind;
    return c->kind ? STATUS_DONE : STATUS_FAILED;
}

/* share [solids] */
static int take_shares(const struct part_places *at, const struct contact_cells *solids, struct contact_share *share)
{
    const int n = at->p->n - at->p->from[KIND_WALL];
    const struct contact_part part = contact_together_part(at, n);
    struct contact_room room;
    int status = contact_room_create(&room, at, solids);

    if (status == STATUS_DONE) {
#pragma omp parallel for schedule(dynamic, 64) if (n > 64)
        for (int i = part.from; i < part.to; i++)
            share[i] = contact_room_share(&room, i);
        contact_room_free(&room);
    }
    TRY(contact_together_agree(at, status));
    TRY(contact_together_compare(at, n));
    contact_together_hear(at, n, sizeof *share, share);
    return STATUS_DONE;
}

static int take_places(struct contact_press_self *c, const struct part_places *at,
                       const struct contact_cells *solids, struct contact_share *share)
{
    TRY(take_shares(at, solids, share));
    TRY(contact_mean_create(&c->mean, at, solids, share));
    TRY(contact_others_create(&c->others, at, &c->mean, share));
    TRY(take_kinds(c, at->p));
    return take_start(c, at, share);
}

int contact_press_create(void *self, const struct part_places *at)
{
    struct contact_press_self *c = self;
    const int first = at->p->from[KIND_WALL], n = at->p->n - first;
    struct contact_share *share = status_alloc((unsigned long)n + 1, sizeof *share);
    struct contact_cells solids;
    int status;

    c->kernel = at->kernel;
    c->sharp = at->sharp;
    c->solids = n;
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

void contact_press_free(void *self)
{
    struct contact_press_self *c = self;

    contact_mean_free(&c->mean);
    contact_others_free(&c->others);
    free(c->missing);
    free(c->kind);
    c->missing = NULL;
    c->kind = NULL;
}

double contact_press_memory(const void *self)
{
    const struct contact_press_self *c = self;

    return contact_mean_memory(&c->mean) + contact_reach_memory(&c->mean) + (10 + 4.0 / CONTACT_ROWS) * c->mean.n
           + 8.0 * c->mean.n * (c->others.groups > 1 ? 9 + DIM : 6);
}

void contact_press_show(const void *self, part_see *see, void *whose)
{
    const struct contact_press_self *c = self;

    contact_mean_show(&c->mean, see, whose);
    see(whose, c->missing, (size_t)c->solids * sizeof *c->missing);
    see(whose, c->others.room, (size_t)c->mean.n * sizeof *c->others.room);
    see(whose, c->others.member, (size_t)c->mean.n * sizeof *c->others.member);
}

void contact_press_start(const void *self, const struct particles *p, enum kind k, double *rho)
{
    const struct contact_press_self *c = self;
    const double *missing = c->missing + (p->from[k] - p->from[KIND_WALL]);

    for (int i = 0; i < particles_count(p, k); i++)
        rho[i] = (c->sharp ? fmax(rho[i], c->eos.rho0) : contact_side_start(&c->eos, rho[i]))
                 - missing[i];
}

/* --- pressure ---------------------------------------------------------------------------- */

const struct contact_slices *contact_press_look(const struct contact_press_self *c,
                                                struct part_press_work *w,
                                                const struct particles *p, enum part_solids which)
{
    look_around(c, p, w);
    w->last = contact_reach_of(&w->reach, which);
    if (which == PART_SOLIDS_MET && c->others.groups > 1)
        contact_reach_widen(&w->reach, w->touched);
    return w->last;
}

void contact_press_choose(const void *self, struct part_press_work *w, enum part_solids which,
                          const bool *solid)
{
    (void)self;
    contact_reach_choose(&w->reach, which, solid);
}

bool contact_press_reads(const void *self, const struct part_press_work *w, bool *read)
{
    const struct contact_press_self *c = self;
    const struct contact_slices *near = contact_reach_of(&w->reach, PART_SOLIDS_MET);

    for (int k = 0; k < near->n[CONTACT_R]; k++)
        for (int i = near->slice[CONTACT_R][k] * CONTACT_ROWS;
             i < (near->slice[CONTACT_R][k] + 1) * CONTACT_ROWS && i < c->mean.n; i++)
            read[c->mean.solid[i]] = true;
    return c->others.groups < 2;
}
