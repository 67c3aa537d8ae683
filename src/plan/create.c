/* create.c -- from a scene to a plan: every decision is taken here, once. */
#include "plan/inside.h"

#include "base/status.h"
#include "plan/kernels.h"
#include "plan/solver.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int take_part(struct plan *p, const struct part *part, void **self, const char *path)
{
    struct plan_part *to = &p->part[p->parts];

    if (p->parts == PLAN_PARTS)
        return status_fail(STATUS_BAD_SCENE, "more than %d parts in a scene", PLAN_PARTS);
    to->part = part;
    to->self = self ? *self : NULL;
    if (self)
        *self = NULL;
    to->slot = part_is_booked(part) ? p->slots++ : -1;
    snprintf(to->path, sizeof to->path, "%s", path);
    if (part->provides & FIELD_PRESSURE)
        p->pressure = to;
    p->parts++;
    return STATUS_DONE;
}

/* Numbers that stand for another one, as 0 may, until prepare() knows it. */
static void note_computed(const struct plan_part *o, struct scene *scene)
{
    for (const struct param *row = o->part->params; o->self && row && row->key; row++) {
        const double *now = (const double *)((const char *)o->self + row->offset);
        if (row->type == PARAM_NUMBER && *now != row->fallback)
            scene_computed(scene, o->path, row->key, *now);
    }
}

/* A part does not know the scene's file. */
static int prepare_parts(struct plan *p, struct scene *scene)
{
    char text[1024];

    for (int i = 0; i < p->parts; i++) {
        const struct part *part = p->part[i].part;
        int status = part->prepare ? part->prepare(p->part[i].self, &p->scales) : STATUS_DONE;
        if (status == STATUS_DONE) {
            note_computed(&p->part[i], scene);
            continue;
        }
        snprintf(text, sizeof text, "%s", status_message());
        status_clear();
        return status_fail(status, "%s: %s", scene_path(scene), text);
    }
    return STATUS_DONE;
}

/* Pressure first, then wall model, then effects in table order. */
static int take_parts(struct plan *p)
{
    unsigned needs = 0;

    for (int i = 0; i < p->in.effects; i++)
        needs |= p->in.effect[i].part->needs;
    if (p->in.fluids == 0)
        return STATUS_DONE;
    if (needs & FIELD_PRESSURE)
        TRY(take_part(p, p->in.pressure, &p->in.pressure_self, "eos"));
    if (needs & FIELD_DENSITY)
        TRY(take_part(p, p->in.walls, p->in.walls->size ? &p->in.walls_self : NULL, "walls"));
    for (int i = 0; i < p->in.effects; i++)
        TRY(take_part(p, p->in.effect[i].part, &p->in.effect[i].self, p->in.effect[i].path));
    return STATUS_DONE;
}

/* The viscosity that the scene wants implicit. */
static int find_stiff(struct plan *p, const struct scene *scene)
{
    for (int i = 0; i < p->parts; i++) {
        const struct plan_part *one = &p->part[i];
        if (!one->part->as.operator || !one->part->as.operator->stiff(one->self))
            continue;
        if (p->stiff)
            return status_fail(STATUS_BAD_SCENE, "%s: both %s and %s are to be implicit, but one "
                               "viscosity is solved for at a time: leave one of them out, or set "
                               "its side = \"explicit\"", scene_path(scene), p->stiff->path,
                               one->path);
        p->stiff = one;
        p->solver = &implicit_viscous;
    }
    return STATUS_DONE;
}

static int make_layout(struct plan *p)
{
    const int n = particles_count(p->particles, KIND_FLUID);
    struct layout *l = &p->layout;

    plan_scales_density(p);
    p->row.x = p->row.u = -1;
    for (int k = 0; k < KINDS; k++)
        p->row.density[k] = -1;
    if (n > 0) {
        p->row.x = layout_add(l, LAYOUT_POSITION, "position of fluid", "m", n, DIM, p->scales.hs);
        p->row.u = layout_add(l, LAYOUT_VELOCITY, "velocity of fluid", "m/s", n, DIM,
                              p->scales.speed);
    }
    for (int i = 0; i < p->bodies; i++)
        TRY(p->body[i].kind->rows(p->body[i].body, l));
    if (p->contacts.kind && p->contacts.kind->rows)
        TRY(p->contacts.kind->rows(p->contacts.self, l));
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->blocks)
            TRY(p->part[i].part->blocks(p->part[i].self, &p->scales, p->particles, l,
                                        p->row.density));
    TRY(plan_book_rows(p));
    layout_done(l);
    return STATUS_DONE;
}

static int check_something(const struct plan *p, const struct scene *scene)
{
    if (p->in.fluids == 0 && p->in.bodies == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: there is nothing that moves: name a fluid "
                           "(fluid = { water = { type = \"box\"; ... } }) or a beam",
                           scene_path(scene));
    return STATUS_DONE;
}

/* With pairs of half the cost a list that lasts longer pays (doc/speed.md). */
static void choose_precision(struct plan *p, struct scene *scene)
{
    const bool single = strcmp(p->in.set.precision, "single") == 0;

    if (single)
        p->engine = engine_single(p->engine);
    if (isnan(p->in.kernel.skin)) {
        p->in.kernel.skin = single ? 0.1 : 0.05;
        scene_computed(scene, "kernel", "skin", p->in.kernel.skin);
    }
}

/* Up to the particles; with a survey those are counted. */
static int read(struct plan *p, struct scene *scene, struct plan_survey *survey)
{
    TRY(input_read(scene, p->engine, &p->in));
    choose_precision(p, scene);
    TRY(check_something(p, scene));
    TRY(plan_scales_make(p, scene));
    TRY(kernels_make(p->engine, p->in.kernel.type, p->in.kernel.use, p->scales.support,
                     p->kernel));
    TRY(kernels_laws(p->engine, p->kernel, p->table.kernel));
    kernels_scales(p->engine, p->kernel, &p->scales);
    TRY(plan_bodies_make(p));
    TRY(plan_contacts_make(p));
    return survey ? plan_survey_take(p, survey) : STATUS_DONE;
}

/* together: all ranks do so. */
static int build(struct plan *p, struct scene *scene, bool together)
{
    TRY(plan_objects_fill(p));
    TRY(take_parts(p));
    TRY(prepare_parts(p, scene));
    TRY(plan_agree(p, scene));
    TRY(find_stiff(p, scene));
    plan_fields_make(p);
    TRY(plan_objects_name(p));
    TRY(plan_panels_make(p));
    TRY(make_layout(p));
    TRY(plan_press_make(p, together));
    TRY(plan_tables_make(p));
    plan_list_make(p);
    TRY(plan_face_make(p, scene));
    TRY(plan_ahead_agree(p, scene));
    TRY(passes_make(p, passes_table));
    return p->solver ? p->solver->agree(p) : STATUS_DONE;
}

static void destroy(struct plan **plan)
{
    struct plan *p = *plan;

    plan_press_free(p);
    for (int i = 0; i < p->parts; i++)
        free(p->part[i].self);
    for (int i = 0; i < p->bodies; i++)
        p->body[i].kind->make.free(&p->body[i].body);
    if (p->contacts.kind)
        p->contacts.kind->free(&p->contacts.self);
    free(p->face);
    plan_panels_free(p);
    particles_free(&p->particles);
    input_free(&p->in);
    free(p->body);
    free(p->wall);
    if (p->table.kernel[0] != p->kernel[0])
        kernels_free(p->table.kernel);
    kernels_free(p->kernel);
    free(p->table.all);
    free(p);
    *plan = NULL;
}

/* survey, out: NULL if there is none, or no plan is wanted.  together: all ranks do so. */
static int create(struct scene *scene, struct plan_survey *survey, bool together, const struct plan **out)
{
    struct plan *p = status_alloc(1, sizeof *p);
    int status;

    if (out)
        *out = NULL;
    if (!p)
        return STATUS_FAILED;
    p->engine = engine_pick();
    status = read(p, scene, survey);
    const bool whole = status == STATUS_DONE && out && !(survey && survey->large);
    if (whole)
        status = build(p, scene, together);
    if (!whole || status != STATUS_DONE)
        destroy(&p);
    if (out)
        *out = p;
    return status;
}

int plan_create(struct scene *scene, const struct plan **out)
{
    return create(scene, NULL, false, out);
}

int plan_create_together(struct scene *scene, const struct plan **out)
{
    return create(scene, NULL, true, out);
}

int plan_survey_create(struct scene *scene, struct plan_survey *survey, const struct plan **out)
{
    *survey = (struct plan_survey){ 0 };
    return create(scene, survey, false, out);
}

int plan_survey_count(struct scene *scene, struct plan_survey *survey)
{
    *survey = (struct plan_survey){ 0 };
    return create(scene, survey, false, NULL);
}

void plan_free(const struct plan **plan)
{
    struct plan *p = (struct plan *)*plan; /* whoever frees it may change it again */

    if (p)
        destroy(&p);
    *plan = NULL;
}
