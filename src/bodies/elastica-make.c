/* elastica-make.c -- makes a beam that bends far from its parameters; takes all its memory. */
#include "bodies/elastica-make.h"

#include "base/status.h"
#include "bodies/element.h"
#include "bodies/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void elastica_make_free(struct body **body)
{
    if (!*body)
        return;
    elastica_free(&(*body)->beam);
    follower_skin_free(&(*body)->skin);
    free((*body)->memory);
    free(*body);
    *body = NULL;
}

void elastica_make_work_free(struct body_work **work)
{
    if (!*work)
        return;
    elastica_work_free(&(*work)->beam);
    free((*work)->memory);
    free(*work);
    *work = NULL;
}

int elastica_make_work(const struct body *b, struct body_work **out)
{
    struct body_work *w = *out = status_alloc(1, sizeof *w);

    if (!w)
        return STATUS_FAILED;
    double **vector[] = { &w->q, &w->v, &w->given, &w->force, &w->resist, &w->load, &w->rate,
                          &w->inertia, &w->predicted };
    if (elastica_work_create(b->beam, &w->beam) == STATUS_DONE
        && vectors_take(vector, sizeof vector / sizeof vector[0], b->beam->dofs, &w->memory)
               == STATUS_DONE)
        return STATUS_DONE;
    elastica_make_work_free(out);
    return STATUS_FAILED;
}

static int take_vectors(struct body *b)
{
    double **vector[] = { &b->start, &b->start_rate, &b->weight, &b->pushed };

    return vectors_take(vector, sizeof vector / sizeof vector[0], b->beam->dofs, &b->memory);
}

static void add_uniform(const struct elastica *e, double load, double *f)
{
    double part[4];

    element_uniform(load, e->l, part);
    for (int i = 0; i < e->def.bending.elements; i++)
        for (int k = 0; k < 4; k++)
            f[elastica_at(i, k, 1)] += part[k];
}

/* Weight is that of the inertia, M g, so that the beam falls as all things do. */
static void prepare_weight(struct body *b, const struct beam_def *d, const struct scales *s)
{
    double g[2] = { 0, 0 };

    b->mass = bending_mass(b->beam->plane);
    for (int i = 0; i < DIM; i++) {
        g[0] += s->g[i] * b->along[i];
        g[1] += s->g[i] * b->normal[i];
    }
    b->rest_potential = beam_def_potential(d, s, b->mass);
    for (int i = 0; i < b->beam->dofs; i++)
        b->weight[i] = g[i % 2] * b->beam->plane->shift[i / 2];
}

static void prepare_loads(struct body *b, const struct beam_def *d)
{
    b->load_until = d->load_until > 0 ? d->load_until : HUGE_VAL;
    if (d->follower) {
        b->turning_load = d->load;
        b->turning_force = d->tip_force;
        return;
    }
    add_uniform(b->beam, d->load, b->pushed);
    b->pushed[b->beam->dofs - ELASTICA_NODE + 1] += d->tip_force;
}

/* Turn of the tangent at part x of the length when the tip has turned by 1: without moment
 * and shear force at an end that is free, without moment at one that is pinned. */
static double turn_at(const struct elastica *e, double x)
{
    if (e->def.bending.root == BENDING_CLAMPED)
        return 1 - pow(1 - x, 3);
    return x * x * x * (10 - x * (15 - 6 * x));
}

/* At part x: r' - e into a, its rate into a_rate. */
static void tangent_at(const struct elastica *e, const struct beam_def *d, double x, double *a,
                       double *a_rate)
{
    const double turn = turn_at(e, x) * M_PI / 180;
    const double angle = d->bent * turn, turning = d->bent_rate * turn;

    a[0] = -2 * pow(sin(angle / 2), 2);
    a[1] = sin(angle);
    a_rate[0] = -sin(angle) * turning;
    a_rate[1] = cos(angle) * turning;
}

/* r is the integral of its tangent: three points of Gauss an element. */
static void prepare_start(struct body *b, const struct beam_def *d)
{
    const double at[3] = { 0.5 - sqrt(0.15), 0.5, 0.5 + sqrt(0.15) };
    const double weight[3] = { 5 / 18.0, 8 / 18.0, 5 / 18.0 };
    double *q = b->start, *v = b->start_rate, a[2], a_rate[2];

    for (int i = 0; i <= d->elements; i++, q += ELASTICA_NODE, v += ELASTICA_NODE) {
        tangent_at(b->beam, d, (double)i / d->elements, q + 2, v + 2);
        for (int k = 0; k < 3 && i > 0; k++) {
            tangent_at(b->beam, d, (i - 1 + at[k]) / d->elements, a, a_rate);
            for (int c = 0; c < 2; c++) {
                q[c] += weight[k] * b->beam->l * a[c];
                v[c] += weight[k] * b->beam->l * a_rate[c];
            }
        }
        for (int c = 0; c < 2 && i < d->elements; c++) {
            q[ELASTICA_NODE + c] = q[c];
            v[ELASTICA_NODE + c] = v[c];
        }
    }
}

static int build(struct body *b, const struct beam_def *d, const struct scales *s)
{
    struct elastica_def def = { .bending = beam_def_bending(d), .EA = beam_def_axial(d),
                                .thickness = d->thickness, .path = b->path };
    const struct skin_def skin = beam_def_skin(d, s, b->path);

    TRY(skin_check(skin_size(&skin), b->path));
    def.speed = s->fluid ? 10 * s->speed : bending_first(&def.bending) * d->thickness;
    beam_def_axes(d, b->along, b->normal);
    b->skin_kind = d->slip ? KIND_SKIN_SLIP : KIND_SKIN;
    b->surface = (struct body_surface){ d->contact, d->restitution, d->friction,
                                         skin.layers };
    TRY(elastica_create(&def, &b->beam));
    TRY(take_vectors(b));
    prepare_weight(b, d, s);
    prepare_loads(b, d);
    prepare_start(b, d);
    return follower_skin_create(&skin, &b->skin);
}

int elastica_make(const void *params, const struct scales *s, const char *name, const char *path,
                  struct body **out)
{
    struct body *b;
    int code;

    (void)name;
    TRY(beam_def_check(params, path));
    b = status_alloc(1, sizeof *b);
    if (!b)
        return STATUS_FAILED;
    snprintf(b->path, sizeof b->path, "%s", path);
    code = build(b, params, s);
    if (code != STATUS_DONE)
        elastica_make_free(&b);
    *out = b;
    return code;
}

static bool is_held(const struct body *b, int i)
{
    const struct bending_def *d = &b->beam->def.bending;

    return skin_held(&b->skin->def, d->root != BENDING_FREE, d->tip != BENDING_FREE, i);
}

static double next_jump(const struct body *b, double t)
{
    return b->load_until > t ? b->load_until : HUGE_VAL;
}

static const struct body_surface *surface(const struct body *b)
{
    return &b->surface;
}

const struct body_watch elastica_make_watch = {
    .event = next_jump, .held = is_held, .surface = surface,
};
