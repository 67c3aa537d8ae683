/* moment.c -- a plan at one (t, y): its memory, and what is asked of it. */
#include "eval/face.h"
#include "eval/given.h"
#include "eval/share.h"
#include "plan/solver.h"
#include "space/list.h"

#include "base/status.h"
#include "state/particles-private.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- memory ---------------------------------------------------------------------- */

static int take_bodies(struct moment *m)
{
    const struct plan *p = m->plan;

    if (!(m->body = status_alloc((size_t)p->bodies + 1, sizeof *m->body)))
        return STATUS_FAILED;
    for (int i = 0; i < p->bodies; i++) {
        const struct plan_body *of = &p->body[i];
        m->body[i] = (struct moment_body){ .kind = of->kind, .body = of->body,
                                           .object = of->object, .skin = of->skin };
        m->body[i].force = status_alloc((size_t)of->points + 1, sizeof *m->body[i].force);
        if (!m->body[i].force)
            return STATUS_FAILED;
        TRY(of->kind->make.work(of->body, &m->body[i].work));
    }
    return STATUS_DONE;
}

static int take_memory(struct moment *m)
{
    const struct plan *p = m->plan;

    TRY(particles_create_beside(p->particles, &m->particles));
    TRY(take_bodies(m));
    m->force = status_alloc((size_t)(p->particles->objects + p->book.panels) + 1, sizeof *m->force);
    m->turn = status_alloc((size_t)p->book.panels + 1, sizeof *m->turn);
    m->meeting.body = status_alloc((size_t)p->bodies + 1, sizeof *m->meeting.body);
    m->meeting.wall = status_alloc((size_t)p->walls + 1, sizeof *m->meeting.wall);
    m->meeting.power = status_alloc((size_t)p->contacts.columns + 1, sizeof *m->meeting.power);
    if (!m->force || !m->turn || !m->meeting.body || !m->meeting.wall || !m->meeting.power)
        return STATUS_FAILED;
    if (p->contacts.kind && p->contacts.kind->work)
        TRY(p->contacts.kind->work(p->contacts.self, &m->meeting.work));
    if (p->particles->n > 0)
        TRY(p->engine->sum->list->create(&m->own, &p->list_def));
    m->list = m->own;
    return STATUS_DONE;
}

/* What a moment beside another shares with it. */
static int take_work(struct moment *m)
{
    TRY(workspace_create(m->plan, &m->work));
    TRY(face_create(m));
    if (plan_ahead(m->plan) > 0)
        TRY(implicit_ahead.create(m, &m->ahead));
    return m->plan->solver ? m->plan->solver->create(m, &m->solver) : STATUS_DONE;
}

static int create(const struct plan *plan, struct moment *beside, struct moment **out)
{
    struct moment *m = *out = status_alloc(1, sizeof *m);
    int status;

    if (!m)
        return STATUS_FAILED;
    m->plan = plan;
    m->beside = beside;
    m->layout = plan->layout;
    m->density[0] = plan->in.eos.lowest * plan->scales.rho0;
    m->density[1] = plan->in.eos.highest * plan->scales.rho0;
    status = take_memory(m);
    if (beside) {
        m->work = beside->work;
        m->face = beside->face;
        m->ahead = beside->ahead;
    } else if (status == STATUS_DONE) {
        status = take_work(m);
    }
    if (status != STATUS_DONE)
        moment_free(out);
    return status;
}

int moment_create(const struct plan *plan, struct moment **out)
{
    return create(plan, NULL, out);
}

int moment_create_beside(struct moment *run, struct moment **out)
{
    TRY(create(run->plan, run, out));
    moment_follow(*out, run);
    return STATUS_DONE;
}

static void free_body(struct moment_body *b)
{
    if (b->kind)
        b->kind->make.work_free(&b->work);
    free(b->force);
}

void moment_free(struct moment **moment)
{
    struct moment *m = *moment;

    if (!m)
        return;
    moment_free(&m->observer);
    given_free(&m->given);
    share_free(&m->share);
    if (!m->beside) {
        if (m->solver)
            m->plan->solver->free(&m->solver);
        implicit_ahead.free(&m->ahead);
        face_free(&m->face);
        workspace_free(m->plan, &m->work);
    }
    m->plan->engine->sum->list->free(&m->own);
    for (int i = 0; m->body && i < m->plan->bodies; i++)
        free_body(&m->body[i]);
    free(m->body);
    free(m->force);
    free(m->turn);
    free(m->meeting.body);
    free(m->meeting.wall);
    free(m->meeting.power);
    if (m->meeting.work)
        m->plan->contacts.kind->work_free(&m->meeting.work);
    particles_free(&m->particles);
    free(m);
    *moment = NULL;
}

/* --- anew ------------------------------------------------------------------------ */

static void forget_forces(struct moment *m)
{
    memset(m->force, 0,
           (size_t)(m->particles->objects + m->plan->book.panels) * sizeof *m->force);
    memset(m->turn, 0, (size_t)m->plan->book.panels * sizeof *m->turn);
    memset(m->pull, 0, sizeof m->pull);
    m->wall_power = 0;
    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        memset(b->force, 0, (size_t)m->plan->body[i].points * sizeof *b->force);
        b->load = (struct body_load){ 0 };
    }
}

/* Factors that bodies keep are functions of their gamma alone: they change no bit. */
void moment_restart(struct moment *m)
{
    if (m->observer)
        moment_restart(m->observer);
    if (m->own)
        list_forget(m->own);
    m->list = m->own;
    if (m->share)
        m->share->near.looked = false;
    wet_forget(m);
    forget_forces(m);
    if (m->given)
        m->given->known = false;
    if (m->solver)
        m->plan->solver->forget(m->solver);
    if (m->ahead && !m->beside)
        implicit_ahead.forget(m->ahead);
    m->refusal[0] = '\0';
    memset(m->culprit, 0, sizeof m->culprit);
}

int moment_renew(struct moment **moment)
{
    const struct plan *plan = (*moment)->plan;
    const struct moment_counts counts = (*moment)->counts;
    const long builds = (*moment)->own ? (*moment)->own->builds : 0;

    moment_free(moment);
    TRY(moment_create(plan, moment));
    (*moment)->counts = counts;
    if ((*moment)->own)
        (*moment)->own->builds = builds;
    return STATUS_DONE;
}

/* --- what is asked of it --------------------------------------------------------- */

const struct plan *moment_plan(const struct moment *m)
{
    return m->plan;
}

long moment_size(const struct moment *m)
{
    return layout_size(&m->layout);
}

const struct layout *moment_layout(const struct moment *m)
{
    return &m->layout;
}

int moment_stiff_ranges(const struct moment *m, int most, long (*range)[2])
{
    return plan_stiff_ranges(m->plan, &m->layout, most, range);
}

void moment_weights(const struct moment *m, double tol, double *weight)
{
    int rows[LAYOUT_ROWS];

    for (int i = 0; i < m->layout.rows; i++) {
        const int k = moment_kind(m, i);
        rows[i] = k < KINDS ? moment_rows_of(m, (enum kind)k) : m->layout.row[i].n;
    }
    layout_weights(&m->layout, tol, rows, weight);
}

const char *moment_entry(const struct moment *m, long i)
{
    static char text[96];
    const struct layout_row *r;
    int which = 0;

    r = layout_find(&m->layout, i, &which);
    if (r)
        snprintf(text, sizeof text, "%s, number %d", r->name,
                 moment_id(m, (int)(r - m->layout.row), which));
    return r ? text : "nothing";
}

const char *moment_refusal(const struct moment *m)
{
    return m->refusal;
}

const struct moment_counts *moment_counts(const struct moment *m)
{
    return &m->counts;
}

int moment_keep(struct moment *m, struct archive *a)
{
    struct moment_counts *c = &m->counts;

    TRY(archive_integers(a, "counts.rhs_explicit", &c->rhs_explicit, 1));
    TRY(archive_integers(a, "counts.rhs_implicit", &c->rhs_implicit, 1));
    TRY(archive_integers(a, "counts.passes", &c->passes, 1));
    TRY(archive_integers(a, "counts.solves", &c->solves, 1));
    TRY(archive_integers(a, "counts.products", &c->products, 1));
    TRY(archive_integers(a, "counts.rebuilds", &c->rebuilds, 1));
    TRY(archive_integers(a, "counts.settled", &c->settled, 1));
    TRY(archive_integers(a, "counts.looked", &c->looked, 1));
    TRY(archive_integers(a, "counts.refused", &c->refused, 1));
    TRY(archive_integers(a, "counts.iterations", &c->iterations, 1));
    TRY(archive_numbers(a, "counts.compression", &c->compression, 1));
    TRY(archive_numbers(a, "counts.gain", &c->gain, 1));
    TRY(archive_numbers(a, "counts.deepest", &c->deepest, 1));
    if (archive_fills(a) && m->own)
        m->own->builds = c->rebuilds;
    return STATUS_DONE;
}

void moment_solve_tolerance(struct moment *m, double tol)
{
    if (m->solver)
        m->plan->solver->exact(m->solver, tol);
}

const double *moment_force(const struct moment *m, int object)
{
    return m->force[object];
}

double moment_pairs(const struct moment *m)
{
    return m->own && m->own->stands ? list_entries(m->own) : 0;
}
