/* contacts.c -- which bodies and walls may touch: a plan's contacts, if it has any. */
#include "plan/inside.h"

#include "base/status.h"

#include <stdlib.h>

static int create_contacts(struct plan *p, struct contacts_body *body, struct contacts_wall *wall,
                           struct contacts_rule *rule)
{
    const struct contacts_scene scene = { .scales = &p->scales, .bodies = p->bodies, .body = body,
                                          .walls = p->in.wall_count, .wall = wall,
                                          .rules = p->in.pairs.n, .rule = rule };

    for (int i = 0; i < p->bodies; i++)
        body[i] = (struct contacts_body){ .kind = p->body[i].kind, .body = p->body[i].body,
                                          .path = p->body[i].path, .points = p->body[i].skin };
    for (int i = 0; i < p->in.wall_count; i++)
        wall[i] = (struct contacts_wall){ .path = p->in.wall[i].path,
                                          .shape = &p->in.wall[i].set.shape };
    for (int i = 0; i < p->in.pairs.n; i++) {
        const struct input_contact *c = &p->in.pairs.of[i];
        rule[i] = (struct contacts_rule){ .name = c->name, .where = c->where, .of = c->set.of,
                                          .with = c->set.with, .friction = c->set.friction,
                                          .restitution = c->set.restitution };
    }
    return bodies_contacts->create(&scene, &p->contacts.self);
}

int plan_contacts_make(struct plan *p)
{
    struct plan_contacts *c = &p->contacts;
    struct contacts_body *body;
    struct contacts_wall *wall;
    struct contacts_rule *rule;
    int code = STATUS_FAILED;

    if (!bodies_contacts || p->bodies == 0)
        return STATUS_DONE;
    body = status_alloc((size_t)p->bodies, sizeof *body);
    wall = status_alloc((size_t)p->in.wall_count + 1, sizeof *wall);
    rule = status_alloc((size_t)p->in.pairs.n + 1, sizeof *rule);
    if (body && wall && rule)
        code = create_contacts(p, body, wall, rule);
    free(body);
    free(wall);
    free(rule);
    if (code != STATUS_DONE || !c->self)
        return code;
    c->kind = bodies_contacts;
    c->columns = c->kind->columns(c->self);
    return STATUS_DONE;
}
