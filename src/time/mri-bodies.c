/* mri-bodies.c -- bodies between two stages of the water, in steps of their own.
 *
 * MRIStep gives the water's rates as a polynomial of time, g(t) = sum_k s^k g_k with
 * s = (t - shift)/scale.  Entries that are no bodies' have no other rate: they move by
 * its integral.  Bodies take y' = f_F(y) + g(t) in steps of a Runge-Kutta pair with error
 * control: how its stages are found is the side's (mri-beams.c, mri-rigid.c).
 *
 * The book takes what the motion of bodies does to it (supports hold them, damping takes
 * energy, loads give it) from these stages, with their weights, and the rest from the
 * stages of the water: then momentum is kept to rounding. */
#include "time/mri.h"

#include "base/status.h"
#include "eval/moment.h"
#include "time/arkode.h"
#include "time/stability.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- from y to the bodies' entries and back -------------------------------- */

void mri_bodies_pick(const struct fixed *x, const double *y, double *to)
{
    for (int k = 0; k < x->ranges; k++) {
        const long size = x->range[k][1] - x->range[k][0];
        memcpy(to, y + x->range[k][0], (size_t)size * sizeof *to);
        to += size;
    }
}

void mri_bodies_put(const struct fixed *x, const double *from, double *y)
{
    for (int k = 0; k < x->ranges; k++) {
        const long size = x->range[k][1] - x->range[k][0];
        memcpy(y + x->range[k][0], from, (size_t)size * sizeof *from);
        from += size;
    }
}

/* --- what the water does to them ------------------------------------------- */

struct mri_forcing {
    double shift, scale;
    N_Vector *g;
    int n;
};

static struct mri_forcing forcing_of(MRIStepInnerStepper inner)
{
    struct mri_forcing f = { .n = 0 };

    MRIStepInnerStepper_GetForcingData(inner, &f.shift, &f.scale, &f.g, &f.n);
    return f;
}

void mri_bodies_load(const struct mri *m, const struct mri_forcing *f, double t)
{
    const struct fixed *x = m->frame;
    double *load = m->bodies.load, s = 1;

    memset(load, 0, (size_t)m->bodies.entries * sizeof *load);
    for (int k = 0; k < f->n; k++, s *= (t - f->shift) / f->scale) {
        const double *g = vector_data(f->g[k]);
        long j = 0;
        for (int r = 0; r < x->ranges; r++)
            for (long i = x->range[r][0]; i < x->range[r][1]; i++)
                load[j++] += s * g[i];
    }
}

/* All of y by the integral of g; what bodies get so is overwritten. */
static void drift(const struct mri *m, const struct mri_forcing *f, double t, double t_end, double *y)
{
    double a = (t - f->shift) / f->scale, b = (t_end - f->shift) / f->scale;
    double pa = a, pb = b;

    for (int k = 0; k < f->n; k++, pa *= a, pb *= b) {
        const double c[2] = { 1, f->scale * (pb - pa) / (k + 1) };
        vector_combine(2, c, (const double *[]){ y, vector_data(f->g[k]) }, m->frame->n, y);
    }
}

/* --- a step of theirs ------------------------------------------------------ */

/* sum = y + h sum_(j<stages) c_j k_j. */
void mri_bodies_add_up(const struct mri_bodies *b, const double *c, int stages, double h, double *sum)
{
    for (long j = 0; j < b->entries; j++) {
        double rate = 0;
        for (int i = 0; i < stages; i++)
            rate += c[i] * b->rate[i][j];
        sum[j] = b->y[j] + h * rate;
    }
}

static double error_of(const struct mri_bodies *b, double h)
{
    double most = 0;

    for (long j = 0; j < b->entries; j++) {
        double e = 0;
        for (int i = 0; i < b->table.stages; i++)
            e += (b->table.b[i] - b->table.d[i]) * b->rate[i][j];
        e = fabs(h * e * b->weight[j]);
        if (!(e <= most))
            most = e;
    }
    return most;
}

/* `longest` after a step h: one that an end cut short says little against a longer one. */
static void adapt(struct mri_bodies *b, double h, double e)
{
    const double next = control_next(&b->control, h, e);

    b->longest = e <= b->control.row->accept && h < 0.99 * b->longest ? fmax(b->longest, next) : next;
}

/* With the forces of the water, which stay until t_end and are taken off there. */
static void book_step(struct mri *m, double t, double h, double *y)
{
    struct mri_bodies *b = &m->bodies;

    for (int i = 0; i < b->table.stages; i++) {
        if (b->table.b[i] == 0)
            continue;
        mri_bodies_add_up(b, b->table.a[i], i + 1, h, b->sum);
        mri_bodies_put(m->frame, b->sum, m->frame->rates);
        moment_body_book(m->frame->moment, t, m->frame->rates, h * b->table.b[i], y);
    }
}

/* From t on towards t_end; t moves when the step is accepted, and the book in y is kept. */
static int step(struct mri *m, const struct mri_forcing *f, double *t, double t_end, double *y)
{
    struct mri_bodies *b = &m->bodies;
    const double stable = m->side->longest ? m->side->longest(m, *t) : HUGE_VAL;
    const double left = t_end - *t, most = fmin(fmin(b->longest, stable), m->frame->substep);
    const double parts = ceil(left / most * (1 - 1e-12)), h = left / fmax(parts, 1);
    double e;

    if (!(h > 1e-9 * m->h))
        return STATUS_FAILED;
    for (int i = 0; i < b->table.stages; i++)
        TRY(m->side->stage(m, f, *t, h, i));
    e = error_of(b, h);
    if (!isfinite(e))
        return STATUS_FAILED;
    adapt(b, h, e);
    if (!(e <= b->control.row->accept))
        return STATUS_DONE;
    if (m->side->implicit)
        book_step(m, *t, h, y);
    mri_bodies_add_up(b, b->table.b, b->table.stages, h, b->y);
    *t = parts > 1 ? *t + h : t_end;
    return STATUS_DONE;
}

/* MRIStep of 6.4.1 leaves it to the bodies to know where a step begins. */
int mri_bodies_evolve(MRIStepInnerStepper inner, sunrealtype t, sunrealtype t_end, N_Vector y)
{
    struct mri *m = NULL;
    struct mri_forcing f = forcing_of(inner);
    const double start = t;

    MRIStepInnerStepper_GetContent(inner, (void **)&m);
    if (t == m->frame->t_old)
        vector_copy(m->frame->n, vector_data(m->start), vector_data(y));
    mri_bodies_pick(m->frame, vector_data(y), m->bodies.y);
    drift(m, &f, t, t_end, vector_data(y));
    while (t < t_end)
        if (step(m, &f, &t, t_end, vector_data(y)) != STATUS_DONE)
            return -1;
    moment_body_book(m->frame->moment, start, m->bodies.rest, start - t_end, vector_data(y));
    mri_bodies_put(m->frame, m->bodies.y, vector_data(y));
    return 0;
}

/* --- memory ---------------------------------------------------------------- */

static int take_table(const struct mri_side *side, struct mri_bodies *b)
{
    const ARKodeButcherTable t = side->implicit ? ARKodeButcherTable_LoadDIRKByName(side->table)
                                                : ARKodeButcherTable_LoadERKByName(side->table);

    if (!t || !t->d)
        return status_fail(STATUS_FAILED, "SUNDIALS has no table %s", side->table);
    arkode_tables_read(t, &b->table);
    ARKodeButcherTable_Free(t);
    if (!side->implicit) {
        b->stable[0] = stability_wave(&b->table, STABILITY_DAMPING);
        b->stable[1] = stability_decay(&b->table);
    }
    return STATUS_DONE;
}

static int take_weights(struct mri *m, double tol)
{
    double *all = status_alloc((unsigned long)m->frame->n, sizeof *all);

    if (!all)
        return STATUS_FAILED;
    moment_weights(m->frame->moment, tol, all);
    mri_bodies_pick(m->frame, all, m->bodies.weight);
    free(all);
    return STATUS_DONE;
}

int mri_bodies_create(struct mri *m, const struct method_def *def)
{
    struct mri_bodies *b = &m->bodies;
    double **place[] = { &b->weight, &b->y, &b->sum, &b->load };

    m->frame->ranges = m->side->ranges(m->frame->moment, LAYOUT_ROWS, m->frame->range);
    TRY(take_table(m->side, b));
    for (int k = 0; k < m->frame->ranges; k++)
        b->entries += m->frame->range[k][1] - m->frame->range[k][0];
    for (size_t i = 0; i < sizeof place / sizeof place[0]; i++)
        if (!(*place[i] = status_alloc((unsigned long)b->entries, sizeof(double))))
            return STATUS_FAILED;
    b->rest = status_alloc((unsigned long)m->frame->n, sizeof(double));
    if (!b->rest)
        return STATUS_FAILED;
    for (int i = 0; i < b->table.stages; i++)
        if (!(b->rate[i] = status_alloc((unsigned long)b->entries, sizeof(double))))
            return STATUS_FAILED;
    return take_weights(m, def->tol);
}

void mri_bodies_restart(struct mri *m, const struct method_pace *pace)
{
    struct mri_bodies *b = &m->bodies;

    b->longest = pace && pace->h > 0 ? pace->h
               : m->frame->substep; /* or as long as a stage of the water */
    control_start(&b->control, m->side->control, b->table.order, b->table.embedded, pace);
}

void mri_bodies_free(struct mri *m)
{
    struct mri_bodies *b = &m->bodies;

    for (int i = 0; i < TABLEAU_STAGES; i++)
        free(b->rate[i]);
    free(b->weight);
    free(b->y);
    free(b->sum);
    free(b->load);
    free(b->rest);
}
