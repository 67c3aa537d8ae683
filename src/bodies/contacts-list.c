/* contacts-list.c -- which of the solids of a scene may touch. */
#include "bodies/contacts-list.h"

#include "base/status.h"
#include "bodies/contacts-solids.h"
#include "bodies/contacts-table.h"
#include "state/period.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* At the start nothing may be deeper: overlap is energy from nowhere, and this much stores
 * less than a thousandth of what d_U stores. */
static const double start_depth = 0.05; /* [d_U] */

void contacts_list_free(struct contacts **contacts)
{
    struct contacts *c = *contacts;

    if (!c)
        return;
    contacts_solids_free(c);
    free(c->pair);
    free(c->pair_of);
    free(c->seats.first);
    free(c->skin);
    free(c->beam);
    for (int i = 0; i < c->lifts; i++)
        contacts_uplift_free(&c->lift[i].of);
    free(c->lift);
    free(c);
    *contacts = NULL;
}

static int no_skin(void)
{
    return status_fail(STATUS_BAD_SCENE, "a beam with contact = true touches by its skin, and that is "
                       "there in water only; name a fluid, be it far away, or leave contact out");
}

static int no_law(const char *path)
{
    return status_fail(STATUS_BAD_SCENE, "%s: law = \"hertz-mindlin\" is for rigid bodies and walls, and a "
                       "beam touches by its skin; leave the law out for beams", path);
}

/* Skins touch all solids but sides that are no wall's, which only rigid bodies name. */
static int list_skins(struct contacts *c, const struct contacts_scene *s)
{
    c->skin = status_alloc((size_t)s->bodies * (size_t)c->solids + 1, sizeof *c->skin);
    if (!c->skin)
        return STATUS_FAILED;
    for (int i = 0; i < s->bodies; i++) {
        const struct body_surface *surface = contacts_solids_surface(&s->body[i]);
        if (surface && s->body[i].points == 0)
            return no_skin();
        for (int j = 0; j < c->solids && surface; j++) {
            if (c->part_of[j] == c->bodies + c->walls)
                continue;
            struct contacts_skin *p = &c->skin[c->skins++];
            const struct contacts_rub rub = contacts_table_rub(c, s, i, j);
            if (rub.made)
                return no_law(s->body[i].path);
            contacts_skin_make(p, &s->body[i], surface, &c->solid[j], &rub, &c->scales);
            p->body = i;
            p->second = j;
            p->from = c->places;
            c->places += p->points;
            c->known[i] = true;
        }
    }
    return STATUS_DONE;
}

static int add_beams(struct contacts *c, const struct contacts_scene *s, int body, int other)
{
    struct contacts_beams *p = &c->beam[c->beams++];
    const struct contacts_rub rub = contacts_rules_of(s, contacts_rules_path(s, body),
                                                      contacts_rules_path(s, other));

    if (rub.made)
        return no_law(s->body[body].path);
    contacts_beams_make(p, &s->body[body], &s->body[other], &rub, s->scales);
    p->body = body;
    p->other = other;
    p->from = c->places;
    c->places += p->points;
    c->known[body] = true;
    return STATUS_DONE;
}

/* Each is told to each other. */
static int list_beams(struct contacts *c, const struct contacts_scene *s)
{
    c->beam = status_alloc((size_t)s->bodies * (size_t)s->bodies + 1, sizeof *c->beam);
    if (!c->beam)
        return STATUS_FAILED;
    for (int i = 0; i < s->bodies; i++)
        for (int j = 0; j < s->bodies; j++)
            if (i != j && contacts_solids_surface(&s->body[i]) && contacts_solids_surface(&s->body[j]))
                TRY(add_beams(c, s, i, j));
    return STATUS_DONE;
}

/* Of solids, the first are bodies. */
static int list_lifts(struct contacts *c, const struct contacts_scene *s, int bodies)
{
    c->lift = status_alloc((size_t)bodies + 1, sizeof *c->lift);
    if (!c->lift)
        return STATUS_FAILED;
    for (int i = 0; i < bodies; i++) {
        const struct contacts_body *b = &s->body[c->part_of[i]];
        struct contacts_lift *l = &c->lift[c->lifts];
        if (!c->solid[i].uplift || b->points == 0)
            continue;
        TRY(contacts_uplift_create(&c->solid[i], b, &c->scales, &l->of));
        l->solid = i;
        l->body = c->part_of[i];
        c->lifts++;
    }
    return STATUS_DONE;
}

struct contacts_stand contacts_list_stand(const struct contacts *c, const struct solid_place *a,
                                          const struct solid_place *b)
{
    struct contacts_stand s = { .a = a, .b = b };

    for (int d = 0; d < DIM; d++)
        s.apart[d] = period_nearest(&c->scales, d, a->x[d] - b->x[d]);
    return s;
}

/* " (FILE:LINE)" of a solid in the scene; "" of a side of the domain. */
static const char *place_of(const struct contacts *c, const struct contacts_scene *s,
                            const struct solid *solid, char text[280])
{
    const int part = c->part_of[solid - c->solid];
    const char *where = part < s->bodies             ? s->body[part].where
                        : part < s->bodies + s->walls ? s->wall[part - s->bodies].where
                                                      : NULL;

    text[0] = '\0';
    if (where)
        snprintf(text, 280, " (%.256s)", where);
    return text;
}

static int check_start(const struct contacts *c, const struct contacts_scene *scene)
{
    char first[280], second[280];

    for (int i = 0; i < c->pairs; i++) {
        const struct contacts_pair *p = &c->pair[i];
        const struct contacts_stand s = contacts_list_stand(c, &p->a->start, &p->b->start);
        const double depth = contacts_pair_depth(p, &s), most = start_depth * p->depth;
        char deep[40] = "far";
        TRY(contacts_pair_check(p));
        if (depth <= most)
            continue;
        if (depth < HUGE_VAL)
            snprintf(deep, sizeof deep, "%g m", depth);
        return status_fail(STATUS_BAD_SCENE, "%s%s and %s%s overlap at t = 0: they are %s inside "
                           "each other, and at most %g m may be, as overlap is energy from nowhere; "
                           "move them apart, so that their faces touch or less", p->a->path,
                           place_of(c, scene, p->a, first), p->b->path,
                           place_of(c, scene, p->b, second), deep, most);
    }
    return STATUS_DONE;
}

static int build(struct contacts *c, const struct contacts_scene *s)
{
    c->scales = *s->scales;
    c->bodies = s->bodies;
    c->walls = s->walls;
    TRY(contacts_rules_check(s));
    TRY(contacts_solids_list(c, s, &c->movers));
    TRY(contacts_table_make(c, s));
    TRY(list_skins(c, s));
    TRY(list_beams(c, s));
    TRY(list_lifts(c, s, c->movers));
    TRY(contacts_table_check(c));
    return check_start(c, s);
}

int contacts_list_create(const struct contacts_scene *scene, struct contacts **out)
{
    struct contacts *c = status_alloc(1, sizeof *c);
    int code = c ? build(c, scene) : STATUS_FAILED;

    if (code != STATUS_DONE || c->places == 0)
        contacts_list_free(&c);
    *out = c;
    return code;
}
