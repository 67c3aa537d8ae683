/* mri-bodies.c -- bodies between two stages of the water, in steps of their own.
 *
 * MRIStep gives the water's rates as a polynomial of time, g(t) = sum_k s^k g_k with
 * s = (t - shift)/scale.  Entries that are no bodies' have no other rate: they move by
 * its integral.  Bodies take y' = f_I(y) + g(t) in implicit steps,
 *
 *   z_i - h a_ii (f_I(z_i) + g(t_i)) = y + h sum_(j<i) a_ij k_j,   k_i = f_I(z_i) + g(t_i),
 *
 * with error control: SDIRK of order 4(3) and 5 stages, L-stable.  Hairer, Wanner,
 * Solving Ordinary Differential Equations II, section IV.6, table 6.5.  A vibration is
 * resolved as far as tol asks for, however long the steps of the water are.
 *
 * The book takes what the motion of bodies does to it (supports hold them, damping takes
 * energy, loads give it) from these stages, with their weights, and the rest from the
 * stages of the water: then momentum is kept to rounding. */
#include "time/mri.h"

#include "base/status.h"
#include "eval/moment.h"
#include "time/arkode.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char mri_fast_table[] = "ARKODE_SDIRK_5_3_4";

static const struct control_row control = { { 0.60, -0.20, 0 }, 0.5, 1, 2.5 };

/* --- from y to the bodies' entries and back -------------------------------- */

static void pick(const struct fixed *x, const double *y, double *to)
{
    for (int k = 0; k < x->ranges; k++) {
        const long size = x->range[k][1] - x->range[k][0];
        memcpy(to, y + x->range[k][0], (size_t)size * sizeof *to);
        to += size;
    }
}

static void put(const struct fixed *x, const double *from, double *y)
{
    for (int k = 0; k < x->ranges; k++) {
        const long size = x->range[k][1] - x->range[k][0];
        memcpy(y + x->range[k][0], from, (size_t)size * sizeof *from);
        from += size;
    }
}

/* --- what the water does to them ------------------------------------------- */

struct forcing {
    double shift, scale;
    N_Vector *g;
    int n;
};

static struct forcing forcing_of(MRIStepInnerStepper inner)
{
    struct forcing f = { .n = 0 };

    MRIStepInnerStepper_GetForcingData(inner, &f.shift, &f.scale, &f.g, &f.n);
    return f;
}

static void load_at(const struct mri *m, const struct forcing *f, double t)
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
static void drift(const struct mri *m, const struct forcing *f, double t, double t_end, double *y)
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
static void add_up(const struct mri_bodies *b, const double *c, int stages, double h, double *sum)
{
    for (long j = 0; j < b->entries; j++) {
        double rate = 0;
        for (int i = 0; i < stages; i++)
            rate += c[i] * b->rate[i][j];
        sum[j] = b->y[j] + h * rate;
    }
}

/* Rate of stage i. */
static int stage(struct mri *m, const struct forcing *f, double t, double h, int i)
{
    struct mri_bodies *b = &m->bodies;
    struct fixed *x = m->frame;
    const double gamma = h * b->table.a[i][i];

    load_at(m, f, t + h * tableau_node(&b->table, i));
    add_up(b, b->table.a[i], i, h, b->sum);
    for (long j = 0; j < b->entries; j++)
        b->rate[i][j] = b->sum[j] + gamma * b->load[j];
    put(x, b->rate[i], x->try);
    put(x, b->sum, x->rates);
    TRY(moment_solve(x->moment, t, gamma, x->try, x->rates));
    pick(x, x->rates, b->rate[i]);
    for (long j = 0; j < b->entries; j++)
        b->rate[i][j] = (b->rate[i][j] - b->sum[j]) / gamma;
    return STATUS_DONE;
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

    b->longest = e <= control.accept && h < 0.99 * b->longest ? fmax(b->longest, next) : next;
}

/* With the forces of the water, which bodies at rest book as well, taken off. */
void mri_bodies_book(struct mri *m, double t, const double *y, double share, double *ydot)
{
    moment_body_book(m->frame->moment, t, y, share, ydot);
    moment_body_book(m->frame->moment, t, m->bodies.rest, -share, ydot);
}

/* With the forces of the water, which stay until t_end and are taken off there. */
static void book_step(struct mri *m, double t, double h, double *y)
{
    struct mri_bodies *b = &m->bodies;

    for (int i = 0; i < b->table.stages; i++) {
        if (b->table.b[i] == 0)
            continue;
        add_up(b, b->table.a[i], i + 1, h, b->sum);
        put(m->frame, b->sum, m->frame->rates);
        moment_body_book(m->frame->moment, t, m->frame->rates, h * b->table.b[i], y);
    }
}

/* From t on towards t_end; t moves when the step is accepted, and the book in y is kept. */
static int step(struct mri *m, const struct forcing *f, double *t, double t_end, double *y)
{
    struct mri_bodies *b = &m->bodies;
    const double left = t_end - *t, most = fmin(b->longest, m->frame->substep);
    const double parts = ceil(left / most * (1 - 1e-12)), h = left / fmax(parts, 1);
    double e;

    if (!(h > 1e-9 * m->h))
        return STATUS_FAILED;
    for (int i = 0; i < b->table.stages; i++)
        TRY(stage(m, f, *t, h, i));
    e = error_of(b, h);
    if (!isfinite(e))
        return STATUS_FAILED;
    adapt(b, h, e);
    if (!(e <= control.accept))
        return STATUS_DONE;
    book_step(m, *t, h, y);
    add_up(b, b->table.b, b->table.stages, h, b->y);
    *t = parts > 1 ? *t + h : t_end;
    return STATUS_DONE;
}

/* MRIStep of 6.4.1 leaves it to the bodies to know where a step begins. */
int mri_bodies_evolve(MRIStepInnerStepper inner, sunrealtype t, sunrealtype t_end, N_Vector y)
{
    struct mri *m = NULL;
    struct forcing f = forcing_of(inner);
    const double start = t;

    MRIStepInnerStepper_GetContent(inner, (void **)&m);
    if (t == m->frame->t_old)
        vector_copy(m->frame->n, vector_data(m->start), vector_data(y));
    pick(m->frame, vector_data(y), m->bodies.y);
    drift(m, &f, t, t_end, vector_data(y));
    while (t < t_end)
        if (step(m, &f, &t, t_end, vector_data(y)) != STATUS_DONE)
            return -1;
    moment_body_book(m->frame->moment, start, m->bodies.rest, start - t_end, vector_data(y));
    put(m->frame, m->bodies.y, vector_data(y));
    return 0;
}

/* --- memory ---------------------------------------------------------------- */

static int take_table(struct mri_bodies *b)
{
    const ARKodeButcherTable t = ARKodeButcherTable_LoadDIRKByName(mri_fast_table);

    if (!t || !t->d)
        return status_fail(STATUS_FAILED, "SUNDIALS has no table %s", mri_fast_table);
    arkode_tables_read(t, &b->table);
    ARKodeButcherTable_Free(t);
    return STATUS_DONE;
}

static int take_weights(struct mri *m, double tol)
{
    double *all = status_alloc((unsigned long)m->frame->n, sizeof *all);

    if (!all)
        return STATUS_FAILED;
    moment_weights(m->frame->moment, tol, all);
    pick(m->frame, all, m->bodies.weight);
    free(all);
    return STATUS_DONE;
}

int mri_bodies_create(struct mri *m, const struct method_def *def)
{
    struct mri_bodies *b = &m->bodies;
    double **place[] = { &b->weight, &b->y, &b->sum, &b->load };

    TRY(take_table(b));
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

void mri_bodies_restart(struct mri *m)
{
    m->bodies.longest = m->frame->substep; /* or as long as a stage of the water */
    control_start(&m->bodies.control, &control, m->bodies.table.order, m->bodies.table.embedded);
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
