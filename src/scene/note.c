/* note.c -- notes what every parameter came to be, for scene_write_used(). */
#include "base/status.h"
#include "scene/tree.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool same(const char *a, const char *b)
{
    return a == b || (a && b && strcmp(a, b) == 0);
}

/* FNV-1a over both texts and the end of the first. */
static size_t seat_of(const struct scene *scene, const char *path, const char *key)
{
    unsigned long hash = 0xcbf29ce484222325;

    for (const char *c = path; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 0x100000001b3;
    hash *= 0x100000001b3;
    for (const char *c = key ? key : ""; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 0x100000001b3;
    return (hash ^ hash >> 32) & (scene->seats - 1);
}

/* Where the number of that note stands, or 0 for the next one to be made: scenes of thousands of
 * objects have a hundred thousand notes, and each is looked for. */
static int *find_seat(const struct scene *scene, const char *path, const char *key)
{
    size_t i = seat_of(scene, path, key);

    for (; scene->seat[i] > 0; i = (i + 1) & (scene->seats - 1)) {
        const struct scene_note *note = &scene->note[scene->seat[i] - 1];
        if (same(note->path, path) && same(note->key, key))
            break;
    }
    return &scene->seat[i];
}

/* Twice as many seats before half of them are taken. */
static int make_seats(struct scene *scene)
{
    const size_t seats = scene->seats ? 2 * scene->seats : 256;
    int *seat;

    if (2 * ((size_t)scene->notes + 1) < scene->seats)
        return STATUS_DONE;
    seat = scene_pool_take(&scene->pool, seats * sizeof *seat);
    if (!seat)
        return STATUS_FAILED;
    scene->seat = seat;
    scene->seats = seats;
    for (int i = 0; i < scene->notes; i++)
        *find_seat(scene, scene->note[i].path, scene->note[i].key) = i + 1;
    return STATUS_DONE;
}

static struct scene_note *find(const struct scene *scene, const char *path, const char *key)
{
    const int seat = scene->seats ? *find_seat(scene, path, key) : 0;

    return seat > 0 ? &scene->note[seat - 1] : NULL;
}

/* The note of path and key, made if it is missing; NULL if there is no memory. */
static struct scene_note *find_or_make(struct scene *scene, const char *path, const char *key)
{
    struct scene_pool *pool = &scene->pool;
    struct scene_note *note = find(scene, path, key);

    if (note)
        return note;
    note = scene_pool_grow(pool, scene->note, scene->notes, &scene->notes_room, sizeof *note);
    if (!note || make_seats(scene) != STATUS_DONE)
        return NULL;
    scene->note = note;
    note += scene->notes;
    *note = (struct scene_note){ .path = scene_pool_print(pool, "%s", path), .unit = "",
                                 .key = key ? scene_pool_print(pool, "%s", key) : NULL,
                                 .value = "", .origin = "" };
    if (!note->path || (key && !note->key))
        return NULL;
    scene->notes++;
    *find_seat(scene, path, key) = scene->notes;
    return note;
}

int scene_note_group(struct scene *scene, const char *path)
{
    return find_or_make(scene, path, NULL) ? STATUS_DONE : STATUS_FAILED;
}

/* Writes some numbers as a list; answers whether a scene can say them all. */
static bool write_numbers(const double *x, int n, FILE *to)
{
    bool finite = true;

    fputc('[', to);
    for (int i = 0; i < n; i++) {
        if (i > 0)
            fputs(", ", to);
        scene_write_number(x[i], to);
        finite = finite && isfinite(x[i]);
    }
    fputc(']', to);
    return finite;
}

static void write_points(const struct param_points *points, int dimension, FILE *to)
{
    fputc('(', to);
    for (int i = 0; i < points->n; i++) {
        fputs(i > 0 ? ", " : "", to);
        write_numbers(points->x[i], dimension, to);
    }
    fputc(')', to);
}

static void write_words(unsigned set, const char *const *words, FILE *to)
{
    const char *gap = "";

    fputc('[', to);
    for (int i = 0; words[i]; i++)
        if (set >> i & 1) {
            fputs(gap, to);
            scene_write_text(words[i], to);
            gap = ", ";
        }
    fputc(']', to);
}

/* Writes what stands in the caller's struct; answers whether a scene can say it. */
static bool write_value(const struct scene_wish *w, FILE *to)
{
    switch (w->row->type) {
    case PARAM_NUMBER:
        scene_write_number(*(const double *)w->to, to);
        return isfinite(*(const double *)w->to);
    case PARAM_INTEGER:
        if (*(const int *)w->to == INT_MIN)
            break;
        fprintf(to, "%d", *(const int *)w->to);
        return true;
    case PARAM_FLAG:
        fputs(*(const bool *)w->to ? "true" : "false", to);
        return true;
    case PARAM_WORD:
    case PARAM_TEXT:
        scene_write_text(*(const char *const *)w->to, to);
        return true;
    case PARAM_VECTOR:
        return write_numbers(w->to, w->dimension, to);
    case PARAM_POINTS:
        write_points(w->to, w->dimension, to);
        return true;
    case PARAM_PAIRS:
        write_points(w->to, 2, to);
        return true;
    case PARAM_WORDS:
        write_words(*(const unsigned *)w->to, w->row->words, to);
        return true;
    }
    fputs("nan", to);
    return false;
}

/* What was written to the stream that open_memstream() made, kept in the pool. */
static const char *keep(struct scene_pool *pool, FILE *stream, char **text)
{
    const char *kept = fclose(stream) == 0 ? scene_pool_print(pool, "%s", *text) : NULL;

    free(*text);
    return kept;
}

static int out_of_memory(void)
{
    return status_starved("values of the scene cannot be noted");
}

int scene_value_note(const struct scene_wish *wish, const char *path)
{
    struct scene_note *note = find_or_make(wish->scene, path, wish->row->key);
    char *text = NULL;
    size_t n = 0;
    FILE *stream = note ? open_memstream(&text, &n) : NULL;

    if (!stream)
        return out_of_memory();
    note->silent = !write_value(wish, stream);
    note->value = keep(&wish->scene->pool, stream, &text);
    note->unit = scene_pool_print(&wish->scene->pool, "%s", wish->row->unit ? wish->row->unit : "");
    note->origin = wish->node ? "" : "default";
    return note->value && note->unit ? STATUS_DONE : out_of_memory();
}

int scene_note_raw(struct scene *scene, const char *path, const struct scene_node *node)
{
    struct scene_note *note;
    char *text = NULL;
    size_t n = 0;
    FILE *stream;

    if (find(scene, path, node->name))
        return STATUS_DONE;
    note = find_or_make(scene, path, node->name);
    stream = note ? open_memstream(&text, &n) : NULL;
    if (!stream)
        return out_of_memory();
    scene_write_node(node, stream);
    note->value = keep(&scene->pool, stream, &text);
    return note->value ? STATUS_DONE : out_of_memory();
}

/* text: NULL when there is no memory for it, and the note stays. */
static void compute(struct scene *scene, const char *path, const char *key, const char *text)
{
    struct scene_note *note = find(scene, path, key);

    if (!note || !note->origin[0] || !text)
        return;
    note->value = text;
    note->origin = "computed";
    note->silent = false;
}

void scene_computed(struct scene *scene, const char *path, const char *key, double value)
{
    if (isfinite(value))
        compute(scene, path, key, scene_pool_print(&scene->pool, "%.17g", value));
}

void scene_computed_word(struct scene *scene, const char *path, const char *key, const char *word)
{
    compute(scene, path, key, scene_pool_print(&scene->pool, "\"%s\"", word));
}
