/* facts.c -- the little of a scene that a study of its runs has to know. */
#include "study/facts.h"

#include "base/param.h"
#include "base/status.h"
#include "output/hash.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct top {
    const char *title;
    double until, spacing, gravity[3];
    int dimension;
};

#define AT(type, member) .offset = offsetof(struct type, member)

static const struct param rows[] = {
    { .key = "title", .unit = "", .type = PARAM_TEXT, AT(top, title), .about = "" },
    { .key = "until", .unit = "s", AT(top, until), .min = 1e-9, .max = 1e6, .required = 1,
      .about = "" },
    { .key = "spacing", .unit = "m", AT(top, spacing), .about = "" },
    { .key = "gravity", .unit = "m/s^2", .type = PARAM_VECTOR, AT(top, gravity), .about = "" },
    { .key = "dimension", .unit = "", .type = PARAM_INTEGER, AT(top, dimension), .fallback = 2,
      .min = 2, .max = 3, .about = "" },
    { 0 },
};

struct box {
    double from[3], to[3];
    unsigned periodic;
};

static const char *const axes[] = { "x", "y", "z", NULL };

static const struct param box_rows[] = {
    { .key = "from", .unit = "m", .type = PARAM_VECTOR, AT(box, from), .about = "" },
    { .key = "to", .unit = "m", .type = PARAM_VECTOR, AT(box, to), .about = "" },
    { .key = "periodic", .unit = "", .type = PARAM_WORDS, AT(box, periodic), .words = axes,
      .about = "" },
    { 0 },
};

/* Some rows of a node, whatever else is there. */
static int fill(struct scene *scene, const struct scene_node *node, const char *path,
                const struct param *wanted, int dimension, void *to)
{
    const int n = scene_count(node);
    const char **also = status_alloc(n + 1, sizeof *also);
    int status;

    if (!also)
        return STATUS_FAILED;
    for (int i = 0; i < n; i++)
        also[i] = scene_name(scene_at(node, i));
    status = scene_fill(scene, node, path, wanted, also, dimension, to);
    free(also);
    return status;
}

static int read_periods(struct scene *scene, struct facts *f)
{
    struct box b;

    TRY(fill(scene, scene_child(scene_root(scene), "domain"), "domain", box_rows, f->dimension,
             &b));
    for (int d = 0; d < f->dimension; d++)
        if (b.periodic >> d & 1)
            f->period[d] = b.to[d] - b.from[d];
    return STATUS_DONE;
}

int facts_read(struct scene *scene, struct facts *f)
{
    const struct scene_node *root = scene_root(scene);
    struct top t;

    *f = (struct facts){0};
    TRY(scene_fill(scene, NULL, "", rows + 4, NULL, 2, &t));
    if (scene_child(root, "dimension"))
        TRY(fill(scene, root, "", rows + 4, 2, &t));
    TRY(fill(scene, root, "", rows, t.dimension, &t));
    snprintf(f->title, sizeof f->title, "%s", t.title);
    status_plain(f->title);
    f->until = t.until;
    f->dx = t.spacing;
    f->dimension = t.dimension;
    memcpy(f->gravity, t.gravity, sizeof f->gravity);
    f->beam = scene_count(scene_child(root, "beam")) > 0;
    f->fluid = scene_count(scene_child(root, "fluid")) > 0;
    return read_periods(scene, f);
}

double facts_gravity(const struct facts *f)
{
    const double *g = f->gravity;

    return sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
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

int facts_hash(const char *path, char *to, unsigned long size)
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
