/* contacts.c -- rigid bodies that touch each other and walls: the rows that they remember in, and
 * the pass over all pairs. */
#include "bodies/contacts.h"

#include "base/status.h"
#include "bodies/contacts-list.h"
#include "bodies/contacts-place.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const column[] = { "contact", "friction", "uplift" };

static int columns(const struct contacts *c)
{
    return c->lifts > 0 ? 3 : 2;
}

static int rows(struct contacts *c, struct layout *l)
{
    double least = HUGE_VAL;

    for (int i = 0; i < c->pairs; i++)
        least = fmin(least, c->pair[i].depth);
    for (int i = 0; i < c->skins; i++)
        least = fmin(least, c->skin[i].depth);
    c->row = layout_add(l, LAYOUT_OTHER, "contacts.slip", "m", (int)c->places, DIM, 0.4 * least);
    return c->row < 0 ? STATUS_FAILED : STATUS_DONE;
}

static void start(const struct contacts *c, const struct layout *l, double *y)
{
    memset(y + layout_at(l, c->row), 0, (size_t)c->places * DIM * sizeof *y);
}

/* Skins do not touch each other. */
static bool parts(const struct contacts *c, int i, int j)
{
    return c->known[i] && c->known[j] && !(c->skinned[i] && c->skinned[j]);
}

/* Once a pass: a body may be of many pairs. */
static void place_bodies(const struct contacts *c, const struct contacts_moment *m)
{
    for (int i = 0; i < c->solids && c->part_of[i] < c->bodies; i++) {
        struct contacts_body *b = &m->body[c->part_of[i]];
        b->kind->role.solid->stand(b->body, m->layout, m->y, &b->at);
    }
}

/* Where solid i stands; of a wall or side in `room`. */
static const struct solid_place *place_of(const struct contacts *c,
                                          const struct contacts_moment *m, int i,
                                          struct solid_place *room)
{
    const int body = c->part_of[i];

    if (body < c->bodies)
        return &m->body[body].at;
    if (body == c->bodies + c->walls)
        *room = c->solid[i].start;
    else
        solid_carry(&m->wall[body - c->bodies].by, &c->solid[i].start, room);
    return room;
}

static struct body_push *push_of(const struct contacts *c, const struct contacts_moment *m, int i,
                                 struct body_push *aside)
{
    return c->part_of[i] < c->bodies ? &m->body[c->part_of[i]].push : aside;
}

/* Two that no contact can part: what went into what. */
static int fail(const char *first, const char *second, double t, char *text, size_t room)
{
    snprintf(text, room, "%s has gone into %s at t = %g s, further than its margin", first, second,
             t);
    return STATUS_FAILED;
}

static int meet_pair(const struct contacts *c, const struct contacts_moment *m,
                     const struct contacts_pair *p, const double *xi, double *xi_rate)
{
    struct solid_place at[2];
    struct body_push aside = { .force = { 0 } };
    const struct contacts_stand s = contacts_list_stand(c, place_of(c, m, p->first, &at[0]),
                                                        place_of(c, m, p->second, &at[1]));

    return contacts_pair_meet(p, &s, xi + p->from * DIM, xi_rate + p->from * DIM,
                              push_of(c, m, p->first, &aside), push_of(c, m, p->second, &aside),
                              m->power);
}

static int meet_skin(const struct contacts *c, const struct contacts_moment *m,
                     const struct contacts_skin *p, const double *xi, double *xi_rate)
{
    struct body_push aside = { .force = { 0 } };
    struct solid_place at;

    return contacts_skin_meet(p, &c->scales, &m->body[p->body], place_of(c, m, p->second, &at),
                              xi + p->from * DIM, xi_rate + p->from * DIM,
                              push_of(c, m, p->second, &aside), m->power);
}

/* The pair as its solid i has it: as the guest of the other. */
static void as_guest(const struct contacts *c, const struct contacts_moment *m,
                     const struct contacts_pair *p, int i, struct solid_place at[2],
                     struct contacts_guest *g)
{
    const int other = p->first == i ? p->second : p->first;
    const struct solid_place *here = place_of(c, m, i, &at[0]), *there = place_of(c, m, other, &at[1]);
    const struct contacts_stand s = contacts_list_stand(c, here, there);

    contacts_guest_make(g, &c->solid[i], here, &c->solid[other], there, s.apart);
}

/* Of two with uplift it is the first whose faces have it. */
static bool lifts(const struct contacts_pair *p, int i)
{
    return p->first == i || (p->second == i && !p->a->uplift);
}

static void lift(const struct contacts *c, const struct contacts_moment *m,
                 const struct contacts_lift *l)
{
    struct body_push aside = { .force = { 0 } };
    struct solid_place at[2];
    struct uplift_faces faces;
    struct contacts_guest g;

    contacts_uplift_read(l->of, place_of(c, m, l->solid, &at[0]),
                         (const double (*)[DIM])m->body[l->body].force, &faces);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < c->pairs; i++) {
            const struct contacts_pair *p = &c->pair[i];
            if (p->first != l->solid && p->second != l->solid)
                continue;
            as_guest(c, m, p, l->solid, at, &g);
            if (pass == 0)
                contacts_uplift_close(l->of, &g, &faces);
            else if (lifts(p, l->solid))
                contacts_uplift_push(l->of, &g, &faces, push_of(c, m, l->solid, &aside),
                                     push_of(c, m, p->first == l->solid ? p->second : p->first,
                                             &aside), &m->power[2]);
        }
}

static int meet(const struct contacts *c, const struct contacts_moment *m, char *text, size_t room)
{
    const double *xi = m->y + layout_at(m->layout, c->row);
    double *xi_rate = m->ydot + layout_at(m->layout, c->row);

    memset(m->power, 0, (size_t)columns(c) * sizeof *m->power);
    for (int i = 0; i < c->bodies; i++)
        m->body[i].push = (struct body_push){ .force = { 0 } };
    place_bodies(c, m);
    for (int i = 0; i < c->pairs; i++)
        if (meet_pair(c, m, &c->pair[i], xi, xi_rate) != STATUS_DONE)
            return fail(c->pair[i].a->path, c->pair[i].b->path, m->t, text, room);
    for (int i = 0; i < c->skins; i++)
        if (meet_skin(c, m, &c->skin[i], xi, xi_rate) != STATUS_DONE)
            return fail("a beam", c->skin[i].solid->path, m->t, text, room);
    for (int i = 0; i < c->lifts; i++)
        lift(c, m, &c->lift[i]);
    return STATUS_DONE;
}

static void keep(struct limit *out, double rate, const char *first, const char *second)
{
    if (!(rate > out->rate))
        return;
    out->rate = rate;
    snprintf(out->part, sizeof out->part, "%.28s at %.28s", first, second);
}

static void limit(const struct contacts *c, const struct contacts_moment *m, struct limit *out)
{
    struct solid_place at[2];

    place_bodies(c, m);
    for (int i = 0; i < c->pairs; i++) {
        const struct contacts_pair *p = &c->pair[i];
        const struct contacts_stand s = contacts_list_stand(c, place_of(c, m, p->first, &at[0]),
                                                            place_of(c, m, p->second, &at[1]));
        keep(out, contacts_pair_rate(p, &s), p->a->path, p->b->path);
    }
    for (int i = 0; i < c->skins; i++) {
        const struct contacts_skin *p = &c->skin[i];
        keep(out, contacts_skin_rate(p, &c->scales, &m->body[p->body],
                                     place_of(c, m, p->second, &at[0])), "a beam", p->solid->path);
    }
}

static const struct body_contacts solids = {
    .about = "solids, and skins of beams, that press and rub where they touch", .column = column,
    .columns = columns,
    .create = contacts_list_create, .free = contacts_list_free, .rows = rows, .start = start, .parts = parts,
    .meet = meet, .limit = limit,
};

const struct body_contacts *const bodies_contacts = &solids;
