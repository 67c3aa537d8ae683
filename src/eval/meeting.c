/* meeting.c -- bodies that stand in walls or in each other, where no contact keeps them apart.
 *
 * The face of a body is half a spacing before the points of its skin, and that of a wall
 * half a spacing before its particles: two that touch are a spacing apart.  They have met
 * when a point is behind the face of a wall, or nearer than half a spacing to a point of
 * another body. */
#include "eval/block.h"
#include "eval/inside.h"

#include "base/status.h"
#include "state/period.h"

#include <math.h>

static const double near_bodies = 0.5; /* [dx] */

/* Where point j of the skin of body i is now. */
static const double *point(const struct moment *m, int i, int j)
{
    const struct particles *all = m->particles;

    return all->x[particles_row_of(all, all->object[m->body[i].object].from + j)];
}

static int points(const struct moment *m, int i)
{
    return m->body[i].object < 0 ? 0 : m->particles->object[m->body[i].object].n;
}

static int refuse(const struct moment *m, int body, int other, double t, const double *x)
{
    const struct plan *p = m->plan;

    return status_fail_with(STATUS_FAILED, (struct status_advice){
                                .cause = "No contact keeps the two apart",
                                .remedy = "let a beam touch what it meets (contact = true), let the "
                                          "run end before that (until), leave them more room, or make what bends "
                                          "stiffer" },
                            "%s has met %s.%s: at t = %g s a part of it is inside, near (%g, %g) m",
                            p->body[body].path, plan_object_group(p, other),
                            m->particles->object[other].name, t, x[0], x[1]);
}

static bool is_held(const struct moment *m, int i, int j)
{
    const struct body_watch *watch = m->body[i].kind->watch;

    return watch && watch->held && watch->held(m->body[i].body, j);
}

/* By a contact, body i and body j, or wall j - bodies. */
static bool kept_apart(const struct plan *p, int i, int j)
{
    return p->contacts.kind && p->contacts.kind->parts(p->contacts.self, i, j);
}

static int check_wall(const struct moment *m, int wall, double t)
{
    const struct plan *p = m->plan;
    struct block block;
    double x[DIM];

    block_make(&block, p, wall, t);
    for (int i = 0; i < p->bodies; i++)
        for (int j = 0; j < points(m, i) && !kept_apart(p, i, p->bodies + wall); j++) {
            period_home(&p->scales, point(m, i, j), x);
            if (block_holds(&block, x, 0) && !is_held(m, i, j))
                return refuse(m, i, p->wall[wall].object, t, x);
        }
    return STATUS_DONE;
}

/* The box around the points of body i, and near_bodies around that. */
static void bounds(const struct moment *m, int i, double *low, double *high)
{
    const double reach = near_bodies * m->plan->scales.dx;

    for (int d = 0; d < DIM; d++) {
        low[d] = HUGE_VAL;
        high[d] = -HUGE_VAL;
        for (int j = 0; j < points(m, i); j++) {
            low[d] = fmin(low[d], point(m, i, j)[d] - reach);
            high[d] = fmax(high[d], point(m, i, j)[d] + reach);
        }
    }
}

/* Where a direction repeats its bounds tell nothing. */
static bool outside(const struct scales *s, const double *x, const double *low, const double *high)
{
    for (int d = 0; d < DIM; d++)
        if (!(s->period[d] > 0) && !(low[d] <= x[d] && x[d] <= high[d]))
            return true;
    return false;
}

static int check_pair(const struct moment *m, int a, int b, double t)
{
    const struct scales *s = &m->plan->scales;
    const double reach = near_bodies * s->dx;
    double low[DIM], high[DIM];

    bounds(m, b, low, high);
    for (int i = 0; i < points(m, a); i++) {
        const double *x = point(m, a, i);
        for (int j = 0; j < points(m, b) && !outside(s, x, low, high); j++)
            if (period_square(s, x, point(m, b, j), DIM) < reach * reach)
                return refuse(m, a, m->body[b].object, t, x);
    }
    return STATUS_DONE;
}

int observe_meeting(struct moment *m, double t, const double *y)
{
    const struct plan *p = m->plan;
    struct view v;

    if (p->bodies == 0)
        return STATUS_DONE;
    moment_view(m, t, y, &v);
    for (int i = 0; i < p->walls; i++)
        TRY(check_wall(m, i, t));
    for (int a = 0; a < p->bodies; a++)
        for (int b = a + 1; b < p->bodies; b++)
            if (!kept_apart(p, a, b))
                TRY(check_pair(m, a, b, t));
    return STATUS_DONE;
}
