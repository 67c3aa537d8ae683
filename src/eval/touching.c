/* touching.c -- bodies and walls as contacts see them. */
#include "eval/inside.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

enum { UP = DIM - 1 };

/* How the frame moves that a wall is carried along with, which stood at the origin.  Its
 * surface may slide beside its particles, as that of a belt. */
static void carry(const struct plan *p, int i, double t, struct solid_place *to)
{
    const struct plan_wall *w = &p->wall[i];
    const double origin[DIM] = { 0 };
    struct motion_place place;

    motion_at(&w->motion, t, &place);
    motion_point(&w->motion, &place, origin, to->x, to->v);
    memset(to->R, 0, sizeof to->R);
    memset(to->spin, 0, sizeof to->spin);
    for (int d = 0; d < DIM; d++) {
        to->R[d][d] = d == 0 || d == UP ? place.cosine : 1;
        to->v[d] += p->particles->object[w->object].slide[d];
    }
    to->R[0][UP] = -place.sine;
    to->R[UP][0] = place.sine;
    if (DIM == 2)
        to->spin[0] = place.omega;
    else
        to->spin[1] = -place.omega; /* from x to the last is clockwise about y */
}

static void set_body(const struct moment *m, int i, struct contacts_body *to)
{
    const struct particles *all = m->particles;
    const struct moment_body *b = &m->body[i];
    const int from = b->skin > 0 ? all->object[b->object].from : 0;

    *to = (struct contacts_body){ .kind = b->kind, .body = b->body, .points = b->skin,
                                  .x = (const double (*)[DIM])(all->x + from),
                                  .u = (const double (*)[DIM])(all->u + from),
                                  .force = b->force };
}

struct contacts_moment touching_now(struct moment *m, double t, const double *y)
{
    const struct plan *p = m->plan;

    for (int i = 0; i < p->bodies; i++)
        set_body(m, i, &m->meeting.body[i]);
    for (int i = 0; i < p->walls; i++)
        carry(p, i, t, &m->meeting.wall[i].by);
    return (struct contacts_moment){ .layout = &m->layout, .t = t, .y = y, .body = m->meeting.body,
                                     .wall = m->meeting.wall, .power = m->meeting.power,
                                     .work = m->meeting.work, .looked = &m->counts.looked,
                                     .deepest = &m->counts.deepest };
}

void touching_load(const struct moment *m, int i, double t, const double *y, double *ydot,
                   struct body_load *out)
{
    const struct moment_body *b = &m->body[i];

    b->kind->load(b->body, b->work, &m->layout, t, y, (const double (*)[DIM])b->force, ydot, out);
    for (int d = 0; d < DIM && m->plan->contacts.kind && !b->kind->role.solid; d++)
        out->support[d] += m->meeting.body[i].push.by_walls[d];
}

bool moment_lacks(struct moment *m, double t, const double *y)
{
    const struct plan_contacts *c = &m->plan->contacts;
    struct contacts_moment now;

    if (!c->kind || !c->kind->seats)
        return false;
    now = touching_now(m, t, y);
    return c->kind->seats->lack(c->self, &now);
}

int moment_settle(struct moment *m, double t, double *y)
{
    const struct plan_contacts *c = &m->plan->contacts;
    const struct contacts_moment now = touching_now(m, t, y);
    char text[sizeof m->refusal];

    m->counts.settled++;
    if (c->kind->seats->settle(c->self, &now, y, text, sizeof text) == STATUS_DONE)
        return STATUS_DONE;
    return status_fail(STATUS_FAILED, "%s", text);
}

long moment_tidy(const struct moment *m, double *y)
{
    const struct plan_contacts *c = &m->plan->contacts;

    return c->kind && c->kind->seats ? c->kind->seats->tidy(c->self, &m->layout, y)
                                     : layout_size(&m->layout);
}
