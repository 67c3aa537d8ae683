/* contacts-rules.c -- which rule a pair of solids has. */
#include "bodies/contacts-rules.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

const char *contacts_rules_path(const struct contacts_scene *s, int part)
{
    if (part < s->bodies)
        return s->body[part].path;
    return part < s->bodies + s->walls ? s->wall[part - s->bodies].path : "side";
}

/* A name is that of one solid, or of its group: all bodies, beams, walls or sides. */
static bool fits(const char *name, const char *path)
{
    const size_t n = strcspn(path, ".");

    return strcmp(name, path) == 0 || (strlen(name) == n && strncmp(name, path, n) == 0);
}

struct contacts_rub contacts_rules_of(const struct contacts_scene *s, const char *a, const char *b)
{
    struct contacts_rub to = { .restitution = NAN, .friction = NAN };

    for (int i = 0; i < s->rules; i++) {
        const struct contacts_rule *r = &s->rule[i];
        if (!(fits(r->of, a) && fits(r->with, b)) && !(fits(r->of, b) && fits(r->with, a)))
            continue;
        to.restitution = isnan(r->restitution) ? to.restitution : r->restitution;
        to.friction = isnan(r->friction) ? to.friction : r->friction;
        if (r->law != CONTACTS_AS_OTHERS)
            to.made = r->law == CONTACTS_HERTZ_MINDLIN;
        if (r->law == CONTACTS_HERTZ_MINDLIN)
            memcpy(to.material, r->material, sizeof to.material);
    }
    return to;
}

static bool is_there(const struct contacts_scene *s, const char *name)
{
    for (int i = 0; i <= s->bodies + s->walls; i++)
        if (fits(name, contacts_rules_path(s, i)))
            return true;
    return false;
}

/* In the plane contacts are lines, whose law is another. */
static int check_law(const struct contacts_rule *r)
{
    const bool made = r->law == CONTACTS_HERTZ_MINDLIN;

    if (made && DIM == 2)
        return status_fail(STATUS_BAD_SCENE, "%s: contact.%s: the law of Hertz and Mindlin is that of balls, "
                           "and discs in the plane touch along lines; set law = \"soft\", or dimension = 3",
                           r->where, r->name);
    if (made && !(r->material[0].young > 0 && r->material[1].young > 0))
        return status_fail(STATUS_BAD_SCENE, "%s: contact.%s: law = \"hertz-mindlin\" needs young, Young's "
                           "modulus of `%s`, and young_with, that of `%s`, where it is another (Pa; PVC has "
                           "3e9, steel 2.1e11)", r->where, r->name, r->of, r->with);
    if (!made && r->material[0].young > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: contact.%s: young belongs to law = \"hertz-mindlin\", and "
                           "this one goes by softness; set that law, or leave young out", r->where, r->name);
    return STATUS_DONE;
}

int contacts_rules_check(const struct contacts_scene *s)
{
    for (int i = 0; i < s->rules; i++) {
        const struct contacts_rule *r = &s->rule[i];
        const char *stranger = !is_there(s, r->of) ? r->of : !is_there(s, r->with) ? r->with : NULL;
        if (stranger)
            return status_fail(STATUS_BAD_SCENE, "%s: contact.%s: there is no `%s`: name one solid, as "
                               "body.NAME, beam.NAME or wall.NAME, or all of a kind by body, beam, wall "
                               "or side (of the domain)", r->where, r->name, stranger);
        if (isnan(r->restitution) && isnan(r->friction) && r->law == CONTACTS_AS_OTHERS)
            return status_fail(STATUS_BAD_SCENE, "%s: contact.%s gives neither friction nor "
                               "restitution nor a law, and so says nothing; give one of them", r->where,
                               r->name);
        TRY(check_law(r));
    }
    return STATUS_DONE;
}
