/* contact.c -- solids that stop water where its full kernel begins.
 *
 * Points of walls and skins obey (D1) like the fluid, with the velocity of the solid: so their
 * density is a function of positions.  Its constant is such that it reaches that at rest when
 * all the room around that is open to water is full:
 *
 *   rho_w(0) = rho0 (1 + d_w) - lack_w - g(o_w(0)),  pi_w(d_w) = p_start/rho^2   contact-start.h
 *   r_w = rho_w + g(o_w)                                                   contact-others.h
 *   d = sum_w' A_ww' r_w'/rho0 - 1                                         contact-mean.h
 *   d+ = (d + sqrt(d^2 + eps^2))/2,  eps = 1e-3                                contact-side.h
 *   e_w = e(rho0 (1 + d+)),  pi_w = p(rho0 (1 + d+))/(rho0 (1 + d+))^2 d+/sqrt(d^2 + eps^2)
 *   q_w = sum_w' A_w'w pi_w' m_w'/m_w                                            (W6)
 *
 * and q_w stands for p_w/rho_w^2 in (P1).  q_w is the exact derivative of the energy stored,
 * sum m e, so the book closes to rounding; it is never negative, so nothing sucks.  The density
 * that solids show is rho0 (1 + d+).  A pressure that looks ahead solves for pi_w >= 0, with
 * eps = 0 (implicit/ahead.h). */
#include "walls/contact-press.h"

#include "base/lanes.h"
#include "base/threads.h"
#include "base/waiting.h"
#include "walls/contact-side.h"
#include "walls/solid-rows.h"
#include "walls/walls.h"

#include <string.h>

enum {
    CHUNK = 32, /* slices                                                 */
    WORTH = 32  /* a slice takes as long as so many particles of a light loop */
};

/* What goes through the passes over slices. */
struct pressing {
    const struct contact_press_self *c;
    struct part_press_work *w;
    const struct particles *p;
    const struct part_pressed *io;
};

static int end_of(const struct contact_mean *m, int slice)
{
    return (slice + 1) * CONTACT_ROWS < m->n ? (slice + 1) * CONTACT_ROWS : m->n;
}

/* Rows of a slice: where the same slices are asked for as before, nothing was rearranged. */
static void find_rows(const struct pressing *of, int slice)
{
    for (int i = slice * CONTACT_ROWS; i < end_of(&of->c->mean, slice); i++)
        of->w->row[i] = contact_press_row(of->c, of->p, i) - of->p->from[KIND_WALL];
}

/* r of a slice. */
static void read_slice(const struct pressing *of, int slice)
{
    const struct contact_press_self *c = of->c;
    struct part_press_work *w = of->w;

    for (int i = slice * CONTACT_ROWS; i < end_of(&c->mean, slice); i++)
        w->rho[i] = of->io->rho[w->row[i]]
                    + contact_others_fill(&c->others, i, w->around[i], &w->slope[i]);
}

/* What the one side is taken of. */
static void show_means(const struct pressing *of, const double *rho, const int *slice, int slices)
{
    for (int k = 0; k < slices; k++) {
        const int from = slice[k] * CONTACT_ROWS;
        for (int i = from; i < end_of(&of->c->mean, slice[k]); i++)
            of->io->mean[of->w->row[i]] = rho[k * CONTACT_ROWS + i - from];
    }
}

/* A few slices: what they show, and m pi/N. */
static void press_chunk(const struct pressing *of, const int *slice, int slices)
{
    const struct contact_mean *mean = &of->c->mean;
    const int n = slices * CONTACT_ROWS, *row = of->w->row;
    const double *m = of->p->m + of->p->from[KIND_WALL];
    double rho[CHUNK * CONTACT_ROWS] = { 0 }, share[CHUNK * CONTACT_ROWS];
    double press[CHUNK * CONTACT_ROWS];

    for (int k = 0; k < slices; k++) {
        contact_mean_sums(mean, slice[k], of->w->rho, rho + k * CONTACT_ROWS);
        for (int l = 0; l < CONTACT_ROWS; l++)
            rho[k * CONTACT_ROWS + l] *= mean->inverse[slice[k] * CONTACT_ROWS + l];
    }
    if (of->io->mean)
        show_means(of, rho, slice, slices);
    (of->c->sharp ? contact_side_sharp : contact_side)(of->c->eos.rho0, n, rho, share);
    eos_pressures(&of->c->eos, n, rho, press);
    for (int k = 0; k < n; k++)
        press[k] = press[k] / (rho[k] * rho[k]) * share[k];
    for (int k = 0; k < slices; k++) {
        const int from = slice[k] * CONTACT_ROWS, at = k * CONTACT_ROWS - from;
        for (int i = from; i < end_of(mean, slice[k]); i++) {
            of->io->shown[row[i]] = rho[at + i];
            of->w->pi[i] = m[row[i]] * mean->inverse[i] * press[at + i];
        }
    }
}

static void push_slice(const struct pressing *of, int slice)
{
    const int from = slice * CONTACT_ROWS, *row = of->w->row;
    const double *m = of->p->m + of->p->from[KIND_WALL];
    double sum[CONTACT_ROWS];

    contact_mean_sums(&of->c->mean, slice, of->w->pi, sum);
    for (int i = from; i < end_of(&of->c->mean, slice); i++)
        of->io->p2[row[i]] = sum[i - from] / m[row[i]];
}

/* Where no water is. */
static void rest(const struct part_pressed *io, double rho0, int i)
{
    io->shown[i] = rho0;
    if (io->p2)
        io->p2[i] = 0;
    if (io->mean)
        io->mean[i] = rho0;
}

/* Which solids must be written as they are where no water is?  Arrays of the last press() have it already
 * where that did not write, as long as nothing else writes to them. */
enum rests { RESTS_STAND, RESTS_LAST, RESTS_ALL };

static enum rests rests_of(const struct part_press_work *w, const struct part_pressed *io, bool lasts)
{
    if (!lasts || io->shown != w->rest.shown || io->p2 != w->rest.p2)
        return RESTS_ALL;
    return w->reach.made == w->rest.made ? RESTS_STAND : RESTS_LAST;
}

/* For the next press(): where this one wrote.  Other arrays may have been written to in between. */
static void keep_rests(struct part_press_work *w, const struct part_pressed *io,
                       const struct contact_slices *slices, bool lasts)
{
    if (!lasts) {
        if (io->shown == w->rest.shown || io->p2 == w->rest.p2)
            w->rest.shown = w->rest.p2 = NULL;
        return;
    }
    w->rest.shown = io->shown;
    w->rest.p2 = io->p2;
    w->rest.made = w->reach.made;
    w->rest.n = slices->n[CONTACT_PI]; /* slices of q are among them */
    memcpy(w->rest.slice, slices->slice[CONTACT_PI], (size_t)w->rest.n * sizeof *w->rest.slice);
}

static void rest_slice(const struct pressing *of, int slice)
{
    for (int i = slice * CONTACT_ROWS; i < end_of(&of->c->mean, slice); i++)
        rest(of->io, of->c->eos.rho0, of->w->row[i]);
}

/* All that is asked for.  Rows in which the last press() wrote are needed before they are found anew;
 * densities are read before all are written, as that may be the same array. */
static void press_slices(const struct pressing *of, const struct contact_slices *slices, enum rests rests)
{
    const int *n = slices->n, *const *slice = (const int *const *)slices->slice;
    const int solids = of->p->n - of->p->from[KIND_WALL];

#pragma omp for schedule(static) nowait
    for (int k = 0; k < (rests == RESTS_LAST ? of->w->rest.n : 0); k++)
        rest_slice(of, of->w->rest.slice[k]);
    if (rests == RESTS_LAST)
        threads_meet();
#pragma omp for schedule(static) nowait
    for (int k = 0; k < n[CONTACT_R]; k++) {
        if (rests != RESTS_STAND)
            find_rows(of, slice[CONTACT_R][k]);
        read_slice(of, slice[CONTACT_R][k]);
    }
    threads_meet();
#pragma omp for schedule(static) nowait
    for (int i = 0; i < (rests == RESTS_ALL ? solids : 0); i++)
        rest(of->io, of->c->eos.rho0, i);
    threads_meet();
#pragma omp for schedule(static) nowait
    for (int k = 0; k < n[CONTACT_PI]; k += CHUNK)
        press_chunk(of, slice[CONTACT_PI] + k,
                    n[CONTACT_PI] - k < CHUNK ? n[CONTACT_PI] - k : CHUNK);
    threads_meet();
#pragma omp for schedule(static) nowait
    for (int k = 0; k < (of->io->p2 ? n[CONTACT_Q] : 0); k++)
        push_slice(of, slice[CONTACT_Q][k]);
}

static void press(const void *self, struct part_press_work *w, const struct particles *p,
                  const struct part_pressed *io)
{
    const struct contact_press_self *c = self;
    const struct contact_slices *slices = contact_press_look(c, w, p, io->which);
    const struct pressing of = { c, w, p, io };

    const bool lasts = io->which == PART_SOLIDS_MET && !io->mean && io->rho != io->shown;
    const enum rests rests = rests_of(w, io, lasts);

    w->row = w->rows[!lasts];
    THREADS(waiting_repays((long)slices->n[CONTACT_R] * WORTH), press_slices(&of, slices, rests));
    if (rests != RESTS_STAND)
        keep_rests(w, io, slices, lasts);
}

static const struct part_press contact_press = {
    .create = contact_press_create,
    .free = contact_press_free,
    .start = contact_press_start,
    .work = contact_press_work,
    .work_free = contact_press_work_free,
    .choose = contact_press_choose,
    .reads = contact_press_reads,
    .press = press,
    .mean = contact_press_mean,
    .spread = contact_press_spread,
    .meet = contact_press_meet,
    .memory = contact_press_memory,
    .show = contact_press_show,
};

static const char *const with[] = { "continuity", NULL };

static const struct part_wall wall = {
    .as_fluid = true,
    .with = with,
    .press = &contact_press,
};

const struct part LANE_NAME(walls_contact) = {
    .name = "contact",
    .about = "solids that stop water at their faces, without gap or suction",
    .equation = "(W6) rho_w by (D1), d = sum_w' A_ww' rho_w'/rho0 - 1, d+ = (d + sqrt(d^2 + "
                "1e-6))/2, e_w = e(rho0 (1 + d+)), q_w = sum_w' A_w'w de_w'/drho; (P1) with q_w",
    .source = "Crespo, Gomez-Gesteira, Dalrymple, Comput. Mater. Contin. 5 (2007) 173-184, with "
              "a constant, a mean and one side of its own",
    .size = sizeof(struct contact_press_self),
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .prepare = contact_press_prepare,
    .blocks = solid_rows_add,
    .as.wall = &wall,
};
