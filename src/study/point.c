/* point.c -- combinations of swept values, and what the scene is there. */
#include "study/point.h"

#include "base/status.h"
#include "output/hash.h"
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

struct facts {
    const char *title;
    double until, spacing, gravity[3];
    int dimension;
};

enum { LEAST_PICTURES = 20 }; /* of a reference: enough to see a disturbance grow */

#define AT(member) .offset = offsetof(struct facts, member)

static const struct param rows[] = {
    { .key = "title", .unit = "", .type = PARAM_TEXT, AT(title), .about = "" },
    { .key = "until", .unit = "s", AT(until), .min = 1e-9, .max = 1e6, .required = 1, .about = "" },
    { .key = "spacing", .unit = "m", AT(spacing), .about = "" },
    { .key = "gravity", .unit = "m/s^2", .type = PARAM_VECTOR, AT(gravity), .about = "" },
    { .key = "dimension", .unit = "", .type = PARAM_INTEGER, AT(dimension), .fallback = 2,
      .min = 2, .max = 3, .about = "" },
    { 0 },
};

int point_pieces(double until, double dx, double g, double early)
{
    const double fall = dx > 0 && g > 0 ? sqrt(20 * dx / g) : until / 10;
    const double wanted = until / (early > 0 ? early : fall);

    return (int)fmax(1, fmin(ceil(wanted - 1e-6), early > 0 ? 999 : 50));
}

/* Only what a comparison has to know; all else is the run's to read and to refuse. */
static int read_facts(const struct study *s, struct scene *scene, struct point *p)
{
    const struct scene_node *root = scene_root(scene);
    const struct scene_node *dimension = scene_child(root, "dimension");
    const int n = scene_count(root);
    const char **also = status_alloc(n + 1, sizeof *also);
    struct facts f = { .title = "" };
    const double *g = f.gravity;
    int status;

    if (!also)
        return STATUS_FAILED;
    for (int i = 0; i < n; i++)
        also[i] = scene_name(scene_at(root, i));
    status = scene_fill(scene, NULL, "", rows + 4, NULL, 2, &f);
    if (status == STATUS_DONE && dimension)
        status = scene_fill(scene, root, "", rows + 4, also, 2, &f);
    if (status == STATUS_DONE)
        status = scene_fill(scene, root, "", rows, also, f.dimension, &f);
    free(also);
    TRY(status);
    snprintf(p->title, sizeof p->title, "%s", f.title);
    p->until = f.until;
    p->dx = f.spacing;
    p->dimension = f.dimension;
    memcpy(p->gravity, f.gravity, sizeof p->gravity);
    p->beam = scene_count(scene_child(root, "beam")) > 0;
    p->pieces = point_pieces(p->until, p->dx, sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]),
                             s->order->early);
    p->fine = (LEAST_PICTURES + p->pieces - 1) / p->pieces;
    return STATUS_DONE;
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
    return read_facts(s, scene, p);
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

/* Files that nodes come from, each once. */
enum { FILES = 32 };

struct files {
    int n;
    const char *name[FILES];
};

static void collect(const struct scene_node *node, struct files *f)
{
    const char *name = scene_file(node);
    bool known = false;

    for (int i = 0; i < f->n; i++)
        known |= strcmp(f->name[i], name) == 0;
    if (!known && f->n < FILES)
        f->name[f->n++] = name;
    for (int i = 0; i < scene_count(node); i++)
        collect(scene_at(node, i), f);
}

static uint64_t hash_file(uint64_t hash, const char *path)
{
    FILE *from = fopen(path, "r");
    char bytes[4096];
    size_t n;

    while (from && (n = fread(bytes, 1, sizeof bytes, from)) > 0)
        hash = hash_bytes(hash, bytes, n);
    if (from)
        fclose(from);
    return hash;
}

int point_hash(const char *path, char *to, unsigned long size)
{
    struct scene *scene = NULL;
    uint64_t hash = hash_file(HASH_START, path);
    struct files f = {0};
    char text[HASH_TEXT];

    TRY(scene_read(path, &scene));
    collect(scene_root(scene), &f);
    for (int i = 0; i < f.n; i++)
        if (strcmp(f.name[i], path) != 0)
            hash = hash_file(hash, f.name[i]);
    scene_free(&scene);
    snprintf(to, size, "%s", hash_text(hash, text));
    return STATUS_DONE;
}
