/* ahead-bodies.c -- bodies in the solve for a pressure that looks ahead: their skins move as
 * (E4) predicts, one banded solve a body and product. */
#include "implicit/ahead.h"

#include "base/status.h"

#include <stdio.h>
#include <string.h>

int ahead_bodies_create(const struct plan *p, double (**push)[DIM])
{
    int points = 0;

    for (int i = 0; i < p->bodies; i++)
        points += p->body[i].skin;
    *push = status_alloc((size_t)points + 1, sizeof **push);
    return *push ? STATUS_DONE : STATUS_FAILED;
}

static int place(const struct moment *m, const struct moment_body *b, int j)
{
    return m->list->slot[particles_row_of(m->particles, m->particles->object[b->object].from + j)];
}

/* Accelerations of a body's points to their places. */
static void move(struct ahead *a, const struct moment_body *b)
{
    double (*point)[DIM] = a->m->work->points;

    for (int j = 0; j < b->skin; j++) {
        const int s = place(a->m, b, j);
        if (s >= 0)
            memcpy(a->vector + (size_t)s * NABLA_STRIDE, point[j], sizeof point[j]);
    }
}

int ahead_bodies_set(struct ahead *a, double t, const double *y)
{
    struct moment *m = a->m;

    for (int i = 0, from = 0; i < m->plan->bodies; from += m->body[i++].skin) {
        struct moment_body *b = &m->body[i];
        solids_skin(m, b);
        memcpy(a->push + from, b->force, (size_t)b->skin * sizeof *b->force);
        if (b->kind->role.ahead->set(b->body, b->work, &m->layout, t, a->tau, y) == STATUS_DONE)
            continue;
        status_clear();
        snprintf(m->refusal, sizeof m->refusal,
                 "the pressure that looks ahead has no acceleration of %s at t = %g s: with tau = %g s "
                 "its matrix M + tau D + tau^2 K is not finite; it has moved too far in too long "
                 "a step, or its mass and stiffness are out of all proportion",
                 m->plan->body[i].path, t, a->tau);
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

void ahead_bodies_drive(struct ahead *a)
{
    struct moment *m = a->m;

    for (int i = 0, from = 0; i < m->plan->bodies; from += m->body[i++].skin) {
        const struct moment_body *b = &m->body[i];
        b->kind->role.ahead->drive(b->body, b->work, (const double (*)[DIM])a->push + from,
                              m->work->points);
        move(a, b);
    }
}

/* By G P in work->f, which pulls where the pressure pushes: as of the fluid, its sign is that
 * of the system. */
void ahead_bodies_yield(struct ahead *a)
{
    struct moment *m = a->m;

    wet_take(m);
    for (int i = 0; i < m->plan->bodies; i++) {
        struct moment_body *b = &m->body[i];
        solids_skin(m, b);
        b->kind->role.ahead->yield(b->body, b->work, (const double (*)[DIM])b->force,
                              m->work->points);
        move(a, b);
    }
}
