/* limit.c -- the largest explicit step: the fastest wave and the fastest decay
 * of all parts, by name. */
#include "eval/share.h"

#include <math.h>
#include <stdio.h>

static void keep_fastest(const struct limit *one, const char *name, struct limit limit[2])
{
    struct limit *best = &limit[one->decay ? 1 : 0];

    if (!(one->rate > best->rate))
        return;
    *best = *one;
    if (name != one->part)
        snprintf(best->part, sizeof best->part, "%.63s", name);
}

static void keep_body(const struct plan_body *b,
                      void (*of)(const struct body *, struct limit *), struct limit limit[2])
{
    struct limit one = { .where = -1 };

    of(b->body, &one);
    keep_fastest(&one, b->path, limit);
}

static void keep_contacts(struct moment *m, double t, const double *y, struct limit limit[2])
{
    struct limit one = { .where = -1 };
    const struct contacts_moment now = touching_now(m, t, y);

    m->plan->contacts.kind->limit(m->plan->contacts.self, &now, &one);
    keep_fastest(&one, one.part, limit);
}

static void begin(struct limit limit[2])
{
    limit[0] = (struct limit){ .where = -1 };
    limit[1] = (struct limit){ .where = -1, .decay = true };
}

static void keep_parts(struct moment *m, double t, const double *y, bool stiff,
                       struct limit limit[2])
{
    const struct plan *p = m->plan;
    struct limit one[p->parts + 1];
    struct view v;
    int of[p->parts + 1], n = 0;

    observe_own(m, t, y, &v);
    for (int i = 0; i < p->parts; i++) {
        if (!p->part[i].part->limit || (&p->part[i] == p->stiff && !stiff))
            continue;
        one[n] = (struct limit){ .where = -1, .found = -HUGE_VAL };
        p->part[i].part->limit(p->part[i].self, &v, &one[n]);
        of[n++] = i;
    }
    share_limits(m, n, one);
    for (int k = 0; k < n; k++)
        keep_fastest(&one[k], p->part[of[k]].part->name, limit);
}

static void keep_bodies(struct moment *m, double t, const double *y, bool stiff,
                        struct limit limit[2])
{
    const struct plan *p = m->plan;

    for (int i = 0; i < p->bodies; i++) {
        const struct plan_body *b = &p->body[i];
        if (b->kind->limit)
            keep_body(b, b->kind->limit, limit);
        if (b->kind->implicit && stiff)
            keep_body(b, b->kind->implicit->limit, limit);
    }
    if (p->contacts.kind && p->contacts.kind->limit)
        keep_contacts(m, t, y, limit);
}

void moment_limit(struct moment *m, double t, const double *y, bool stiff, struct limit limit[2])
{
    begin(limit);
    keep_parts(m, t, y, stiff, limit);
    keep_bodies(m, t, y, stiff, limit);
}

void moment_fluid_limit(struct moment *m, double t, const double *y, struct limit limit[2])
{
    begin(limit);
    keep_parts(m, t, y, false, limit);
}

void moment_rigid_limit(struct moment *m, double t, const double *y, struct limit limit[2])
{
    begin(limit);
    keep_bodies(m, t, y, false, limit);
}

void moment_contact_limit(struct moment *m, double t, const double *y, struct limit *out)
{
    struct limit limit[2];

    begin(limit);
    if (m->plan->contacts.kind && m->plan->contacts.kind->limit)
        keep_contacts(m, t, y, limit);
    *out = limit[0];
}

void moment_swing(const struct moment *m, double most, struct limit *out)
{
    const struct plan *p = m->plan;

    *out = (struct limit){ .where = -1 };
    for (int i = 0; i < p->bodies; i++) {
        const struct plan_body *b = &p->body[i];
        const double rate = b->kind->implicit && b->kind->implicit->swing
                          ? b->kind->implicit->swing(b->body) : 0;
        if (!(rate > out->rate && rate <= most))
            continue;
        out->rate = rate;
        snprintf(out->part, sizeof out->part, "%.50s, first mode", b->path);
    }
}
