/* observe.c -- looking at a run without disturbing it. */
#include "eval/given.h"
#include "eval/share.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

/* The first look makes the moment to look through: a run takes at its start what it may
 * need later. */
static struct moment *observer(struct moment *run)
{
    if (!run->observer && moment_create_beside(run, &run->observer) != STATUS_DONE)
        return NULL;
    return run->observer;
}

/* Densities out of bounds are looked at all the same: a view shows what is there. */
static void look_at_sums(struct moment *run, double t, const double *y, struct view *v)
{
    struct moment *o = observer(run);

    if (o)
        rates_fields(o, t, y, v);
    else
        moment_view(run, t, y, v);
    for (int k = 0; k < KINDS; k++) /* a position that is not finite has no sums */
        if (!v->rho[k])
            v->rho[k] = run->work->rho + run->particles->from[k];
}

void observe_fluid(struct moment *run, double t, const double *y, struct view *v)
{
    if (run->plan->passes.fields > 0)
        look_at_sums(run, t, y, v);
    else
        moment_view(run, t, y, v);
}

bool observe_each(const struct moment *run)
{
    return moment_is_full(run) && run->plan->passes.fields > 0;
}

void observe_own(struct moment *run, double t, const double *y, struct view *v)
{
    observe_fluid(run, t, y, v);
    v->others = particles_count(v->p, KIND_FLUID) - moment_rows_of(run, KIND_FLUID);
}

void observe_view(struct moment *run, double t, const double *y, struct view *v)
{
    observe_fluid(run, t, y, v);
    if (run->plan->passes.fields == 0)
        moment_press(run, v);
}

int observe_forces(struct moment *run, double t, const double *y)
{
    struct moment *o = observer(run);
    int status = o ? STATUS_DONE : STATUS_FAILED;

    if (moment_is_packed(run))
        status = moment_agree(run, status);
    TRY(status);
    status = moment_is_packed(run) ? share_look(o, t, y)
                                   : rates_eval(o, &ASK_ALL, t, y, o->work->rates, NULL, NULL);
    return status == STATUS_DONE ? status : status_fail(STATUS_FAILED, "%s", o->refusal);
}

/* Did a step whose pressure was solved for give these forces? */
static bool is_given(const struct moment *run)
{
    return run->given && run->given->known;
}

const double *observe_force(const struct moment *run, int object)
{
    return is_given(run) ? run->given->force[object] : moment_force(run->observer, object);
}

void observe_panel(const struct moment *run, int panel, struct observe_panel *out)
{
    const double *force = observe_force(run, run->particles->objects + panel);
    const double *turn = is_given(run) ? run->given->turn[panel] : run->observer->turn[panel];
    const double *along = run->plan->book.panel[panel].along;
    double size = 0;

    *out = (struct observe_panel){ .drag = 0 };
    memcpy(out->force, force, sizeof out->force);
    memcpy(out->turn, turn, sizeof out->turn);
    for (int d = 0; d < DIM; d++) {
        out->drag += force[d] * along[d];
        size += fabs(along[d]);
    }
    if (!(size > 0))
        out->drag = NAN;
}

static const struct moment_body *seen(const struct moment *run, int body)
{
    return &(run->observer ? run->observer : run)->body[body];
}

static const double (*forces_on(const struct moment *run, int body))[DIM]
{
    return (const double (*)[DIM])(is_given(run) ? run->body[body].force : seen(run, body)->force);
}

void observe_body(const struct moment *run, int body, double t, const double *y,
                  struct body_view *out)
{
    const struct moment_body *b = seen(run, body);

    b->kind->show(b->body, b->work, &run->layout, t, y, forces_on(run, body), out);
}

void observe_pose(const struct moment *run, int body, const double *y, struct body_pose *out)
{
    const struct moment_body *b = seen(run, body);

    b->kind->watch->pose(b->body, b->work, &run->layout, y, forces_on(run, body), out);
}

void observe_stand(const struct moment *run, int body, const double *y, struct solid_place *out)
{
    const struct moment_body *b = seen(run, body);

    b->kind->role.solid->stand(b->body, &run->layout, y, out);
}

int observe_escaped(struct moment *run, double t, const double *y)
{
    struct view v;
    int n = 0;

    moment_view(run, t, y, &v);
    for (int i = 0; i < particles_count(v.p, KIND_FLUID); i++)
        n += !list_inside(&run->plan->list_def, v.x[KIND_FLUID] + (size_t)i * DIM);
    return n;
}

/* The row of the fluid particle that moves fastest, and its speed [m/s]. */
static int fastest(const struct view *v, double *speed)
{
    int particle = -1;

    *speed = 0;
    for (int id = 0; id < particles_count(v->p, KIND_FLUID); id++) {
        const int i = particles_row(v->p, KIND_FLUID, id);
        const double *u = v->u[KIND_FLUID] + (size_t)i * DIM;
        double u2 = 0;
        for (int d = 0; d < DIM; d++)
            u2 += u[d] * u[d];
        if (!(u2 > *speed * *speed))
            continue;
        *speed = sqrt(u2);
        particle = i;
    }
    return particle;
}

bool observe_may_run_away(const struct moment *m, double speed)
{
    const double rounding = 1e-9;

    return speed * (1 + rounding) > m->plan->in.eos.fastest * m->plan->scales.c0;
}

int observe_runaway(struct moment *m, double t, const double *y)
{
    char place[PLAN_PLACE];
    const struct plan *p = m->plan;
    struct view v;
    double speed;
    int i, particle;

    moment_view(m, t, y, &v);
    i = fastest(&v, &speed);
    if (!(speed > p->in.eos.fastest * p->scales.c0))
        return STATUS_DONE;
    moment_place(m, &v, i, place);
    particle = particles_id_of(v.p, i);
    moment_note(m, MOMENT_TOO_FAST, particle, t);
    return status_fail_with(STATUS_FAILED,
                            (struct status_advice){
                                .remedy = "take a higher eos.c0 if that speed is real" },
                            "the fluid has run away: at t = %g s particle %d (%s) at %s m moves "
                            "at %.4g m/s, %.3g times the sound speed of %g m/s (eos.fastest = %g)",
                            t, particle, v.p->object[v.p->object_of[i]].name, place, speed,
                            speed / p->scales.c0, p->scales.c0, p->in.eos.fastest);
}

int observe_judge(const struct moment *m, int body, double t, const double *y, char *doubt,
                  size_t room)
{
    const struct moment_body *b = &m->body[body];

    doubt[0] = '\0';
    if (!b->kind->watch || !b->kind->watch->judge)
        return STATUS_DONE;
    return b->kind->watch->judge(b->body, &m->layout, t, y, doubt, room);
}

/* Own rows, own solids with the densities that they show. */
static void view_own(struct moment *run, double t, const double *y, struct view *v)
{
    moment_view(run, t, y, v);
    press_together(run, v);
    v->mine = run->share->mine;
}

void observe_near(struct moment *run, double t, const double *y, struct view *v)
{
    const struct moment_share *s = run->share;

    if (!moment_is_packed(run)) {
        observe_fluid(run, t, y, v);
        return;
    }
    moment_view(run, t, y, v);
    v->x[KIND_FLUID] = s->now.x; /* own ones, too: share_look() */
    v->others = particles_count(v->p, KIND_FLUID) - moment_rows_of(run, KIND_FLUID);
    v->mine = s->mine;
    v->near = s->near.seen;
    v->nears = s->near.seen_n;
}

void observe_sheet(struct moment *run, double t, const double *y, struct book_sheet *sheet)
{
    struct view v;

    if (moment_is_packed(run))
        view_own(run, t, y, &v);
    else
        observe_view(run, t, y, &v);
    book_read(run->plan, &run->layout, run->body, &v, y, sheet);
}
