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
    s->unit[k] = s->order->unit ? s->order->unit(s->key[k]) : "";
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
    if (s->order->early > p->facts.until * (1 + 1e-9))
        return status_fail(STATUS_BAD_SCENE, "--early %g: positions are compared at that time, and "
                           "runs end at %g s%s%s", s->order->early, p->facts.until,
                           *p->label ? ", with " : "", p->label);
    p->pieces = point_pieces(p->facts.until, p->facts.dx, facts_gravity(&p->facts),
                             s->order->early);
    p->fine = (LEAST_PICTURES + p->pieces - 1) / p->pieces;
    return STATUS_DONE;
}

char *point_settings(const struct study *s, const struct point *p)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    for (int k = 0; k < s->sweeps; k++)
        fprintf(to, "%s=%s\n", s->key[k], p->value[k]);
    fclose(to);
    return text;
}

static bool is_spacing(const struct study *s, int k)
{
    return strcmp(s->key[k], "spacing") == 0;
}

/* Same values of all swept keys but the spacing? */
static bool alike(const struct study *s, const struct point *a, const struct point *b)
{
    for (int k = 0; k < s->sweeps; k++)
        if (!is_spacing(s, k) && strcmp(a->value[k], b->value[k]) != 0)
            return false;
    return true;
}

static void say_place(const struct study *s, struct point *p)
{
    for (int k = 0; k < s->sweeps; k++) {
        const size_t n = strlen(p->place);
        if (!is_spacing(s, k))
            snprintf(p->place + n, sizeof p->place - n, "%s%s=%s", n ? " " : "", s->key[k],
                     p->value[k]);
    }
}

int point_finest(struct study *s)
{
    bool differ = false;

    for (int i = 0; i < s->points; i++) {
        struct point *p = &s->point[i];
        p->finest = p;
        for (int k = 0; k < s->points; k++)
            if (alike(s, p, &s->point[k]) && s->point[k].facts.dx < p->finest->facts.dx)
                p->finest = &s->point[k];
        differ = differ || p->finest != p;
        say_place(s, p);
    }
    if (!differ)
        return status_fail(STATUS_BAD_SCENE, "--reference finest: errors are taken against the "
                           "run with the least spacing: give two spacings or more, like --sweep "
                           "spacing=0.01,0.005");
    if (s->order->growth)
        return status_fail(STATUS_BAD_SCENE, "--growth follows a disturbance of the reference, and "
                           "with --reference finest each run has one of its own; leave one of "
                           "them out");
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
