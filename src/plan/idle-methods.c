/* idle-methods.c -- keys of methods that a scene does not take. */
#include "plan/idle.h"

#include "base/status.h"
#include "plan/input.h"
#include "scene/scene.h"

#include <math.h>
#include <string.h>

/* What a group is that gives no key; of numbers and words. */
static void fill_plain(const struct param *rows, void *to)
{
    for (; rows->key; rows++) {
        char *at = (char *)to + rows->offset;
        if (rows->type == PARAM_NUMBER)
            *(double *)at = rows->fallback;
        else if (rows->type == PARAM_INTEGER)
            *(int *)at = (int)rows->fallback;
        else if (rows->type == PARAM_WORD)
            *(const char **)at = rows->words[0];
    }
}

static bool changed(const struct param *row, const void *values, const void *plain)
{
    const char *at = (const char *)values + row->offset, *of = (const char *)plain + row->offset;

    if (row->type == PARAM_WORD)
        return strcmp(*(const char *const *)at, *(const char *const *)of) != 0;
    if (row->type == PARAM_INTEGER)
        return *(const int *)at != *(const int *)of;
    const double a = *(const double *)at, b = *(const double *)of;
    return a != b && !(isnan(a) && isnan(b));
}

/* Tells of the first. */
static void doubt_group(const struct scene_node *root, const struct input *in, const char *method,
                        const struct param *rows, const void *values, const void *plain)
{
    const struct scene_node *group = scene_child(root, method);

    if (!group || strncmp(in->set.method, method, strlen(method)) == 0)
        return;
    for (; rows->key; rows++)
        if (changed(rows, values, plain)) {
            const struct scene_node *node = scene_child(group, rows->key);
            status_warn("%s: %s.%s does nothing without method = \"%s\"",
                        scene_where(node ? node : group), method, rows->key, method);
            return;
        }
}

void idle_methods(const struct scene_node *root, const struct input *in)
{
    struct settings_pcisph pcisph = { 0 };
    struct settings_mps mps = { 0 };

    fill_plain(settings_pcisph_params, &pcisph);
    fill_plain(settings_mps_params, &mps);
    settings_mps_complete(&mps);
    doubt_group(root, in, "pcisph", settings_pcisph_params, &in->pcisph, &pcisph);
    doubt_group(root, in, "mps", settings_mps_params, &in->mps, &mps);
}
