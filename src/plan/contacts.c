/* contacts.c -- which bodies and walls may touch: a plan's contacts, if it has any. */
#include "plan/inside.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct contacts_rule rule_of(const struct input_contact *c)
{
    const struct settings_contact *s = &c->set;
    struct contacts_rule r = { .name = c->name, .where = c->where, .of = s->of, .with = s->with,
                               .friction = s->friction, .restitution = s->restitution,
                               .law = strcmp(s->law, "hertz-mindlin") == 0 ? CONTACTS_HERTZ_MINDLIN
                                    : strcmp(s->law, "soft") == 0 ? CONTACTS_SOFT : CONTACTS_AS_OTHERS };

    r.material[0] = (struct touch_material){ s->young, s->poisson };
    r.material[1] = (struct touch_material){ s->young_with > 0 ? s->young_with : s->young,
                                             isnan(s->poisson_with) ? s->poisson : s->poisson_with };
    return r;
}

static int create_contacts(struct plan *p, struct contacts_body *body, struct contacts_wall *wall,
                           struct contacts_rule *rule)
{
    const struct contacts_scene scene = { .scales = &p->scales, .bodies = p->bodies, .body = body,
                                          .walls = p->in.wall_count, .wall = wall,
                                          .rules = p->in.pairs.n, .rule = rule };

    for (int i = 0; i < p->bodies; i++)
        body[i] = (struct contacts_body){ .kind = p->body[i].kind, .body = p->body[i].body,
                                          .path = p->body[i].path, .where = p->in.body[i].where,
                                          .points = p->body[i].skin };
    for (int i = 0; i < p->in.wall_count; i++)
        wall[i] = (struct contacts_wall){ .path = p->in.wall[i].path, .where = p->in.wall[i].where,
                                          .shape = &p->in.wall[i].set.shape };
    for (int i = 0; i < p->in.pairs.n; i++)
        rule[i] = rule_of(&p->in.pairs.of[i]);
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
