/* beam.c -- an elastic beam in the water: Euler-Bernoulli, finite elements.
 *
 *   M w'' + D w' + K w = F,  D = alpha M + beta K + drag I         (39)-(45), (BE1)-(BE3)
 *
 * F is the transpose of the skin's motion applied to the forces on its points,
 * plus weight and prescribed loads.  M^-1 F is explicit; w' = v and
 * v' = -M^-1 (K w + D v) are stiff and implicit.  Loads along the axis bend
 * nothing: they go to the support.  Small deflections only: the tip of a beam
 * that bends by a tenth of its length really draws back by 0.6 % of it, here by 0.
 *
 * Toth (2012), section 4, with consistent M and Rayleigh D unless the scene
 * asks for (44), (45), and one monolithic ODE instead of (46), (47).
 * Checked in tests/unit/beam*.c. */
#include "base/status.h"
#include "bodies/beam-ahead.h"
#include "bodies/beam-couple.h"
#include "bodies/beam-judge.h"
#include "bodies/beam-state.h"
#include "bodies/bending-rates.h"
#include "bodies/element.h"
#include "bodies/vectors.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int beam_skin(const struct body *b, double (*x)[DIM], enum kind *kind)
{
    for (int i = 0; x && i < b->skin->points; i++)
        memcpy(x[i], b->skin->point[i].rest, sizeof x[i]);
    if (kind)
        *kind = b->skin_kind;
    return b->skin->points;
}

/* Four blocks.  Rates weigh lightly: their scale is the speed of sound, not of the
 * flow, because the errors of stiff modes that no step resolves show in rates, and
 * deflections hold the accuracy.  (With the speed of the flow, 100 elements take
 * twice the steps of 10, and the tip moves the same.)  Rotations weigh as the
 * deflection over one element, so that the step does not depend on their number. */
static int beam_rows(struct body *b, struct layout *l)
{
    static const struct {
        const char *name, *unit;
        enum layout_class what;
    } row[BEAM_ROWS] = { { "w", "m", LAYOUT_POSITION }, { "theta", "rad", LAYOUT_POSITION },
                         { "w_rate", "m/s", LAYOUT_VELOCITY },
                         { "theta_rate", "rad/s", LAYOUT_VELOCITY } };
    const double scale[BEAM_ROWS] = { b->thickness, b->thickness / b->bending->l, b->speed,
                                      b->speed / b->bending->l };

    for (int i = 0; i < BEAM_ROWS; i++) {
        char name[48];
        snprintf(name, sizeof name, "%.36s.%s", b->path, row[i].name);
        b->row[i] = layout_add(l, row[i].what, name, row[i].unit, b->bending->def.elements + 1, 1,
                               scale[i]);
        if (b->row[i] < 0)
            return STATUS_FAILED;
    }
    return STATUS_DONE;
}

static void beam_start(const struct body *b, const struct layout *l, double *y)
{
    for (int i = 0; i < b->bending->dofs; i++)
        y[beam_state_place(b, l, i, false)] = y[beam_state_place(b, l, i, true)] = 0;
}

static void beam_move(const struct body *b, struct body_work *w, const struct layout *l, double t,
                      const double *y, double (*x)[DIM], double (*u)[DIM])
{
    (void)t;
    beam_state_read(b, w, l, y);
    beam_skin_move(b->skin, w->q, w->v, x, u);
}

/* All vectors at (t, y).  Returns the force of the water along the axis. */
static double balance(const struct body *b, struct body_work *w, const struct layout *l, double t,
                      const double *y, const double (*force)[DIM])
{
    const int n = b->bending->dofs;
    double axial;

    beam_state_read(b, w, l, y);
    beam_state_loads(b, t, w->force);
    axial = beam_skin_load(b->skin, force, w->force);
    memcpy(w->given, w->force, (size_t)n * sizeof *w->given);
    bending_accelerate(b->bending, w->given);
    bending_resist(b->bending, w->bending, w->q, w->v, w->resist);
    memcpy(w->rate, w->resist, (size_t)n * sizeof *w->rate);
    bending_accelerate(b->bending, w->rate);
    for (int i = 0; i < n; i++)
        w->rate[i] = w->given[i] - w->rate[i];
    band_multiply(b->bending->mass, w->rate, w->inertia);
    return axial;
}

static void beam_load(const struct body *b, struct body_work *w, const struct layout *l, double t,
                      const double *y, const double (*force)[DIM], double *ydot,
                      struct body_load *out)
{
    const int n = b->bending->dofs;
    const double axial = balance(b, w, l, t, y, force);

    for (int i = 0; i < n; i++) {
        ydot[beam_state_place(b, l, i, false)] = 0;
        ydot[beam_state_place(b, l, i, true)] = w->given[i];
    }
    beam_state_report(b, w, t, axial, out);
    out->damping = bending_damping(b->bending, w->v);
}

static void beam_stiff(const struct body *b, struct body_work *w, const struct layout *l,
                       double t, const double *y, double *ydot)
{
    (void)t;
    beam_state_read(b, w, l, y);
    bending_resist(b->bending, w->bending, w->q, w->v, w->resist);
    bending_accelerate(b->bending, w->resist);
    for (int i = 0; i < b->bending->dofs; i++) {
        ydot[beam_state_place(b, l, i, false)] += w->v[i];
        ydot[beam_state_place(b, l, i, true)] -= w->resist[i];
    }
}

static int beam_solve(const struct body *b, struct body_work *w, const struct layout *l, double t,
                      double gamma, const double *r, double *z)
{
    const int n = b->bending->dofs;

    (void)t;
    for (int i = 0; i < n; i++) {
        w->q[i] = r[beam_state_place(b, l, i, false)];
        w->v[i] = r[beam_state_place(b, l, i, true)];
    }
    TRY(bending_solve(b->bending, w->bending, gamma, w->q, w->v));
    for (int i = 0; i < n; i++) {
        z[beam_state_place(b, l, i, false)] = w->q[i];
        z[beam_state_place(b, l, i, true)] = w->v[i];
    }
    return STATUS_DONE;
}

static double beam_event(const struct body *b, double t)
{
    return b->load_until > t ? b->load_until : HUGE_VAL;
}

/* The fastest mode sits at the end that is held least. */
static void beam_limit(const struct body *b, struct limit *out)
{
    const struct bending_def *s = &b->bending->def;

    bending_rates_limit(s, b->bending->fastest, b->bending->decay, out);
    if (s->root == s->tip)
        out->where = s->elements / 2;
    else
        out->where = s->tip > s->root ? s->elements - 1 : 0;
    snprintf(out->part, sizeof out->part, "%s", b->path);
}

static void beam_energy(const struct body *b, struct body_work *w, const struct layout *l,
                        const double *y, struct energies *to)
{
    beam_state_read(b, w, l, y);
    to->kinetic += bending_kinetic(b->bending, w->v);
    to->elastic += bending_elastic(b->bending, w->q);
    to->potential += b->rest_potential - vectors_dot(b->bending->dofs, b->weight, w->q);
}

/* Adds to p [DIM]. */
static void beam_momentum(const struct body *b, struct body_work *w, const struct layout *l,
                          const double *y, double *p)
{
    double across = 0;

    beam_state_read(b, w, l, y);
    band_multiply(b->bending->mass, w->v, w->inertia);
    for (int i = 0; i < b->bending->dofs; i += 2)
        across += w->inertia[i];
    for (int d = 0; d < DIM; d++)
        p[d] += across * b->normal[d];
}

static double beam_weight(const struct body *b)
{
    return b->mass;
}

/* What the support at the root feels: force across (positive along n, as loads are)
 * and moment (positive counter-clockwise), so that a cantilever at rest under a tip
 * force P shows P and P L. */
static void show(const struct body *b, const struct body_work *w, struct body_view *out)
{
    const struct bending *s = b->bending;
    const int middle = (s->def.elements - 1) / 2, tip = s->dofs - 2;
    double shape[4], slope[4], across = 0;

    element_shape(0.5 * s->def.elements - middle, s->l, shape, slope);
    for (int k = 0; k < 4; k++)
        across += shape[k] * w->q[2 * middle + k];
    for (int d = 0; d < DIM; d++) {
        out->tip[d] = w->q[tip] * b->normal[d];
        out->mid[d] = across * b->normal[d];
    }
    out->section = b->thickness;
    out->tip_angle = w->q[tip + 1];
    out->root_force = bending_held(s, 0) ? w->force[0] - w->inertia[0] - w->resist[0] : 0;
    out->root_moment = bending_held(s, 1) ? w->force[1] - w->inertia[1] - w->resist[1] : 0;
}

static void beam_show(const struct body *b, struct body_work *w, const struct layout *l, double t,
                      const double *y, const double (*force)[DIM], struct body_view *out)
{
    balance(b, w, l, t, y, force);
    show(b, w, out);
}

static void beam_show_predicted(const struct body *b, struct body_work *w, const struct layout *l,
                                double t, const double *y, const double (*force)[DIM],
                                struct body_view *out)
{
    beam_ahead_balance(b, w, l, t, y, force);
    show(b, w, out);
}

static const struct body_kind *beam_choose(const void *params)
{
    if (beam_def_predicted(params))
        return beam_def_far(params) ? &bodies_elastica_predicted : &bodies_beam_predicted;
    return beam_def_far(params) ? &bodies_elastica : &bodies_beam;
}

static double beam_swing(const struct body *b)
{
    return bending_swing(&b->bending->def);
}

static const struct body_implicit implicit = {
    .stiff = beam_stiff, .solve = beam_solve, .limit = beam_limit,
    .swing = beam_swing,
};

static const struct body_ahead ahead = {
    .set = beam_ahead_set, .drive = beam_ahead_drive, .yield = beam_ahead_yield,
};

static const struct body_coupled coupled = {
    .unknowns = beam_couple_unknowns, .read = beam_couple_read, .write = beam_couple_write,
    .right = beam_couple_right, .inertia = beam_couple_inertia, .drift = beam_couple_drift,
    .pull = beam_couple_pull, .join = beam_couple_join, .joined = beam_couple_joined,
    .fastest = beam_couple_fastest, .yield = beam_couple_yield, .settle = beam_couple_settle,
};

static const struct body_watch watch = {
    .foresee = beam_judge_foresee,
    .event = beam_event, .judge = beam_judge, .held = beam_judge_held,
    .surface = beam_judge_surface,
};

const struct body_kind bodies_beam = {
    .identity = {
        .name = "beam",
        .about = "elastic beam or plate strip (2D); it bends a little, or with "
                 "theory = \"elastica\" as far as it likes",
        .equation = "M w'' + D w' + K w = F, D = alpha M + beta K + drag I, EI = E b^3/12 (plane "
                    "strain: /(1 - nu^2))  (39)-(45); elastica: dE/dq for K w  (BE4)-(BE6)",
        .source = "Toth 2012, section 4; consistent mass and Rayleigh damping unless (44), (45) "
                  "are asked for; elastica: Reissner 1972",
        .group = "beam", .size = sizeof(struct beam_def), .params = beam_def_params,
        .choose = beam_choose,
    },
    .make = { .create = beam_make, .free = beam_make_free, .work = beam_make_work,
              .work_free = beam_make_work_free },
    .skin = beam_skin, .rows = beam_rows, .start = beam_start, .move = beam_move,
    .load = beam_load, .energy = beam_energy, .momentum = beam_momentum,
    .weight = beam_weight, .show = beam_show, .implicit = &implicit,
    .role = { .coupled = &coupled, .ahead = &ahead }, .watch = &watch,
};

static const struct body_ahead moved_ahead = {
    .moves = true,
    .set = beam_ahead_set, .drive = beam_ahead_drive, .yield = beam_ahead_yield,
};

const struct body_kind bodies_beam_predicted = {
    .identity = {
        .name = "beam", .about = "the same beam, moved as a pressure that looks ahead predicts it",
        .equation = "(M + tau D + tau^2 K) w'' = F - K (w + tau w') - D w'  (E4)",
        .source = "backward Euler over tau, as the pressure of (E3)",
        .group = "beam", .size = sizeof(struct beam_def), .params = beam_def_params,
    },
    .make = { .create = beam_make, .free = beam_make_free, .work = beam_make_work,
              .work_free = beam_make_work_free },
    .skin = beam_skin, .rows = beam_rows, .start = beam_start, .move = beam_move,
    .load = beam_ahead_load, .energy = beam_energy,
    .momentum = beam_momentum, .weight = beam_weight, .show = beam_show_predicted,
    .role = { .coupled = &coupled, .ahead = &moved_ahead }, .watch = &watch,
};
