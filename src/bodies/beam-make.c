/* beam-make.c -- makes a beam from its parameters; takes all its memory. */
#include "bodies/beam-make.h"

#include "base/status.h"
#include "bodies/element.h"
#include "bodies/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

void beam_make_work_free(struct body_work **work)
{
    if (!*work)
        return;
    bending_work_free(&(*work)->bending);
    free((*work)->memory);
    free(*work);
    *work = NULL;
}

int beam_make_work(const struct body *b, struct body_work **out)
{
    struct body_work *w = *out = status_alloc(1, sizeof *w);

    if (!w)
        return STATUS_FAILED;
    double **vector[] = { &w->q, &w->v, &w->force, &w->resist, &w->given, &w->rate, &w->inertia,
                          &w->predicted };
    if (bending_work_create(b->bending, &w->bending) == STATUS_DONE
        && vectors_take(vector, sizeof vector / sizeof vector[0], b->bending->dofs, &w->memory)
               == STATUS_DONE)
        return STATUS_DONE;
    beam_make_work_free(out);
    return STATUS_FAILED;
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
 * that the beam falls as all things do. */
static void prepare_loads(struct body *b, const struct beam_def *d, const struct scales *s)
{
    double across = 0, along = 0;

    b->mass = bending_mass(b->bending);
    for (int i = 0; i < DIM; i++) {
        across += s->g[i] * b->normal[i];
        along += s->g[i] * b->along[i];
    }
    b->rest_potential = beam_def_potential(d, s, b->mass);
    b->gravity_along = b->mass * along;
    for (int i = 0; i < b->bending->dofs; i++)
        b->weight[i] = b->bending->shift[i] * across;
    add_uniform(b->bending, d->load, b->pushed);
    b->pushed[b->bending->dofs - 2] += d->tip_force;
    b->load_until = d->load_until > 0 ? d->load_until : HUGE_VAL;
}

static int build(struct body *b, const struct beam_def *d, const struct scales *s)
{
    const struct bending_def bending = beam_def_bending(d);
    const struct skin_def skin = beam_def_skin(d, s, b->path);

    TRY(skin_check(skin_size(&skin), b->path));
    beam_def_axes(d, b->along, b->normal);
    b->thickness = d->thickness;
    b->trusted = strcmp(d->theory, "linear") == 0;
    b->speed = s->fluid ? 10 * s->speed : bending_first(&bending) * d->thickness;
    b->skin_kind = d->slip ? KIND_SKIN_SLIP : KIND_SKIN;
    b->surface = (struct body_surface){ d->contact, d->restitution, d->friction,
                                         skin.layers };
    TRY(bending_create(&bending, &b->bending));
    TRY(vectors_take((double **[]){ &b->weight, &b->pushed }, 2, b->bending->dofs, &b->memory));
    prepare_loads(b, d, s);
    return beam_skin_create(&skin, &b->skin);
}

int beam_make(const void *params, const struct scales *s, const char *name, const char *path,
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
        beam_make_free(&b);
    *out = b;
    return code;
}
