/* rigid-make.c -- makes a rigid body from its parameters; takes all its memory. */
#include "bodies/rigid-make.h"

#include "base/status.h"
#include "bodies/rigid-solid.h"
#include "bodies/skin.h"
#include "state/scales.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void rigid_make_free(struct body **body)
{
    if (*body) {
        free((*body)->arm);
        free((*body)->core);
        rigid_figure_free(&(*body)->figure);
        rigid_ties_free(&(*body)->def);
    }
    free(*body);
    *body = NULL;
}

/* The water before a face holds a light body as a spring does:
 *   rate = 0.56 c0 sqrt(rho0/(dx M/A))                                              (RB4)
 * with its mass per wetted area, measured on a column of water below a free piston. */
static double fastest(const struct body *b, const struct scales *s)
{
    if (!s->fluid)
        return 0;
    return 0.56 * s->c0 * sqrt(s->rho0 * b->figure.surface / (s->dx * b->mass));
}

/* Without water, a speed that its own motion has. */
static void measure(struct body *b, const struct scales *s)
{
    double v2 = 0, spin2 = 0, g2 = 0;
    const double reach = b->figure.reach;

    for (int d = 0; d < DIM; d++) {
        b->g[d] = s->g[d];
        b->low[d] = s->low[d];
        v2 += b->def.velocity[d] * b->def.velocity[d];
        g2 += s->g[d] * s->g[d];
    }
    for (int i = 0; i < TURNING_SPINS; i++)
        spin2 += b->def.spin[i] * b->def.spin[i];
    b->length = s->fluid ? s->hs : reach;
    b->speed = s->fluid ? s->speed : sqrt(v2) + sqrt(spin2) * reach + sqrt(sqrt(g2) * reach);
    if (!s->fluid)
        b->speed += rigid_spring_stretch(b->rope, b->def.ties.springs) * b->rate;
    if (!(b->speed > 0))
        b->speed = reach; /* nothing moves it: 1 1/s */
}

/* Of the lattice in the box around it; those near its border become points. */
static double sites(const struct rigid_figure *f, double dx)
{
    double n = dx > 0;

    for (int k = 0; dx > 0 && k < DIM; k++)
        n *= fmax(1, f->span[k] / dx);
    return n;
}

/* Springs hold it besides the water. */
static void tie(struct body *b)
{
    const int n = b->def.ties.springs;
    double swing, turns = 0;

    rigid_joint_make(&b->def, b->mass, b->inertia, &b->joint);
    for (int i = 0; i < n; i++)
        rigid_spring_make(&b->def, &b->def.ties.spring[i], &b->rope[i]);
    rigid_spring_rates(b->rope, n, b->mass, b->inertia, &swing, &b->decay);
    for (int i = 0; i < TURNING_SPINS; i++)
        turns = i ? fmin(turns, b->inertia[i]) : b->inertia[i];
    swing = hypot(swing, sqrt(b->joint.stiffness / turns));
    b->decay += b->joint.damping / turns;
    b->rate = swing > 0 ? hypot(b->rate, swing) : b->rate;
    if (b->joint.kind == RIGID_FIXED)
        b->rate = b->decay = 0; /* nothing moves it but time */
}

/* Without water it has none. */
static int lay_skin(struct body *b, const struct scales *s)
{
    const int layers = b->def.layers > 0 ? b->def.layers
                                         : s->dx > 0 ? (int)ceil(s->support / s->dx) : 0;
    struct points skin = { .n = 0 };
    int code = STATUS_DONE;

    TRY(skin_check(sites(&b->figure, s->dx), b->path));
    if (s->dx > 0)
        code = b->figure.form->skin(&b->figure, s->dx, layers, &skin);
    b->points = (int)skin.n;
    b->arm = skin.x;
    return code;
}

static int build(struct body *b, const struct scales *s)
{
    b->mass = rigid_figure_mass(&b->figure, &b->def);
    rigid_figure_inertia(&b->figure, b->mass, b->inertia);
    b->rate = fastest(b, s);
    tie(b);
    measure(b, s);
    TRY(lay_skin(b, s));
    return rigid_solid_make(b, s);
}

int rigid_make(const void *params, const struct scales *s, const char *name, const char *path,
               struct body **out)
{
    struct body *b;
    int code;

    (void)name;
    *out = NULL;
    b = status_alloc(1, sizeof *b);
    if (!b)
        return STATUS_FAILED;
    b->def = *(const struct rigid_def *)params;
    snprintf(b->path, sizeof b->path, "%s", path);
    code = rigid_figure_make(&b->def, path, &b->figure);
    if (code == STATUS_DONE)
        code = rigid_ties_prepare(&b->def, path);
    if (code == STATUS_DONE)
        code = build(b, s);
    if (code != STATUS_DONE)
        rigid_make_free(&b);
    *out = b;
    return code;
}

int rigid_make_work(const struct body *b, struct body_work **out)
{
    (void)b;
    *out = status_alloc(1, sizeof **out);
    return *out ? STATUS_DONE : STATUS_FAILED;
}

void rigid_make_work_free(struct body_work **work)
{
    free(*work);
    *work = NULL;
}
