/* rhs.c -- the one right-hand side, and its implicit side. */
#include "plan/inside.h"
#include "plan/viscous.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void add_stiff(struct plan *p, double t, const double *y, double *ydot)
{
    for (int i = 0; i < p->bodies; i++)
        p->body[i].kind->stiff(p->body[i].body, &p->layout, t, y, ydot);
}

static int count_pass(struct plan *p, int status)
{
    p->counts.passes++;
    p->counts.refused += status != STATUS_DONE;
    p->counts.rebuilds = p->main.list ? p->main.list->builds : 0;
    return status;
}

static int explicit_side(struct plan *p, enum plan_which which, double t, const double *y,
                         double *ydot)
{
    p->counts.rhs_explicit += which != PLAN_DENSITY;
    return count_pass(p, plan_rates(p, &p->main, which, t, y, ydot));
}

static int implicit_side(struct plan *p, double t, const double *y, double *ydot)
{
    p->counts.rhs_implicit++;
    memset(ydot, 0, (size_t)plan_size(p) * sizeof *ydot);
    return p->viscous ? count_pass(p, viscous_rates(p, t, y, ydot)) : STATUS_DONE;
}

int plan_rhs(struct plan *p, enum plan_which which, double t, const double *y, double *ydot)
{
    if (which != PLAN_IMPLICIT)
        TRY(explicit_side(p, which, t, y, ydot));
    else
        TRY(implicit_side(p, t, y, ydot));
    if (which & PLAN_IMPLICIT)
        add_stiff(p, t, y, ydot);
    return STATUS_DONE;
}

int plan_sides(struct plan *p, double t, const double *y, double *explicit, double *implicit)
{
    if (!p->viscous) {
        TRY(plan_rhs(p, PLAN_EXPLICIT, t, y, explicit));
        return plan_rhs(p, PLAN_IMPLICIT, t, y, implicit);
    }
    p->counts.rhs_explicit++;
    p->counts.rhs_implicit++;
    TRY(count_pass(p, viscous_sides(p, t, y, explicit, implicit)));
    add_stiff(p, t, y, implicit);
    return STATUS_DONE;
}

int plan_half(struct plan *p, enum plan_which which, double t, const double *y, double later,
              double *ydot)
{
    int status;

    p->later = later;
    status = plan_rhs(p, which, t, y, ydot);
    p->later = 0;
    return status;
}

const char *plan_drifts(const struct plan *p)
{
    return p->drifter ? "an effect of this scene moves positions beside their velocities" : NULL;
}

const char *plan_halves(const struct plan *p)
{
    if (p->drifter)
        return plan_drifts(p);
    if (p->viscous)
        return "its viscosity is implicit (side = \"implicit\")";
    return p->mixed ? "an effect of this scene adds to forces and to densities in one law" : NULL;
}

const char *plan_refusal(const struct plan *p)
{
    return p->refusal;
}

long plan_size(const struct plan *p)
{
    return layout_size(&p->layout);
}

const struct layout *plan_layout(const struct plan *p)
{
    return &p->layout;
}

double plan_length(const struct plan *p)
{
    return p->scales.support;
}

const struct plan_counts *plan_counts(const struct plan *p)
{
    return &p->counts;
}

bool plan_stiff(const struct plan *p)
{
    return p->bodies > 0 || p->viscous;
}

const char *plan_viscous(const struct plan *p)
{
    return p->viscous ? p->stiff->path : NULL;
}

void plan_solve_tolerance(struct plan *p, double tol)
{
    if (p->viscous)
        p->viscous->tol = tol;
}

/* Rows of bodies are all rows whose name starts with the body's path. */
static bool of_body(const struct plan *p, const struct layout_row *r)
{
    for (int i = 0; i < p->bodies; i++) {
        const size_t n = strlen(p->body[i].path);
        if (strncmp(r->name, p->body[i].path, n) == 0 && r->name[n] == '.')
            return true;
    }
    return false;
}

static bool is_stiff(const struct plan *p, int row)
{
    return of_body(p, &p->layout.row[row])
           || (p->viscous && (row == p->row_u || row == p->book.row));
}

int plan_stiff_ranges(const struct plan *p, int most, long (*range)[2])
{
    int n = 0;

    for (int i = 0; i < p->layout.rows && n < most; i++) {
        const struct layout_row *r = &p->layout.row[i];
        if (is_stiff(p, i)) {
            range[n][0] = r->offset;
            range[n++][1] = r->offset + (long)r->n * r->components;
        }
    }
    return n;
}

int plan_solve(struct plan *p, double t, double gamma, const double *r, double *z)
{
    p->counts.solves++;
    if (p->viscous) {
        const int status = viscous_solve(p, t, gamma, r, z);
        p->counts.refused += status != STATUS_DONE;
        p->counts.rebuilds = p->main.list->builds;
        return status;
    }
    for (int i = 0; i < p->bodies; i++)
        TRY(p->body[i].kind->solve(p->body[i].body, &p->layout, t, gamma, r, z));
    return STATUS_DONE;
}

double plan_event(const struct plan *p, double t)
{
    double next = HUGE_VAL;

    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].kind->event)
            next = fmin(next, p->body[i].kind->event(p->body[i].body, t));
    for (int i = 0; i < p->walls; i++)
        next = fmin(next, walls_motion_event(&p->wall[i].motion, t));
    return next;
}

void plan_weights(const struct plan *p, double tol, double *weight)
{
    layout_weights(&p->layout, tol, weight);
}

const char *plan_entry(const struct plan *p, long i)
{
    static char text[96];
    const struct layout_row *r;
    int which = 0;

    r = layout_find(&p->layout, i, &which);
    if (r)
        snprintf(text, sizeof text, "%s, number %d", r->name, which);
    return r ? text : "nothing";
}
