/* point.c -- combinations of swept values, and what the scene is there. */
#include "study/point.h"

#include "base/status.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int read_sweep(struct study *s, int k, const char *word)
{
    const size_t n = strcspn(word, "=");

    if (!word[n] || n == 0 || n >= INSIDE_WORD)
        return status_fail(STATUS_BAD_SCENE, "--sweep %.60s: not of the form KEY=VALUE,VALUE,...",
                           word);
    memcpy(s->key[k], word, n);
    return words_split(&s->values[k], word + n + 1, "--sweep");
}

int point_sweeps(struct study *s)
{
    s->points = 1;
    for (int k = 0; k < s->order->sweeps; k++) {
        s->sweeps = k + 1;
        TRY(read_sweep(s, k, s->order->sweep[k]));
        s->points *= s->values[k].n;
    }
    return STATUS_DONE;
}

enum { LEAST_PICTURES = 20 }; /* of a reference: enough to see a disturbance grow */

int point_pieces(double until, double dx, double g, double early)
{
    const double fall = dx > 0 && g > 0 ? sqrt(20 * dx / g) : until / 10;
    const double wanted = until / (early > 0 ? early : fall);

    return (int)fmax(1, fmin(ceil(wanted - 1e-6), early > 0 ? 999 : 50));
}

static int set_all(const struct study *s, struct scene *scene, struct point *p)
{
    for (int i = 0; i < s->order->overrides; i++)
        TRY(scene_override(scene, s->order->override[i]));
    for (int k = 0; k < s->sweeps; k++) {
        char text[4 * INSIDE_WORD];
        snprintf(text, sizeof text, "%s=%s", s->key[k], p->value[k]);
        TRY(scene_override(scene, text));
        snprintf(p->label + strlen(p->label), sizeof p->label - strlen(p->label), "%s%s",
                 k ? " " : "", text);
    }
    TRY(facts_read(scene, &p->facts));
    p->pieces = point_pieces(p->facts.until, p->facts.dx, facts_gravity(&p->facts),
                             s->order->early);
    p->fine = (LEAST_PICTURES + p->pieces - 1) / p->pieces;
    return STATUS_DONE;
}

int point_all(struct study *s)
{
    s->point = status_alloc(s->points, sizeof *s->point);
    if (!s->point)
        return STATUS_FAILED;
    for (int i = 0; i < s->points; i++) {
        struct scene *scene = NULL;
        int status = scene_read(s->order->scene, &scene);
        for (int k = s->sweeps - 1, rest = i; k >= 0; k--) {
            s->point[i].value[k] = s->values[k].word[rest % s->values[k].n];
            rest /= s->values[k].n;
        }
        if (status == STATUS_DONE)
            status = set_all(s, scene, &s->point[i]);
        scene_free(&scene);
        TRY(status);
    }
    return STATUS_DONE;
}
