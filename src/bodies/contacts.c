/* contacts.c -- rigid bodies that touch each other and walls: the rows that they remember in, and
 * the pass over all pairs. */
#include "bodies/contacts.h"

#include "base/status.h"
#include "bodies/contacts-list.h"
#include "bodies/contacts-near.h"
#include "bodies/contacts-place.h"
#include "bodies/contacts-seats.h"

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
    for (int i = 0; i < c->beams; i++)
        least = fmin(least, c->beam[i].depth);
    c->seats.scale = 0.4 * least;
    c->row = layout_add(l, LAYOUT_OTHER, "contacts.slip", "m", (int)c->places, DIM, c->seats.scale);
    if (c->row >= 0 && c->seats.n > 0)
        c->seats.row = layout_add(l, LAYOUT_OTHER, "contacts.seat", "1", c->seats.n, 1, 0);
    return c->row < 0 || c->seats.row < 0 ? STATUS_FAILED : STATUS_DONE;
}

static void start(const struct contacts *c, const struct layout *l, double *y)
{
    memset(y + layout_at(l, c->row), 0, (size_t)c->places * DIM * sizeof *y);
    if (c->seats.n > 0)
        memcpy(y + layout_at(l, c->seats.row), c->seats.first, (size_t)c->seats.n * sizeof *y);
}

static bool parts(const struct contacts *c, int i, int j)
{
    return c->known[i] && c->known[j];
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

static int meet_pair(const struct contacts *c, const struct contacts_moment *m, int i,
                     const double *xi, double *xi_rate)
{
    const struct contacts_pair *p = &c->pair[i];
    const long from = contacts_seats_at(c, m->work, i);
    struct solid_place at[2];
    struct body_push aside = { .force = { 0 } };
    const struct contacts_stand s = contacts_list_stand(
        c, contacts_near_of(c, m, p->first, &at[0]), contacts_near_of(c, m, p->second, &at[1]));

    if (from < 0) /* a shorter step ends before they touch, where they get a seat */
        return contacts_pair_gap(p, &s, 0) < 0 ? STATUS_FAILED : STATUS_DONE;
    return contacts_pair_meet(p, &s, xi + from * DIM, xi_rate + from * DIM, &m->work->spots,
                              push_of(c, m, p->first, &aside), push_of(c, m, p->second, &aside),
                              m->power, m->deepest);
}

static int refuse_pair(const struct contacts *c, const struct contacts_moment *m, int i, char *text,
                       size_t room)
{
    const struct contacts_pair *p = &c->pair[i];

    if (contacts_seats_at(c, m->work, i) >= 0)
        return fail(p->a->path, p->b->path, m->t, text, room);
    snprintf(text, room, "%s touches %s at t = %g s, a step too long: it came from farther away than "
             "bodies get a seat for their contact at", p->a->path, p->b->path, m->t);
    return STATUS_FAILED;
}

static int meet_pairs(const struct contacts *c, const struct contacts_moment *m, const double *xi,
                      double *xi_rate, char *text, size_t room)
{
    const struct contacts_work *w = m->work;

    for (int k = 0; k < w->near; k++)
        if (meet_pair(c, m, w->pair[k], xi, xi_rate) != STATUS_DONE)
            return refuse_pair(c, m, w->pair[k], text, room);
    return STATUS_DONE;
}

static int meet_skin(const struct contacts *c, const struct contacts_moment *m,
                     const struct contacts_skin *p, const double *xi, double *xi_rate)
{
    struct body_push aside = { .force = { 0 } };
    struct solid_place at;

    return contacts_skin_meet(p, &c->scales, &m->body[p->body], contacts_near_of(c, m, p->second, &at),
                              xi + p->from * DIM, xi_rate + p->from * DIM,
                              push_of(c, m, p->second, &aside), m->power);
}

/* The pair as its solid i has it: as the guest of the other. */
static void as_guest(const struct contacts *c, const struct contacts_moment *m,
                     const struct contacts_pair *p, int i, struct solid_place at[2],
                     struct contacts_guest *g)
{
    const int other = p->first == i ? p->second : p->first;
    const struct solid_place *here = contacts_near_of(c, m, i, &at[0]), *there = contacts_near_of(c, m, other, &at[1]);
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

    contacts_uplift_read(l->of, contacts_near_of(c, m, l->solid, &at[0]),
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
    int status;

    memset(m->power, 0, (size_t)columns(c) * sizeof *m->power);
    for (int i = 0; i < c->bodies; i++)
        m->body[i].push = (struct body_push){ .force = { 0 } };
    for (long i = 0; i < c->places; i++)
        touch_forget(xi + i * DIM, xi_rate + i * DIM);
    for (int k = 0; k < c->seats.n; k++)
        m->ydot[layout_at(m->layout, c->seats.row) + k] = 0;
    contacts_near_place(c, m);
    contacts_near_find(c, m, 0);
    *m->looked += m->work->near;
    contacts_seats_open(c, m);
    status = meet_pairs(c, m, xi, xi_rate, text, room);
    contacts_seats_close(c, m);
    TRY(status);
    for (int i = 0; i < c->skins; i++)
        if (meet_skin(c, m, &c->skin[i], xi, xi_rate) != STATUS_DONE)
            return fail("a beam", c->skin[i].solid->path, m->t, text, room);
    for (int i = 0; i < c->beams; i++) {
        const struct contacts_beams *p = &c->beam[i];
        if (contacts_beams_meet(p, &c->scales, &m->body[p->body], &m->body[p->other],
                                xi + p->from * DIM, xi_rate + p->from * DIM, m->power) != STATUS_DONE)
            return fail("a beam", "another beam", m->t, text, room);
    }
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

/* From how far away some pair may want shorter steps [m]. */
static double window(const struct contacts *c, const struct contacts_moment *m)
{
    double fastest = 0;

    for (int i = 0; i < c->movers; i++) {
        const struct solid_place *at = &m->body[c->part_of[i]].at;
        double v2 = 0, spin2 = 0;
        for (int d = 0; d < DIM; d++)
            v2 += at->v[d] * at->v[d];
        for (int k = 0; k < TURNING_SPINS; k++)
            spin2 += at->spin[k] * at->spin[k];
        fastest = fmax(fastest, sqrt(v2) + sqrt(spin2) * core_reach(&c->solid[i].core));
    }
    return touch_window(c->slow, 2 * fastest);
}

static void limit(const struct contacts *c, const struct contacts_moment *m, struct limit *out)
{
    const struct contacts_pair *always = c->always < 0 ? NULL : &c->pair[c->always];
    struct solid_place at[2];

    contacts_near_place(c, m);
    contacts_near_find(c, m, window(c, m));
    if (always)
        keep(out, always->always, always->a->path, always->b->path);
    for (int k = 0; k < m->work->near; k++) {
        const struct contacts_pair *p = &c->pair[m->work->pair[k]];
        const struct contacts_stand s = contacts_list_stand(
            c, contacts_near_of(c, m, p->first, &at[0]), contacts_near_of(c, m, p->second, &at[1]));
        keep(out, contacts_pair_rate(p, &s), p->a->path, p->b->path);
    }
    for (int i = 0; i < c->skins; i++) {
        const struct contacts_skin *p = &c->skin[i];
        keep(out, contacts_skin_rate(p, &c->scales, &m->body[p->body],
                                     contacts_near_of(c, m, p->second, &at[0])), "a beam", p->solid->path);
    }
    for (int i = 0; i < c->beams; i++) {
        const struct contacts_beams *p = &c->beam[i];
        keep(out, contacts_beams_rate(p, &c->scales, &m->body[p->body], &m->body[p->other]), "a beam",
             "a beam");
    }
}

static int create(const struct contacts_scene *scene, struct contacts **out)
{
    int code = contacts_list_create(scene, out);

    if (code == STATUS_DONE && *out)
        code = contacts_seats_first(*out, (*out)->seats.first);
    if (code != STATUS_DONE)
        contacts_list_free(out);
    return code;
}

static const struct body_seats seats = {
    .lack = contacts_seats_lack, .settle = contacts_seats_settle, .tidy = contacts_seats_tidy,
};

static const struct body_contacts solids = {
    .about = "solids, and skins of beams, that press and rub where they touch", .column = column,
    .columns = columns,
    .create = create, .free = contacts_list_free, .rows = rows, .start = start, .parts = parts,
    .work = contacts_near_create, .work_free = contacts_near_free,
    .seats = &seats,
    .meet = meet, .limit = limit,
};

const struct body_contacts *const bodies_contacts = &solids;
