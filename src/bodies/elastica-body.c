/* elastica-body.c -- an elastic beam in the water that bends far: a cubic centre line,
 * exact strains.
 *
 *   M q'' + D q' + dE/dq = F,   E as in (BE4)                          (BE4)-(BE6)
 *
 * The linear beam of beam.c without its limit on deflections, and with an axial stiffness:
 * M, EI, mass options, ends and damping by mass and drag are the same, damping by beta and
 * damping_ratio turns with the beam (BE7), and small deflections agree.  F is the transpose of the skin's motion applied to the forces on its
 * points, plus weight and prescribed loads.  M^-1 F is explicit; q' = v and
 * v' = -M^-1 (dE/dq + D v) are stiff and implicit.
 * Checked in tests/unit/elastica*.c. */
#include "base/status.h"
#include "bodies/bending-rates.h"
#include "bodies/elastica-ahead.h"
#include "bodies/elastica-state.h"
#include "bodies/vectors.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int elastica_skin(const struct body *b, double (*x)[DIM], enum kind *kind)
{
    if (x)
        follower_skin_move(b->skin, b->start, b->start_rate, x, NULL);
    if (kind)
        *kind = b->skin_kind;
    return b->skin->points;
}

/* Eight blocks; scales are those of beam.c, where the reasons are, for both components. */
static int elastica_rows(struct body *b, struct layout *l)
{
    static const char *const name[ELASTICA_NODE] = { "u", "w", "u_slope", "w_slope" };
    const struct elastica *e = b->beam;

    for (int i = 0; i < 2 * ELASTICA_NODE; i++) {
        const bool rate = i >= ELASTICA_NODE, slope = i % ELASTICA_NODE >= 2;
        const double scale = rate ? e->def.speed : e->def.thickness;
        char text[48];
        snprintf(text, sizeof text, "%.30s.%s%s", b->path, name[i % ELASTICA_NODE],
                 rate ? "_rate" : "");
        b->row[i] = layout_add(l, rate ? LAYOUT_VELOCITY : LAYOUT_POSITION, text,
                               slope ? (rate ? "1/s" : "1") : (rate ? "m/s" : "m"),
                               e->def.bending.elements + 1, 1, slope ? scale / e->l : scale);
        if (b->row[i] < 0)
            return STATUS_FAILED;
    }
    return STATUS_DONE;
}

static void elastica_start(const struct body *b, const struct layout *l, double *y)
{
    for (int i = 0; i < b->beam->dofs; i++) {
        y[elastica_state_place(b, l, i, false)] = b->start[i];
        y[elastica_state_place(b, l, i, true)] = b->start_rate[i];
    }
}

static void elastica_move(const struct body *b, struct body_work *w, const struct layout *l,
                          double t, const double *y, double (*x)[DIM], double (*u)[DIM])
{
    (void)t;
    elastica_state_read(b, w, l, y);
    follower_skin_move(b->skin, w->q, w->v, x, u);
}

/* All vectors at (t, y). */
static void balance(const struct body *b, struct body_work *w, const struct layout *l, double t,
                    const double *y, const double (*force)[DIM])
{
    const int n = b->beam->dofs;

    elastica_state_read(b, w, l, y);
    elastica_state_loads(b, w, t, w->force);
    follower_skin_load(b->skin, w->q, force, w->force);
    memcpy(w->load, w->force, (size_t)n * sizeof *w->load);
    elastica_accelerate(b->beam, w->load);
    elastica_resist(b->beam, w->beam, w->q, w->v, w->resist);
    memcpy(w->rate, w->resist, (size_t)n * sizeof *w->rate);
    elastica_accelerate(b->beam, w->rate);
    for (int i = 0; i < n; i++)
        w->rate[i] = w->load[i] - w->rate[i];
    band_multiply(b->beam->mass, w->rate, w->inertia);
}

static void elastica_load(const struct body *b, struct body_work *w, const struct layout *l,
                          double t, const double *y, const double (*force)[DIM], double *ydot,
                          struct body_load *out)
{
    const int n = b->beam->dofs;

    balance(b, w, l, t, y, force);
    for (int i = 0; i < n; i++) {
        ydot[elastica_state_place(b, l, i, false)] = 0;
        ydot[elastica_state_place(b, l, i, true)] = w->load[i];
    }
    out->damping = elastica_damping(b->beam, w->q, w->v);
    elastica_state_report(b, w, out);
}

static void elastica_stiff(const struct body *b, struct body_work *w, const struct layout *l,
                           double t, const double *y, double *ydot)
{
    (void)t;
    elastica_state_read(b, w, l, y);
    elastica_resist(b->beam, w->beam, w->q, w->v, w->resist);
    elastica_accelerate(b->beam, w->resist);
    for (int i = 0; i < b->beam->dofs; i++) {
        ydot[elastica_state_place(b, l, i, false)] += w->v[i];
        ydot[elastica_state_place(b, l, i, true)] -= w->resist[i];
    }
}

static int elastica_body_solve(const struct body *b, struct body_work *w, const struct layout *l,
                               double t, double gamma, const double *r, double *z)
{
    const int n = b->beam->dofs;

    (void)t;
    for (int i = 0; i < n; i++) {
        w->force[i] = r[elastica_state_place(b, l, i, false)];
        w->resist[i] = r[elastica_state_place(b, l, i, true)];
        w->q[i] = z[elastica_state_place(b, l, i, false)];
    }
    TRY(elastica_solve(b->beam, w->beam, gamma, w->force, w->resist, w->q, w->v));
    for (int i = 0; i < n; i++) {
        z[elastica_state_place(b, l, i, false)] = w->q[i];
        z[elastica_state_place(b, l, i, true)] = w->v[i];
    }
    return STATUS_DONE;
}

/* At rest. */
static void elastica_limit(const struct body *b, struct limit *out)
{
    const struct elastica *e = b->beam;

    bending_rates_limit(&e->def.bending, e->fastest, e->decay, out);
    out->where = e->def.bending.elements / 2;
    snprintf(out->part, sizeof out->part, "%s", b->path);
}

static double elastica_body_swing(const struct body *b)
{
    return bending_swing(&b->beam->def.bending);
}

static void elastica_energies(const struct body *b, struct body_work *w, const struct layout *l,
                              const double *y, struct energies *to)
{
    elastica_state_read(b, w, l, y);
    to->kinetic += elastica_kinetic(b->beam, w->v);
    to->elastic += elastica_elastic(b->beam, w->q);
    to->potential += b->rest_potential - vectors_dot(b->beam->dofs, b->weight, w->q);
}

/* Adds to p [DIM]. */
static void elastica_momentum(const struct body *b, struct body_work *w, const struct layout *l,
                              const double *y, double *p)
{
    double sum[DIM];

    elastica_state_read(b, w, l, y);
    band_multiply(b->beam->mass, w->v, w->inertia);
    elastica_state_total(b, w->inertia, sum);
    for (int d = 0; d < DIM; d++)
        p[d] += sum[d];
}

static double elastica_weight(const struct body *b)
{
    return b->mass;
}

/* Angle of the tip, turn by turn from node to node: it counts on beyond half a turn. */
static double tip_angle(const struct body *b, const double *q)
{
    double sum = 0, from[2] = { 1, 0 };

    for (int i = 2; i < b->beam->dofs; i += ELASTICA_NODE) {
        const double to[2] = { 1 + q[i], q[i + 1] };
        sum += atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
        from[0] = to[0];
        from[1] = to[1];
    }
    return sum;
}

/* Displacement of the centre line at s, in the frame of the tank. */
static void displace(const struct body *b, double s, const double *q, double *to)
{
    double r[2];

    follower_skin_centre(b->skin, s, q, r);
    for (int d = 0; d < DIM; d++)
        to[d] = (r[0] - s) * b->along[d] + r[1] * b->normal[d];
}

/* What the support at the root feels: force across the straight beam (positive along n, as
 * loads are) and moment (positive counter-clockwise): a turn by theta changes the slope
 * across by |r'| theta. */
static void show(const struct body *b, const struct body_work *w, struct body_view *out)
{
    const struct elastica *e = b->beam;
    const double L = e->def.bending.length;

    displace(b, L, w->q, out->tip);
    displace(b, L / 2, w->q, out->mid);
    out->section = e->def.thickness;
    out->tip_angle = tip_angle(b, w->q);
    out->root_force = elastica_held(e, 1) ? w->force[1] - w->inertia[1] - w->resist[1] : 0;
    out->root_moment = elastica_held(e, 3)
                     ? (1 + w->q[2]) * (w->force[3] - w->inertia[3] - w->resist[3]) : 0;
}

static void elastica_show(const struct body *b, struct body_work *w, const struct layout *l,
                          double t, const double *y, const double (*force)[DIM],
                          struct body_view *out)
{
    balance(b, w, l, t, y, force);
    show(b, w, out);
}

static void elastica_show_predicted(const struct body *b, struct body_work *w,
                                    const struct layout *l, double t, const double *y,
                                    const double (*force)[DIM], struct body_view *out)
{
    elastica_ahead_balance(b, w, l, t, y, force);
    show(b, w, out);
}

static const struct body_implicit implicit = {
    .stiff = elastica_stiff, .solve = elastica_body_solve, .limit = elastica_limit,
    .swing = elastica_body_swing,
};

static const struct body_ahead ahead = {
    .set = elastica_ahead_set, .drive = elastica_ahead_drive, .yield = elastica_ahead_yield,
};

const struct body_kind bodies_elastica = {
    .identity = {
        .name = "elastica", .about = "the same beam, bending as far as it likes (2D)",
        .equation = "M q'' + D q' + dE/dq = F, E = int EA/4 (|r'|^2 - 1 - ln |r'|^2) + "
                    "EI/2 kappa^2 ds, kappa = (r' x r'')/|r'|^2  (BE4)-(BE6), bending moment EI (kappa + "
                    "beta dkappa/dt)  (BE7)",
        .source = "Reissner 1972 without shear; cubic centre line as Gerstmayr, Shabana 2006",
        .group = "beam", .size = sizeof(struct beam_def), .params = beam_def_params,
    },
    .make = { .create = elastica_make, .free = elastica_make_free, .work = elastica_make_work,
              .work_free = elastica_make_work_free },
    .skin = elastica_skin, .rows = elastica_rows, .start = elastica_start,
    .move = elastica_move, .load = elastica_load,
    .energy = elastica_energies, .momentum = elastica_momentum, .weight = elastica_weight,
    .show = elastica_show, .implicit = &implicit, .role.ahead = &ahead,
    .watch = &elastica_make_watch,
};

static const struct body_ahead moved_ahead = {
    .moves = true, .set = elastica_ahead_set, .drive = elastica_ahead_drive,
    .yield = elastica_ahead_yield,
};

const struct body_kind bodies_elastica_predicted = {
    .identity = {
        .name = "beam", .about = "the same, moved as a pressure that looks ahead predicts it",
        .equation = "(M + tau D + tau^2 K) q'' = F - dE/dq - (D + tau K) q'  (E4)",
        .source = "backward Euler over tau, as the pressure of (E3)",
        .group = "beam", .size = sizeof(struct beam_def), .params = beam_def_params,
    },
    .make = { .create = elastica_make, .free = elastica_make_free, .work = elastica_make_work,
              .work_free = elastica_make_work_free },
    .skin = elastica_skin, .rows = elastica_rows, .start = elastica_start,
    .move = elastica_move, .load = elastica_ahead_load,
    .energy = elastica_energies, .momentum = elastica_momentum, .weight = elastica_weight,
    .show = elastica_show_predicted, .role.ahead = &moved_ahead,
    .watch = &elastica_make_watch,
};
