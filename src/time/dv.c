/* dv.c -- staggered Verlet with error control: its memory, and what it says of itself. */
#include "time/dv.h"

#include "base/status.h"
#include "time/fixed.h"
#include <stdlib.h>

/* half; what bodies need besides; rates. */
enum { OURS = 1, OF_BODIES = 3, OF_RATES = 2 * DV_POINTS };

static bool has_densities(const struct layout *l)
{
    for (int i = 0; i < l->rows; i++)
        if (l->row[i].what == LAYOUT_OTHER && l->row[i].scale > 0)
            return true;
    return false;
}

static int take_memory(struct paced *frame)
{
    struct dv *x = (struct dv *)frame;
    const struct layout *l = moment_layout(frame->moment);
    double **place[] = { &x->half, &x->load, &x->load_old, &x->right };

    for (int c = 0; c <= LAYOUT_CLASSES; c++)
        x->from[c] = l->from[c];
    x->flows = has_densities(l);
    x->ranges = moment_stiff_ranges(frame->moment, LAYOUT_ROWS, x->range);
    for (int i = 0; i < OURS + (x->ranges > 0 ? OF_BODIES : 0); i++)
        TRY(paced_numbers(frame, place[i]));
    for (int k = 0; k < DV_POINTS; k++) {
        TRY(paced_numbers(frame, &x->a.f[k]));
        TRY(paced_numbers(frame, &x->d.f[k]));
    }
    return STATUS_DONE;
}

static void free_memory(struct paced *frame)
{
    struct dv *x = (struct dv *)frame;
    double *const place[] = { x->half, x->load, x->load_old, x->right };

    for (int i = 0; i < OURS + OF_BODIES; i++)
        free(place[i]);
    for (int k = 0; k < DV_POINTS; k++) {
        free(x->a.f[k]);
        free(x->d.f[k]);
    }
}

static int vectors(const struct method *m, const struct plan *plan)
{
    (void)m;
    return PACED_VECTORS + OURS + (plan_stiff(plan) ? OF_BODIES : 0) + OF_RATES;
}

/* Of memory, of a solve, or the plan's. */
static const char *refusal(const struct paced *x)
{
    const char *said = status_message();

    return said[0] ? said : moment_refusal(x->moment);
}

static const char *serves(const struct plan *plan)
{
    const char *why = fixed_serves(plan);

    return why ? why : plan_halves(plan);
}

static const char *table(const void *self)
{
    (void)self;
    return "dv";
}

/* Low gain, as Runge-Kutta pairs have it at their stability limit; at an error of
 * 10 tol it would ask for 0.81 of the step. */
const struct paced_kind dv_kind = {
    .method = { .name = "dv",
                .told = { "staggered Verlet, velocities and densities in turn, order 2 (1 in the "
                         "dissipative terms), with error control, bodies implicit",
                          "Verlet, Phys. Rev. 159 (1967) 98-103" },
                .order = 2, .serves = serves, .table = table, .room = { vectors }, PACED_METHOD },
    .size = sizeof(struct dv),
    .control = { { 0.28, -0.23, 0 }, 1, 10, 1.3 },
    .take_memory = take_memory,
    .free_memory = free_memory,
    .begin = dv_begin,
    .advance = dv_advance,
    .error = dv_error,
    .refusal = refusal,
    .remember = dv_remember,
    .bound = dv_bound,
    .haste = dv_haste,
    .inside = dv_inside,
};
