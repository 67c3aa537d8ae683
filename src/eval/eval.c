/* eval.c -- the one right-hand side, and its implicit side. */
#include "eval/inside.h"
#include "plan/solver.h"

#include "base/status.h"

#include <stdio.h>
#include <stdlib.h>

static void add_stiff(struct moment *m, double t, const double *y, double *ydot)
{
    for (int i = 0; i < m->plan->bodies; i++) {
        const struct moment_body *b = &m->body[i];
        if (b->kind->implicit)
            b->kind->implicit->stiff(b->body, b->work, &m->layout, t, y, ydot);
    }
}

static int count_pass(struct moment *m, int status)
{
    m->counts.passes++;
    m->counts.refused += status != STATUS_DONE;
    m->counts.rebuilds = m->own ? m->own->builds : 0;
    return status;
}

static int implicit_side(struct moment *m, double t, const double *y, double *ydot)
{
    m->counts.rhs_implicit++;
    moment_clear(m, 0, moment_size(m), ydot);
    if (m->solver)
        TRY(count_pass(m, m->plan->solver->rates(m, t, y, ydot)));
    add_stiff(m, t, y, ydot);
    return STATUS_DONE;
}

/* Either side by itself, or both added up. */
static int one_vector(struct moment *m, const struct ask *ask, double t, const double *y,
                      double *ydot)
{
    if (ask->sides == ASK_IMPLICIT)
        return implicit_side(m, t, y, ydot);
    m->counts.rhs_explicit += ask->rates != ASK_DENSITIES;
    TRY(count_pass(m, rates_eval(m, ask, t, y, ydot, NULL, NULL)));
    if (ask->sides & ASK_IMPLICIT)
        add_stiff(m, t, y, ydot);
    return STATUS_DONE;
}

/* Both sides, each for itself. */
static int two_vectors(struct moment *m, const struct ask *ask, double t, const double *y,
                       double *ydot)
{
    if (!m->solver) {
        TRY(one_vector(m, &ASK_EXPLICIT_SIDE, t, y, ydot));
        return one_vector(m, &ASK_IMPLICIT_SIDE, t, y, ask->apart);
    }
    m->counts.rhs_explicit++;
    m->counts.rhs_implicit++;
    TRY(count_pass(m, m->plan->solver->sides(m, t, y, ydot, ask->apart)));
    add_stiff(m, t, y, ask->apart);
    return STATUS_DONE;
}

void moment_quit(struct moment *m, bool (*quit)(void))
{
    m->quit = quit;
}

int moment_eval(struct moment *m, struct ask ask, double t, const double *y, double *ydot)
{
    if (m->quit && m->quit()) {
        snprintf(m->refusal, sizeof m->refusal, "a signal asked to stop");
        return STATUS_FAILED;
    }
    return ask.apart ? two_vectors(m, &ask, t, y, ydot) : one_vector(m, &ask, t, y, ydot);
}

int moment_solve(struct moment *m, double t, double gamma, const double *r, double *z)
{
    m->counts.solves++;
    if (m->solver) {
        const int status = m->plan->solver->solve(m, t, gamma, r, z);
        m->counts.refused += status != STATUS_DONE;
        m->counts.rebuilds = m->own->builds;
        return status;
    }
    for (int i = 0; i < m->plan->bodies; i++) {
        const struct moment_body *b = &m->body[i];
        if (b->kind->implicit)
            TRY(b->kind->implicit->solve(b->body, b->work, &m->layout, t, gamma, r, z));
    }
    return STATUS_DONE;
}

void moment_body_book(struct moment *m, double t, const double *y, double share, double *ydot)
{
    const struct plan *p = m->plan;
    double *book = ydot + layout_at(&m->layout, p->book.row);

    for (int i = 0; i < p->bodies; i++) {
        struct body_load load;

        if (!plan_body_stiff(p, i)) /* moved by the right-hand sides themselves */
            continue;
        touching_load(m, i, t, y, m->work->rates, &load);
        book_add_load(p, i, share, &load, book);
    }
}

int moment_try(struct moment *m, double t, const double *y, struct moment_trial *was)
{
    double *ydot = status_alloc((unsigned long)moment_size(m), sizeof *ydot);
    int status = moment_agree(m, ydot ? STATUS_DONE : STATUS_FAILED);

    *was = (struct moment_trial){ m->counts, m->own ? m->own->builds : 0 };
    if (status == STATUS_DONE)
        status = moment_eval(m, ASK_ALL, t, y, ydot);
    free(ydot);
    return status;
}

void moment_tried(struct moment *m, const struct moment_trial *was)
{
    moment_restart(m);
    m->counts = was->counts;
    if (m->own)
        m->own->builds = was->builds;
}
