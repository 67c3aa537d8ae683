/* input-probes.c -- reads what a scene measures: probes, and panels of solids; and what it says of
 * pairs of solids. */
#include "plan/input-objects.h"

#include "base/status.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* In how many directions the probe has an extent. */
static int extents(const struct settings_probe *p)
{
    int n = 0;

    for (int d = 0; d < DIM; d++)
        n += p->to[d] != p->at[d];
    return n;
}

static int check_box(const struct settings_probe *p, const char *where, const char *path)
{
    if (isnan(p->to[0]))
        return STATUS_DONE;
    if (extents(p) == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.to is its `at`: give the other end, or leave "
                           "it out to measure at a point", where, path);
    if (extents(p) > 2)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: `at` and `to` differ in all three "
                           "directions, but an area is flat: let them agree in one of them, that "
                           "across the rectangle", where, path);
    return STATUS_DONE;
}

static int check_disc(const struct settings_probe *p, const char *where, const char *path)
{
    const bool turned = p->normal[0] != 0 || p->normal[1] != 0 || p->normal[2] != 0;

    if (isnan(p->radius) && turned)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.normal does nothing without radius; give "
                           "that, or leave normal out", where, path);
    if (isnan(p->radius))
        return STATUS_DONE;
    if (DIM == 2)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.radius: a disc is an area in 3D; in 2D take "
                           "`to`, the other end of a segment", where, path);
    if (!isnan(p->to[0]))
        return status_fail(STATUS_BAD_SCENE, "%s: %s has `to`, of a rectangle, and radius, of a "
                           "disc: leave one of them out", where, path);
    if (!turned)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.normal is needed: the direction across the "
                           "disc, such as [1, 0, 0]", where, path);
    return STATUS_DONE;
}

/* Heights are taken at a point; a profile needs an area. */
static int check_what(const struct input *in, const struct settings_probe *p, const char *where,
                      const char *path)
{
    const bool height = strcmp(p->what, "height") == 0, area = !isnan(p->to[0]) || p->radius > 0;

    if (height && in->domain.periodic & 1u << (DIM - 1))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: there is no height where the vertical "
                           "repeats (domain.periodic); take what = \"pressure\" or "
                           "\"velocity\"", where, path);
    if (height && area)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: a height is measured at a point; leave `to` "
                           "and radius out, or take what = \"pressure\"", where, path);
    if (p->profile && !area)
        return status_fail(STATUS_BAD_SCENE, "%s: %s.profile does nothing without to or radius: a "
                           "point has no profile", where, path);
    return STATUS_DONE;
}

static int read_probe(struct scene *scene, const struct scene_node *node, const struct input *in,
                      struct input_probe *p)
{
    char path[80];

    snprintf(p->name, sizeof p->name, "%s", scene_name(node));
    snprintf(path, sizeof path, "probe.%s", p->name);
    TRY(scene_fill(scene, node, path, settings_probe_params, NULL, DIM, &p->set));
    TRY(check_box(&p->set, scene_where(node), path));
    TRY(check_disc(&p->set, scene_where(node), path));
    return check_what(in, &p->set, scene_where(node), path);
}

int input_probes(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "probe");

    TRY(input_check_objects(group, "probe"));
    if (!(in->probe = input_objects(group, sizeof *in->probe)))
        return STATUS_FAILED;
    for (int i = 0; i < scene_count(group); i++)
        TRY(read_probe(scene, scene_at(group, i), in, &in->probe[in->probes++]));
    return STATUS_DONE;
}

int input_panels(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "panel");

    TRY(input_check_objects(group, "panel"));
    if (!(in->panels.of = input_objects(group, sizeof *in->panels.of)))
        return STATUS_FAILED;
    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        struct input_panel *p = &in->panels.of[in->panels.n++];
        char path[80];

        snprintf(p->name, sizeof p->name, "%s", scene_name(node));
        snprintf(p->where, sizeof p->where, "%s", scene_where(node));
        snprintf(path, sizeof path, "panel.%s", p->name);
        TRY(scene_fill(scene, node, path, settings_panel_params, NULL, DIM, &p->set));
    }
    return STATUS_DONE;
}

int input_contacts(struct scene *scene, struct input *in)
{
    const struct scene_node *group = scene_child(scene_root(scene), "contact");

    TRY(input_check_objects(group, "contact"));
    if (!(in->pairs.of = input_objects(group, sizeof *in->pairs.of)))
        return STATUS_FAILED;
    for (int i = 0; i < scene_count(group); i++) {
        const struct scene_node *node = scene_at(group, i);
        struct input_contact *c = &in->pairs.of[in->pairs.n++];
        char path[80];

        snprintf(c->name, sizeof c->name, "%s", scene_name(node));
        snprintf(c->where, sizeof c->where, "%s", scene_where(node));
        snprintf(path, sizeof path, "contact.%s", c->name);
        TRY(scene_fill(scene, node, path, settings_contact_params, NULL, DIM, &c->set));
    }
    if (in->pairs.n > 0 && in->bodies == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: contact.%s: nothing touches anything here, as there "
                           "are no bodies; leave contact out", in->pairs.of[0].where,
                           in->pairs.of[0].name);
    return STATUS_DONE;
}
