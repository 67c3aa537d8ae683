/* float.c -- a body without an implicit side, for tests.  It is also the table of bodies of
 * the tests that link it: there is no beam. */
#include "float.h"

#include "base/status.h"
#include "state/scales.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

enum { LAYERS = 3, UP = DIM - 1 };

struct body {
    struct float_def def;
    char path[40];
    double spacing, g, low; /* [m], [m/s^2], of the domain [m] */
    int columns;
    int row[2];
};

struct body_work {
    double s, v; /* [m], [m/s] */
};

static const struct param params[] = {
    { .key = "at", .unit = "m", .offset = offsetof(struct float_def, at), .min = -1e6,
      .max = 1e6, .type = PARAM_VECTOR, .required = 1, .about = "lower left point at rest" },
    { .key = "length", .unit = "m", .offset = offsetof(struct float_def, length), .min = 1e-6,
      .max = 1e6, .required = 1, .about = "of the block" },
    { .key = "mass", .unit = "kg/m", .offset = offsetof(struct float_def, mass), .min = 1e-6,
      .max = 1e9, .required = 1, .about = "of the block" },
    { .key = "stiffness", .unit = "N/m^2", .offset = offsetof(struct float_def, stiffness),
      .max = 1e12, .about = "of the spring" },
    { .key = "lift", .unit = "m", .offset = offsetof(struct float_def, lift), .min = -1e6,
      .max = 1e6, .about = "height above rest at t = 0" },
    { 0 },
};

static int create(const void *def, const struct scales *s, const char *name, const char *path,
                  struct body **out)
{
    struct body *b = *out = status_alloc(1, sizeof *b);

    (void)name;
    if (!b)
        return STATUS_FAILED;
    b->def = *(const struct float_def *)def;
    b->spacing = s->dx;
    b->g = s->g[UP];
    b->low = s->low[UP];
    b->columns = s->dx > 0 ? (int)round(b->def.length / s->dx) : 0;
    snprintf(b->path, sizeof b->path, "%.39s", path);
    return STATUS_DONE;
}

static void free_body(struct body **b)
{
    free(*b);
    *b = NULL;
}

static int work(const struct body *b, struct body_work **out)
{
    (void)b;
    *out = status_alloc(1, sizeof **out);
    return *out ? STATUS_DONE : STATUS_FAILED;
}

static void work_free(struct body_work **w)
{
    free(*w);
    *w = NULL;
}

static void place(const struct body *b, int i, double *x)
{
    for (int d = 0; d < DIM; d++)
        x[d] = b->def.at[d];
    x[0] += i / LAYERS * b->spacing;
    x[UP] += i % LAYERS * b->spacing;
}

static int skin(const struct body *b, double (*x)[DIM], enum kind *kind)
{
    for (int i = 0; x && i < b->columns * LAYERS; i++)
        place(b, i, x[i]);
    if (kind)
        *kind = KIND_SKIN;
    return b->columns * LAYERS;
}

static int rows(struct body *b, struct layout *l)
{
    char name[48];

    snprintf(name, sizeof name, "%s.s", b->path);
    b->row[0] = layout_add(l, LAYOUT_POSITION, name, "m", 1, 1, 0.01);
    snprintf(name, sizeof name, "%s.s_rate", b->path);
    b->row[1] = layout_add(l, LAYOUT_VELOCITY, name, "m/s", 1, 1, 0.1);
    return b->row[0] < 0 || b->row[1] < 0 ? STATUS_FAILED : STATUS_DONE;
}

static void start(const struct body *b, const struct layout *l, double *y)
{
    y[layout_at(l, b->row[0])] = b->def.lift;
    y[layout_at(l, b->row[1])] = 0;
}

static void read_state(const struct body *b, struct body_work *w, const struct layout *l,
                       const double *y)
{
    w->s = y[layout_at(l, b->row[0])];
    w->v = y[layout_at(l, b->row[1])];
}

static void move(const struct body *b, struct body_work *w, const struct layout *l, double t,
                 const double *y, double (*x)[DIM], double (*u)[DIM])
{
    (void)t;
    read_state(b, w, l, y);
    for (int i = 0; i < b->columns * LAYERS; i++) {
        place(b, i, x[i]);
        x[i][UP] += w->s;
        for (int d = 0; d < DIM; d++)
            u[i][d] = d == UP ? w->v : 0;
    }
}

/* The spring pulls at the ground, and what holds the block along, too. */
static void load(const struct body *b, struct body_work *w, const struct layout *l, double t,
                 const double *y, const double (*force)[DIM], double *ydot,
                 struct body_load *out)
{
    double up = 0;

    (void)t;
    read_state(b, w, l, y);
    *out = (struct body_load){ .support[UP] = -b->def.stiffness * w->s };
    for (int i = 0; i < b->columns * LAYERS; i++) {
        up += force[i][UP];
        for (int d = 0; d < UP; d++)
            out->support[d] -= force[i][d];
    }
    ydot[layout_at(l, b->row[0])] = w->v;
    ydot[layout_at(l, b->row[1])] = b->g + (up - b->def.stiffness * w->s) / b->def.mass;
}

static void limit(const struct body *b, struct limit *out)
{
    out->rate = sqrt(b->def.stiffness / b->def.mass);
    out->decay = false;
    out->where = 0;
    snprintf(out->part, sizeof out->part, "%s", b->path);
}

static void energy(const struct body *b, struct body_work *w, const struct layout *l,
                   const double *y, struct energies *to)
{
    read_state(b, w, l, y);
    to->kinetic += 0.5 * b->def.mass * w->v * w->v;
    to->elastic += 0.5 * b->def.stiffness * w->s * w->s;
    to->potential -= b->def.mass * b->g * (b->def.at[UP] + w->s - b->low);
}

static void momentum(const struct body *b, struct body_work *w, const struct layout *l,
                     const double *y, double *p)
{
    read_state(b, w, l, y);
    p[UP] += b->def.mass * w->v;
}

static double weight(const struct body *b)
{
    return b->def.mass;
}

static void show(const struct body *b, struct body_work *w, const struct layout *l, double t,
                 const double *y, const double (*force)[DIM], struct body_view *out)
{
    (void)t;
    (void)force;
    read_state(b, w, l, y);
    *out = (struct body_view){ .tip[UP] = w->s, .mid[UP] = w->s };
}

const struct body_kind float_kind = {
    .identity = { .name = "float", .about = "a block on a spring", .equation = "m s'' = F - k s",
                  .source = "Newton 1687", .group = "beam", .size = sizeof(struct float_def),
                  .params = params },
    .make = { .create = create, .free = free_body, .work = work, .work_free = work_free },
    .skin = skin, .rows = rows, .start = start, .move = move, .load = load, .limit = limit,
    .energy = energy, .momentum = momentum, .weight = weight, .show = show,
};

const struct body_kind *const bodies_table[] = { &float_kind, NULL };
