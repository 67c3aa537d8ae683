/* rigid-state.c -- the rows of a rigid body in y, and what they say. */
#include "bodies/rigid-state.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

int rigid_state_row(struct body *b, struct layout *l, int *row, enum layout_class what,
                    const char *name, const char *unit, int n, int components, double scale)
{
    char path[80];

    snprintf(path, sizeof path, "%s.%s", b->path, name);
    *row = layout_add(l, what, path, unit, n, components, scale);
    return *row < 0 ? STATUS_FAILED : STATUS_DONE;
}

/* A quaternion turns by half the angle. */
static int free_rows(struct body *b, struct layout *l)
{
    const double reach = b->figure.reach, half = DIM == 2 ? 1 : 0.5;

    TRY(rigid_state_row(b, l, &b->row[0], LAYOUT_POSITION, "x", "m", 1, DIM, b->length));
    TRY(rigid_state_row(b, l, &b->row[1], LAYOUT_POSITION, "turn", DIM == 2 ? "rad" : "", 1,
                        TURNING_NUMBERS, half * b->length / reach));
    TRY(rigid_state_row(b, l, &b->row[2], LAYOUT_VELOCITY, "v", "m/s", 1, DIM, b->speed));
    return rigid_state_row(b, l, &b->row[3], LAYOUT_VELOCITY, "spin", "rad/s", 1, TURNING_SPINS,
                           b->speed / reach);
}

/* A hinge moves what is farthest from it by its angle times this. */
static double lever(const struct body *b)
{
    double arm2 = 0;

    for (int d = 0; d < DIM; d++)
        arm2 += b->joint.arm[d] * b->joint.arm[d];
    return b->joint.kind == RIGID_HINGE ? sqrt(arm2) + b->figure.reach : 1;
}

static int joint_rows(struct body *b, struct layout *l)
{
    const bool hinged = b->joint.kind == RIGID_HINGE;

    if (b->joint.kind != RIGID_FIXED) {
        TRY(rigid_state_row(b, l, &b->joint_row[0], LAYOUT_POSITION, hinged ? "turned" : "slid",
                            hinged ? "rad" : "m", 1, 1, b->length / lever(b)));
        TRY(rigid_state_row(b, l, &b->joint_row[1], LAYOUT_VELOCITY, hinged ? "turning" : "sliding",
                            hinged ? "rad/s" : "m/s", 1, 1, b->speed / lever(b)));
    }
    if (!b->joint.motion)
        return STATUS_DONE;
    return rigid_state_row(b, l, &b->joint_row[2], LAYOUT_OTHER, "time", "s", 1, 1, 0);
}

int rigid_state_rows(struct body *b, struct layout *l)
{
    return b->joint.kind == RIGID_FREE ? free_rows(b, l) : joint_rows(b, l);
}

static void joint_start(const struct body *b, const struct layout *l, double *y)
{
    if (b->joint.kind != RIGID_FIXED) {
        y[layout_at(l, b->joint_row[0])] = 0;
        y[layout_at(l, b->joint_row[1])] = b->joint.rate;
    }
    if (b->joint.motion)
        y[layout_at(l, b->joint_row[2])] = 0;
}

void rigid_state_start(const struct body *b, const struct layout *l, double *y)
{
    if (b->joint.kind != RIGID_FREE) {
        joint_start(b, l, y);
        return;
    }
    memcpy(y + layout_at(l, b->row[0]), b->def.at, DIM * sizeof *y);
    rigid_def_turned(&b->def, y + layout_at(l, b->row[1]));
    memcpy(y + layout_at(l, b->row[2]), b->def.velocity, DIM * sizeof *y);
    memcpy(y + layout_at(l, b->row[3]), b->def.spin, TURNING_SPINS * sizeof *y);
}

static void read_joint(const struct body *b, struct body_work *w, const struct layout *l,
                       const double *y)
{
    const bool fixed = b->joint.kind == RIGID_FIXED;

    rigid_joint_at(&b->joint, b->joint.motion ? y[layout_at(l, b->joint_row[2])] : 0,
                   fixed ? 0 : y[layout_at(l, b->joint_row[0])],
                   fixed ? 0 : y[layout_at(l, b->joint_row[1])], &w->place, &w->link);
    w->x = w->place.x;
    w->turn = w->place.turn;
    w->v = w->place.v;
    w->spin = w->place.spin;
}

void rigid_state_read(const struct body *b, struct body_work *w, const struct layout *l,
                      const double *y)
{
    if (b->joint.kind != RIGID_FREE)
        read_joint(b, w, l, y);
    else {
        w->x = y + layout_at(l, b->row[0]);
        w->turn = y + layout_at(l, b->row[1]);
        w->v = y + layout_at(l, b->row[2]);
        w->spin = y + layout_at(l, b->row[3]);
    }
    turning_matrix(w->turn, w->R);
}

void rigid_state_rates(const struct body *b, const struct body_work *w, const struct layout *l,
                       double second, double *ydot)
{
    if (b->joint.kind != RIGID_FIXED) {
        ydot[layout_at(l, b->joint_row[0])] = w->link.rate;
        ydot[layout_at(l, b->joint_row[1])] = second;
    }
    if (b->joint.motion)
        ydot[layout_at(l, b->joint_row[2])] = 1;
}
