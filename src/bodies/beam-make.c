/* beam-make.c -- makes a beam from its parameters; takes all its memory. */
#include "bodies/beam-make.h"

#include "base/status.h"
#include "bodies/element.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void beam_make_free(struct body **body)
{
    if (!*body)
        return;
    bending_free(&(*body)->bending);
    beam_skin_free(&(*body)->skin);
    free((*body)->memory);
    free(*body);
    *body = NULL;
}

static int take_vectors(struct body *b)
{
    double **vector[] = { &b->vec.q, &b->vec.v, &b->vec.weight, &b->vec.pushed, &b->vec.force,
                          &b->vec.resist, &b->vec.given, &b->vec.rate, &b->vec.inertia };
    const int n = sizeof vector / sizeof vector[0], dofs = b->bending->dofs;

    b->memory = status_alloc((unsigned long)(n * dofs), sizeof *b->memory);
    if (!b->memory)
        return STATUS_FAILED;
    for (int i = 0; i < n; i++)
        *vector[i] = b->memory + i * dofs;
    return STATUS_DONE;
}

static void add_uniform(const struct bending *s, double load, double *f)
{
    double part[4];

    element_uniform(load, s->l, part);
    for (int e = 0; e < s->def.elements; e++)
        for (int k = 0; k < 4; k++)
            f[2 * e + k] += part[k];
}

/* Weight and prescribed loads, once for all.  Weight is that of the inertia, M g, so
 * that the beam falls as all things do; nodes spread evenly have their centre in the
 * middle, whichever mass matrix. */
static void prepare_loads(struct body *b, const struct beam_def *d, const struct scales *s)
{
    double across = 0, along = 0;

    b->mass = bending_shift(b->bending, b->vec.weight);
    for (int i = 0; i < DIM; i++) {
        const double centre = d->at[i] + 0.5 * d->length * b->along[i];
        across += s->g[i] * b->normal[i];
        along += s->g[i] * b->along[i];
        b->rest_potential -= b->mass * s->g[i] * (centre - s->low[i]);
    }
    b->gravity_along = b->mass * along;
    for (int i = 0; i < b->bending->dofs; i++)
        b->vec.weight[i] *= across;
    add_uniform(b->bending, d->load, b->vec.pushed);
    b->vec.pushed[b->bending->dofs - 2] += d->tip_force;
    b->load_until = d->load_until > 0 ? d->load_until : HUGE_VAL;
}

static int make_skin(struct body *b, const struct beam_def *d, const struct scales *s)
{
    const int needed = s->dx > 0 ? (int)ceil(s->support / s->dx - 1e-9) : 0;
    struct beam_skin_def skin = { .length = d->length, .spacing = s->dx,
                                  .elements = d->elements,
                                  .layers = d->layers > 0 ? d->layers : needed };

    for (int i = 0; i < DIM; i++) {
        skin.at[i] = d->at[i];
        skin.along[i] = b->along[i];
        skin.normal[i] = b->normal[i];
    }
    if (s->fluid && skin.layers < needed)
        status_warn("%s: layers = %d is less than the %d that the kernel's support covers: water "
                    "on one side feels water on the other through the beam", b->path,
                    skin.layers, needed);
    return beam_skin_create(&skin, &b->skin);
}

static int build(struct body *b, const struct beam_def *d, const struct scales *s)
{
    const struct bending_def bending = beam_def_bending(d);

    beam_def_axes(d, b->along, b->normal);
    b->thickness = d->thickness;
    b->speed = s->fluid ? 10 * s->speed : bending_first(&bending) * d->thickness;
    b->skin_kind = d->slip ? KIND_SKIN_SLIP : KIND_SKIN;
    TRY(bending_create(&bending, &b->bending));
    TRY(take_vectors(b));
    prepare_loads(b, d, s);
    return make_skin(b, d, s);
}

int beam_make(const void *params, const struct scales *s, const char *name, const char *path,
              struct body **out)
{
    struct body *b;
    int code;

    (void)name;
    if (DIM != 2)
        return status_fail(STATUS_BAD_SCENE, "%s: a beam in three dimensions is not there yet; "
                           "set dimension = 2, or leave the beam out", path);
    TRY(beam_def_check(params, path));
    b = status_alloc(1, sizeof *b);
    if (!b)
        return STATUS_FAILED;
    snprintf(b->path, sizeof b->path, "%s", path);
    code = build(b, params, s);
    if (code != STATUS_DONE)
        beam_make_free(&b);
    *out = b;
    return code;
}
