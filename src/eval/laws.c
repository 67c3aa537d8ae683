/* laws.c -- sums over pairs: what laws between particles give. */
#include "eval/share.h"

#include "base/status.h"
#include "eval/face.h"

#include <string.h>

/* What pushes the fluid besides pairs stands where its rates will. */
int passes_ahead(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    if (e->job.ahead == 0)
        return STATUS_DONE;
    e->job.push = spread_velocities(e->m, e->ydot);
    memset(e->job.push, 0,
           (size_t)moment_rows_of(e->m, KIND_FLUID) * sizeof *e->job.push);
    passes_add_body_forces(e);
    return STATUS_DONE;
}

int passes_slip(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    e->m->face->power = 0;
    if (!face_among(e->m->plan, e->job.table))
        return STATUS_DONE;
    TRY(face_find(e->m));
    if (e->job.push)
        face_push(e->m, e->job.push);
    return STATUS_DONE;
}

int passes_laws(struct evaluation *e, const struct plan_field *of)
{
    const struct plan *p = e->m->plan;
    const struct rates_job *laws = &e->job;
    struct workspace *w = e->m->work;
    const struct sum_job job = {
        .list = e->m->list, .record = w->record, .mass = p->table.mass, .table = laws->table,
        .slots = p->slots,
        .later = laws->ahead, .push = (const double (*)[DIM])laws->push,
        .moduli = laws->table == p->table.velocities ? NULL : p->in.pressure->as.pressure->moduli,
        .fluid_only = p->passes.press != NULL,
        .eos = p->pressure ? p->pressure->self : p->in.pressure_self,
        .f = w->f, .drho = w->drho, .power = w->power, .rates = laws->to,
        .apart = laws->apart, .apart_slot = laws->apart ? p->stiff->slot : 0,
        .shared = e->m->share != NULL, .parts = share_parts(e),
    };

    (void)of;
    TRY(p->engine->sum->pairs(&job, &w->scratch));
    if (moment_is_full(e->m))
        share_laws(e->m, &job);
    return STATUS_DONE;
}

int passes_faces(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    if (face_among(e->m->plan, e->job.table))
        face_add(e->m, &e->job);
    return STATUS_DONE;
}

/* The power of the implicit law is booked on its own side. */
int passes_apart(struct evaluation *e, const struct plan_field *of)
{
    const int slot = e->m->plan->stiff->slot;

    (void)of;
    *e->power = e->m->work->power[slot];
    e->m->work->power[slot] = 0;
    if (plan_face_implicit(e->m->plan))
        e->m->face->power = 0;
    return STATUS_DONE;
}

/* Accelerations by all but the pressure, into rates of velocities of ydot: a solve for
 * the pressure finds them there.  The laws write over them, and over forces and powers. */
int passes_others(struct evaluation *e, const struct plan_field *of)
{
    const struct ask ask = { .sides = e->ask->sides, .without_pressure = true };
    const struct sum_rates to = spread_places(e->m, &ask, e->ydot);
    struct evaluation one = *e;

    one.ask = &ask;
    one.job = (struct rates_job){ .table = e->m->plan->table.without_pressure };
    one.job.to = (struct sum_rates){ .u = to.u, .rows = to.rows };
    if (e->m->face)
        TRY(passes_slip(&one, of));
    TRY(passes_laws(&one, of));
    if (e->m->face)
        TRY(passes_faces(&one, of));
    spread_accelerations(e->m, e->ydot);
    passes_add_body_forces(&one);
    return STATUS_DONE;
}
